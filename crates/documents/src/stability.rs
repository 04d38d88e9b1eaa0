//! Verdicts on the stability of relative equilibria, and what friction leaves of them, as documents.

use bifdiag_equilibria::nonlinear::{Friction, Nonlinear, Verdict, Why};
use bifdiag_schema::{Damped, FrictionDocument, NonlinearDocument, NonlinearVerdict, Reason, ResonancesDocument};

/// The words for verdicts, in the order of their declaration.
pub const NONLINEAR_VERDICTS: [NonlinearVerdict; 3] =
    [NonlinearVerdict::Stable, NonlinearVerdict::Unstable, NonlinearVerdict::Open];

/// The words for reasons, in the order of their declaration.
pub const REASONS: [Reason; 8] = [
    Reason::Energy,
    Reason::Integral,
    Reason::Arnold,
    Reason::Spectrum,
    Reason::Resonance12,
    Reason::Resonance13,
    Reason::Resonance11,
    Reason::Degenerate,
];

/// The word for a verdict.
#[must_use]
pub fn nonlinear_verdict(verdict: Verdict) -> NonlinearVerdict {
    match verdict {
        Verdict::Stable => NonlinearVerdict::Stable,
        Verdict::Unstable => NonlinearVerdict::Unstable,
        Verdict::Open => NonlinearVerdict::Open,
    }
}

/// The word for a reason.
#[must_use]
pub fn reason(why: Why) -> Reason {
    match why {
        Why::Energy => Reason::Energy,
        Why::Integral => Reason::Integral,
        Why::Arnold => Reason::Arnold,
        Why::Spectrum => Reason::Spectrum,
        Why::Resonance12 => Reason::Resonance12,
        Why::Resonance13 => Reason::Resonance13,
        Why::Resonance11 => Reason::Resonance11,
        Why::Degenerate => Reason::Degenerate,
    }
}

/// A verdict with all that it rests on.
#[must_use]
pub fn nonlinear(found: &Nonlinear) -> NonlinearDocument {
    NonlinearDocument {
        verdict: nonlinear_verdict(found.verdict),
        why: reason(found.why),
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
