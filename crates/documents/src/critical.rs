//! Relative equilibria as a document.

use numbers::Number;
use schema::{CriticalDocument, CurveDocument, RelativeEquilibriumDocument};
use top::atlas::Atlas;
use top::critical::{Equilibria, Equilibrium, Multiplicity};
use top::curves::CurveName;
use top::stability::{ChangeKind, LinearType, Setting, Verdict};

use crate::body::given;
use crate::command::head;
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

/// Each of the relative equilibria.
#[must_use]
pub fn equilibria(found: &Equilibria) -> Vec<RelativeEquilibriumDocument> {
    found.list.iter().map(equilibrium).collect()
}

fn equilibrium(found: &Equilibrium) -> RelativeEquilibriumDocument {
    RelativeEquilibriumDocument {
        h: found.h,
        gamma: found.gamma,
        omega: found.omega,
        index: found.index,
        multiplicity: multiplicity(found.multiplicity),
        stability: stability(found.stability),
        stable: verdict(found.verdict),
        eigenvalues: found.eigenvalues.pairs,
        eigenvalue_error: found.eigenvalues.error,
        branch: found.curve.map_or_else(String::new, |curve| curve.to_string()),
        branch_name: found.branch_name.to_string(),
    }
}

/// How many critical points an entry stands for.
#[must_use]
pub fn multiplicity(found: Multiplicity) -> schema::Multiplicity {
    match found {
        Multiplicity::Points(count) => schema::Multiplicity::Points(count),
        Multiplicity::Circle => schema::Multiplicity::Circle,
        Multiplicity::Sphere => schema::Multiplicity::Sphere,
    }
}

/// The words for linear types, in the order of [`type_code`].
pub const LINEAR_TYPES: [schema::Stability; 7] = [
    schema::Stability::Elliptic,
    schema::Stability::SaddleCentre,
    schema::Stability::Saddle,
    schema::Stability::Complex,
    schema::Stability::DoubleElliptic,
    schema::Stability::DoubleReal,
    schema::Stability::Zero,
];

/// The words for verdicts, in the order of [`verdict_code`].
pub const VERDICTS: [schema::Verdict; 5] = [
    schema::Verdict::Energy,
    schema::Verdict::Integral,
    schema::Verdict::Spectrum,
    schema::Verdict::Unstable,
    schema::Verdict::Open,
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

/// The place of a verdict among [`VERDICTS`].
#[must_use]
pub fn verdict_code(verdict: Verdict) -> i8 {
    match verdict {
        Verdict::Energy => 0,
        Verdict::Integral => 1,
        Verdict::Spectrum => 2,
        Verdict::Unstable => 3,
        Verdict::Open => 4,
    }
}

/// The word for a verdict.
#[must_use]
pub fn verdict(verdict: Verdict) -> schema::Verdict {
    VERDICTS[verdict_code(verdict).unsigned_abs() as usize]
}

/// What is known of the rotations of a curve of an atlas where they have this type; `None` for a pole line.
#[must_use]
pub fn verdict_along(atlas: &Atlas, curve: &CurveDocument, kind: schema::Stability) -> Option<schema::Verdict> {
    let set = &atlas.arrangement().set;
    let (_, found) = set.curves.pairs().find(|(id, _)| CurveName::of(set, *id).to_string() == curve.id)?;
    let kind = LinearType::ALL.into_iter().find(|known| stability(*known) == kind)?;
    Setting::along(set, found).map(|setting| verdict(setting.verdict(kind)))
}

/// The word for a linear type.
pub(crate) fn stability(kind: LinearType) -> schema::Stability {
    LINEAR_TYPES[type_code(kind).unsigned_abs() as usize]
}

/// The word for a change of the linear type.
pub(crate) fn change(kind: ChangeKind) -> schema::StabilityChangeKind {
    match kind {
        ChangeKind::HamiltonianHopf => schema::StabilityChangeKind::HamiltonianHopf,
        ChangeKind::RealCollision => schema::StabilityChangeKind::RealCollision,
        ChangeKind::Zero => schema::StabilityChangeKind::Zero,
    }
}
