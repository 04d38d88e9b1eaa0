//! Relative equilibria as a document.

use bifdiag_body::part::Spin;
use bifdiag_equilibria::critical::{Equilibria, Equilibrium};
use bifdiag_equilibria::stability::LinearType;
use bifdiag_numbers::Number;
use bifdiag_schema::{
    CriticalDocument, NonlinearDocument, NonlinearVerdict, Reason, RelativeEquilibriumDocument, SteadyAxesDocument,
    SteadyAxisDocument,
};

use crate::body::given;
use crate::command::head;
use crate::stability::{friction, nonlinear};
use crate::subject::Subject;

/// The relative equilibria of a body at one l.
#[must_use]
pub fn critical(subject: &Subject, l: &Number, found: &Equilibria) -> CriticalDocument {
    let body = &subject.body;
    let method = found.by_continuation.then_some("newton");
    let note = (!found.complete).then(|| {
        "l lies beside cusps that are closer to one another than 2^-4000: how many relative equilibria meet there is \
         not decided"
            .to_owned()
    });
    CriticalDocument {
        head: head(subject.command("critical").option("l", l.text()).option_if("method", method).json()),
        body: given(body),
        l: l.text().to_owned(),
        critical: equilibria(found),
        error_bound: found.error_bound,
        complete: found.complete,
        note,
        part: subject.part.clone(),
    }
}

/// The axes about which a body turns steadily at a spin.
#[must_use]
pub fn steady_axes(subject: &Subject, spin: &Spin, found: &Equilibria) -> SteadyAxesDocument {
    let axis = |found: &Equilibrium| SteadyAxisDocument {
        // γ points down.
        axis: subject.to_given(found.gamma.map(|x| 0.0 - x)),
        l: found.l,
        fold: found.is_fold,
        equilibrium: equilibrium(found),
    };
    SteadyAxesDocument {
        head: head(subject.command("critical").option("spin", spin).json()),
        body: given(&subject.body),
        spin: crate::spin::asked_spin(spin),
        axes: found.list.iter().map(axis).collect(),
        error_bound: found.error_bound,
        complete: found.complete,
        part: subject.part.clone(),
    }
}

/// Each of the relative equilibria.
#[must_use]
pub fn equilibria(found: &Equilibria) -> Vec<RelativeEquilibriumDocument> {
    found.list.iter().map(equilibrium).collect()
}

fn equilibrium(found: &Equilibrium) -> RelativeEquilibriumDocument {
    let (nonlinear, stability) = (nonlinear(&found.nonlinear), stability(found.stability));
    RelativeEquilibriumDocument {
        h: found.h,
        gamma: found.gamma,
        omega: found.omega,
        index: found.index,
        multiplicity: found.multiplicity,
        stability,
        stable: bifdiag_schema::Verdict::of(&nonlinear, stability),
        nonlinear,
        friction: friction(&found.friction, &found.eigenvalues.pairs),
        eigenvalues: found.eigenvalues.pairs,
        eigenvalue_error: found.eigenvalues.error,
        branch: found.curve.map_or_else(String::new, |curve| curve.to_string()),
        branch_name: found.branch_name.to_string(),
    }
}

/// The words for linear types, in the order of [`type_code`].
pub const LINEAR_TYPES: [bifdiag_schema::Stability; 7] = [
    bifdiag_schema::Stability::Elliptic,
    bifdiag_schema::Stability::SaddleCentre,
    bifdiag_schema::Stability::Saddle,
    bifdiag_schema::Stability::Complex,
    bifdiag_schema::Stability::DoubleElliptic,
    bifdiag_schema::Stability::DoubleReal,
    bifdiag_schema::Stability::Zero,
];

/// The words for what is known of the stability.
pub const VERDICTS: [bifdiag_schema::Verdict; 6] = [
    bifdiag_schema::Verdict::Energy,
    bifdiag_schema::Verdict::Integral,
    bifdiag_schema::Verdict::Arnold,
    bifdiag_schema::Verdict::Spectrum,
    bifdiag_schema::Verdict::Unstable,
    bifdiag_schema::Verdict::Open,
];

/// The place of a linear type among [`LINEAR_TYPES`].
#[must_use]
pub fn type_code(kind: LinearType) -> i8 {
    match kind {
        LinearType::Elliptic => 0,
        LinearType::SaddleCentre => 1,
        LinearType::Saddle => 2,
        LinearType::Complex => 3,
        LinearType::DoubleElliptic => 4,
        LinearType::DoubleReal => 5,
        LinearType::Zero | LinearType::ZeroReal => 6,
    }
}

/// What is known of the stability where the verdict is this, or where nothing more than the type is told.
pub(crate) fn stable(found: Option<(NonlinearVerdict, Reason)>, kind: LinearType) -> bifdiag_schema::Verdict {
    let told = found.unwrap_or((NonlinearVerdict::Open, Reason::Degenerate));
    let nonlinear = NonlinearDocument::along(told.0, told.1, true);
    bifdiag_schema::Verdict::of(&nonlinear, stability(kind))
}

/// The word for a linear type.
#[must_use]
pub fn stability(kind: LinearType) -> bifdiag_schema::Stability {
    LINEAR_TYPES[type_code(kind).unsigned_abs() as usize]
}
