//! What a document is about.

use bifdiag_body::part::{Part, Units};
use bifdiag_body::{Body, PrincipalForm, TensorError};
use bifdiag_numbers::vector::dot;
use bifdiag_schema::{CommandLine, PartAnswerDocument, PartDocument};
use dashu_ratio::RBig;

use crate::body::{given, head};
use crate::integrals::integrable;

/// A body, and the part from which it was computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The body.
    pub body: Body,
    /// The part, if one was given.
    pub part: Option<PartDocument>,
    /// The units of the part.
    pub units: Option<Units>,
}

impl From<Body> for Subject {
    fn from(body: Body) -> Self {
        Self { body, part: None, units: None }
    }
}

impl Subject {
    /// The body of a part about its fixed point.
    ///
    /// # Errors
    /// [`TensorError`] for a tensor that is not positive definite.
    pub fn of_part(part: &Part) -> Result<Self, TensorError> {
        Ok(Self::new(part, part.principal()?))
    }

    /// The body of a part whose principal form is known.
    #[must_use]
    pub fn new(part: &Part, principal: PrincipalForm) -> Self {
        let document = crate::body::part(part, &principal);
        Self { body: principal.body, part: Some(document), units: Some(part.units.clone()) }
    }

    /// A vector of the question's frame, which is the part's, in principal axes; without a part they are the same.
    #[must_use]
    pub fn to_principal(&self, v: [f64; 3]) -> [f64; 3] {
        self.part.as_ref().map_or(v, |part| part.principal.axes.map(|axis| dot(axis, v)))
    }

    /// A vector in principal axes in the frame of the question.
    #[must_use]
    pub fn to_given(&self, v: [f64; 3]) -> [f64; 3] {
        let Some(part) = &self.part else { return v };
        std::array::from_fn(|i| (0..3).map(|k| part.principal.axes[k][i] * v[k]).sum())
    }

    /// The body's unit of time in seconds, exactly.
    #[must_use]
    pub fn unit_of_time(&self) -> RBig {
        self.units.as_ref().map_or(RBig::ONE, |units| units.time().clone())
    }

    /// One second in the body's unit of time.
    #[must_use]
    pub fn second(&self) -> f64 {
        1.0 / self.unit_of_time().to_f64().value()
    }

    /// The answer of `bifdiag body`, of a subject that is a part.
    #[must_use]
    pub fn part_answer(&self) -> Option<PartAnswerDocument> {
        Some(PartAnswerDocument {
            head: head(self.command("body").json()),
            part: self.part.clone()?,
            integrable: integrable(&self.body),
        })
    }

    /// `bifdiag COMMAND` with the options that describe the body.
    #[must_use]
    pub fn command(&self, command: &str) -> CommandLine {
        CommandLine::new(command).body(&given(&self.body), self.part.as_ref())
    }
}
