//! Bodies that are special: two moments are equal, or r lies in a principal plane, on an axis, or vanishes.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};

use bifdiag_survey::space::{BodySet, ReducedBody};

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
    /// The stratum of a body; `None` for a generic one.
    #[must_use]
    pub fn of(place: &ReducedBody) -> Option<&'static Self> {
        let ReducedBody { a, r } = place;
        let (equal, open) = ([a[0] == a[1], a[1] == a[2]], r.map(|x| x > 0.0));
        SPECIAL_STRATA.iter().find(|stratum| (stratum.equal, stratum.open) == (equal, open))
    }

    /// Random bodies of it, without end: A (or the second moments of mass, for bodies that exist) uniform on what is left of the simplex,
    /// r̂ on what is left of the octant; where r was turned, as it is distributed before that.
    pub fn bodies(&self, domain: BodySet, seed: u64) -> impl Iterator<Item = ReducedBody> {
        let mut rng = SplitMix64::seed_from_u64(seed);
        std::iter::repeat_with(move || self.random(&mut rng, domain))
    }

    fn random(&self, rng: &mut SplitMix64, domain: BodySet) -> ReducedBody {
        let (u, v) = (uniform(rng), uniform(rng));
        let mut a = match (self.equal, domain) {
            ([false, false], _) => {
                let s = u.sqrt();
                let m = [1.0 - s, s * (1.0 - v), s * v];
                m.map(|m| if domain == BodySet::Physical { 1.0 - m } else { 2.0 * m })
            }
            ([true, true], _) => [2.0 / 3.0; 3],
            // A3 = 2 − 2 A1 between A1 and 2 A1, or between A1 and 2.
            ([true, false], BodySet::Physical) => symmetric(0.5 + u / 6.0),
            ([true, false], BodySet::All) => symmetric(u * 2.0 / 3.0),
            // A1 = 2 − 2 A3 from 0 to A3.
            ([false, true], _) => symmetric(2.0 / 3.0 + u / 3.0),
        };
        // The axes of r are numbered by rising moments.
        a.sort_by(f64::total_cmp);
        let height = uniform(rng);
        let across = ((1.0 - height) * (1.0 + height)).sqrt();
        let angle = std::f64::consts::FRAC_PI_2 * height;
        let [one, other] = match self.equal {
            [false, false] => [libm::cos(angle), libm::sin(angle)],
            [true, _] => [across, height],
            [false, true] => [height, across],
        };
        let mut parts = [one, other].into_iter();
        let count = self.open.iter().filter(|open| **open).count();
        let r = self.open.map(|open| match (open, count) {
            (false, _) => 0.0,
            (true, 1) => 1.0,
            (true, _) => parts.next().unwrap_or_default(),
        });
        ReducedBody::of([a, r])
    }
}

/// A number in [0, 1).
pub fn uniform(rng: &mut SplitMix64) -> f64 {
    (rng.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// The moments a, a and 2 − 2a.
fn symmetric(a: f64) -> [f64; 3] {
    [a, a, 2.0 - 2.0 * a]
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_survey::space::TangentBasis;

    #[test]
    fn random_bodies_lie_where_they_should() {
        for stratum in &SPECIAL_STRATA {
            for domain in [BodySet::Physical, BodySet::All] {
                for place in stratum.bodies(domain, 1).take(20) {
                    assert_eq!(SpecialStratum::of(&place), Some(stratum), "{place:?}");
                    assert!(place.is_in(domain), "{place:?}");
                }
            }
        }
        assert_eq!(SpecialStratum::of(&ReducedBody::of([[0.5, 0.6, 0.9], [0.6, 0.12, 0.45]])), None);
    }

    #[test]
    fn they_are_ordered_by_their_parameters() {
        let parameters =
            |stratum: &SpecialStratum| TangentBasis::new(stratum.bodies(BodySet::All, 2).next().unwrap()).dimensions();
        let all: Vec<usize> = SPECIAL_STRATA.iter().map(parameters).collect();
        assert_eq!(all, [3, 3, 3, 2, 2, 2, 2, 2, 2, 1, 1, 1, 1, 1, 1, 0, 0]);
    }
}
