//! Bodies to start from.

use crate::design::{Design, Family};
use bifdiag_numbers::sequence::point;

/// 10^(−4u).
fn tiny(u: f64) -> f64 {
    libm::exp(-4.0 * std::f64::consts::LN_10 * u)
}

/// A and r of body n of the search, from four strata in turn: the whole family, r near a principal axis, two moments
/// nearly equal, and r in a principal plane or on an axis.
#[must_use]
pub fn sample(n: u64, seed: u64, physical: bool) -> [[f64; 3]; 2] {
    let family = if physical { Family::General } else { Family::Positive };
    let design = Design { family, vary: Vec::new(), samples: Some(u64::MAX), seed };
    let (stratum, k) = (n % 4, n / 4);
    let [a, r] = design.values(k);
    let u = point(k, 4, seed.wrapping_add(1 + stratum));
    let axis = usize::try_from(k % 3).unwrap_or_default();
    match stratum {
        0 => [a, r],
        1 => {
            let mut r = [1.0; 3];
            r[(axis + 1) % 3] = tiny(u[2]);
            r[(axis + 2) % 3] = tiny(u[3]);
            [a, r]
        }
        2 => {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let third = if physical { 2.0 } else { 4.0 } * u[1];
            [[1.0, 1.0 + sign * 0.5 * tiny(u[0]), third], r]
        }
        _ => {
            let mut r = r;
            r[axis] = 0.0;
            if k % 4 == 0 {
                r[(axis + 1) % 3] = 0.0;
            }
            [a, r]
        }
    }
}
