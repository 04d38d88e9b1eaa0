//! What uncertain moments and weight do to the spins at which a rotation changes.
//!
//! With w = −ρ the roots of K_A, K_B and of the discriminant (see the head of this folder) are s = w/(C − A), w/(C − B) and, by
//! Proposition 13.7 of docs/algorithms.md, where p = 2A − C and q = 2B − C have one sign and w > 0,
//!
//! - s± = 2w (√(A|q|) ± √(B|p|))² / (C² (|p| + |q|)).
//!
//! Over a box of parts each of them lies in an interval. Outside these intervals no root lies for any part of the box, and
//! the box is connected: the type between two of them is that of one part.

use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use dashu_ratio::RBig;

use super::certain::AxisBox;
use super::rotation::{AxisRotation, SpinChange};
use bifdiag_body::Body;
use bifdiag_schema::SpinType;

/// The inputs that are varied, as they are reported.
pub const INPUTS: [&str; 4] =
    ["moment about the axis", "first other moment", "second other moment", "weight times distance"];

/// Parts that are tried at most: each input less, nominal and more.
pub const SAMPLES: usize = 81;

/// Into how many pieces each moment is cut, so that the intervals are narrow.
const PIECES: u32 = 20;

/// Spins at which a change may lie, over a box of parts.
#[derive(Clone, Debug, PartialEq)]
pub struct SpinRange {
    /// The type of every part at slower spins, down to the next range; `None` where the range begins at rest.
    pub from: Option<SpinType>,
    /// The type of every part at faster spins; `None` where the range has no end.
    pub to: Option<SpinType>,
    /// Bounds on the spins Ω: no part of the box changes outside all ranges.
    pub omega: [f64; 2],
    /// Types other than these two that some of the sampled parts have inside.
    pub between: Vec<SpinType>,
    /// The input that by itself moves the change of the nominal part in the range, the last of several, most, and how far in
    /// Ω: infinitely far where that change vanishes with it; `None` where the nominal part changes nowhere in it.
    pub most: Option<(&'static str, f64)>,
}

/// The ranges of spins, ascending and apart, in which rotation of a part may change its type when C, A, B and the weight are
/// known to relative tolerances below 1.
#[must_use]
pub fn spin_ranges(rotation: &AxisRotation, tolerances: &[RBig; 4]) -> Vec<SpinRange> {
    let around = |value: &RBig, tolerance: &RBig| [value * (RBig::ONE - tolerance), value * (RBig::ONE + tolerance)];
    let [lighter, heavier] = around(&rotation.weight, &tolerances[3]).map(|end| Interval::rational(&end, ()));
    let ends = std::array::from_fn(|k| around(&rotation.moments[k], &tolerances[k]));
    let whole = AxisBox::new(&ends, -lighter.hull(&heavier));
    let mut found = ranges_over(rotation, &[whole]);
    let nominal = rotation.changes();
    let parts: Vec<AxisRotation> = samples(tolerances).map(|steps| varied(rotation, steps, tolerances)).collect();
    let sampled: Vec<Vec<SpinChange>> = parts.iter().map(AxisRotation::changes).collect();
    for range in &mut found {
        let [low, high] = range.omega.map(|omega| omega * omega);
        let omega = range.omega;
        let within = |change: &SpinChange| omega[0] <= change.omega && change.omega <= omega[1];
        // A part that does not change inside has one type there.
        let unchanged = parts.iter().zip(&sampled).filter(|(_, changes)| !changes.iter().any(within));
        let unchanged = inside(low, high)
            .into_iter()
            .flat_map(|at| unchanged.clone().filter_map(move |(part, _)| part.type_at_spin(&at)).collect::<Vec<_>>());
        let mut between: Vec<SpinType> = sampled
            .iter()
            .flatten()
            .filter(|change| within(change))
            .flat_map(|change| [change.from, change.to])
            .chain(unchanged)
            .collect();
        between.sort_by_key(|kind| *kind as u8);
        between.dedup();
        between.retain(|found| Some(*found) != range.from && Some(*found) != range.to);
        range.between = between;
        let last = nominal.iter().rfind(|change| within(change));
        range.most = last.and_then(|change| most(rotation, tolerances, change));
    }
    // Where discriminant and stiffness vanish together the ends round.
    found.retain(|range| range.from != range.to || !range.between.is_empty() || range.from.is_none());
    found
}

/// The ranges of spins, ascending and apart, outside of which the rotation about the axis does not change for any part
/// of some boxes around the nominal one.
pub(super) fn ranges_over(rotation: &AxisRotation, boxes: &[AxisBox]) -> Vec<SpinRange> {
    let ranges = joined(boxes.iter().flat_map(root_ranges).collect());
    let gap = |low: f64, high: f64| inside(low, high).and_then(|at| rotation.type_at_spin(&at));
    let range = |(number, &[low, high]): (usize, &[f64; 2])| {
        let before = number.checked_sub(1).map_or(0.0, |k| ranges[k][1]);
        let after = ranges.get(number + 1).map_or(f64::INFINITY, |next| next[0]);
        let omega = [low.sqrt().next_down().max(0.0), high.sqrt().next_up()];
        SpinRange { from: gap(before, low), to: gap(high, after), omega, between: Vec::new(), most: None }
    };
    ranges.iter().enumerate().map(range).collect()
}

/// A spin between those with these squares; a gap of a few doubles has none.
fn inside(low: f64, high: f64) -> Option<RBig> {
    let middle = if high.is_finite() { 0.5 * (low + high) } else { 2.0 * low.max(1.0) };
    let is_between = low < middle && middle < high;
    is_between.then(|| RBig::try_from(middle.sqrt()).ok()).flatten()
}

/// The bodies of the sampled parts; `None` where one is no body.
pub fn sampled_bodies(rotation: &AxisRotation, tolerances: &[RBig; 4]) -> impl Iterator<Item = Option<Body>> {
    samples(tolerances).map(|steps| varied(rotation, steps, tolerances).body())
}

/// The steps of the sampled parts, each once: those of an exact input are 0.
fn samples(tolerances: &[RBig; 4]) -> impl Iterator<Item = [i8; 4]> {
    let is_known = |(step, tolerance): (&i8, &RBig)| *step == 0 || !tolerance.is_zero();
    (0..SAMPLES).map(steps).filter(move |steps| steps.iter().zip(tolerances).all(is_known))
}

/// How many of the steps of a sampled part: −1, 0 or 1 tolerance for each input.
fn steps(number: usize) -> [i8; 4] {
    let mut rest = number;
    std::array::from_fn(|_| {
        let step = [-1, 0, 1][rest % 3];
        rest /= 3;
        step
    })
}

/// Each input times 1 + step · tolerance.
fn varied(rotation: &AxisRotation, steps: [i8; 4], tolerances: &[RBig; 4]) -> AxisRotation {
    let factor = |k: usize| RBig::ONE + &tolerances[k] * RBig::from(steps[k]);
    let mut varied = rotation.clone();
    for (k, moment) in varied.moments.iter_mut().enumerate() {
        *moment = &*moment * factor(k);
    }
    varied.weight = &rotation.weight * factor(3);
    varied.exact =
        rotation.exact.as_ref().map(|[product, squared]| [product * factor(1) * factor(2), squared * factor(3).sqr()]);
    varied
}

/// The input that by itself moves the last of some changes of the nominal part most, and how far in Ω: infinitely far where
/// with it the condition whose root the change is (K_A, K_B or the discriminant; where several vanish there, each of them) has
/// none. Of equals the first.
fn most(rotation: &AxisRotation, tolerances: &[RBig; 4], change: &SpinChange) -> Option<(&'static str, f64)> {
    let is_here = |omega: &f64| (omega - change.omega).abs() <= change.error_bound;
    let held: Vec<usize> = rotation
        .thresholds()
        .iter()
        .enumerate()
        .filter(|(_, at)| at.as_ref().is_some_and(is_here))
        .map(|(k, _)| k)
        .collect();
    let moved_to = |part: AxisRotation| {
        let found = part.thresholds();
        let left = held.iter().filter_map(|&k| found[k]).map(|omega| (omega - change.omega).abs());
        left.reduce(f64::max).unwrap_or(f64::INFINITY)
    };
    let mut most: Option<(&'static str, f64)> = None;
    for (input, name) in INPUTS.into_iter().enumerate() {
        let alone = [-1, 1].map(|step| std::array::from_fn(|k| if k == input { step } else { 0 }));
        let moved = alone.map(|steps| moved_to(varied(rotation, steps, tolerances))).into_iter().fold(0.0, f64::max);
        if moved > most.map_or(change.error_bound, |(_, far)| far) {
            most = Some((name, moved));
        }
    }
    most
}

/// Ranges that overlap become one.
fn joined(mut ranges: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    ranges.sort_by(|p, q| p[0].total_cmp(&q[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for [low, high] in ranges {
        match joined.last_mut() {
            Some(last) if low <= last[1] => last[1] = last[1].max(high),
            _ => joined.push([low, high]),
        }
    }
    joined
}

/// Intervals of s that hold every root of K_A, K_B and the discriminant over the box.
fn root_ranges(of: &AxisBox) -> Vec<[f64; 2]> {
    let AxisBox { moments, differences: [above_first, above_second, across], weight } = *of;
    let mut ranges: Vec<[f64; 2]> =
        [above_first, above_second].into_iter().filter_map(|difference| quotient(weight, difference)).collect();
    if weight.is_positive() == Some(true) {
        ranges.extend(collisions(moments, across).into_iter().flatten().map(|range| {
            let range = range * weight.twice();
            [range.lo.max(0.0), range.hi]
        }));
    }
    // At rest nothing turns.
    ranges.retain(|range| range[1] > 0.0);
    ranges
}

/// All positive quotients of two intervals, the first of which is zero or has a sign.
fn quotient(weight: Interval, difference: Interval) -> Option<[f64; 2]> {
    let Some(upward) = weight.is_positive() else {
        // s (C − A) alone: no root at any spin but where the difference vanishes for some parts and not for all.
        let may_vanish = difference.is_positive().is_none() && difference != Interval::ZERO;
        return may_vanish.then_some([0.0, f64::INFINITY]);
    };
    let (weight, difference) = if upward { (weight, difference) } else { (-weight, -difference) };
    if difference.hi <= 0.0 {
        return None;
    }
    let least = (weight / Interval::point(difference.hi)).lo.max(0.0);
    let most = if difference.lo > 0.0 { (weight / Interval::point(difference.lo)).hi } else { f64::INFINITY };
    Some([least, most])
}

/// s−/(2w) and s+/(2w) over a box of moments C, A, B with this A − B, each the hull over its pieces; `None` where p and q have
/// different signs throughout.
fn collisions(moments: [Interval; 3], across: Interval) -> [Option<Interval>; 2] {
    let mut hulls: [Option<Interval>; 2] = [None, None];
    let [axis, first, second] = moments.map(pieces);
    let is_symmetric = across == Interval::ZERO;
    for c in &axis {
        for a in &first {
            let same = [*a];
            for b in if is_symmetric { &same } else { &second[..] } {
                let Some(mut found) = collisions_of_piece(*c, *a, *b) else { continue };
                if is_symmetric {
                    found[0] = Interval::ZERO;
                }
                for (hull, found) in hulls.iter_mut().zip(found) {
                    *hull = Some(hull.map_or(found, |hull| hull.hull(&found)));
                }
            }
        }
    }
    hulls
}

fn collisions_of_piece(c: Interval, a: Interval, b: Interval) -> Option<[Interval; 2]> {
    let (p, q) = (a.twice() - c, b.twice() - c);
    if let (Some(p), Some(q)) = (p.is_positive(), q.is_positive())
        && p != q
    {
        return None;
    }
    let size = |x: Interval| match x.is_positive() {
        Some(true) => x,
        Some(false) => -x,
        None => Interval::between(0.0, x.magnitude()),
    };
    let (p, q) = (size(p), size(q));
    let sum = ((a * q).sqrt() + (b * p).sqrt()).square();
    let below = c.square() * (p + q);
    // (√(Aq) + √(Bp))² ≤ (A + B)(p + q), (√(Aq) − √(Bp))² ≤ max(A, B)(p + q), and their product is C⁴(B − A)².
    let most = |moment: Interval| Interval::between(0.0, (moment / c.square()).hi);
    let kept = |found: Interval, most: Interval| found.meet(&most).unwrap_or(most);
    let upper = kept(sum / below, most(a + b));
    Some([kept((b - a).square() / (sum * (p + q)), most(a.hull(&b))), upper])
}

/// An interval in pieces that cover it; one alone where it is a point.
fn pieces(whole: Interval) -> Vec<Interval> {
    if whole.lo >= whole.hi {
        return vec![whole];
    }
    let end = |k: u32| {
        if k == PIECES { whole.hi } else { whole.lo + (whole.hi - whole.lo) * (f64::from(k) / f64::from(PIECES)) }
    };
    (0..PIECES).map(|k| Interval::between(end(k), end(k + 1))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::{Body, BodyAxis};
    use bifdiag_numbers::Sign;

    fn percent(n: u32) -> RBig {
        RBig::from_parts(n.into(), 100u32.into())
    }

    fn alike(tolerance: &RBig) -> [RBig; 4] {
        std::array::from_fn(|_| tolerance.clone())
    }

    /// Ω = 2 √(Ar)/C of a top that is symmetric: C counts once, A and r half.
    #[test]
    fn the_axial_moment_matters_most_to_a_sleeping_top() {
        let body = Body::parse(&["2", "2.000001", "0.5"], &["0", "0", "3"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Negative).unwrap();
        let found = spin_ranges(&rotation, &alike(&percent(1)));
        // At rest a part that is nearly symmetric has two real pairs or a quadruple.
        assert_eq!((found.len(), found[0].from, found[0].omega[0]), (2, None, 0.0), "{found:?}");
        let last = &found[1];
        assert_eq!((last.from, last.to), (Some(SpinType::Complex), Some(SpinType::Elliptic)));
        let (input, moved) = last.most.unwrap();
        assert_eq!(input, INPUTS[0]);
        let nominal = 4.0 * 6.0_f64.sqrt();
        assert!((moved / nominal - 1.0 / 99.0).abs() < 1e-5, "{found:?}");
        // The extremes of a symmetric top lie at corners of the box, and the bounds are hardly wider.
        let [least, most] = [(0.99, 1.01), (1.01, 0.99)].map(|(more, less): (f64, f64)| nominal * more / less);
        assert!(last.omega[0] <= least && least - last.omega[0] < 0.1 * (nominal - least), "{found:?}");
        assert!(last.omega[1] >= most && last.omega[1] - most < 0.1 * (most - nominal), "{found:?}");
    }

    /// Upright about the middle axis, where a part with a larger first moment has a change that the nominal one lacks:
    /// s = r/(A₂ − A₁), which A₁ moves to 9.409 and 9.696 rpm and A₂ to 9.275 and 9.849.
    #[test]
    fn a_change_is_compared_with_itself() {
        let body = Body::parse(&["1", "2", "2.5"], &["0", "-1", "0"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[1], Sign::Positive).unwrap();
        let (input, moved) = spin_ranges(&rotation, &alike(&percent(3)))[0].most.unwrap();
        assert_eq!(input, INPUTS[0]);
        assert!((moved - ((1.0_f64 / 0.94).sqrt() - 1.0)).abs() < 1e-12, "{moved}");
    }

    /// The stiffness K_B = −1 + s(C − B) of a body with C slightly above B has no root where B is above C.
    #[test]
    fn an_input_without_which_there_is_no_change_matters_most() {
        let body = Body::parse(&["1", "0.5", "0.995"], &["1", "0", "0"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[0], Sign::Negative).unwrap();
        let found = spin_ranges(&rotation, &[RBig::ZERO, RBig::ZERO, percent(1), RBig::ZERO]);
        assert_eq!(found.last().unwrap().most, Some((INPUTS[2], f64::INFINITY)), "{found:?}");
    }

    /// K_A and K_B vanish together, and K_B still does where a larger A leaves K_A no root; C moves both.
    #[test]
    fn of_two_conditions_at_one_spin_one_may_keep_its_root() {
        let body = Body::parse(&["0.995", "0.995", "1"], &["0", "0", "1"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Negative).unwrap();
        let found = spin_ranges(&rotation, &[RBig::ZERO, percent(1), RBig::ZERO, RBig::ZERO]);
        let (input, moved) = found.last().unwrap().most.unwrap();
        // s = 1/(C − A), at A = 0.99 × 0.995.
        let spin = |a: f64| (1.0 / (1.0 - a)).sqrt();
        assert_eq!(input, INPUTS[1]);
        assert!((moved - (spin(0.995) - spin(0.98505))).abs() < 1e-9, "{found:?}");
    }

    /// Of a symmetric part the ends of the minimum come apart when one of the equal moments is larger: 95.493 rpm becomes 94.092.
    #[test]
    fn one_of_two_equal_moments_can_matter_most() {
        let body = Body::parse(&["0.04", "0.04", "0.02"], &["0", "0", "1"]).unwrap();
        let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Positive).unwrap();
        let tolerances = [RBig::ZERO, percent(1), RBig::ZERO, RBig::ZERO];
        let found = spin_ranges(&rotation, &tolerances);
        let ends = |a: f64| (1.0 / (a - 0.02)).sqrt();
        let (input, moved) = found.last().unwrap().most.unwrap();
        assert_eq!(input, INPUTS[1]);
        assert!((moved - (ends(0.0396) - ends(0.04))).abs() < 1e-12, "{found:?}");
    }

    /// Every change of random parts of the box lies in a range, and between the ranges their types are those that are reported.
    #[test]
    fn no_part_of_the_box_changes_outside_the_ranges() {
        let mut state = 1_u64;
        let mut random = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i64::try_from(state >> 44).unwrap()
        };
        let (mut inside, mut gaps) = (0, 0);
        for _ in 0..25 {
            let moments: [String; 3] = std::array::from_fn(|_| format!("{}/1000000", 300_000 + random()));
            let body = Body::parse(&moments.each_ref().map(String::as_str), &["0", "0", "1"]).unwrap();
            for gamma in Sign::BOTH {
                let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], gamma).unwrap();
                let tolerances: [RBig; 4] =
                    std::array::from_fn(|_| RBig::from_parts((random() % 60).into(), 1000u32.into()));
                let ranges = spin_ranges(&rotation, &tolerances);
                for _ in 0..40 {
                    let mut part = rotation.clone();
                    let mut factor = |k: usize| {
                        let step = RBig::from_parts((random() % 2001 - 1000).into(), 1000u32.into());
                        RBig::ONE + &tolerances[k] * step
                    };
                    for (k, moment) in part.moments.iter_mut().enumerate() {
                        *moment = &*moment * factor(k);
                    }
                    part.weight = &part.weight * factor(3);
                    for change in part.changes() {
                        let within =
                            |range: &&SpinRange| range.omega[0] <= change.omega && change.omega <= range.omega[1];
                        assert!(ranges.iter().any(|range| within(&range)), "{part:?} {change:?}\n{ranges:?}");
                        inside += 1;
                    }
                    for (k, range) in ranges.iter().enumerate() {
                        let next = ranges.get(k + 1).map_or(2.0 * range.omega[1], |next| next.omega[0]);
                        let middle = 0.5 * (range.omega[1] + next);
                        if let Some(to) = range.to {
                            assert_eq!(
                                part.type_at_spin(&RBig::try_from(middle).unwrap()),
                                Some(to),
                                "{part:?}\n{ranges:?}"
                            );
                            gaps += 1;
                        }
                    }
                }
            }
        }
        assert!(inside > 500 && gaps > 500, "{inside} {gaps}");
    }

    /// Without tolerance the ranges are the changes.
    #[test]
    fn exact_inputs_have_exact_changes() {
        let body = Body::parse(&["1", "1.3", "1.6"], &["0", "0", "1"]).unwrap();
        for gamma in Sign::BOTH {
            let rotation = AxisRotation::new(&body, BodyAxis::ALL[2], gamma).unwrap();
            let (found, changes) = (spin_ranges(&rotation, &alike(&RBig::ZERO)), rotation.changes());
            assert_eq!(found.len(), changes.len(), "{found:?}\n{changes:?}");
            for (range, change) in found.iter().zip(&changes) {
                assert_eq!((range.from, range.to), (Some(change.from), Some(change.to)));
                assert!(range.omega[0] <= change.omega && change.omega <= range.omega[1]);
                assert!(range.omega[1] - range.omega[0] < 1e-12 * change.omega, "{range:?}");
            }
        }
    }

    /// A free body has no changes, but moments that may be equal leave its stability open.
    #[test]
    fn a_free_body_is_open_where_moments_may_be_equal() {
        let rotation = |a: [&str; 3]| {
            let body = Body::parse(&a, &["0", "0", "0"]).unwrap();
            spin_ranges(&AxisRotation::new(&body, BodyAxis::ALL[2], Sign::Positive).unwrap(), &alike(&percent(1)))
        };
        assert_eq!(rotation(["1", "2", "2.5"]), []);
        let open = rotation(["1", "2", "2.01"]);
        assert_eq!((open.len(), open[0].from, open[0].to, open[0].omega), (1, None, None, [0.0, f64::INFINITY]));
    }
}
