//! Witnesses: known or found, rounded, and confirmed by two methods.

use thiserror::Error;

use super::score::{Score, ScoredPoint, SearchDomain, look};
use super::target::Target;
use bifdiag_body::{Body, BodyError};
use bifdiag_diagram::topology::latitude::{self, SweepError};
use bifdiag_diagram::topology::{Classification, Component, Components, Margin};
use bifdiag_equilibria::critical::{CriticalError, Equilibrium, Multiplicity, critical};
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
}

/// The ways in which every witness is confirmed: minima joined by saddles, and circles of latitude without any critical point.
pub const METHODS: [&str; 2] = ["merge tree", "latitude sweep"];

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
        let frame = body.frame();
        let swept = latitude::components(&frame, h.to_f64() / frame.energy_unit, l.to_f64() / frame.momentum_unit)?;
        if swept != components {
            return Err(WitnessError::Disagreement);
        }
        let critical_points = match target {
            Target::CriticalPoints(wanted) => {
                let found = critical(&body, &l)?;
                let is_isolated = |at: &&Equilibrium| matches!(at.multiplicity, Multiplicity::Points(_));
                let isolated = found.list.iter().filter(is_isolated).count();
                if !found.complete || isolated < *wanted as usize {
                    return Err(WitnessError::NotShown);
                }
                Some(isolated)
            }
            _ if target.accepts_region(&swept) => None,
            _ => return Err(WitnessError::NotShown),
        };
        let (target, margin) = (target.clone(), answer.margin);
        Ok(Self { target, body, h, l, components, margin, critical_points })
    }

    /// Makes a witness of a body: the place where it shows best what is sought is [confirmed](Self::confirm), with h and l
    /// rounded to as few digits as leave most of its margin, where such a place is confirmed too.
    ///
    /// # Errors
    /// [`WitnessError`].
    pub fn of_body(values: [[f64; 3]; 2], target: &Target, accuracy: Accuracy) -> Result<Self, WitnessError> {
        let everything = SearchDomain { physical: false, moment_ratio: f64::INFINITY };
        let Some(ScoredPoint { score: Score::Shown(_), at: Some(at) }) = look(values, target, &everything) else {
            return Err(WitnessError::NotShown);
        };
        let body = Body::from_f64(values[0], values[1])?;
        let number = |x: f64| Number::from_f64(x).map_err(|_out_of_range| WitnessError::NotShown);
        let rounded_to = |digits: usize| {
            let [h, l] = at.map(|x| rounded(x, digits));
            Self::confirm(body.clone(), [number(h)?, number(l)?], target, accuracy)
        };
        let exact = rounded_to(ALL_DIGITS)?;
        let is_as_good = |rough: &Self| rough.components == exact.components && rough.margin.h >= KEPT * exact.margin.h;
        Ok((2..ALL_DIGITS).find_map(|digits| rounded_to(digits).ok().filter(is_as_good)).unwrap_or(exact))
    }
}

/// The share of the margin that is left where h and l are rounded.
const KEPT: f64 = 0.8;

/// Significant digits of a double.
const ALL_DIGITS: usize = 17;

/// A body and a point with the components of U_hl there.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownPoint {
    /// The body.
    pub body: Body,
    /// Energy.
    pub h: Number,
    /// Vertical angular momentum.
    pub l: Number,
    /// The components of U_hl.
    pub components: Vec<Component>,
}

/// The first of the known points that shows what is sought, with a body in the domain; confirmed again.
#[must_use]
pub fn known_witness(
    known: &[KnownPoint],
    target: &Target,
    domain: &SearchDomain,
    accuracy: Accuracy,
) -> Option<Witness> {
    let shows = |point: &&KnownPoint| target.accepts_region(&point.components) && domain.holds(&point.body);
    known.iter().filter(shows).find_map(|point| {
        let place = [point.h.clone(), point.l.clone()];
        Witness::confirm(point.body.clone(), place, target, accuracy).ok()
    })
}

/// The nearest number with a few significant digits.
pub(super) fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x)
}
