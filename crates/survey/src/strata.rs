//! Bodies that are special: two moments are equal, or r lies in a principal plane, on an axis, or vanishes.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_1_SQRT_2;

use bifdiag_body::Body;
use bifdiag_diagram::class::ClassName;
use bifdiag_exact::Accuracy;
use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::SeedableRng;

use crate::border::class_of;
use crate::parallel::each;
use crate::path::in_standard_axes;
use crate::space::{ReducedBody, in_ball, unit};

/// The bodies that are special in one way, and in no further one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpecialStratum {
    /// What it is called.
    pub name: &'static str,
    /// Whether A1 = A2, and A2 = A3.
    pub equal: [bool; 2],
    /// Which components of r are not 0, with r as [`ReducedBody`] turns it.
    pub open: [bool; 3],
}

const fn stratum(name: &'static str, equal: [bool; 2], open: [bool; 3]) -> SpecialStratum {
    SpecialStratum { name, equal, open }
}

/// One moment for each axis, those of two axes equal, and all equal.
const DISTINCT: [bool; 2] = [false, false];
const LOWER: [bool; 2] = [true, false];
const UPPER: [bool; 2] = [false, true];

/// All of them, by falling number of parameters; A1 ≤ A2 ≤ A3.
pub const SPECIAL_STRATA: [SpecialStratum; 17] = [
    stratum("r in the plane of axes 2 and 3", DISTINCT, [false, true, true]),
    stratum("r in the plane of axes 1 and 3", DISTINCT, [true, false, true]),
    stratum("r in the plane of axes 1 and 2", DISTINCT, [true, true, false]),
    stratum("r on axis 1", DISTINCT, [true, false, false]),
    stratum("r on axis 2", DISTINCT, [false, true, false]),
    stratum("r on axis 3", DISTINCT, [false, false, true]),
    stratum("Euler, r = 0", DISTINCT, [false; 3]),
    stratum("A1 = A2", LOWER, [false, true, true]),
    stratum("A2 = A3", UPPER, [true, false, true]),
    stratum("A1 = A2, Lagrange", LOWER, [false, false, true]),
    stratum("A2 = A3, Lagrange", UPPER, [true, false, false]),
    stratum("A1 = A2, r across axis 3", LOWER, [false, true, false]),
    stratum("A2 = A3, r across axis 1", UPPER, [false, false, true]),
    stratum("A1 = A2, Euler", LOWER, [false; 3]),
    stratum("A2 = A3, Euler", UPPER, [false; 3]),
    stratum("the ball", [true, true], [false, false, true]),
    stratum("the ball, Euler", [true, true], [false; 3]),
];

impl SpecialStratum {
    /// Bodies nearer to a more special one are not [resolved](Self::is_resolved): √(|ΔA|² + ∠²), for A with the sum 2 and the
    /// angle between the two r.
    pub const RESOLVED: f64 = 1e-8;

    /// The stratum of a body; `None` for a generic one.
    #[must_use]
    pub fn of(place: &ReducedBody) -> Option<&'static Self> {
        let ReducedBody { a, r } = place;
        let (equal, open) = ([a[0] == a[1], a[1] == a[2]], r.map(|x| x > 0.0));
        SPECIAL_STRATA.iter().find(|stratum| (stratum.equal, stratum.open) == (equal, open))
    }

    /// True where a body is so far from more special ones that borders beside it are found in doubles.
    #[must_use]
    pub fn is_resolved(body: &Body) -> bool {
        let place = ReducedBody::of_body(body);
        let [a, r] = place.values();
        // Two moments become equal halfway between them.
        let mut distances = [a[1] - a[0], a[2] - a[1]].map(|gap| FRAC_1_SQRT_2 * gap).into_iter().chain(r);
        let is_far = |distance: f64| distance == 0.0 || distance >= Self::RESOLVED;
        Self::of(&place) == Self::of_body(body) && distances.all(is_far)
    }

    /// The stratum of a body, decided exactly; `None` for a generic one.
    #[must_use]
    pub fn of_body(body: &Body) -> Option<&'static Self> {
        let standard = in_standard_axes(body);
        let (a, r) = (standard.moments(), standard.center());
        let equal = [a[0] == a[1], a[1] == a[2]];
        let mut open = r.each_ref().map(|x| !x.value().is_zero());
        // r is turned until the component of the first of two axes of equal moments is 0.
        for (i, _) in equal.iter().enumerate().filter(|(_, equal)| **equal) {
            open[i + 1] |= open[i];
            open[i] = false;
        }
        SPECIAL_STRATA.iter().find(|stratum| (stratum.equal, stratum.open) == (equal, open))
    }
}

/// Bodies next to a special one that are classified.
pub const BESIDE: usize = 48;
/// How far they are: √(|ΔA|² + |Δr|²) at most this, for A with the sum 2 and |r| = 1.
pub const BESIDE_DISTANCE: f64 = 1e-6;

/// The classes of generic bodies beside a special one, with how many of the random ones at a distance of 1e-6 have each, the
/// most frequent first. Rare ones may be missing.
#[must_use]
pub fn classes_beside(body: &Body) -> Vec<(ClassName, usize)> {
    let ReducedBody { a, r } = ReducedBody::of_body(body);
    let mut rng = SplitMix64::seed_from_u64(0);
    let mut near = || {
        let mut turned = r;
        // Axes of equal moments lie anywhere in their plane; those of the body beside it are fixed.
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if a[i] == a[j] {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * unit(&mut rng));
                (turned[i], turned[j]) = (cos * turned[i] - sin * turned[j], sin * turned[i] + cos * turned[j]);
            }
        }
        let change = in_ball(&mut rng, 6);
        let moved = |x: f64, change: f64| x + BESIDE_DISTANCE * change;
        ReducedBody::of([
            std::array::from_fn(|k| moved(a[k], change[k])),
            std::array::from_fn(|k| moved(turned[k], change[3 + k])),
        ])
    };
    let bodies: Vec<ReducedBody> = (0..BESIDE).map(|_| near()).collect();
    let class = |place: &ReducedBody| {
        let body = Body::from_f64(place.a, place.r).ok()?;
        let found = class_of(&body, Accuracy::Fast).or_else(|_open| class_of(&body, Accuracy::Exact));
        found.ok().map(|(_, class)| class.name().clone())
    };
    let mut counts: BTreeMap<ClassName, usize> = BTreeMap::new();
    for name in each(&bodies, class).into_iter().flatten() {
        *counts.entry(name).or_default() += 1;
    }
    let mut counts: Vec<(ClassName, usize)> = counts.into_iter().collect();
    counts.sort_by(|(p, p_count), (q, q_count)| q_count.cmp(p_count).then_with(|| p.cmp(q)));
    counts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(a: [&str; 3], r: [&str; 3]) -> Body {
        Body::parse(&a, &r).unwrap()
    }

    #[test]
    fn strata_are_decided_exactly() {
        let name = |a, r| SpecialStratum::of_body(&body(a, r)).map(|stratum| stratum.name);
        assert_eq!(name(["2", "1.1", "1"], ["0.9", "0", "0.6"]), Some("r in the plane of axes 1 and 3"));
        assert_eq!(name(["2", "2", "1"], ["1", "0", "0"]), Some("A2 = A3, r across axis 1"));
        assert_eq!(name(["2", "2", "1"], ["1", "2", "3"]), Some("A2 = A3"));
        assert_eq!(name(["1", "1", "1"], ["1", "-2", "3"]), Some("the ball"));
        assert_eq!(name(["2", "1.5", "1"], ["0"; 3]), Some("Euler, r = 0"));
        assert_eq!(name(["2", "1.1", "1"], ["0.9", "1e-30", "0.6"]), None);
        assert_eq!(name(["2", "1.00000000000000000001", "1"], ["0.9", "1", "0.6"]), None);
    }

    /// The plane of axes 1 and 3 has one generic side: r2 and −r2 are mirror images.
    #[test]
    fn the_papers_body_lies_beside_one_class() {
        let beside = classes_beside(&body(["2", "1.1", "1"], ["0.94868", "0", "0.61623"]));
        let [(name, BESIDE)] = &beside[..] else { panic!("{beside:?}") };
        let (_, near) = class_of(&body(["2", "1.1", "1"], ["0.94868", "1e-6", "0.61623"]), Accuracy::Exact).unwrap();
        assert_eq!(name, near.name());
    }
}
