//! Meetings of critical curves with the pole lines, and how long the lists of a certificate can be: compared before anything is
//! worked out from them.

use bifdiag_schema::{CertificateDocument, CertifiedMeeting, CertifiedPair};
use dashu_ratio::RBig;

use super::pieces::{Branch, End, Pieces};
use super::places::{Place, Side};
use super::roots::{isolated, listed, places};
use super::spaces::Spaces;
use crate::Refused;
use crate::numbers::polynomial::Polynomial;

/// A meeting with a pole line, checked.
pub(crate) struct Meeting {
    /// With P+.
    pub plus: bool,
    pub place: Place,
    /// The critical curves: two at a cusp or pitchfork.
    pub curves: Vec<usize>,
    /// The end at which it lies exactly.
    pub end: Option<End>,
    /// Its isolated root is a root of this.
    pub polynomial: Polynomial,
}

/// The polynomials of a branch: `meeting` is 0 where it meets a pole line, and the sign of `side` there says which one.
struct Equations {
    branch: Branch,
    side: Polynomial,
    meeting: Polynomial,
    /// Between these the parameter runs.
    ends: [Option<RBig>; 2],
}

/// The meetings of a certificate: of each branch as many as are counted, each isolated, with the right line
/// and curves.
pub(crate) fn meetings(
    certificate: &CertificateDocument,
    spaces: &Spaces,
    pieces: &Pieces,
) -> Result<Vec<Meeting>, Refused> {
    let places = places(certificate.meetings.iter().map(|meeting| &meeting.place), spaces, "meeting")?;
    let mut found: Vec<Option<Meeting>> = places.iter().map(|_| None).collect();
    for equations in branches(spaces) {
        let ends = equations.ends.each_ref().map(Option::as_ref);
        let ranges = listed(&places, spaces, |place| equations.branch.holds(place), ends);
        isolated(&equations.meeting, &ranges, ends, ["meeting", "meetings with pole lines"], || {
            match equations.branch {
                Branch::Generic(number) => format!("G{number}"),
                _ => "over a moment".to_owned(),
            }
        })?;
        for (number, range) in ranges {
            let refuse = |why| Refused::entry("meeting", number, why);
            let claim = &certificate.meetings[number];
            let plus = line(claim, &equations, &range).map_err(refuse)?;
            let (curves, end) =
                on_curves(spaces, pieces, &equations, &range).ok_or_else(|| refuse("its curve is not certain"))?;
            if !curves.iter().map(|&c| &pieces.list[c].id).eq(&claim.curves) {
                return Err(refuse("it lies on another curve"));
            }
            let (place, polynomial) = (places[number].clone(), equations.meeting.clone());
            found[number] = Some(Meeting { plus, place, curves, end, polynomial });
        }
    }
    let proper = |(number, meeting): (usize, Option<Meeting>)| meeting.ok_or(Refused::misplaced("meeting", number));
    found.into_iter().enumerate().map(proper).collect()
}

/// The meetings that there can be at most, by the degrees of their polynomials: that of the generic family is one for all of
/// its branches.
fn most_meetings(spaces: &Spaces) -> usize {
    match spaces.active.len() {
        0 => 0,
        n => (if n > 1 { 8 * n - 5 } else { 0 }) + 5 * spaces.passive().len(),
    }
}

/// Stretches of a pair of curves at most: the prover visits no more points of curves for one.
const STRETCHES: usize = 4000;

/// A list is not longer than the body allows.
fn is_short(what: &'static str, listed: usize, most: usize) -> Result<(), Refused> {
    if listed <= most { Ok(()) } else { Err(Refused::TooMany { what, listed, most }) }
}

/// Cusps and meetings: no more than the degrees of their polynomials.
pub(crate) fn count_roots(certificate: &CertificateDocument, spaces: &Spaces) -> Result<(), Refused> {
    let n = spaces.active.len();
    let generic = if n > 1 { 5 * n - 4 } else { 0 };
    is_short("cusps", certificate.cusps.len(), generic + spaces.passive().len())?;
    is_short("meetings", certificate.meetings.len(), most_meetings(spaces))
}

/// What is listed of curves and of the slabs between events.
pub(crate) fn count_lists(certificate: &CertificateDocument, spaces: &Spaces, pieces: &Pieces) -> Result<(), Refused> {
    let curves = pieces.list.len();
    is_short("pairs", certificate.pairs.len(), curves * curves / 2)?;
    for pair in &certificate.pairs {
        is_short("stretches of a pair", pair.stretches.len(), STRETCHES)?;
    }
    let crossings = |pair: &CertifiedPair| pair.stretches.iter().filter(|stretch| stretch.crossing.is_some()).count();
    let crossings: usize = certificate.pairs.iter().map(crossings).sum();
    let sources = pieces.cusps.len() + pieces.forks.len() + most_meetings(spaces) + crossings;
    is_short("events", certificate.events.len(), sources)?;
    for event in &certificate.events {
        is_short("sources of an event", event.sources.len(), sources)?;
        is_short("curves of an event", event.curves.len(), curves)?;
    }
    is_short("transitions", certificate.transitions.len(), sources)?;
    is_short("events of transitions", certificate.transitions.iter().map(Vec::len).sum(), sources)?;
    is_short("slabs", certificate.slabs.len(), sources + 1)?;
    for slab in &certificate.slabs {
        is_short("curves of a slab", slab.curves.len(), curves)?;
    }
    is_short("samples", certificate.samples.len(), (sources + 1) * curves)
}

/// Every branch that can meet a pole line: those of the generic family, and those over spaces without r.
fn branches(spaces: &Spaces) -> Vec<Equations> {
    let mut branches = Vec::new();
    if spaces.active.len() > 1 {
        let [side, meeting] = spaces.pole_polynomials();
        for number in 0..=spaces.active.len() {
            let ends = spaces.interval(number).map(Option::<&RBig>::cloned);
            let branch = Branch::Generic(number);
            branches.push(Equations { branch, side: side.clone(), meeting: meeting.clone(), ends });
        }
    }
    if !spaces.active.is_empty() {
        for base in spaces.passive() {
            let [side, meeting] = spaces.pole_polynomials_over(base);
            branches.push(Equations { branch: Branch::Over(base), side, meeting, ends: [Some(RBig::ZERO), None] });
        }
    }
    branches
}

impl Branch {
    /// A place may lie on this branch.
    fn holds(self, place: &Place) -> bool {
        match self {
            Self::Over(base) => place.side == Side::Over && place.base == base,
            _ => place.side != Side::Over,
        }
    }
}

/// Whether a meeting is with P+, if all that is claimed of its line is right.
fn line(claim: &CertifiedMeeting, equations: &Equations, range: &[RBig; 2]) -> Result<bool, &'static str> {
    let signs = range.each_ref().map(|end| equations.meeting.sign_at(end));
    let crosses = match signs.iter().position(|sign| *sign == 0) {
        // A rational root may be an end of its range.
        Some(end) => equations.meeting.order_at(&range[end]) % 2 == 1,
        None => signs[0] * signs[1] < 0,
    };
    if crosses == claim.touch {
        return Err("whether the curves touch or cross is not as claimed");
    }
    let sign = equations.side.sign_at(&range[0]);
    if equations.side.closed(range.each_ref()) != Some(0) || sign == 0 {
        return Err("its range does not tell the pole lines apart");
    }
    // N < 0 on P+ of the generic family; E > 0 on P+ over a space without r.
    let plus = (sign < 0) == matches!(equations.branch, Branch::Generic(_));
    if claim.pole == if plus { "+" } else { "-" } { Ok(plus) } else { Err("it lies on the other pole line") }
}

/// The curve of a branch on which a meeting lies; both at a cusp or pitchfork that is proved to be the same point.
fn on_curves(
    spaces: &Spaces,
    pieces: &Pieces,
    equations: &Equations,
    range: &[RBig; 2],
) -> Option<(Vec<usize>, Option<End>)> {
    let mine: Vec<usize> = (0..pieces.list.len()).filter(|&c| pieces.list[c].branch == equations.branch).collect();
    let alone = mine.iter().find(|&&curve| {
        let [low, high] = &pieces.list[curve].range;
        low.as_ref().is_none_or(|low| low[1] < range[0]) && high.as_ref().is_none_or(|high| range[1] < high[0])
    });
    if let Some(&curve) = alone {
        return Some((vec![curve], None));
    }
    mine.windows(2).find_map(|pair| {
        let [first, second] = [&pieces.list[pair[0]], &pieces.list[pair[1]]];
        let station = first.range[1].as_ref()?;
        let end = first.ends.into_iter().find(|end| end.is_station() && second.ends.contains(end))?;
        let (lo, hi) = ((&station[0]).max(&range[0]), (&station[1]).min(&range[1]));
        let same = if lo > hi {
            false
        } else if station[0] == station[1] {
            equations.meeting.sign_at(lo) == 0
        } else {
            equations.meeting.share_root(&spaces.cusp_polynomial(), [lo, hi])
        };
        same.then(|| (pair.to_vec(), Some(end)))
    })
}
