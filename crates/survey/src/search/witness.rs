//! Witnesses: found, rounded, and confirmed by two methods.

use std::fmt;

use thiserror::Error;

use super::score::{Domain, Score, Seen, look};
use super::target::Target;
use crate::digits::{DIGITS, rounded};
use bifdiag_body::{Body, BodyError};
use bifdiag_diagram::topology::latitude::{self, SweepError};
use bifdiag_diagram::topology::{Classification, Components, Margin};
use bifdiag_equilibria::critical::{CriticalError, critical};
use bifdiag_exact::{Accuracy, AnswerError, classify};
use bifdiag_numbers::Number;

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
    /// The methods that confirm it.
    pub methods: Vec<Method>,
}

/// A way to find the components of U_hl.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// Minima joined by saddles.
    MergeTree,
    /// Circles of latitude, without any critical point.
    LatitudeSweep,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::MergeTree => "merge tree",
            Self::LatitudeSweep => "latitude sweep",
        })
    }
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
    Classify(#[from] AnswerError),
    /// The relative equilibria cannot be found.
    #[error(transparent)]
    Critical(#[from] CriticalError),
    /// The second method has no answer.
    #[error(transparent)]
    Sweep(#[from] SweepError),
    /// Two methods disagree: a defect of this program.
    #[error("two methods disagree")]
    Disagreement,
}

impl Witness {
    /// Confirms that a body shows what is sought at a point: the merge tree and the latitude sweep must give the same
    /// components there, and the margin must exceed its error bound.
    ///
    /// # Errors
    /// [`WitnessError`].
    pub fn confirm(body: Body, [h, l]: [Number; 2], target: &Target, accuracy: Accuracy) -> Result<Self, WitnessError> {
        let answer = classify(&body, &h, &l, accuracy)?;
        Self::confirm_answer(body, [h, l], &answer, target)
    }

    fn confirm_answer(
        body: Body,
        [h, l]: [Number; 2],
        answer: &Classification,
        target: &Target,
    ) -> Result<Self, WitnessError> {
        let Some(components) = answer.components().map(<[_]>::to_vec) else { return Err(WitnessError::NotShown) };
        let methods = vec![Method::MergeTree, Method::LatitudeSweep];
        let frame = body.frame();
        let swept = latitude::components(&frame, h.to_f64() / frame.energy_unit, l.to_f64() / frame.momentum_unit)?;
        if swept != components {
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
        let (target, margin) = (target.clone(), answer.margin);
        Ok(Self { target, body, h, l, components, margin, critical_points, methods })
    }

    /// Makes a witness of a body: the place where it shows best what is sought, with h and l rounded to a few digits,
    /// is [confirmed](Self::confirm).
    ///
    /// # Errors
    /// [`WitnessError`].
    pub fn of_body(values: [[f64; 3]; 2], target: &Target, accuracy: Accuracy) -> Result<Self, WitnessError> {
        let everything = Domain { physical: false, moment_ratio: f64::INFINITY };
        let Some(Seen { score: Score::Shown(_), at: Some(at) }) = look(values, target, &everything) else {
            return Err(WitnessError::NotShown);
        };
        let body = Body::from_f64(values[0], values[1])?;
        let (point, answer) = plain_point(&body, at, accuracy)?;
        Self::confirm_answer(body, point, &answer, target)
    }
}

/// A point (h, l) with as few digits as leave most of its margin.
fn plain_point(body: &Body, at: [f64; 2], accuracy: Accuracy) -> Result<([Number; 2], Classification), WitnessError> {
    /// The share of the margin that must be left.
    const KEPT: f64 = 0.8;
    let number = |x: f64| Number::from_f64(x).map_err(|_out_of_range| WitnessError::NotShown);
    let point = |digits: usize| {
        let [h, l] = at.map(|x| rounded(x, digits));
        let (h, l) = (number(h)?, number(l)?);
        let answer = classify(body, &h, &l, accuracy)?;
        Ok::<_, WitnessError>(([h, l], answer))
    };
    let exact = point(DIGITS)?;
    for digits in 2..DIGITS {
        let rough = point(digits)?;
        if rough.1.answer == exact.1.answer && rough.1.margin.h >= KEPT * exact.1.margin.h {
            return Ok(rough);
        }
    }
    Ok(exact)
}
