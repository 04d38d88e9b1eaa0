//! The events of a certificate: points where curves meet.

use bifdiag_schema::{CertificateDocument, CertifiedEvent};
use dashu_ratio::RBig;

use super::orders::Orders;
use super::pairs::Crossing;
use crate::Refused;
use crate::equilibria::meetings::Meeting;
use crate::equilibria::pieces::{Branch, End};
use crate::equilibria::places::{Point, Side};
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;
use crate::numbers::number;
use crate::numbers::polynomial::{Polynomial, plus, times};

/// The events of a certificate.
#[derive(Default)]
pub(crate) struct Events {
    /// Enclosures of x, as claimed (and found right).
    pub x: Vec<[RBig; 2]>,
    /// The curves that meet at each.
    pub curves: Vec<Vec<usize>>,
    /// (curve, side, other): the other passes exactly through this end.
    pub meetings: Vec<(usize, usize, usize)>,
    /// Curves and claimed x of the crossings of pairs, to be compared with the boxes.
    crossings: Vec<(usize, [usize; 2])>,
    /// The event of each cusp and pitchfork.
    ends: Vec<(End, usize)>,
}

/// What makes an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    Cusp(usize),
    Pitchfork(usize),
    Meeting(usize),
    Crossing,
}

impl Source {
    /// A source with its number in canonical form, so that none has two names.
    pub fn read(text: &str) -> Option<Self> {
        let Some((kind, digits)) = text.split_once(':') else {
            return (text == "crossing").then_some(Self::Crossing);
        };
        let number: usize = digits.parse().ok().filter(|number: &usize| number.to_string() == digits)?;
        match kind {
            "cusp" => Some(Self::Cusp(number)),
            "pitchfork" => Some(Self::Pitchfork(number)),
            "meeting" => Some(Self::Meeting(number)),
            _ => None,
        }
    }

    /// The end of curves that it is.
    pub fn end(self) -> Option<End> {
        match self {
            Self::Cusp(cusp) => Some(End::Cusp(cusp)),
            Self::Pitchfork(fork) => Some(End::Pitchfork(fork)),
            Self::Meeting(_) | Self::Crossing => None,
        }
    }
}

/// What the sources of one event bring together.
#[derive(Default)]
struct Gathered {
    curves: Vec<usize>,
    points: Vec<Point>,
}

impl Gathered {
    fn add(&mut self, curves: &[usize]) {
        for &curve in curves {
            if !self.curves.contains(&curve) {
                self.curves.push(curve);
            }
        }
    }
}

type Why = &'static str;

const NO_SOURCE: Why = "its source does not exist";
const NOT_ONE_POINT: Why = "its sources are not proved to be one point";

impl Events {
    /// Reads the events: each cusp, pitchfork and meeting once, with all its curves and a right enclosure. Crossings
    /// are compared later, by [`Self::compare_crossings`].
    pub fn read(certificate: &CertificateDocument, orders: &Orders, meetings: &[Meeting]) -> Result<Self, Refused> {
        let mut found = Self::default();
        let mut seen: Vec<Source> = Vec::new();
        for (at, event) in certificate.events.iter().enumerate() {
            let refuse = |why| Refused::entry("event", at, why);
            let sources = sources(event, &mut seen).map_err(refuse)?;
            let x = [number::read(&event.x[0])?, number::read(&event.x[1])?];
            let h = [number::read(&event.h[0])?, number::read(&event.h[1])?];
            let named: Vec<usize> = event.curves.iter().map(|id| orders.pieces.find(id)).collect::<Result<_, _>>()?;
            let end = sources.iter().find_map(|source| source.end());
            let mut gathered = Gathered::default();
            for &source in &sources {
                gather(orders, meetings, source, end, &named, &mut gathered).map_err(refuse)?;
            }
            if !gathered.points.iter().all(|point| encloses(&x, &h, point)) {
                return Err(refuse("its enclosure does not hold the point"));
            }
            if sources == [Source::Crossing] {
                if named[0] > named[1] {
                    return Err(refuse("its curves are not by their numbers"));
                }
                found.crossings.push((at, [named[0], named[1]]));
            }
            if named != gathered.curves {
                return Err(refuse("other curves meet there, or they are not in their order"));
            }
            if let (Some(end), true) = (end, sources.len() > 1) {
                found.passes_through(orders, end, &gathered.curves);
            }
            found.ends.extend(end.map(|end| (end, at)));
            found.x.push(x);
            found.curves.push(gathered.curves);
        }
        if seen.len() == orders.pieces.cusps.len() + orders.pieces.forks.len() + meetings.len() {
            Ok(found)
        } else {
            Err(Refused::entry("event", certificate.events.len(), "an event is missing"))
        }
    }

    /// The event of an end of curves.
    pub fn of(&self, end: End) -> Option<usize> {
        self.ends.iter().find(|(known, _)| *known == end).map(|(_, event)| *event)
    }

    /// At an event of several sources each curve that ends there meets all others.
    fn passes_through(&mut self, orders: &Orders, end: End, curves: &[usize]) {
        for &curve in curves {
            for side in (0..2).filter(|&side| orders.pieces.list[curve].ends[side] == end) {
                self.meetings.extend(curves.iter().filter(|&&c| c != curve).map(|&c| (curve, side, c)));
            }
        }
    }

    /// Each crossing of a pair is an event, and each such event a crossing.
    pub fn compare_crossings(&self, crossings: &[Crossing]) -> Result<(), Refused> {
        let mut open: Vec<&Crossing> = crossings.iter().collect();
        for (at, pair) in &self.crossings {
            let [lo, hi] = &self.x[*at];
            let place =
                open.iter().position(|(curves, boxed)| curves == pair && boxed.iter().all(|x| x.lies_in(lo, hi)));
            let place = place.ok_or(Refused::entry("event", *at, "the curves do not cross there"))?;
            open.remove(place);
        }
        if open.is_empty() { Ok(()) } else { Err(Refused::entry("event", self.x.len(), "a crossing is missing")) }
    }
}

/// The sources of an event, none of them seen before. Several are one point only at one cusp or pitchfork.
fn sources(event: &CertifiedEvent, seen: &mut Vec<Source>) -> Result<Vec<Source>, Why> {
    let sources: Option<Vec<Source>> = event.sources.iter().map(|text| Source::read(text)).collect();
    let sources = sources.ok_or("its source cannot be read")?;
    for source in sources.iter().filter(|source| **source != Source::Crossing) {
        if seen.contains(source) {
            return Err("its source is used twice");
        }
        seen.push(*source);
    }
    let ends = sources.iter().filter(|source| source.end().is_some()).count();
    match sources.len() {
        1 => Ok(sources),
        0 => Err(NOT_ONE_POINT),
        _ if ends != 1 || sources.contains(&Source::Crossing) => Err(NOT_ONE_POINT),
        _ => Ok(sources),
    }
}

/// The curves and the point of one source. `end` is the cusp or pitchfork among the sources of the event.
fn gather(
    orders: &Orders,
    meetings: &[Meeting],
    source: Source,
    end: Option<End>,
    named: &[usize],
    gathered: &mut Gathered,
) -> Result<(), Why> {
    let (pieces, spaces) = (orders.pieces, orders.spaces);
    match source {
        Source::Cusp(cusp) => {
            let place = pieces.cusps.get(cusp).ok_or(NO_SOURCE)?;
            gathered.add(&pieces.at_cusp(cusp));
            gathered.points.extend(spaces.point(place.base, place.side, &place.y(spaces)));
        }
        Source::Pitchfork(fork) => {
            let base = *pieces.forks.get(fork).ok_or(NO_SOURCE)?;
            gathered.add(&pieces.at_fork(fork));
            gathered.points.extend(spaces.point(base, Side::Over, &Fixed::whole(0)));
        }
        Source::Meeting(meeting) => {
            let meeting = meetings.get(meeting).ok_or(NO_SOURCE)?;
            let point = spaces.point(meeting.place.base, meeting.place.side, &meeting.place.y(spaces));
            let point = point.ok_or("its place cannot be enclosed")?;
            gathered.add(&meeting.curves);
            gathered.add(&line(orders, meeting, &point.x, end)?);
            if meeting.end.is_some_and(|own| end != Some(own)) {
                return Err("a meeting at a cusp or pitchfork must be one event with it");
            }
            if meeting.end.is_none() && end.is_some_and(|end| !through(orders, meeting, end)) {
                return Err(NOT_ONE_POINT);
            }
            gathered.points.push(point);
        }
        Source::Crossing => match named {
            [_, _] => gathered.add(named),
            _ => return Err("a crossing has two curves"),
        },
    }
    Ok(())
}

/// The claimed ranges of x and h hold the point.
fn encloses(x: &[RBig; 2], h: &[RBig; 2], point: &Point) -> bool {
    let holds = |[lo, hi]: &[RBig; 2], set: &Fixed| set.lies_in(lo, hi);
    holds(x, &point.x) && Spaces::height(&point.x, point).is_some_and(|height| holds(h, &height))
}

/// The pole line of a meeting: when r lies on an axis, the piece of the line over its x.
fn line(orders: &Orders, meeting: &Meeting, x: &Fixed, end: Option<End>) -> Result<Vec<usize>, Why> {
    let pieces = orders.pieces;
    let mut found = Vec::new();
    for (curve, piece) in pieces.list.iter().enumerate() {
        if piece.branch != Branch::Line(meeting.plus) {
            continue;
        }
        let [low, high] = [0, 1].map(|side| pieces.end_x(curve, side));
        if low.is_none_or(|low| low.below(x)) && high.is_none_or(|high| x.below(high)) {
            return Ok(vec![curve]);
        }
        if end.is_some_and(|end| piece.ends.contains(&end)) {
            found.push(curve);
        }
    }
    if found.is_empty() { Err("its piece of the pole line is not certain") } else { Ok(found) }
}

/// r on an axis: the meeting of a pair with the line lies exactly at this pitchfork. 4x²v³ = (a v − R̂)⁴ on the pair,
/// 4x² = α⁴r²/d² at the pitchfork.
fn through(orders: &Orders, meeting: &Meeting, end: End) -> bool {
    let spaces = orders.spaces;
    let ([axis], Side::Over, End::Pitchfork(fork)) = (&spaces.active[..], meeting.place.side, end) else {
        return false;
    };
    let base = meeting.place.base;
    let (r_sum, p_sum) = spaces.sums(base);
    let alpha = &spaces.list[*axis].a;
    let d = &spaces.list[orders.pieces.forks[fork]].a - alpha;
    let x2 = alpha * alpha * alpha * alpha * &spaces.r2 / (&d * &d);
    // In y: v = P̂ + y.
    let j = [spaces.list[base].a.clone() * &p_sum - r_sum, spaces.list[base].a.clone()];
    let v = [p_sum, RBig::ONE];
    let fourth = times(&times(&j, &j), &times(&j, &j));
    let cube = times(&times(&v, &v), &v);
    let difference = Polynomial::new(&plus(&fourth, &cube, &-x2));
    meeting.polynomial.share_root(&difference, [&meeting.place.lo, &meeting.place.hi])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_has_one_name() {
        assert_eq!(Source::read("cusp:10"), Some(Source::Cusp(10)));
        assert_eq!(Source::read("crossing"), Some(Source::Crossing));
        for text in ["cusp", "cusp:01", "cusp:+1", "crossing:0", "meeting:", "pitchfork:-1", "swallowtail:0", ""] {
            assert_eq!(Source::read(text), None, "{text}");
        }
    }
}
