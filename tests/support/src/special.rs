//! Bodies that are special: two moments are equal, or r lies in a principal plane, on an axis, or vanishes.

use rand_xoshiro::SplitMix64;
use rand_xoshiro::rand_core::{RngCore, SeedableRng};

use bifdiag_survey::space::{BodySet, ReducedBody};

pub use bifdiag_survey::strata::{SPECIAL_STRATA, SpecialStratum};

/// Random bodies of a stratum.
pub trait RandomBodies {
    /// Without end: A (or the second moments of mass, for bodies that exist) uniform on what is left of the simplex, r̂ on what
    /// is left of the octant; where r was turned, as it is distributed before that.
    fn bodies(&self, domain: BodySet, seed: u64) -> impl Iterator<Item = ReducedBody>;
}

impl RandomBodies for SpecialStratum {
    fn bodies(&self, domain: BodySet, seed: u64) -> impl Iterator<Item = ReducedBody> {
        let mut rng = SplitMix64::seed_from_u64(seed);
        std::iter::repeat_with(move || random(self, &mut rng, domain))
    }
}

fn random(stratum: &SpecialStratum, rng: &mut SplitMix64, domain: BodySet) -> ReducedBody {
    let (u, v) = (uniform(rng), uniform(rng));
    let mut a = match (stratum.equal, domain) {
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
    let [one, other] = match stratum.equal {
        [false, false] => [libm::cos(angle), libm::sin(angle)],
        [true, _] => [across, height],
        [false, true] => [height, across],
    };
    let mut parts = [one, other].into_iter();
    let count = stratum.open.iter().filter(|open| **open).count();
    let r = stratum.open.map(|open| match (open, count) {
        (false, _) => 0.0,
        (true, 1) => 1.0,
        (true, _) => parts.next().unwrap_or_default(),
    });
    ReducedBody::of([a, r])
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
