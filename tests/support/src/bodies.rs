//! Random bodies, stratum by stratum.

use bifdiag_body::Body;

use super::random::SplitMix64;

/// A family of bodies, special in the way its name says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stratum {
    /// Nothing special.
    Generic,
    /// One r_i = 0.
    Plane,
    /// r on a principal axis.
    Axis,
    /// r within about a thousandth of a principal axis.
    NearAxis,
    /// Two equal moments.
    Symmetric,
    /// A rod or a plate: one moment much smaller or about the sum of the others.
    Flat,
    /// One tiny r_i.
    TinyR,
    /// Two or three moments nearly equal.
    NearEqual,
    /// A_i = A_j and r on the third axis.
    Lagrange,
    /// r = 0.
    Euler,
    /// Three equal moments.
    Isotropic,
}

/// All of them.
pub const STRATA: [Stratum; 11] = [
    Stratum::Generic,
    Stratum::Plane,
    Stratum::Axis,
    Stratum::NearAxis,
    Stratum::Symmetric,
    Stratum::Flat,
    Stratum::TinyR,
    Stratum::NearEqual,
    Stratum::Lagrange,
    Stratum::Euler,
    Stratum::Isotropic,
];

/// A body of the stratum; |r| between a tenth and ten (zero for Euler).
pub fn random_body(rng: &mut SplitMix64, stratum: Stratum) -> Body {
    let mut a = [rng.between(0.2, 2.0), rng.between(0.2, 2.0), rng.between(0.2, 2.0)];
    let length = rng.power_of_ten(-1.0, 1.0);
    let mut r = rng.direction();
    let (i, j, k) = axes(rng);
    match stratum {
        Stratum::Generic => {}
        Stratum::Plane => r[i] = 0.0,
        Stratum::Axis => {
            r = [0.0; 3];
            r[i] = rng.sign();
        }
        Stratum::NearAxis => {
            r[j] *= rng.power_of_ten(-4.0, -2.0);
            r[k] *= rng.power_of_ten(-4.0, -2.0);
            r[i] = rng.sign();
        }
        Stratum::Symmetric => a[i] = a[j],
        Stratum::Flat => {
            if rng.sign() > 0.0 {
                a[i] = rng.power_of_ten(-2.5, -0.5);
                a[j] = 1.0;
                a[k] = 1.0 - a[i] * rng.between(-0.5, 0.5);
            } else {
                a[i] = a[j] + a[k];
            }
        }
        Stratum::TinyR => r[i] *= rng.power_of_ten(-12.0, -3.0),
        Stratum::NearEqual => {
            a[i] = a[j] * (1.0 + rng.sign() * rng.power_of_ten(-6.0, -1.5));
            if rng.unit() < 0.3 {
                a[k] = a[j] * (1.0 + rng.sign() * rng.power_of_ten(-6.0, -1.5));
            }
        }
        Stratum::Lagrange => {
            a[i] = a[j];
            r = [0.0; 3];
            r[k] = rng.sign();
        }
        Stratum::Euler => r = [0.0; 3],
        Stratum::Isotropic => a = [a[0]; 3],
    }
    Body::from_f64(a, r.map(|x| x * length)).expect("moments are positive")
}

fn axes(rng: &mut SplitMix64) -> (usize, usize, usize) {
    let i = rng.index(3);
    if rng.sign() > 0.0 { (i, (i + 1) % 3, (i + 2) % 3) } else { (i, (i + 2) % 3, (i + 1) % 3) }
}

/// A random point (h, l): l log-uniform about the scale on which l²/A balances r, h between somewhat below the
/// minimum of U_l and somewhat above its maximum, estimated on a coarse grid.
pub fn random_point(rng: &mut SplitMix64, body: &Body) -> (f64, f64) {
    let (a, r) = (body.moments_f64(), body.center_f64());
    let norm = (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).sqrt();
    let scale = if norm == 0.0 { 1.0 } else { norm };
    let l = (scale * a[0].max(a[1]).max(a[2])).sqrt() * rng.power_of_ten(-0.7, 1.0);
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    for _ in 0..400 {
        let g = rng.direction();
        let j = a[0] * g[0] * g[0] + a[1] * g[1] * g[1] + a[2] * g[2] * g[2];
        let u = l * l / (2.0 * j) - (g[0] * r[0] + g[1] * r[1] + g[2] * r[2]);
        lowest = lowest.min(u);
        highest = highest.max(u);
    }
    let t = rng.between(-0.1, 1.1);
    (lowest + (highest - lowest).max(1e-3 * scale) * t, l)
}
