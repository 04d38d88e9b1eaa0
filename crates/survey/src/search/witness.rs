//! Witnesses: found, rounded, and confirmed by two methods.

use thiserror::Error;

use super::chart::{DIGITS, rounded};
use super::score::{Domain, Score, look};
use super::target::Target;
use proof::{Accuracy, CertifiedAtlas, NotProved};
use top::body::{Body, BodyError, Number};
use top::classify::{ClassifyError, Components, Margin, classify};
use top::critical::{CriticalError, critical};
use top::topology::latitude::{self, SweepError};

/// A body and a point that show what was sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// What it shows.
    pub target: Target,
    /// The body.
    pub body: Body,
    /// Energy.
    pub h: Number,
    /// Vertical angular momentum.
    pub l: Number,
    /// The components of U_hl.
    pub components: Components,
    /// Distance in h to the nearest curve.
    pub margin: Margin,
    /// Relative equilibria at this l, where their number was sought.
    pub critical_points: Option<usize>,
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
        if rough.2.answer == answer.answer && rough.2.margin.h >= 0.8 * answer.margin.h {
            (h, l, answer) = rough;
            break;
        }
    }
    let Some(components) = answer.components().map(<[_]>::to_vec) else { return Err(WitnessError::NotShown) };
    let frame = body.frame();
    let swept = latitude::components(&frame, h.to_f64() / frame.energy_unit, l.to_f64() / frame.momentum_unit)?;
    if swept != components {
        return Err(WitnessError::Disagreement);
    }
    if accuracy == Accuracy::Certified && CertifiedAtlas::new(&body)?.classify(&h, &l).components() != Some(&components)
    {
        return Err(WitnessError::Disagreement);
    }
    let critical_points = match target {
        Target::CriticalPoints(wanted) => {
            let found = critical(&body, &l)?;
            if !found.complete || found.list.len() < *wanted as usize {
                return Err(WitnessError::NotShown);
            }
            Some(found.list.len())
        }
        _ if target.accepts_region(&swept) => None,
        _ => return Err(WitnessError::NotShown),
    };
    Ok(Witness { target: target.clone(), body, h, l, components, margin: answer.margin, critical_points })
}
