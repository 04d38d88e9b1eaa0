//! What a document is about.

use bifdiag_body::part::Part;
use bifdiag_body::{Body, TensorError};
use bifdiag_schema::{PartAnswerDocument, PartDocument};

use crate::command::{CommandLine, head};

/// A body, and the part from which it was computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// The body.
    pub body: Body,
    /// The part, if one was given.
    pub part: Option<PartDocument>,
}

impl From<Body> for Subject {
    fn from(body: Body) -> Self {
        Self { body, part: None }
    }
}

impl Subject {
    /// The body of a part about its fixed point.
    ///
    /// # Errors
    /// [`TensorError`] for a tensor that is not positive definite.
    pub fn of_part(part: &Part) -> Result<Self, TensorError> {
        let principal = part.principal()?;
        Ok(Self { part: Some(crate::body::part(part, &principal)), body: principal.body })
    }

    /// The answer of `bifdiag body`, of a subject that is a part.
    #[must_use]
    pub fn part_answer(&self) -> Option<PartAnswerDocument> {
        Some(PartAnswerDocument { head: head(self.command("body").json()), part: self.part.clone()? })
    }

    /// `bifdiag COMMAND` with the options that describe the body.
    #[must_use]
    pub fn command(&self, command: &str) -> CommandLine {
        let line = CommandLine::new(command);
        let Some(part) = &self.part else { return line.body(&self.body) };
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = &part.inertia;
        let products = [xy, xz, yz].iter().any(|product| *product != "0");
        line.option("inertia", [xx, yy, zz, xy, xz, yz].map(String::as_str).join(","))
            .option_if("products", products.then_some("tensor"))
            .option("com", part.com.join(","))
            .option("mass", &part.mass)
            .option("units", &part.units)
            .option("g", &part.g)
            .flag("unphysical", !part.physical)
    }
}
