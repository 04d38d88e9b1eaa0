//! Relative equilibria as a document.

use bifdiag_body::part::Spin;
use bifdiag_equilibria::critical::{Equilibria, Equilibrium};
use bifdiag_equilibria::stability::LinearType;
use bifdiag_numbers::Number;
use bifdiag_schema::{
    CriticalDocument, NonlinearDocument, NonlinearVerdict, Reason, RelativeEquilibriumDocument, SteadyAxesDocument,
    SteadyAxisDocument,
};

use crate::body::{given, head};
use crate::spin_change::asked_spin;
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
        spin: asked_spin(spin),
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

pub(crate) fn equilibrium(found: &Equilibrium) -> RelativeEquilibriumDocument {
    let (nonlinear, stability) = (nonlinear(&found.nonlinear), found.stability.term());
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

/// What is known of the stability where the verdict is this, or where nothing more than the type is known.
pub(crate) fn stable(found: Option<(NonlinearVerdict, Reason)>, kind: LinearType) -> bifdiag_schema::Verdict {
    let (verdict, why) = found.unwrap_or((NonlinearVerdict::Open, Reason::Degenerate));
    let nonlinear = NonlinearDocument::along(verdict, why, true);
    bifdiag_schema::Verdict::of(&nonlinear, kind.term())
}
