//! A point of a curve in the (x, h) plane, x = l²/2, and the difference of two curves.

use std::cmp::Ordering;

use bifdiag_body::Frame;
use bifdiag_numbers::UNIT_ROUNDOFF;
use thiserror::Error;

/// An angular momentum at which `f64` cannot compute.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("l = {l:e} is too {} for this body in f64; |l| between {smallest:.1e} and {largest:.1e}, or 0, is possible", if *.l < *.smallest { "small" } else { "large" })]
pub struct MomentumError {
    /// |l| as asked for.
    pub l: f64,
    /// About the smallest |l| > 0, inside the range.
    pub smallest: f64,
    /// About the largest |l|, inside the range.
    pub largest: f64,
}

/// Roundings of x = l²/2 relative to its exact value: l itself, the square.
pub const X_ROUNDINGS: f64 = 4.0;

/// x = l²/2 in the frame's units.
///
/// # Errors
/// [`MomentumError`] when squares and cubes of x would leave the range of `f64`.
#[inline]
pub fn abscissa(frame: &Frame, l: f64) -> Result<f64, MomentumError> {
    const LIMIT: f64 = 1e45;
    // So that the bounds that are named, of two digits, are inside.
    const INSIDE: f64 = 1.1;
    let scaled = l.abs() / frame.momentum_unit;
    if scaled == 0.0 || (1.0 / LIMIT..=LIMIT).contains(&scaled) {
        Ok(0.5 * scaled * scaled)
    } else {
        let unit = frame.momentum_unit;
        Err(MomentumError { l: l.abs(), smallest: INSIDE * unit / LIMIT, largest: unit * LIMIT / INSIDE })
    }
}

/// One point of a critical curve or pole line.
///
/// In the variables x = l²/2 and h the potential U = x/J(γ) − ⟨γ, r⟩ is linear in x for each γ; so a critical curve is
/// the envelope of straight lines, its slope is dh/dx = 1/J (Proposition 3.6 of docs/mathematics.md), and a pole line
/// is straight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// x = l²/2 at which the point was asked for.
    pub x: f64,
    /// γ in the frame; for a pole line ±r̂.
    pub gamma: [f64; 3],
    /// J = ⟨γ, Aγ⟩.
    pub j: f64,
    /// ⟨γ, r⟩.
    pub rho: f64,
    /// Σ |γ_k r_k|: the scale of the error of `rho`.
    pub rho_scale: f64,
}

impl Point {
    /// The point over γ at x.
    #[must_use]
    pub fn over(frame: &Frame, x: f64, gamma: [f64; 3], j: f64) -> Self {
        let terms = [gamma[0] * frame.r[0], gamma[1] * frame.r[1], gamma[2] * frame.r[2]];
        Self {
            x,
            gamma,
            j,
            rho: terms[0] + terms[1] + terms[2],
            rho_scale: terms[0].abs() + terms[1].abs() + terms[2].abs(),
        }
    }

    /// h = x/J − ⟨γ, r⟩.
    #[must_use]
    pub fn h(&self) -> f64 {
        self.x / self.j - self.rho
    }

    /// dh/dx = 1/J.
    #[must_use]
    pub fn slope(&self) -> f64 {
        1.0 / self.j
    }

    /// Bound on |h − h_exact|, for exact body and exact x.
    ///
    /// γ is the critical point of a neighbouring x to within a few units of roundoff, and h is stationary in γ; what
    /// remains is the rounding of U itself: fewer than 12 operations on each path, and the roundings of a and r.
    #[must_use]
    pub fn h_error(&self) -> f64 {
        const ROUNDINGS: f64 = 24.0;
        ROUNDINGS * UNIT_ROUNDOFF * (self.x / self.j + self.rho_scale)
    }
}

/// h of one curve minus h of another, with a bound on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The difference.
    pub value: f64,
    /// Bound on its error.
    pub error: f64,
}

impl Gap {
    /// Whether the first curve lies above the other or below, never equal; `None` when the bound leaves it open.
    #[must_use]
    pub fn order(&self) -> Option<Ordering> {
        (self.value.abs() > self.error).then(|| self.value.total_cmp(&0.0))
    }

    /// h_a − h_b at one x, by the difference of moments: this separates two branches that end at the same axis, or at
    /// axes with nearly equal moments, although h ~ x/a swallows the difference.
    #[must_use]
    pub fn between(frame: &Frame, a: &Point, b: &Point) -> Self {
        let [moment_gap, moment_error] = Self::moments(frame, a, b);
        let factor = a.x / (a.j * b.j);
        let kinetic = factor * moment_gap;
        let potential = a.rho - b.rho;
        let scale = factor * moment_error + a.rho_scale + b.rho_scale;
        Self { value: kinetic - potential, error: 16.0 * UNIT_ROUNDOFF * scale }
    }

    /// d(h_a − h_b)/dx = 1/J_a − 1/J_b at one x, by the same difference: J itself may be the same double on both.
    #[must_use]
    pub fn slope(frame: &Frame, a: &Point, b: &Point) -> f64 {
        let [moment_gap, _] = Self::moments(frame, a, b);
        moment_gap / (a.j * b.j)
    }

    /// J_b − J_a = Σ_j (γ_bj² − γ_aj²)(a_j − a_k), and the sum of the sizes of its terms. It holds for every k; the k with
    /// the smallest rounding error is taken.
    fn moments(frame: &Frame, a: &Point, b: &Point) -> [f64; 2] {
        let (wa, wb) = (a.gamma.map(|g| g * g), b.gamma.map(|g| g * g));
        let mut best = [0.0, f64::INFINITY];
        for k in 0..3 {
            let (mut gap, mut scale) = (0.0, 0.0);
            for j in 0..3 {
                let d = frame.diff[j][k];
                gap += (wb[j] - wa[j]) * d;
                scale += (wb[j] + wa[j]) * d.abs();
            }
            if scale < best[1] {
                best = [gap, scale];
            }
        }
        best
    }
}
