//! All relative equilibria of a body at one l.

use thiserror::Error;

use crate::atlas::{MomentumError, abscissa, curve_name};
use crate::body::{Body, Number};
use crate::document::{CriticalDocument, Multiplicity, RelativeEquilibriumDocument, SCHEMA_VERSION, Stability};
use crate::equilibria::{CriticalSet, EquilibriaError, Orbit};
use crate::numerics::UNIT_ROUNDOFF;
use crate::stability::stability_of;

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
/// They are complete whenever `complete` is true; within rounding of a cusp or pitchfork f64 cannot count them, and the
/// document says so.
///
/// # Errors
/// [`CriticalError`] when the body or l leave the range of `f64`.
pub fn critical(body: &Body, l: &Number) -> Result<CriticalDocument, CriticalError> {
    let set = CriticalSet::new(body.frame())?;
    let frame = &set.frame;
    if l.to_f64() == 0.0 {
        return Ok(document(body, l, at_rest(&set), 8.0 * UNIT_ROUNDOFF * frame.r_norm * frame.energy_unit, true));
    }
    let x = abscissa(frame, l.to_f64())?;
    let found = set.equilibria_at(x);
    let sign = l.to_f64().signum();
    let mut error_bound = 0.0_f64;
    let list = found
        .list
        .iter()
        .map(|equilibrium| {
            let point = &equilibrium.point;
            let rounding = 8.0 * UNIT_ROUNDOFF * point.x * point.slope();
            error_bound = error_bound.max((point.h_error() + rounding) * frame.energy_unit);
            let multiplicity = match equilibrium.orbit {
                Orbit::Circle(_) => Multiplicity::Circle,
                Orbit::Sphere => Multiplicity::Sphere,
                _ if equilibrium.degenerate => Multiplicity::Points(2),
                _ => Multiplicity::Points(1),
            };
            RelativeEquilibriumDocument {
                h: point.h() * frame.energy_unit,
                gamma: frame.vector_to_body(point.gamma),
                omega: sign * (2.0 * x).sqrt() / point.j * frame.frequency_unit,
                index: equilibrium.index,
                multiplicity,
                stability: if equilibrium.degenerate {
                    Stability::Degenerate
                } else {
                    stability_of(frame, point.gamma, (2.0 * x).sqrt() / point.j)
                },
                branch: curve_name(&set, equilibrium.curve),
            }
        })
        .collect();
    Ok(document(body, l, list, error_bound, found.complete))
}

/// l = 0: the body hangs (γ = r̂) or stands (γ = −r̂) at rest; for r = 0 every γ is an equilibrium.
fn at_rest(set: &CriticalSet) -> Vec<RelativeEquilibriumDocument> {
    let frame = &set.frame;
    if frame.is_euler() {
        return vec![RelativeEquilibriumDocument {
            h: 0.0,
            gamma: [0.0, 0.0, 1.0],
            omega: 0.0,
            index: 0,
            multiplicity: Multiplicity::Sphere,
            stability: Stability::Degenerate,
            branch: "l=0".to_owned(),
        }];
    }
    [(1.0, 0), (-1.0, 2)]
        .into_iter()
        .map(|(side, index)| {
            let gamma = frame.r_hat().map(|c| side * c);
            let starts = |c: &usize| {
                let curve = &set.curves[*c];
                curve.is_critical() && curve.x()[0] == 0.0 && (curve.index == Some(0)) == (index == 0)
            };
            let branch = (0..set.curves.len()).find(starts).map_or_else(String::new, |c| curve_name(set, c));
            RelativeEquilibriumDocument {
                h: -side * frame.r_norm * frame.energy_unit,
                gamma: frame.vector_to_body(gamma),
                omega: 0.0,
                index,
                multiplicity: Multiplicity::Points(1),
                stability: stability_of(frame, gamma, 0.0),
                branch,
            }
        })
        .collect()
}

fn document(
    body: &Body,
    l: &Number,
    mut critical: Vec<RelativeEquilibriumDocument>,
    error_bound: f64,
    complete: bool,
) -> CriticalDocument {
    critical.sort_by(|p, q| {
        let by_gamma = (0..3).map(|k| p.gamma[k].total_cmp(&q.gamma[k]));
        by_gamma.fold(p.h.total_cmp(&q.h), std::cmp::Ordering::then)
    });
    let note = (!complete).then(|| {
        "l lies within rounding of a cusp or pitchfork: f64 cannot tell how many relative equilibria meet there"
            .to_owned()
    });
    CriticalDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: body.moments().clone(),
        center: body.center().clone(),
        l: l.clone(),
        critical,
        error_bound,
        complete,
        note,
        inertia: None,
    }
}
