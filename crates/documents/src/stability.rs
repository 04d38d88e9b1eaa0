//! Verdicts on the stability of relative equilibria, and what friction leaves of them, as documents.

use bifdiag_equilibria::nonlinear::{Friction, Nonlinear, VerdictChange};
use bifdiag_schema::{Damped, FrictionDocument, IsolatedSpinDocument, NonlinearDocument, ResonancesDocument};

use crate::spin_change::spin;

/// A verdict with all that it rests on.
#[must_use]
pub fn nonlinear(found: &Nonlinear) -> NonlinearDocument {
    NonlinearDocument {
        verdict: found.verdict,
        why: found.why,
        d4_over_s: found.arnold.map(|determinant| determinant.value),
        d4_error: found.arnold.map(|determinant| determinant.error),
        near: found.near.map(|[one_to_one, one_to_two, one_to_three]| ResonancesDocument {
            one_to_one,
            one_to_two,
            one_to_three,
        }),
        proved: found.proved,
    }
}

/// An isolated spin at which Arnold's theorem does not apply; `second` is one second in the body's unit of time.
pub(crate) fn isolated_spin(change: &VerdictChange, second: f64) -> IsolatedSpinDocument {
    IsolatedSpinDocument {
        spin: spin(change.omega * second),
        kind: change.kind,
        verdict: change.verdict,
        why: change.why,
    }
}

/// What friction leaves, with the rates of the eigenvalues that have one.
#[must_use]
pub fn friction(found: &Friction, eigenvalues: &[[f64; 2]; 2]) -> FrictionDocument {
    let rates = eigenvalues.iter().zip(found.rates).filter_map(|(pair, rate)| Some((*pair, rate?)));
    FrictionDocument { conserving_l: found.survives.map(damped), growing: found.growing, rates: rates.collect() }
}

/// The word for what friction leaves.
pub(crate) fn damped(survives: bool) -> Damped {
    if survives { Damped::Survives } else { Damped::Lost }
}
