//! Witnesses: found, rounded, and confirmed by two methods.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::chart::{DIGITS, rounded};
use super::score::{Domain, Score, look};
use super::target::Target;
use crate::body::{Body, BodyError, Number};
use crate::certified::{CertifiedAtlas, NotProved};
use crate::classify::{ClassifyError, classify};
use crate::critical::{CriticalError, critical};
use crate::document::{Accuracy, ComponentDocument, MarginDocument};
use crate::topology::latitude::{self, SweepError};

/// A body and a point that show what was sought.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Witness {
    /// What it shows: `k3n1`, `M4`, a signature, a number of relative equilibria.
    #[serde(rename = "type")]
    pub kind: String,
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [Number; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [Number; 3],
    /// Energy.
    pub h: Number,
    /// Vertical angular momentum.
    pub l: Number,
    /// The components of U_hl.
    pub components: Vec<ComponentDocument>,
    /// Distance in h to the nearest curve.
    pub margin: MarginDocument,
    /// Relative equilibria at this l, where their number was sought.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub critical_points: Option<usize>,
}

/// How near the best body came.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearestDocument {
    /// A1, A2, A3.
    #[serde(rename = "A")]
    pub moments: [f64; 3],
    /// r1, r2, r3.
    #[serde(rename = "r")]
    pub center: [f64; 3],
    /// Energy.
    pub h: Option<f64>,
    /// Vertical angular momentum.
    pub l: Option<f64>,
    /// What is missing: the distance in h by which a pole would have to enter or leave, divided by |r|; or the number of
    /// relative equilibria.
    pub missing: f64,
}

/// The answer of `find`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FindDocument {
    /// Version of this document.
    pub schema_version: String,
    /// True when there is a witness.
    pub found: bool,
    /// What was sought.
    pub sought: String,
    /// The witness.
    #[serde(flatten)]
    pub witness: Option<Witness>,
    /// The methods that confirm it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub verified_by: Vec<String>,
    /// Bodies that were looked at while sampling.
    pub tried: u64,
    /// Of these, bodies that show it.
    pub showing: u64,
    /// Where nothing was found: the body that came nearest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest: Option<NearestDocument>,
}

/// Why a candidate is no witness.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum WitnessError {
    /// It does not show what was sought.
    #[error("the body does not show what was sought")]
    NotShown,
    /// The body cannot be made.
    #[error(transparent)]
    Body(#[from] BodyError),
    /// The first method has no answer.
    #[error(transparent)]
    Classify(#[from] ClassifyError),
    /// The relative equilibria cannot be found.
    #[error(transparent)]
    Critical(#[from] CriticalError),
    /// The components are not proved.
    #[error(transparent)]
    NotProved(#[from] NotProved),
    /// The second method has no answer.
    #[error(transparent)]
    Sweep(#[from] SweepError),
    /// Two methods disagree: a defect of this program.
    #[error("two methods disagree")]
    Disagreement,
}

/// Makes a witness of a body: h and l are rounded to a few digits, the merge tree and the latitude sweep must both
/// confirm the components there, and the margin must exceed its error bound; at [`Accuracy::Certified`] they are proved too.
///
/// # Errors
/// [`WitnessError`].
pub fn witness(values: [[f64; 3]; 2], target: &Target, accuracy: Accuracy) -> Result<Witness, WitnessError> {
    let everything = Domain { physical: false, moment_ratio: f64::INFINITY };
    let seen = look(values, target, &everything);
    let (Score::Shown(_), Some(at)) = (seen.score, seen.at) else { return Err(WitnessError::NotShown) };
    let body = Body::from_f64(values[0], values[1])?;
    let number = |x: f64| Number::from_f64(x).map_err(|_out_of_range| WitnessError::NotShown);
    let point = |digits: usize| {
        let [h, l] = at.map(|x| rounded(x, digits));
        let (h, l) = (number(h)?, number(l)?);
        let answer = classify(&body, &h, &l)?;
        Ok::<_, WitnessError>((h, l, answer))
    };
    // As few digits as leave most of the margin.
    let (mut h, mut l, mut answer) = point(DIGITS)?;
    for digits in 2..DIGITS {
        let rough = point(digits)?;
        if rough.2.components == answer.components && rough.2.margin.h >= 0.8 * answer.margin.h {
            (h, l, answer) = rough;
            break;
        }
    }
    let Some(components) = answer.components else { return Err(WitnessError::NotShown) };
    let frame = body.frame();
    let swept = latitude::components(&frame, h.to_f64() / frame.energy_unit, l.to_f64() / frame.momentum_unit)?;
    if swept.iter().map(ComponentDocument::from).ne(components.iter().cloned()) {
        return Err(WitnessError::Disagreement);
    }
    if accuracy == Accuracy::Certified
        && CertifiedAtlas::new(&body)?.classify(&h, &l).components.as_ref() != Some(&components)
    {
        return Err(WitnessError::Disagreement);
    }
    let critical_points = match target {
        Target::CriticalPoints(wanted) => {
            let found = critical(&body, &l)?;
            if !found.complete || found.critical.len() < *wanted as usize {
                return Err(WitnessError::NotShown);
            }
            Some(found.critical.len())
        }
        _ if target.accepts_region(&swept) => None,
        _ => return Err(WitnessError::NotShown),
    };
    Ok(Witness {
        kind: target.to_string(),
        moments: body.moments().clone(),
        center: body.center().clone(),
        h,
        l,
        components,
        margin: answer.margin,
        critical_points,
    })
}
