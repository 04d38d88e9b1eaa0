//! Every critical curve and pole line, cut at cusps and pitchforks, from exactly isolated roots.

use std::sync::Arc;

use dashu_ratio::RBig;

use super::family::Half;
use super::model::Model;
use numbers::Sign;
use numbers::polynomial::{Polynomial, Root};
use top::body::{Axis, Frame};
use top::curves::{Branch, BranchName, CurveId, CurveName, CuspId, End, IntervalId, Orbit, PitchforkId, Pole};
use top::table::{Id, Table};

/// Bits to which the roots of a proof are refined.
pub(super) const ROOT_BITS: usize = 420;

/// A place on a half of a family.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub half: Half,
    /// y between lo and hi; equal when y is this rational.
    pub lo: RBig,
    pub hi: RBig,
    /// The root, if it is one.
    pub root: Option<Arc<Root>>,
}

/// Where a segment ends.
#[derive(Clone, Debug)]
pub(super) enum Bound {
    /// y → 0: x → ∞ on the generic family, the pitchfork over a group without r.
    Zero,
    /// y → ∞: x → 0 on the generic family, x → ∞ over a group without r.
    Infinity,
    /// A cusp, a pitchfork, or the middle between two moments.
    At(Place),
}

/// A stretch of a piece on one half; x is monotone in y.
#[derive(Clone, Debug)]
pub(super) struct Segment {
    pub half: Half,
    /// Ends by rising x.
    pub ends: [Bound; 2],
}

impl Segment {
    /// x rises with y.
    pub fn is_rising(&self) -> bool {
        match &self.ends {
            [Bound::Zero, _] | [_, Bound::Infinity] => true,
            [Bound::Infinity, _] | [_, Bound::Zero] => false,
            [Bound::At(from), Bound::At(to)] => from.lo < to.lo,
        }
    }

    /// Where h − x/a goes when the segment ends at infinity on the generic family.
    fn limit(&self) -> Option<Limit> {
        match self.half {
            Half::Generic { base, sign } => Some(Limit { group: base, side: sign }),
            Half::Over { .. } => None,
        }
    }
}

/// A curve over which x is a coordinate.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub branch: Branch,
    /// Number of the piece on its branch, from 1, by rising parameter.
    pub piece: usize,
    pub orbit: Orbit,
    pub pole: Option<Pole>,
    pub shape: Shape,
    pub ends: [End; 2],
    /// The group at whose axis it ends for x → ∞.
    pub limit: Option<Limit>,
    /// μ ≥ the largest moment: the global minimum (see the module's head of `certified`).
    pub lowest: bool,
}

/// h − x/a → −`side`·√q for x → ∞.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Limit {
    pub group: usize,
    /// Positive at +e, negative at −e, zero for a group without r.
    pub side: Sign,
}

#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// By rising x.
    Family(Vec<Segment>),
    /// γ = ± r̂: h = x/J_r ∓ r.
    Pole(Pole),
    /// r = 0: h = x/a.
    Euler { group: usize },
}

/// Two curves end at a common point.
#[derive(Clone, Debug)]
pub(super) struct Cusp {
    pub place: Place,
    pub curves: [CurveId; 2],
    /// The curves lie at larger x.
    pub opens: bool,
}

/// A pair (or circle) over a group leaves a curve.
#[derive(Clone, Debug)]
pub(super) struct Pitchfork {
    pub group: usize,
    /// On the generic family; `None` when r lies on an axis.
    pub place: Option<Place>,
    /// The curve before and after, by rising x.
    pub through: [CurveId; 2],
    pub pair: CurveId,
    /// The pair lies at larger x.
    pub opens: bool,
}

/// The curves of a body.
#[derive(Clone, Debug)]
pub(super) struct Curves {
    pub list: Table<CurveId, Curve>,
    pub cusps: Table<CuspId, Cusp>,
    pub pitchforks: Table<PitchforkId, Pitchfork>,
    /// The one place where dJ/dμ = 0 on the generic family.
    pub inflection: Option<(usize, Place)>,
    /// Degenerate points that are no cusp (roots of even multiplicity) or that coincide with a pitchfork.
    pub degenerate: Vec<Place>,
}

/// Roots lie closer together than isolation goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NotIsolated;

/// A chart of the generic family: y in (0, limit], or (0, ∞).
struct Chart {
    half: Half,
    limit: Option<RBig>,
}

/// The interval of μ with this number: charts by rising μ.
fn charts(model: &Model, number: usize) -> Vec<Chart> {
    let left = number.checked_sub(1).map(|n| model.active[n]);
    let right = model.active.get(number).copied();
    match (left, right) {
        (Some(left), Some(right)) => {
            let middle = model.difference(right, left) / RBig::from(2);
            vec![
                Chart { half: Half::Generic { base: left, sign: Sign::Positive }, limit: Some(middle.clone()) },
                Chart { half: Half::Generic { base: right, sign: Sign::Negative }, limit: Some(middle) },
            ]
        }
        (None, Some(base)) => vec![Chart { half: Half::Generic { base, sign: Sign::Negative }, limit: None }],
        (Some(base), None) => vec![Chart { half: Half::Generic { base, sign: Sign::Positive }, limit: None }],
        (None, None) => Vec::new(),
    }
}

/// Roots of a polynomial in μ on one interval of the generic family, by rising μ. A root in the very middle between two
/// moments is given once, on the left half.
pub(super) fn roots_in_interval(
    model: &Model,
    polynomial: &Polynomial,
    number: usize,
    bits: usize,
) -> Result<Vec<(Place, bool)>, NotIsolated> {
    let mut found = Vec::new();
    for chart in charts(model, number) {
        let Half::Generic { base, sign } = chart.half else { continue };
        let scale = chart.limit.clone().unwrap_or(RBig::ONE);
        let oriented = sign.orient(scale.clone());
        let local = polynomial.composed(model.a(base), &oriented);
        let mut roots =
            if chart.limit.is_some() { local.roots_in_unit() } else { local.positive_roots() }.ok_or(NotIsolated)?;
        if chart.limit.is_some() && sign == Sign::Positive && local.sign_at(&RBig::ONE) == Sign::Zero {
            roots.push(Root::exact(&local, RBig::ONE));
        }
        let mut places: Vec<(Place, bool)> = roots
            .into_iter()
            .map(|mut root| {
                root.refine(bits);
                let odd = root.odd;
                let (lo, hi) = (&root.lo * &scale, &root.hi * &scale);
                (Place { half: chart.half, lo, hi, root: Some(Arc::new(root)) }, odd)
            })
            .collect();
        if sign == Sign::Negative {
            places.reverse();
        }
        found.extend(places);
    }
    Ok(found)
}

/// A place where a branch is cut or changes its half.
#[derive(Clone)]
enum Station {
    Cusp(Place),
    Pitchfork(Place, usize),
    Middle([Place; 2]),
}

/// What ends at a station and begins there.
struct Stop {
    bound: Bound,
    /// The end of the curve; `None` where only the half changes.
    end: Option<End>,
    /// Where the next segment begins.
    next: Option<Place>,
}

impl Stop {
    fn at(place: &Place, end: End) -> Self {
        Self { bound: Bound::At(place.clone()), end: Some(end), next: Some(place.clone()) }
    }
}

impl Station {
    fn place(&self) -> &Place {
        match self {
            Self::Cusp(place) | Self::Pitchfork(place, _) => place,
            Self::Middle(places) => &places[0],
        }
    }
}

/// Order on an interval of the generic family: by rising μ; `None` when the enclosures overlap.
pub(super) fn order(model: &Model, p: &Place, q: &Place) -> Option<std::cmp::Ordering> {
    use std::cmp::Ordering::{Greater, Less};
    let (Half::Generic { .. }, Half::Generic { .. }) = (p.half, q.half) else {
        return match (&p.lo, &p.hi, &q.lo, &q.hi) {
            (_, a, b, _) if a < b => Some(Less),
            (a, _, _, b) if a > b => Some(Greater),
            _ => None,
        };
    };
    let ([a, b], [c, d]) = (p.mu(model), q.mu(model));
    if b < c {
        Some(Less)
    } else if d < a {
        Some(Greater)
    } else {
        None
    }
}

impl Place {
    pub fn exact(half: Half, y: RBig) -> Self {
        Self { half, lo: y.clone(), hi: y, root: None }
    }

    /// The range of μ.
    pub fn mu(&self, model: &Model) -> [RBig; 2] {
        match self.half {
            Half::Generic { base, sign: Sign::Positive } => [model.a(base) + &self.lo, model.a(base) + &self.hi],
            Half::Generic { base, .. } => [model.a(base) - &self.hi, model.a(base) - &self.lo],
            Half::Over { group } => [model.a(group).clone(), model.a(group).clone()],
        }
    }
}

impl Curve {
    /// Its name.
    pub fn name(&self, frame: &Frame) -> CurveName {
        CurveName::on(BranchName::of(frame, self.branch), self.piece)
    }
}

impl Curves {
    /// The curves of a body, with the bits of a proof.
    pub fn of(model: &Model) -> Result<Self, NotIsolated> {
        Self::new(model, ROOT_BITS)
    }

    /// Isolates all cusps (to `bits` bits) and cuts the families.
    pub fn new(model: &Model, bits: usize) -> Result<Self, NotIsolated> {
        let mut curves = Self {
            list: Table::new(),
            cusps: Table::new(),
            pitchforks: Table::new(),
            inflection: None,
            degenerate: Vec::new(),
        };
        match model.active.len() {
            0 => curves.add_euler(model),
            1 => curves.add_lines(model),
            _ => curves.add_generic(model, bits)?,
        }
        curves.add_pairs(model);
        if model.active.len() > 1 {
            curves.add_pole_lines();
        }
        Ok(curves)
    }

    fn add_euler(&mut self, model: &Model) {
        for (group, eigenspace) in model.groups.iter().enumerate() {
            self.list.push(Curve {
                branch: Branch::Symmetric(model.axis[group]),
                piece: 1,
                orbit: orbit(eigenspace.size, model.axis[group]),
                pole: None,
                shape: Shape::Euler { group },
                ends: [End::Origin, End::Infinity],
                limit: None,
                lowest: group + 1 == model.groups.len(),
            });
        }
    }

    /// r on a principal axis: the lines γ = ∓r̂, cut where a pair leaves them: μ = a ∓ r/s passes a_k at
    /// x = a² r/(2 |a_k − a|).
    fn add_lines(&mut self, model: &Model) {
        let axis = model.active[0];
        for (side, pole) in [(0, Pole::Minus), (1, Pole::Plus)] {
            let mut cuts: Vec<usize> = model.passive.iter().copied().filter(|&k| (k > axis) == (side == 1)).collect();
            // x falls with |a_k − a|.
            cuts.sort_by_key(|&k| std::cmp::Reverse(k.abs_diff(axis)));
            let first = self.list.len();
            let mut from = End::Origin;
            for piece in 0..=cuts.len() {
                let to = cuts
                    .get(piece)
                    .map_or(End::Infinity, |_| End::Pitchfork(PitchforkId::at(self.pitchforks.len() + piece)));
                self.list.push(Curve {
                    branch: Branch::Axis(pole),
                    piece: piece + 1,
                    orbit: Orbit::Point,
                    pole: Some(pole),
                    shape: Shape::Pole(pole),
                    ends: [from, to],
                    limit: None,
                    // Beyond the first cut μ has passed the largest moment.
                    lowest: side == 1 && (piece == 0 || cuts.is_empty()),
                });
                from = to;
            }
            for (piece, &group) in cuts.iter().enumerate() {
                let through = [first + piece, first + piece + 1].map(CurveId::at);
                self.pitchforks.push(Pitchfork { group, place: None, through, pair: through[0], opens: true });
            }
        }
    }

    fn add_generic(&mut self, model: &Model, bits: usize) -> Result<(), NotIsolated> {
        let polynomial = model.cusp_polynomial();
        let bend = model.inflection_polynomial();
        let last = model.active.len();
        for number in 0..=last {
            let roots = roots_in_interval(model, &polynomial, number, bits)?;
            if let Some(bend) = bend.as_ref().filter(|_| number > 0 && number < last)
                && let Some((place, _)) = roots_in_interval(model, bend, number, bits)?.into_iter().next()
            {
                self.inflection = Some((number, place));
            }
            let mut stations: Vec<Station> = Vec::new();
            for (place, odd) in roots {
                if odd {
                    stations.push(Station::Cusp(place));
                } else {
                    self.degenerate.push(place);
                }
            }
            for &group in &model.passive {
                if let Some(place) = passive_place(model, number, group) {
                    stations.push(Station::Pitchfork(place, group));
                }
            }
            if let [left, right] = &charts(model, number)[..]
                && let (Some(l), Some(r)) = (&left.limit, &right.limit)
            {
                let places = [Place::exact(left.half, l.clone()), Place::exact(right.half, r.clone())];
                stations.push(Station::Middle(places));
            }
            let mut overlap = None;
            stations.sort_by(|p, q| {
                order(model, p.place(), q.place()).unwrap_or_else(|| {
                    if rank(p).max(rank(q)) < MIDDLE {
                        overlap = Some(p.place().clone());
                    }
                    // A station in the very middle comes first and begins the right half.
                    rank(p).cmp(&rank(q))
                })
            });
            self.degenerate.extend(overlap);
            self.cut(model, number, &stations);
        }
        Ok(())
    }

    /// Turns the stations of an interval of the generic family into curves.
    fn cut(&mut self, model: &Model, number: usize, stations: &[Station]) {
        let charts = charts(model, number);
        let last = model.active.len();
        let mut half = charts[0].half;
        // Rising μ: towards larger x on the first interval, away from it elsewhere, and the other way after each cusp.
        let mut rising = number == 0;
        let mut start = if number == 0 { Bound::Infinity } else { Bound::Zero };
        let mut start_end = if number == 0 { End::Origin } else { End::Infinity };
        let mut segments: Vec<Segment> = Vec::new();
        let mut piece = 0;
        for index in 0..=stations.len() {
            let station = stations.get(index);
            let Stop { bound, end, next } = self.stop(station, number == last);
            let same_place = matches!((&start, &bound), (Bound::At(p), Bound::At(q)) if p.half == q.half && p.lo == q.lo && p.hi == q.hi);
            if !same_place {
                let ends = if rising { [start.clone(), bound.clone()] } else { [bound.clone(), start.clone()] };
                segments.push(Segment { half, ends });
            }
            if let Some(next) = &next {
                half = next.half;
                start = Bound::At(next.clone());
            }
            let Some(end) = end else { continue };
            piece += 1;
            let this = self.list.next_id();
            let mut done = std::mem::take(&mut segments);
            let mut ends = [start_end, end];
            if !rising {
                done.reverse();
                ends.reverse();
            }
            let limit = if ends[1] == End::Infinity { done.last().and_then(Segment::limit) } else { None };
            // Beyond the last pitchfork only, where a group without r has the largest moment.
            let ends_in_pair = model.passive.iter().max().is_some_and(|&top| top > model.active[last - 1]);
            let lowest = number == last && (!ends_in_pair || station.is_none());
            self.join(start_end, this, rising);
            self.list.push(Curve {
                branch: Branch::Generic(IntervalId::at(number)),
                piece,
                orbit: Orbit::Point,
                pole: None,
                shape: Shape::Family(done),
                ends,
                limit,
                lowest,
            });
            self.enter(station, this, rising);
            rising ^= matches!(station, Some(Station::Cusp(_)));
            start_end = end;
        }
    }

    /// What a station, or the end of the interval after the last one, ends and begins.
    fn stop(&self, station: Option<&Station>, at_origin: bool) -> Stop {
        match station {
            None if at_origin => Stop { bound: Bound::Infinity, end: Some(End::Origin), next: None },
            None => Stop { bound: Bound::Zero, end: Some(End::Infinity), next: None },
            Some(Station::Middle([left, right])) => {
                Stop { bound: Bound::At(left.clone()), end: None, next: Some(right.clone()) }
            }
            Some(Station::Cusp(place)) => Stop::at(place, End::Cusp(self.cusps.next_id())),
            Some(Station::Pitchfork(place, _)) => Stop::at(place, End::Pitchfork(self.pitchforks.next_id())),
        }
    }

    /// Enters the cusp or pitchfork at which the curve `this` ends; the next curve and the pair are not known yet.
    fn enter(&mut self, station: Option<&Station>, this: CurveId, rising: bool) {
        match station {
            Some(Station::Cusp(place)) => {
                self.cusps.push(Cusp { place: place.clone(), curves: [this; 2], opens: !rising });
            }
            Some(Station::Pitchfork(place, group)) => {
                let place = Some(place.clone());
                self.pitchforks.push(Pitchfork { group: *group, place, through: [this; 2], pair: this, opens: true });
            }
            Some(Station::Middle(_)) | None => {}
        }
    }

    /// Enters `this` as the curve after a cut.
    fn join(&mut self, cut: End, this: CurveId, rising: bool) {
        match cut {
            End::Cusp(cusp) => self.cusps[cusp].curves[1] = this,
            End::Pitchfork(pitchfork) => self.pitchforks[pitchfork].through[usize::from(rising)] = this,
            End::Origin | End::Infinity => {}
        }
    }

    /// The pairs and circles over groups without r: v = s² from P̂ on, with a cusp at v = −3R̂/a if that lies beyond.
    fn add_pairs(&mut self, model: &Model) {
        if model.active.is_empty() {
            return;
        }
        for &group in &model.passive {
            let Some((number, _)) = self.pitchforks.pairs().find(|(_, p)| p.group == group) else { continue };
            let half = Half::Over { group };
            let (r_sum, p_sum) = model.sums_over(group);
            let turn = r_sum * RBig::from(-3) / model.a(group) - p_sum;
            let axis = model.axis[group];
            let orbit = orbit(model.groups[group].size, axis);
            let first = self.list.next_id();
            let lowest = group + 1 == model.groups.len();
            let limit = Some(Limit { group, side: Sign::Zero });
            let curve = |piece, ends: [Bound; 2], marks, limit| Curve {
                branch: Branch::Symmetric(axis),
                piece,
                orbit,
                pole: None,
                shape: Shape::Family(vec![Segment { half, ends }]),
                ends: marks,
                limit,
                lowest,
            };
            if turn > RBig::ZERO {
                let place = Place::exact(half, turn);
                let at = || Bound::At(place.clone());
                let cusp = End::Cusp(self.cusps.next_id());
                self.list.push(curve(1, [at(), Bound::Zero], [cusp, End::Pitchfork(number)], None));
                let second = self.list.push(curve(2, [at(), Bound::Infinity], [cusp, End::Infinity], limit));
                self.cusps.push(Cusp { place, curves: [first, second], opens: true });
                self.pitchforks[number].opens = false;
            } else {
                let marks = [End::Pitchfork(number), End::Infinity];
                self.list.push(curve(1, [Bound::Zero, Bound::Infinity], marks, limit));
            }
            self.pitchforks[number].pair = first;
        }
    }

    fn add_pole_lines(&mut self) {
        for pole in [Pole::Plus, Pole::Minus] {
            self.list.push(Curve {
                branch: Branch::Pole(pole),
                piece: 1,
                orbit: Orbit::Pole(pole),
                pole: Some(pole),
                shape: Shape::Pole(pole),
                ends: [End::Origin, End::Infinity],
                limit: None,
                lowest: false,
            });
        }
    }
}

/// The rank of [`Station::Middle`].
const MIDDLE: u8 = 2;

fn rank(station: &Station) -> u8 {
    match station {
        Station::Cusp(_) => 0,
        Station::Pitchfork(..) => 1,
        Station::Middle(_) => MIDDLE,
    }
}

fn orbit(size: usize, axis: Axis) -> Orbit {
    match size {
        1 => Orbit::Pair(axis),
        2 => Orbit::Circle(axis),
        _ => Orbit::Sphere,
    }
}

/// μ = a_k of a group without r, if it lies in the interval.
pub(super) fn passive_place(model: &Model, number: usize, group: usize) -> Option<Place> {
    let mu = model.a(group);
    charts(model, number).into_iter().find_map(|chart| {
        let Half::Generic { base, sign } = chart.half else { return None };
        let delta = mu - model.a(base);
        let y = sign.orient(delta);
        let inside = y > RBig::ZERO && chart.limit.is_none_or(|limit| y <= limit);
        inside.then(|| Place::exact(chart.half, y))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use top::body::{Body, Preset};
    use top::curves::CriticalSet;

    fn compare(body: &Body) {
        let frame = body.frame();
        let model = Model::new(body, &frame);
        let curves = Curves::new(&model, 80).unwrap();
        let set = CriticalSet::new(frame).unwrap();
        let mut names: Vec<_> =
            curves.list.iter().map(|c| format!("{:?} {} {:?}", c.branch, c.piece, c.orbit)).collect();
        let mut expected: Vec<_> =
            set.curves.iter().map(|c| format!("{:?} {} {:?}", c.branch, c.piece, c.orbit)).collect();
        names.sort();
        expected.sort();
        assert_eq!(names, expected);
        assert_eq!(curves.cusps.len(), set.cusps.len());
        assert_eq!(curves.pitchforks.len(), set.pitchforks.len());
        for curve in &curves.list {
            let other = set.curves.iter().find(|c| c.branch == curve.branch && c.piece == curve.piece).unwrap();
            let end = |end: End| match end {
                End::Origin => "o",
                End::Infinity => "i",
                End::Cusp(_) => "c",
                End::Pitchfork(_) => "p",
            };
            let other_end = |end: top::curves::End| match end {
                top::curves::End::Origin => "o",
                top::curves::End::Infinity => "i",
                top::curves::End::Cusp(_) => "c",
                top::curves::End::Pitchfork(_) => "p",
            };
            assert_eq!(curve.ends.map(end), other.ends.map(other_end), "{curve:?}");
        }
    }

    #[test]
    fn the_curves_are_those_of_the_closed_form() {
        for preset in Preset::all() {
            compare(&preset.body());
        }
        for (a, r) in [
            (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
            (["1", "2", "3"], ["0.5", "0", "0.5"]),
            (["1", "1", "3"], ["0.5", "0", "0.5"]),
            (["1", "1", "3"], ["0", "0", "0.5"]),
        ] {
            compare(&Body::parse(&a, &r).unwrap());
        }
    }

    #[derive(serde::Deserialize)]
    struct Oracle {
        #[serde(rename = "A")]
        a: [String; 3],
        r: [String; 3],
        cusps: Vec<String>,
        poles: Vec<String>,
    }

    /// The roots that FLINT isolates (data/oracles/roots.py): as many, in the same places.
    #[test]
    fn roots_are_those_of_flint() {
        let value = |text: &str| text.parse::<top::body::Number>().unwrap().value().clone();
        let mut compared = 0;
        for line in support::data("oracles/roots.jsonl").lines() {
            let oracle: Oracle = serde_json::from_str(line).unwrap();
            let body = Body::parse(&oracle.a, &oracle.r).unwrap();
            let frame = body.frame();
            let model = Model::new(&body, &frame);
            let unit = RBig::try_from(frame.momentum_unit * frame.momentum_unit / frame.energy_unit).unwrap();
            let [_, pole] = model.pole_polynomials();
            for (polynomial, expected) in [(model.cusp_polynomial(), &oracle.cusps), (pole, &oracle.poles)] {
                let mut found: Vec<[RBig; 2]> = Vec::new();
                for number in 0..=model.active.len() {
                    let roots = roots_in_interval(&model, &polynomial, number, 110).unwrap();
                    found.extend(roots.into_iter().filter(|(_, odd)| *odd).map(|(place, _)| place.mu(&model)));
                }
                assert_eq!(found.len(), expected.len(), "{line}");
                for ([lo, hi], text) in found.into_iter().zip(expected) {
                    let (at, slack) = (value(text), RBig::from_parts(1.into(), 10u8.into()).pow(25));
                    let (lo, hi) = (lo * &unit, hi * &unit);
                    assert!(&lo - &slack <= at && at <= &hi + &slack, "{text} {line}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 250, "{compared}");
    }
}
