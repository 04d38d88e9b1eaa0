//! The contract of interval arithmetic, held against exact rationals in every precision: each operation on random
//! intervals, many of them with special ends, must contain the exact result for every member that is tried.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::wide::{Interval128, Interval384, Interval1024, Wide};
use dashu_ratio::RBig;
use proptest::prelude::*;

const SPECIAL: [f64; 18] = [
    0.0,
    -0.0,
    5e-324,
    -5e-324,
    2e-308,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    1e-160,
    1.0,
    -1.0,
    1.0 + f64::EPSILON,
    0.1,
    -3.0,
    1e160,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
];

fn end() -> impl Strategy<Value = f64> {
    prop_oneof![3 => proptest::sample::select(&SPECIAL[..]), 1 => proptest::num::f64::NORMAL, 2 => -9.0..9.0f64]
}

/// Ends in order. One in three is a point; neither end is an infinite point.
fn ends() -> impl Strategy<Value = [f64; 2]> {
    (end(), end(), 0..3u8).prop_map(|(a, b, kind)| {
        let (a, b) = if kind == 0 { (a, a) } else { (a, b) };
        [a.min(b).min(f64::MAX), a.max(b).max(f64::MIN)]
    })
}

/// Two intervals; one pair in four touches.
fn pairs() -> impl Strategy<Value = [[f64; 2]; 2]> {
    (ends(), ends(), end(), 0..4u8).prop_map(|(x, y, c, kind)| {
        let touching = [x[1].min(f64::MAX), c.max(x[1]).max(f64::MIN)];
        [x, if kind == 0 && x[1] < f64::INFINITY { touching } else { y }]
    })
}

fn exact(value: f64) -> RBig {
    RBig::try_from(value).unwrap()
}

/// Members of an interval: its ends, some between, some far out where there is no bound.
fn members([lo, hi]: [f64; 2]) -> Vec<RBig> {
    let far = RBig::from(3) * exact(f64::MAX);
    let low = if lo.is_finite() { exact(lo) } else { -far.clone() };
    let high = if hi.is_finite() { exact(hi) } else { far };
    let inside = |value: &RBig| low <= *value && *value <= high;
    let between = [RBig::ONE, RBig::from(2)].map(|t| &low + (&high - &low) * t / RBig::from(3));
    let simple = [RBig::ZERO, RBig::ONE, -RBig::ONE].into_iter().filter(inside);
    simple.chain(between).chain([low.clone(), high.clone()]).collect()
}

/// An interval type that can be made from ends and asked for members without rounding.
trait Set: Enclosure {
    fn set(ends: [f64; 2], precision: Self::Precision) -> Self {
        Self::double(ends[0], precision).hull(&Self::double(ends[1], precision))
    }

    fn holds(&self, value: &RBig) -> bool {
        match self.exact_bounds() {
            Some([lo, hi]) => lo <= *value && *value <= hi,
            None => holds(self.bounds(), value),
        }
    }
}

fn holds([lo, hi]: [f64; 2], value: &RBig) -> bool {
    assert!(lo < f64::INFINITY && hi > f64::NEG_INFINITY, "[{lo}, {hi}] has no member");
    (lo.is_infinite() || exact(lo) <= *value) && (hi.is_infinite() || *value <= exact(hi))
}

impl Set for Wide {}
impl Set for Interval128 {}
impl Set for Interval1024 {}
impl Set for Interval384 {}

impl Set for Interval {
    fn set([lo, hi]: [f64; 2], (): ()) -> Self {
        Self { lo, hi }
    }
}

/// The sets of one case are shown with what they miss.
macro_rules! contains {
    ($result:expr, $value:expr, $($operand:expr),+) => {
        let (result, value) = (&$result, &$value);
        prop_assert!(result.holds(value), "{} of {:?} is {:?} without {value}", stringify!($result), ($(&$operand),+), result);
    };
}

fn arithmetic<E: Set>([x, y]: [[f64; 2]; 2], precision: E::Precision) -> Result<(), TestCaseError> {
    let (a, b) = (E::set(x, precision), E::set(y, precision));
    for p in &members(x) {
        contains!(-a.clone(), -p.clone(), a);
        contains!(a.square(), p * p, a);
        for q in &members(y) {
            contains!(a.clone() + b.clone(), p + q, a, b);
            contains!(a.clone() - b.clone(), p - q, a, b);
            contains!(a.clone() * b.clone(), p * q, a, b);
            if !q.is_zero() {
                contains!(a.clone() / b.clone(), p / q, a, b);
            }
        }
    }
    if let Some([low, _]) = a.square().exact_bounds() {
        prop_assert!(low >= RBig::ZERO);
    }
    // A divisor with 0 leaves nothing known, and the point 0 is exact.
    if y[0] <= 0.0 && y[1] >= 0.0 {
        prop_assert_eq!((a.clone() / b.clone()).bounds(), [f64::NEG_INFINITY, f64::INFINITY]);
    }
    let zero = E::small(0, precision);
    prop_assert_eq!((a.clone() * zero.clone()).sign(), Some(Sign::Zero));
    prop_assert_eq!((zero.clone() * a.clone()).sign(), Some(Sign::Zero));
    Ok(())
}

fn roots<E: Set>(x: [f64; 2], precision: E::Precision) -> Result<(), TestCaseError> {
    let a = E::set(x, precision);
    let root = a.sqrt();
    // r ∈ √X for √p, p ∈ X, is lo ≤ 0 or lo² ≤ p, and p ≤ hi².
    for p in members(x).iter().filter(|p| **p >= RBig::ZERO) {
        let ends =
            root.exact_bounds().unwrap_or_else(|| root.bounds().map(|end| RBig::try_from(end).unwrap_or(RBig::ZERO)));
        prop_assert!(ends[0] <= RBig::ZERO || ends[0].sqr() <= *p, "√{a:?} is {root:?} without √{p}");
        let unbounded = root.bounds()[1] == f64::INFINITY && root.exact_bounds().is_none();
        prop_assert!(unbounded || (ends[1] >= RBig::ZERO && ends[1].sqr() >= *p), "√{a:?} is {root:?} without √{p}");
    }
    if x[1] < 0.0 {
        prop_assert_eq!(root.bounds(), [f64::NEG_INFINITY, f64::INFINITY]);
    }
    // Planted squares.
    for p in members(x) {
        let root = E::rational(&p.sqr(), precision).sqrt();
        let size = if p < RBig::ZERO { -p } else { p };
        contains!(root, size, a);
    }
    Ok(())
}

fn order<E: Set>([x, y]: [[f64; 2]; 2], precision: E::Precision) -> Result<(), TestCaseError> {
    let (a, b) = (E::set(x, precision), E::set(y, precision));
    let (members_a, members_b) = (members(x), members(y));
    for p in &members_a {
        contains!(a.hull(&b), *p, a, b);
        if let Some(sign) = a.sign() {
            prop_assert_eq!(p.partial_cmp(&RBig::ZERO).map(Sign::from), Some(sign));
        }
        if b.holds(p) {
            let meet = a.meet(&b);
            prop_assert!(meet.is_some(), "{a:?} and {b:?} share {p}");
            contains!(meet.unwrap(), *p, a, b);
        }
        prop_assert!(holds(a.bounds(), p));
        prop_assert!(!a.is_below(&b) || members_b.iter().all(|q| p < q));
    }
    for q in &members_b {
        contains!(a.hull(&b), *q, a, b);
    }
    // A common part lies in both, and there is one unless one interval lies before the other.
    match (a.meet(&b), a.exact_bounds(), b.exact_bounds()) {
        (Some(common), Some(of_a), Some(of_b)) => {
            let [lo, hi] = common.exact_bounds().unwrap();
            prop_assert!(lo <= hi && [of_a, of_b].iter().all(|[low, high]| *low <= lo && hi <= *high));
        }
        (None, _, _) => prop_assert!(x[1] < y[0] || y[1] < x[0], "{a:?} and {b:?}"),
        _ => {}
    }
    for (point, finite) in [(a.lower(), x[0]), (a.upper(), x[1])] {
        match point.exact_bounds() {
            Some([lo, hi]) => prop_assert!(lo == hi && lo == exact(finite)),
            None => prop_assert!(a.exact_bounds().is_none()),
        }
    }
    match (a.middle().exact_bounds(), a.exact_bounds()) {
        (Some([lo, hi]), _) => prop_assert!(lo == hi && a.holds(&lo)),
        (None, bounds) => prop_assert!(bounds.is_none()),
    }
    Ok(())
}

fn numbers<E: Set>(p: &RBig, precision: E::Precision) -> Result<(), TestCaseError> {
    let set = E::rational(p, precision);
    prop_assert!(set.holds(p) && holds(set.bounds(), p), "{set:?} is not {p}");
    prop_assert!(E::line(precision).holds(p));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn arithmetic_contains_every_result(pair in pairs()) {
        arithmetic::<Interval>(pair, ())?;
        for bits in [53, 128, 384] {
            arithmetic::<Wide>(pair, bits)?;
        }
        arithmetic::<Interval128>(pair, ())?;
        arithmetic::<Interval1024>(pair, ())?;
        arithmetic::<Interval384>(pair, ())?;
    }

    #[test]
    fn roots_contain_every_result(x in ends()) {
        roots::<Interval>(x, ())?;
        for bits in [53, 128, 384] {
            roots::<Wide>(x, bits)?;
        }
        roots::<Interval128>(x, ())?;
        roots::<Interval1024>(x, ())?;
        roots::<Interval384>(x, ())?;
    }

    #[test]
    fn hulls_common_parts_and_ends_are_right(pair in pairs()) {
        order::<Interval>(pair, ())?;
        for bits in [53, 128, 384] {
            order::<Wide>(pair, bits)?;
        }
        order::<Interval128>(pair, ())?;
        order::<Interval1024>(pair, ())?;
        order::<Interval384>(pair, ())?;
    }

    #[test]
    fn numbers_lie_in_their_intervals(a in end(), b in end(), n in -9_000_000i64..9_000_000) {
        let [a, b] = [a, b].map(|x| exact(x.clamp(f64::MIN, f64::MAX)));
        let square = &a * &a;
        for p in [&a * &b, &a + &b, &square * &square, RBig::from_parts(n.into(), 1_000_003u32.into()), a] {
            numbers::<Interval>(&p, ())?;
            for bits in [53, 128, 384] {
                numbers::<Wide>(&p, bits)?;
            }
            numbers::<Interval128>(&p, ())?;
            numbers::<Interval1024>(&p, ())?;
            numbers::<Interval384>(&p, ())?;
        }
    }

    /// What doubles alone have.
    #[test]
    fn operations_of_doubles_contain_every_result(x in ends(), factor in end(), units in 0.0..40.0f64) {
        let a = Interval::set(x, ());
        let factor = factor.clamp(f64::MIN, f64::MAX);
        for p in &members(x) {
            contains!(a * factor, p * exact(factor), a, factor);
            contains!(a.twice(), p * RBig::from(2), a);
            contains!(a.widened(units), p.clone(), a, units);
            let size = if *p < RBig::ZERO { -p.clone() } else { p.clone() };
            prop_assert!(a.magnitude().is_infinite() || size <= exact(a.magnitude()));
            prop_assert!(a.is_positive().is_none_or(|positive| positive == (*p > RBig::ZERO) && !p.is_zero()));
        }
        let rounded = Interval::rounded(factor);
        prop_assert!(rounded.holds(&exact(factor)));
        prop_assert!(factor == 0.0 || rounded.lo <= factor.next_down() && factor.next_up() <= rounded.hi);
        prop_assert_eq!(Interval::between(x[1], x[0]), a);
    }
}

#[test]
fn what_is_not_finite_is_the_whole_line() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(Interval::double(value, ()), Interval::LINE);
        assert!(Wide::double(value, 128).exact_bounds().is_none());
    }
}

#[test]
fn nought_times_infinity_hides_nothing() {
    let (some, unbounded) = (Interval::between(0.0, 1.0), Interval { lo: 1.0, hi: f64::INFINITY });
    assert_eq!(some * unbounded, Interval::LINE);
    assert_eq!(unbounded / unbounded, Interval::LINE);
    assert_eq!(unbounded - unbounded, Interval::LINE);
    assert_eq!(Interval::ZERO * unbounded, Interval::ZERO);
}

#[test]
fn disjoint_intervals_have_no_common_part() {
    assert_eq!(Interval::between(0.0, 1.0).meet(&Interval::between(1.0, 2.0)), Some(Interval::ONE));
    assert_eq!(Interval::between(0.0, 1.0).meet(&Interval::between(1.5, 2.0)), None);
    assert!(Wide::small(1, 128).meet(&Wide::small(2, 128)).is_none());
    assert!(Wide::small(1, 128).meet(&Wide::line(128)).is_some());
}
