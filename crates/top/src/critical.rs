//! All relative equilibria of a body at one l.

use thiserror::Error;

use crate::atlas::{MomentumError, abscissa};
use crate::body::{Body, Number};
use crate::curves::{CriticalSet, CurveId, CurveName, EquilibriaError, Orbit};
use crate::stability::{Stability, stability_of};
use numbers::UNIT_ROUNDOFF;

/// How many critical points an entry stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Multiplicity {
    /// One critical point; 2 is a degenerate root (at a cusp).
    Points(u32),
    /// A circle of critical points (Lagrange's top); `gamma` is one of them.
    Circle,
    /// All of S² is critical (r = 0).
    Sphere,
}

/// A relative equilibrium: the body turns about the vertical γ with constant angular velocity ω γ.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Energy h = U_l(γ).
    pub h: f64,
    /// The vertical in body coordinates.
    pub gamma: [f64; 3],
    /// Angular velocity l / J(γ), with the sign of l.
    pub omega: f64,
    /// Morse index of U_l: 0 minimum, 1 saddle, 2 maximum.
    pub index: u8,
    /// How many critical points this entry stands for.
    pub multiplicity: Multiplicity,
    /// Spectral stability.
    pub stability: Stability,
    /// The curve on which it lies; `None` when no curve carries it.
    pub curve: Option<CurveName>,
}

/// All relative equilibria at one l.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibria {
    /// By rising h, then γ lexicographically.
    pub list: Vec<Equilibrium>,
    /// Bound on the error of every `h`.
    pub error_bound: f64,
    /// False when `f64` cannot decide whether further ones exist (l within rounding of a cusp).
    pub complete: bool,
}

/// Why there is no answer.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CriticalError {
    /// The body is beyond `f64`.
    #[error(transparent)]
    Equilibria(#[from] EquilibriaError),
    /// l is beyond `f64`.
    #[error(transparent)]
    Momentum(#[from] MomentumError),
}

/// All critical points of U_l with energy, angular velocity, Morse index and spectral stability.
///
/// They are complete whenever `complete` is true; within rounding of a cusp or pitchfork f64 cannot count them.
///
/// # Errors
/// [`CriticalError`] when the body or l leave the range of `f64`.
pub fn critical(body: &Body, l: &Number) -> Result<Equilibria, CriticalError> {
    let set = CriticalSet::new(body.frame())?;
    let frame = &set.frame;
    if l.to_f64() == 0.0 {
        let error_bound = 8.0 * UNIT_ROUNDOFF * frame.r_norm * frame.energy_unit;
        return Ok(Equilibria { list: sorted(at_rest(&set)), error_bound, complete: true });
    }
    let x = abscissa(frame, l.to_f64())?;
    let found = set.equilibria_at(x);
    let sign = l.to_f64().signum();
    let momentum = (2.0 * x).sqrt();
    let mut error_bound = 0.0_f64;
    let mut list = Vec::with_capacity(found.list.len());
    for equilibrium in &found.list {
        let point = &equilibrium.point;
        let rounding = 8.0 * UNIT_ROUNDOFF * point.x * point.slope();
        error_bound = error_bound.max((point.h_error() + rounding) * frame.energy_unit);
        list.push(Equilibrium {
            h: point.h() * frame.energy_unit,
            gamma: frame.vector_to_body(point.gamma),
            omega: sign * momentum / point.j * frame.frequency_unit,
            index: equilibrium.index,
            multiplicity: match equilibrium.orbit {
                Orbit::Circle(_) => Multiplicity::Circle,
                Orbit::Sphere => Multiplicity::Sphere,
                _ => Multiplicity::Points(if equilibrium.degenerate { 2 } else { 1 }),
            },
            stability: if equilibrium.degenerate {
                Stability::Degenerate
            } else {
                stability_of(frame, point.gamma, momentum / point.j)
            },
            curve: Some(CurveName::of(&set, equilibrium.curve)),
        });
    }
    Ok(Equilibria { list: sorted(list), error_bound, complete: found.complete })
}

/// l = 0: the body hangs (γ = r̂) or stands (γ = −r̂) at rest; for r = 0 every γ is an equilibrium.
fn at_rest(set: &CriticalSet) -> Vec<Equilibrium> {
    let frame = &set.frame;
    if frame.is_euler() {
        return vec![Equilibrium {
            h: 0.0,
            gamma: [0.0, 0.0, 1.0],
            omega: 0.0,
            index: 0,
            multiplicity: Multiplicity::Sphere,
            stability: Stability::Degenerate,
            curve: Some(CurveName::Rest),
        }];
    }
    let equilibrium = |(side, index): (f64, u8)| {
        let gamma = frame.r_hat().map(|c| side * c);
        let starts = |c: &CurveId| {
            let curve = &set.curves[*c];
            curve.is_critical() && curve.x()[0] == 0.0 && (curve.index == Some(0)) == (index == 0)
        };
        Equilibrium {
            h: -side * frame.r_norm * frame.energy_unit,
            gamma: frame.vector_to_body(gamma),
            omega: 0.0,
            index,
            multiplicity: Multiplicity::Points(1),
            stability: stability_of(frame, gamma, 0.0),
            curve: set.curves.ids().find(starts).map(|c| CurveName::of(set, c)),
        }
    };
    [(1.0, 0), (-1.0, 2)].map(equilibrium).to_vec()
}

fn sorted(mut list: Vec<Equilibrium>) -> Vec<Equilibrium> {
    list.sort_by(|p, q| {
        let by_gamma = (0..3).map(|k| p.gamma[k].total_cmp(&q.gamma[k]));
        by_gamma.fold(p.h.total_cmp(&q.h), std::cmp::Ordering::then)
    });
    list
}
