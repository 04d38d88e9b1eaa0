//! Relative equilibria as a document.

use numbers::Number;
use schema::{CriticalDocument, RelativeEquilibriumDocument, SCHEMA_VERSION};
use top::body::Body;
use top::critical::{Equilibria, Equilibrium, Multiplicity};
use top::stability::Stability;

use crate::body::texts;

/// The relative equilibria of a body at one l.
#[must_use]
pub fn critical(body: &Body, l: &Number, found: &Equilibria) -> CriticalDocument {
    let note = (!found.complete).then(|| {
        "l lies within rounding of a cusp or pitchfork: f64 cannot tell how many relative equilibria meet there"
            .to_owned()
    });
    CriticalDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: texts(body.moments()),
        center: texts(body.center()),
        l: l.text().to_owned(),
        critical: found.list.iter().map(equilibrium).collect(),
        error_bound: found.error_bound,
        complete: found.complete,
        note,
        inertia: None,
    }
}

fn equilibrium(found: &Equilibrium) -> RelativeEquilibriumDocument {
    RelativeEquilibriumDocument {
        h: found.h,
        gamma: found.gamma,
        omega: found.omega,
        index: found.index,
        multiplicity: match found.multiplicity {
            Multiplicity::Points(count) => schema::Multiplicity::Points(count),
            Multiplicity::Circle => schema::Multiplicity::Circle,
            Multiplicity::Sphere => schema::Multiplicity::Sphere,
        },
        stability: stability(found.stability),
        branch: found.curve.map_or_else(String::new, |curve| curve.to_string()),
    }
}

/// The word for a spectral type.
pub(crate) fn stability(kind: Stability) -> schema::Stability {
    match kind {
        Stability::Elliptic => schema::Stability::Elliptic,
        Stability::SaddleCentre => schema::Stability::SaddleCentre,
        Stability::Saddle => schema::Stability::Saddle,
        Stability::Complex => schema::Stability::Complex,
        Stability::Degenerate => schema::Stability::Degenerate,
    }
}
