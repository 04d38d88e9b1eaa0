//! Bodies that shrink, one strategy for each way of being special. Numbers are exact rationals; what is near a coincidence
//! is planted there, at a distance of 10⁻³ to 10⁻¹⁵ and further.

use bifdiag_body::{Body, Number};
use dashu_ratio::RBig;
use proptest::prelude::*;
use proptest::strategy::BoxedStrategy;

/// A family of bodies, special in the way its name says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stratum {
    /// Nothing special.
    Generic,
    /// One r_i = 0.
    Plane,
    /// r on a principal axis.
    OnAxis,
    /// r beside a principal axis.
    NearAxis,
    /// One or two tiny r_i/|r|.
    TinyR,
    /// Two equal moments.
    Symmetric,
    /// Two or three moments nearly equal.
    NearlyEqual,
    /// A_1 = A_2 and r on the third axis.
    Lagrange,
    /// Lagrange's top, a little spoilt.
    NearLagrange,
    /// r = 0.
    Euler,
    /// Three equal moments.
    Isotropic,
    /// One tiny moment.
    Rod,
    /// One moment is the sum of the others.
    Plate,
    /// Any positive moments; most of these bodies do not exist.
    Unphysical,
    /// Katok's family: A_1 = 1, r = (1, 0, 0).
    Katok,
    /// Beside the borders of Katok's classes, where three curves all but meet in a point (Example 15.2).
    KatokBorder,
    /// Very large and very small units.
    Scaled,
    /// Beside a border between two diagrams, whatever it is: a cusp on a pole line, a triple point, a swallowtail, …
    Border,
}

/// All of them.
pub const STRATA: [Stratum; 18] = [
    Stratum::Generic,
    Stratum::Plane,
    Stratum::OnAxis,
    Stratum::NearAxis,
    Stratum::TinyR,
    Stratum::Symmetric,
    Stratum::NearlyEqual,
    Stratum::Lagrange,
    Stratum::NearLagrange,
    Stratum::Euler,
    Stratum::Isotropic,
    Stratum::Rod,
    Stratum::Plate,
    Stratum::Unphysical,
    Stratum::Katok,
    Stratum::KatokBorder,
    Stratum::Scaled,
    Stratum::Border,
];

/// Moments and centre of mass.
type Parts = ([RBig; 3], [RBig; 3]);

impl Stratum {
    /// Bodies of this stratum; they shrink towards small numbers, axes in their order and positive r_i.
    pub fn bodies(self) -> BoxedStrategy<Body> {
        turned(self.standing()).prop_map(body).boxed()
    }

    /// Whether near coincidences are planted in it, so that `f64` may leave a body open.
    #[must_use]
    pub fn is_planted(self) -> bool {
        use Stratum::{Border, KatokBorder, NearAxis, NearLagrange, NearlyEqual, Rod, TinyR};
        matches!(self, NearAxis | TinyR | NearlyEqual | NearLagrange | Rod | KatokBorder | Border)
    }

    /// What is special stands on axes of its own choice.
    fn standing(self) -> BoxedStrategy<Parts> {
        let [zero, one] = [RBig::ZERO, RBig::ONE];
        match self {
            Self::Generic => (moments(), center()).boxed(),
            Self::Plane => changed(|[a, b, c], [x, y, _]| ([a, b, c], [x, y, RBig::ZERO])),
            Self::OnAxis => changed(|a, [x, ..]| (a, [x, RBig::ZERO, RBig::ZERO])),
            Self::NearAxis => spoilt(|a, [x, ..], [p, q]| (a, [x, p, q])),
            Self::TinyR => spoilt(|a, [x, y, z], [p, q]| (a, [x, y * p, if q.is_zero() { z } else { z * q }])),
            Self::Symmetric => changed(|[a, _, c], r| ([a.clone(), a, c], r)),
            Self::NearlyEqual => spoilt(|[a, _, c], r, [p, q]| {
                let third = if q.is_zero() { c } else { &a - &a * q };
                ([a.clone(), &a + &a * p, third], r)
            }),
            Self::Lagrange => changed(|[a, _, c], [.., z]| ([a.clone(), a, c], [RBig::ZERO, RBig::ZERO, z])),
            Self::NearLagrange => spoilt(|[a, b, c], [.., z], [p, q]| {
                let second = &a + &a * if b > c { p.clone() } else { RBig::ZERO };
                ([a, second, c], [RBig::ZERO, if b > RBig::ONE { p } else { q }, z])
            }),
            Self::Euler => changed(|a, _| (a, [RBig::ZERO, RBig::ZERO, RBig::ZERO])),
            Self::Isotropic => changed(|[a, ..], r| ([a.clone(), a.clone(), a], r)),
            Self::Rod => spoilt(|[_, b, _], r, [p, q]| ([p, b.clone(), b + q], r)),
            Self::Plate => (moments(), center(), any::<bool>())
                .prop_map(|([_, b, c], [x, y, z], beside)| {
                    ([&b + &c, b, c], [if beside { x } else { RBig::ZERO }, y, z])
                })
                .boxed(),
            Self::Unphysical => (moments(), [0..=3_isize, 0..=3, 0..=3], center())
                .prop_map(|(a, k, r)| (std::array::from_fn(|i| &a[i] * ten_to(-k[i])), r))
                .boxed(),
            Self::Katok => moments().prop_map(move |[_, b, c]| ([one.clone(), b, c], axis())).boxed(),
            Self::KatokBorder => katok_border(),
            Self::Scaled => (moments(), center(), -60..=60_isize, -60..=60_isize)
                .prop_map(|(a, r, p, q)| (a.map(|x| x * ten_to(p)), r.map(|x| x * ten_to(q))))
                .boxed(),
            Self::Border => {
                let parts = move || prop_oneof![Self::Generic.standing(), Self::Plane.standing()];
                (parts(), parts(), 3..=45_u32)
                    .prop_map(|(here, there, depth)| beside_a_border(here, &there, depth))
                    .prop_filter("r = 0", move |(_, r)| r.iter().any(|x| *x != zero))
                    .boxed()
            }
        }
    }
}

fn body((a, r): Parts) -> Body {
    Body::new(a.map(Number::from_rational), r.map(Number::from_rational)).expect("moments are positive")
}

/// 10ᵏ.
pub(crate) fn ten_to(k: isize) -> RBig {
    RBig::from(10).pow(k)
}

/// Three moments between 1/5 and 2.
fn moments() -> BoxedStrategy<[RBig; 3]> {
    let moment = || (200_000..=2_000_000_u32).prop_map(|n| RBig::from(n) / RBig::from(1_000_000));
    [moment(), moment(), moment()].boxed()
}

/// Three coordinates between 1/1000 and 1.
fn center() -> BoxedStrategy<[RBig; 3]> {
    let coordinate = || (1_000..=1_000_000_u32).prop_map(|n| RBig::from(n) / RBig::from(1_000_000));
    [coordinate(), coordinate(), coordinate()].boxed()
}

fn axis() -> [RBig; 3] {
    [RBig::ONE, RBig::ZERO, RBig::ZERO]
}

/// m·10⁻ᵏ, k from 3 to 15 and sometimes more; 10²⁵ is where data are refused.
pub(crate) fn tiny() -> impl Strategy<Value = RBig> {
    let exponent = prop_oneof![12 => 3..=15_isize, 1 => 16..=20_isize];
    (1..=99_u32, exponent).prop_map(|(m, k)| RBig::from(m) * ten_to(-k - 1))
}

/// A generic body, changed.
fn changed(change: fn([RBig; 3], [RBig; 3]) -> Parts) -> BoxedStrategy<Parts> {
    (moments(), center()).prop_map(move |(a, r)| change(a, r)).boxed()
}

/// A generic body, changed by a small number, and by a second one that is sometimes 0.
fn spoilt(change: fn([RBig; 3], [RBig; 3], [RBig; 2]) -> Parts) -> BoxedStrategy<Parts> {
    let second = prop_oneof![Just(RBig::ZERO), tiny()];
    (moments(), center(), tiny(), second).prop_map(move |(a, r, p, q)| change(a, r, [p, q])).boxed()
}

/// Any order of the axes, any signs of r.
fn turned(parts: BoxedStrategy<Parts>) -> impl Strategy<Value = Parts> {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [1, 0, 2], [2, 1, 0]];
    (parts, 0..6_usize, any::<[bool; 3]>()).prop_map(|((a, r), order, minus)| {
        let sign = |i: usize| RBig::from(if minus[i] { -1 } else { 1 });
        (ORDERS[order].map(|i| a[i].clone()), ORDERS[order].map(|i| &r[i] * sign(i)))
    })
}

/// A_1 = 1 and, with k_j = 1 − A_j: A_2 = 1, A_2 = 3/4 or 16/k_2 = (1/k_3 + 4)², each up to a small number.
fn katok_border() -> BoxedStrategy<Parts> {
    (0..3_u8, 251..=999_u32, tiny(), any::<bool>(), moments())
        .prop_map(|(border, k3, off, below, [.., other])| {
            let off = if below { -off } else { off };
            let k3 = RBig::from(k3) / RBig::from(1000);
            let (second, third) = match border {
                0 => (RBig::ONE, other),
                1 => (RBig::from(3) / RBig::from(4), other),
                _ => {
                    let root = RBig::ONE / &k3 + RBig::from(4);
                    (RBig::ONE - RBig::from(16) / (&root * &root), RBig::ONE - &k3)
                }
            };
            ([RBig::ONE, second + off, third], axis())
        })
        .prop_filter("a moment is 0 or less", |(a, _)| a.iter().all(|x| *x > RBig::ZERO))
        .boxed()
}

/// Between two bodies with different numbers of regions and events: on the side of the first, at 2⁻ᵈᵉᵖᵗʰ of their
/// distance from one of the other kind. The first itself where both are of one kind.
fn beside_a_border(here: Parts, there: &Parts, depth: u32) -> Parts {
    let kind = |parts: &Parts| {
        bifdiag_diagram::fast::atlas(&body(parts.clone()))
            .ok()
            .map(|atlas| (atlas.regions().len(), atlas.arrangement().events.len()))
    };
    let middle = |p: &Parts, q: &Parts| -> Parts {
        let mean = |x: &[RBig; 3], y: &[RBig; 3]| std::array::from_fn(|i| (&x[i] + &y[i]) / RBig::from(2));
        (mean(&p.0, &q.0), mean(&p.1, &q.1))
    };
    let own = kind(&here);
    let (mut near, mut far) = (here, there.clone());
    if kind(&far) == own {
        return near;
    }
    for _ in 0..depth {
        let parts = middle(&near, &far);
        if kind(&parts) == own { near = parts } else { far = parts }
    }
    near
}
