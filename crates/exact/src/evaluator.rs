//! The point of a curve over x, enclosed.

use std::borrow::Cow;
use std::cell::{Cell, OnceCell};

use super::curves::{Bound, Curve, Curves, Segment, Shape};
use super::estimate::Estimate;
use super::family::{Half, State};
use super::model::{Constants, Model};
use bifdiag_equilibria::curves::{CurveId, Pole};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::root::{Bracket, newton_bracketed};
use bifdiag_numbers::table::Table;
use bifdiag_numbers::wide::{Interval128, Interval384};

/// A curve passes exactly through the end of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Passage {
    /// The curve that ends there, with the lower end (0) or the upper (1).
    pub curve: CurveId,
    pub side: usize,
    /// The curve that passes.
    pub other: CurveId,
}

/// Everything that is needed to evaluate curves in one arithmetic.
#[derive(Clone, Debug)]
pub(super) struct Evaluator<'a, E: Enclosure> {
    pub model: &'a Model,
    pub curves: &'a Curves,
    pub c: Constants<E>,
    estimate: Constants<Estimate>,
    /// The ends of each curve's segments.
    ends: Table<CurveId, Vec<Ends<E>>>,
    meetings: Vec<Passage>,
    /// How many more points a question may ask for.
    left: Cell<u32>,
}

/// Evaluators in growing precision, each made when first needed.
pub(super) struct Evaluators<'a> {
    model: &'a Model,
    curves: &'a Curves,
    meetings: &'a [Passage],
    narrow: OnceCell<Evaluator<'a, Interval>>,
    middle: OnceCell<Evaluator<'a, Interval128>>,
    wide: OnceCell<Evaluator<'a, Interval384>>,
}

impl<'a> Evaluators<'a> {
    pub fn new(model: &'a Model, curves: &'a Curves, meetings: &'a [Passage]) -> Self {
        let (narrow, middle, wide) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Self { model, curves, meetings, narrow, middle, wide }
    }

    pub fn narrow(&self) -> &Evaluator<'a, Interval> {
        self.narrow.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }

    pub fn middle(&self) -> &Evaluator<'a, Interval128> {
        self.middle.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }

    pub fn wide(&self) -> &Evaluator<'a, Interval384> {
        self.wide.get_or_init(|| Evaluator::new(self.model, self.curves, self.meetings, ()))
    }
}

/// The ends of a segment, by rising x; y and x themselves only where they can be evaluated.
#[derive(Clone, Debug)]
struct Ends<E> {
    y: [Option<E>; 2],
    x: [Option<E>; 2],
    y_estimate: [f64; 2],
    x_estimate: [f64; 2],
}

/// A point of a curve over x.
#[derive(Clone, Debug)]
pub(super) struct Point<E: Enclosure> {
    /// The x that was asked for.
    pub x: E,
    /// Half and the range of y that holds the solution; `None` on a line.
    pub place: Option<(Half, E)>,
    /// All states of that range; holds the state at x.
    pub over: State<E>,
    /// One state of the range.
    pub at: State<E>,
    /// h(x) − (x/J − ρ) of `at`: of second order.
    pub correction: E,
    /// A critical point (not merely on a pole line).
    pub critical: bool,
}

impl<E: Enclosure> Point<E> {
    pub fn h(&self) -> E {
        self.x.clone() / self.at.j.clone() - self.at.rho.clone() + self.correction.clone()
    }

    /// The point where a curve ends.
    pub fn at_end(half: Half, y: E, state: State<E>, c: &Constants<E>) -> Self {
        let (x, correction) = (state.x.clone(), c.small(0));
        Self { x, place: Some((half, y)), over: state.clone(), at: state, correction, critical: true }
    }

    /// h − x/a of a moment.
    pub fn h_above(&self, c: &Constants<E>, group: usize, a: &E) -> E {
        let n = self.at.gamma.len();
        // a − J about the moment itself.
        let excess = (0..n)
            .filter(|&k| k != group)
            .fold(c.small(0), |sum, k| sum + self.at.gamma[k].square() * c.diff[group][k].clone());
        self.x.clone() * excess / (self.at.j.clone() * a.clone()) - self.at.rho.clone() + self.correction.clone()
    }

    pub fn slope(&self, c: &Constants<E>) -> E {
        c.small(1) / self.over.j.clone()
    }
}

impl<'a, E: Enclosure> Evaluator<'a, E> {
    pub fn new(model: &'a Model, curves: &'a Curves, meetings: &[Passage], precision: E::Precision) -> Self {
        let (c, estimate) = (Constants::new(model, precision), Constants::new(model, ()));
        let (meetings, left) = (meetings.to_vec(), Cell::new(u32::MAX));
        let mut evaluator = Self { model, curves, c, estimate, ends: Table::new(), meetings, left };
        for curve in &curves.list {
            let segments = if let Shape::Family(segments) = &curve.shape { segments.as_slice() } else { &[] };
            let ends = segments.iter().map(|segment| evaluator.ends(segment)).collect();
            evaluator.ends.push(ends);
        }
        evaluator
    }

    fn ends(&self, segment: &Segment) -> Ends<E> {
        let y = segment.ends.each_ref().map(|end| self.bound(segment, end));
        let x = y.each_ref().map(|y| y.as_ref().map(|y| self.x(segment.half, y)));
        let estimate = |end: &Bound| match end {
            Bound::Zero => 0.0,
            Bound::Infinity => f64::INFINITY,
            Bound::At(place) => 0.5 * (place.lo.to_f64().value() + place.hi.to_f64().value()),
        };
        let y_estimate = segment.ends.each_ref().map(estimate);
        let x_of = |y: f64| match segment.half {
            Half::Generic { .. } if y == 0.0 => f64::INFINITY,
            Half::Generic { .. } if y.is_infinite() => 0.0,
            Half::Over { .. } if y.is_infinite() => f64::INFINITY,
            half => State::x_at(self.model, &self.estimate, half, &Estimate(y)).0,
        };
        Ends { y, x, y_estimate, x_estimate: y_estimate.map(x_of) }
    }

    /// The next question may ask for at most this many points.
    pub fn allow(&self, points: u32) {
        self.left.set(points);
    }

    /// It is proved that a curve passes through this end of another.
    pub fn meet_at(&self, passage: Passage) -> bool {
        self.meetings.contains(&passage)
    }

    pub fn state(&self, half: Half, y: &E) -> State<E> {
        State::at(self.model, &self.c, half, y)
    }

    fn x(&self, half: Half, y: &E) -> E {
        State::x_at(self.model, &self.c, half, y)
    }

    /// y of a bound, as a range; `None` at a limit that cannot be evaluated.
    pub fn bound(&self, segment: &Segment, bound: &Bound) -> Option<E> {
        match bound {
            Bound::Zero if matches!(segment.half, Half::Over { .. }) => Some(self.c.small(0)),
            Bound::Zero | Bound::Infinity => None,
            Bound::At(place) => Some(self.place(place)),
        }
    }

    pub fn place(&self, place: &super::curves::Place) -> E {
        let number = |y| E::rational(y, self.c.precision);
        number(&place.lo).hull(&number(&place.hi))
    }

    /// The point of a curve over x. `None` when it cannot be enclosed with these bits, x is not surely inside the
    /// curve's range, or the question has asked for as many points as it may.
    pub fn point(&self, curve: CurveId, x: &E) -> Option<Point<E>> {
        self.left.set(self.left.get().checked_sub(1)?);
        match &self.curves.list[curve].shape {
            Shape::Family(segments) => self.family_point(curve, segments, x),
            Shape::Pole(pole) => Some(self.line_point(&self.curves.list[curve], *pole, x)),
            Shape::Euler { group } => Some(self.euler_point(*group, x)),
        }
    }

    fn line_point(&self, curve: &Curve, pole: Pole, x: &E) -> Point<E> {
        let c = &self.c;
        let j = c.j_r.clone().unwrap_or_else(|| c.small(1));
        let sign = |e: E| if pole == Pole::Plus { e } else { -e };
        let n = self.model.groups.len();
        let gamma: Vec<E> = (0..n).map(|k| sign(c.root_q[k].clone() / c.r.clone())).collect();
        let s = c.small(2) * x.clone() / j.square();
        // On a critical line μ = a ± r/s.
        let shift = sign(c.r.clone() / s.clone());
        let base = self.model.active[0];
        let tau = (0..n).map(|k| c.diff[base][k].clone() + shift.clone()).collect();
        let zero = c.small(0);
        let state = State {
            gamma,
            j,
            rho: sign(c.r.clone()),
            x: x.clone(),
            tau,
            log_slope: zero.clone(),
            j_slope: zero.clone(),
        };
        let critical = !matches!(curve.orbit, bifdiag_equilibria::curves::Orbit::Pole(_));
        Point { x: x.clone(), place: None, at: state.clone(), over: state, correction: zero, critical }
    }

    fn euler_point(&self, group: usize, x: &E) -> Point<E> {
        let c = &self.c;
        let n = self.model.groups.len();
        let zero = c.small(0);
        let j = c.a[group].clone();
        let state = State {
            gamma: (0..n).map(|k| c.small(i32::from(k == group))).collect(),
            j,
            rho: zero.clone(),
            x: x.clone(),
            tau: (0..n).map(|k| c.diff[group][k].clone()).collect(),
            log_slope: zero.clone(),
            j_slope: zero.clone(),
        };
        Point { x: x.clone(), place: None, at: state.clone(), over: state, correction: zero, critical: true }
    }

    fn family_point(&self, curve: CurveId, segments: &[Segment], x: &E) -> Option<Point<E>> {
        let [low, high] = x.bounds();
        let middle = if high.is_finite() { 0.5 * (low + high) } else { low };
        let ends = &self.ends[curve];
        let number = (0..segments.len()).find(|&k| middle <= ends[k].x_estimate[1]).unwrap_or(segments.len() - 1);
        // The middle between two moments may lie the other way of a rounding.
        (0..segments.len()).filter(|&k| k == number || k + 1 == number || k == number + 1).find_map(|k| {
            let ends = Self::open_at_joints(&ends[k], [k > 0, k + 1 < segments.len()], x);
            self.segment_point(&segments[k], &ends, x, middle)
        })
    }

    /// The ends of a segment, without y where the curve continues in the next one and x may lie there: the point is
    /// then also searched beyond the end.
    fn open_at_joints<'b>(ends: &'b Ends<E>, joints: [bool; 2], x: &E) -> Cow<'b, Ends<E>> {
        let is_inside = |side: usize| {
            ends.x[side].as_ref().is_some_and(|end| if side == 0 { end.is_below(x) } else { x.is_below(end) })
        };
        let mut open = Cow::Borrowed(ends);
        for side in [0, 1] {
            if joints[side] && !is_inside(side) {
                open.to_mut().y[side] = None;
            }
        }
        open
    }

    fn segment_point(&self, segment: &Segment, ends: &Ends<E>, x: &E, target: f64) -> Option<Point<E>> {
        let half = segment.half;
        // x lies between the x of the segment's ends (up to the enclosure of an end itself).
        let [from, to] = &ends.x;
        if from.as_ref().is_some_and(|from| x.is_below(from)) || to.as_ref().is_some_and(|to| to.is_below(x)) {
            return None;
        }
        let guess = self.guess(half, ends.y_estimate, ends.x_estimate, target);
        let y = self.refined(half, guess, x);
        let near = self.sides(segment, ends, &y, x);
        let sides = match near {
            Some(sides) if Self::converged(&sides, &self.c) => sides,
            near => {
                let bracketed = self.bisected(segment, ends, x).and_then(|y| self.sides(segment, ends, &y, x));
                bracketed.or(near)?
            }
        };
        let range = sides[0].hull(&sides[1]);
        let over = self.state(half, &range);
        let at = self.state(half, &range.middle());
        let one = self.c.small(1);
        let slopes = one.clone() / over.j.clone() - one / at.j.clone();
        let correction = (x.clone() - at.x.clone()) * slopes;
        Some(Point { x: x.clone(), place: Some((half, range)), at, over, correction, critical: true })
    }

    /// Two sides are as close as a guess that is a solution makes them, up to what a cusp costs, where x(y) is quadratic.
    fn converged(sides: &[E; 2], c: &Constants<E>) -> bool {
        let [low, high] = ((sides[1].clone() - sides[0].clone()) / sides[0].clone()).bounds();
        low.abs().max(high.abs()) < 16.0 * E::resolution(c.precision).sqrt()
    }

    /// Two y around the solution of x(y) = x, from a guess.
    fn sides(&self, segment: &Segment, ends: &Ends<E>, y: &E, x: &E) -> Option<[E; 2]> {
        /// Beside a cusp x changes little with y; further away than this nothing is close.
        const WIDEST: f64 = 0.05;
        let c = &self.c;
        let mut radius = E::resolution(c.precision);
        let (rising, outer) = (segment.is_rising(), &ends.y);
        let (mut sides, mut done) = ([y.clone(), y.clone()], [false, false]);
        // sides[0] towards smaller x, sides[1] towards larger x.
        while radius < WIDEST {
            let reach = y.clone() * E::double(radius, c.precision);
            for side in [0, 1] {
                if done[side] {
                    continue;
                }
                let upward = (side == 1) == rising;
                let candidate =
                    if upward { (y.clone() + reach.clone()).upper() } else { (y.clone() - reach.clone()).lower() };
                let before =
                    |bound: &E, up: bool| if up { candidate.is_below(bound) } else { bound.is_below(&candidate) };
                // Behind the other end of the segment x is that of another curve. (An end in the middle between two moments that
                // is left out does not count: as x is monotone up to the next end, a y whose x is beyond lies beyond
                // the solution.)
                if outer[1 - side].as_ref().is_some_and(|bound| !before(bound, !upward)) {
                    continue;
                }
                if let Some(bound) = outer[side].as_ref().filter(|bound| !before(bound, upward)) {
                    // The solution lies before the end of the segment, if x lies before x of that end.
                    sides[side] = if upward { bound.upper() } else { bound.lower() };
                    done[side] = true;
                    continue;
                }
                if candidate.sign() != Some(Sign::Positive) {
                    return None;
                }
                let reached = self.x(segment.half, &candidate);
                done[side] = if side == 0 { reached.is_below(x) } else { x.is_below(&reached) };
                sides[side] = candidate;
            }
            if done == [true, true] {
                return Some(sides);
            }
            radius *= 16.0;
        }
        None
    }

    /// y of x, not proved: Newton's method doubles the digits of a guess good to ten.
    fn refined(&self, half: Half, guess: f64, x: &E) -> E {
        let c = &self.c;
        let mut y = E::double(guess, c.precision);
        let mut digits = 1e-12;
        while digits > E::resolution(c.precision) {
            let state = self.state(half, &y);
            let residual = x.middle() / state.x - c.small(1);
            let step = residual / state.log_slope;
            y = (y + step).middle();
            digits *= digits;
        }
        y
    }

    /// y of x, not proved, where doubles do not separate it from an end of the segment: Newton's method inside a bracket.
    fn bisected(&self, segment: &Segment, ends: &Ends<E>, x: &E) -> Option<E> {
        const STEPS: usize = 600;
        let c = &self.c;
        let rising = segment.is_rising();
        let [small, large] = if rising { [0, 1] } else { [1, 0] };
        let side = |which: usize| ends.y[which].as_ref().map(Enclosure::middle);
        let mut low = side(small).unwrap_or_else(|| c.small(0));
        let mut high = side(large);
        let target = x.middle();
        let mut next: Option<E> = None;
        for _ in 0..STEPS {
            let middle = || match &high {
                Some(high) if low.sign() == Some(Sign::Zero) => {
                    (high.clone() * E::double(0.0625, c.precision)).middle()
                }
                Some(high) => low.hull(high).middle(),
                None => (low.clone() * c.small(16) + c.small(1)).middle(),
            };
            let inside = |y: &E| low.is_below(y) && high.as_ref().is_none_or(|high| y.is_below(high));
            let y = next.take().filter(inside).unwrap_or_else(middle);
            if y.sign() != Some(Sign::Positive) {
                return None;
            }
            let state = self.state(segment.half, &y);
            let residual = target.clone() / state.x.clone() - c.small(1);
            let step = (residual.clone() / state.log_slope).middle();
            let [lo, hi] = (step.clone() / y.clone()).bounds();
            if lo.abs().max(hi.abs()) < 16.0 * E::resolution(c.precision) {
                return Some((y + step).middle());
            }
            match residual.sign() {
                Some(sign) if (sign == Sign::Positive) == rising => low = y.clone(),
                Some(_) => high = Some(y.clone()),
                None => return Some(y),
            }
            next = Some((y + step).middle());
        }
        None
    }

    fn guess(&self, half: Half, y: [f64; 2], x: [f64; 2], target: f64) -> f64 {
        let start = match half {
            Half::Generic { .. } if y[0].is_infinite() || y[1] == 0.0 => y[0].min(y[1]),
            _ if x[1].is_finite() && x[1] > x[0] => {
                y[0] + (y[1] - y[0]) * ((target - x[0]) / (x[1] - x[0])).clamp(0.0, 1.0).sqrt()
            }
            _ => 0.0,
        };
        newton_bracketed(Bracket { negative: y[0], positive: y[1] }, start, 4.0 * f64::EPSILON, |at| {
            let state = State::at(self.model, &self.estimate, half, &Estimate(at));
            (1.0 - target / state.x.0, target / state.x.0 * state.log_slope.0)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Body;
    use bifdiag_equilibria::curves::CriticalSet;
    use bifdiag_numbers::enclosure::Arithmetic;
    use bifdiag_numbers::wide::Wide;
    use dashu_ratio::RBig;

    fn compare<E: Enclosure>(precision: E::Precision, width: f64) {
        let mut compared = 0;
        for (a, r) in [
            (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
            (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
            (["1", "1.3", "1.9"], ["0.8", "1e-6", "0.6"]),
            (["1", "0.7", "0.5"], ["1", "0", "0"]),
        ] {
            let body = Body::parse(&a, &r).unwrap();
            let frame = body.frame();
            let model = Model::new(&body, &frame);
            let curves = Curves::new(&model, 200).unwrap();
            let set = CriticalSet::new(frame).unwrap();
            let evaluator = Evaluator::<E>::new(&model, &curves, &[], precision);
            for x in [0.2, 0.7, 1.7, 3.1, 5.3, 8.8, 40.0, 1e7] {
                let x_set = E::double(x, precision);
                let mut points: Vec<(Point<E>, f64)> = Vec::new();
                for (number, curve) in curves.list.pairs() {
                    let other = set.curves.iter().find(|c| c.branch == curve.branch && c.piece == curve.piece).unwrap();
                    if x <= other.x()[0] * 1.001 || x >= other.x()[1] * 0.999 {
                        continue;
                    }
                    let point = evaluator.point(number, &x_set).unwrap();
                    let [lo, hi] = point.h().bounds();
                    let expected = other.point(&set.frame, x);
                    let slack = expected.h_error();
                    assert!(
                        lo - slack <= expected.h() && expected.h() <= hi + slack,
                        "{x} {curve:?} [{lo}, {hi}] {}",
                        expected.h()
                    );
                    assert!(hi - lo <= width * (1.0 + x), "{}", hi - lo);
                    points.push((point, expected.h()));
                    compared += 1;
                }
                for (p, h) in &points {
                    for (q, k) in &points {
                        let [lo, hi] = evaluator.gap(p, q).bounds();
                        assert!(lo <= hi, "the two formulas for the gap contradict each other at {x}");
                        let slack = 1e-13 * (1.0 + x);
                        assert!(lo - slack <= h - k && h - k <= hi + slack);
                    }
                }
            }
        }
        assert!(compared > 100);
    }

    #[test]
    fn points_and_gaps_are_those_of_the_closed_form() {
        compare::<Interval>((), 1e-13);
        compare::<Wide>(160, 1e-14);
    }

    /// Behind a cusp x turns back, and there the other branch has the same x.
    #[test]
    fn beside_a_cusp_a_place_is_not_that_of_the_other_branch() {
        let mut seen = 0;
        for (a, r) in [(["2", "1.1", "1"], ["0.3", "0.5", "0.7"]), (["2", "1.1", "1"], ["0.94868", "0", "0.61623"])] {
            let body = Body::parse(&a, &r).unwrap();
            let model = Model::new(&body, &body.frame());
            let curves = Curves::of(&model).unwrap();
            let evaluator = Evaluator::<Interval128>::new(&model, &curves, &[], ());
            for cusp in &curves.cusps {
                let at = evaluator.place(&cusp.place);
                let [low, high] = evaluator.x(cusp.place.half, &at).exact_bounds().unwrap();
                for digits in 1..=30 {
                    let away = RBig::ONE / RBig::from(10).pow(digits);
                    let x = if cusp.opens { &high * (RBig::ONE + away) } else { &low * (RBig::ONE - away) };
                    let places = cusp.curves.map(|curve| {
                        let point = evaluator.point(curve, &Interval128::rational(&x, ()));
                        point.and_then(|point| point.place).filter(|(half, _)| *half == cusp.place.half)
                    });
                    let [Some((_, p)), Some((_, q))] = places else { continue };
                    // The cusp lies between the two, or at their ends.
                    let [p, q, middle] = [&p, &q, &at].map(|y| y.exact_bounds().unwrap());
                    let parted = |p: &[RBig; 2], q: &[RBig; 2]| p[0] >= middle[0] && q[1] <= middle[1];
                    assert!(parted(&p, &q) || parted(&q, &p), "{a:?} {r:?} {digits}");
                    seen += 1;
                }
            }
        }
        assert!(seen > 60, "{seen}");
    }
}
