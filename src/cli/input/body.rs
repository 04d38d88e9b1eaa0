//! The body that the options describe.

use bifdiag_body::part::{MeasuredPart, Part, Units};
use bifdiag_body::{Body, BodyError, Number, Preset};
use bifdiag_documents::Subject;
use clap::Args;
use thiserror::Error;

use super::part::{GivenPart, PartArguments, PartInput, shown};
use super::values::{self, Triple};
use crate::cli::failure::{CommandError, Exit};
use crate::cli::terminal::Report;

/// The body, in one of three ways: by its principal moments, by name, or as a real part.
#[derive(Debug, Args)]
#[command(next_help_heading = "Body (one of three ways)")]
pub struct BodyArguments {
    /// Principal moments of inertia
    #[arg(long = "A", value_name = "A1,A2,A3", allow_hyphen_values = true, value_parser = values::moments)]
    pub moments: Option<Triple>,
    /// Centre of mass in principal axes, m g absorbed
    #[arg(long = "r", value_name = "r1,r2,r3", allow_hyphen_values = true, value_parser = values::center)]
    pub center: Option<Triple>,
    /// A named body; `bifdiag bodies` lists them
    #[arg(long, value_name = "NAME", hide_possible_values = true, value_parser = values::preset())]
    pub body: Option<&'static Preset>,
    #[command(flatten)]
    pub part: PartArguments,
}

/// The options do not describe a body.
#[derive(Debug, Error)]
pub enum BodyInput {
    #[error(
        "no body is given; use --A 2,1.1,1 --r 0.94868,0,0.61623, a named body such as --body paper, or a real part: --inertia-com"
    )]
    NoBody,
    #[error("--A is missing: --r also needs the principal moments, such as --A 2,1.1,1")]
    NoMoments,
    #[error("--r is missing: --A also needs the centre of mass, such as --r 0.94868,0,0.61623")]
    NoCenter,
    #[error(
        "{first} and {second} both describe the body; give one of --A with --r, --body, --inertia, --inertia-com, --part"
    )]
    TwoBodies { first: &'static str, second: &'static str },
    #[error(transparent)]
    Part(#[from] PartInput),
    #[error("--A with --r: {0}")]
    Body(#[from] BodyError),
}

/// A body, and how its part was measured where the numbers of the part are not exact.
pub type MeasuredSubject = (Subject, Option<(Part, MeasuredPart)>);

impl CommandError for BodyInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

impl BodyArguments {
    /// The body of the options.
    pub fn subject(&self) -> Result<Subject, BodyInput> {
        self.optional_subject()?.ok_or(BodyInput::NoBody)
    }

    /// The body of the options, or `None` if none of them was given.
    pub fn optional_subject(&self) -> Result<Option<Subject>, BodyInput> {
        self.given_body(PartArguments::part).map(|given| given.map(|(subject, _)| subject))
    }

    /// The body of the options, and how its part was measured where its numbers are not exact.
    pub fn measured_subject(&self) -> Result<MeasuredSubject, BodyInput> {
        self.given_body(PartArguments::measured_part)?.ok_or(BodyInput::NoBody)
    }

    fn given_body(
        &self,
        read: impl Fn(&PartArguments) -> Result<Option<GivenPart>, PartInput>,
    ) -> Result<Option<MeasuredSubject>, BodyInput> {
        /// Which of the three ways an option belongs to.
        fn way(option: &str) -> usize {
            match option {
                "--A" | "--r" => 0,
                "--body" => 1,
                _ => 2,
            }
        }
        if let Some(first) = self.given().next()
            && let Some(second) = self.given().find(|option| way(option) != way(first))
        {
            return Err(BodyInput::TwoBodies { first, second });
        }
        let mut measured = None;
        let subject = match (&self.moments, &self.center, self.body) {
            (Some(_), None, _) => return Err(BodyInput::NoCenter),
            (None, Some(_), _) => return Err(BodyInput::NoMoments),
            (Some(moments), Some(center), _) => Body::new(moments.0.clone(), center.0.clone())?.into(),
            (None, None, Some(preset)) => preset.body().into(),
            (None, None, None) => match read(&self.part)? {
                Some(given) => {
                    let document = given.document();
                    measured = given.measured.map(|measured| (given.part, measured));
                    Subject { part: Some(document), body: given.principal.body }
                }
                None => return Ok(None),
            },
        };
        warn(&subject);
        Ok(Some((subject, measured)))
    }

    /// The options that are given, by name.
    pub fn given(&self) -> impl Iterator<Item = &'static str> {
        let options =
            [("--A", self.moments.is_some()), ("--r", self.center.is_some()), ("--body", self.body.is_some())];
        options.into_iter().filter(|(_, given)| *given).map(|(name, _)| name).chain(self.part.given())
    }
}

/// A and r, and how they came about.
pub fn head(subject: &Subject, report: &mut Report) {
    let join = |numbers: &[Number; 3]| numbers.each_ref().map(|number| shown(number.text())).join(", ");
    report.line(format!("A = ({})", join(subject.body.moments())));
    report.line(format!("r = ({})", join(subject.body.center())));
    let Some(part) = &subject.part else { return };
    if let Ok(units) = part.units.parse::<Units>() {
        let [moment, energy, momentum] = [units.moment(), units.energy(), units.momentum()];
        report.line(format!("A in {moment}, r and h in {energy}, l in {momentum}; the principal axes are the rows of"));
    }
    for [x, y, z] in part.principal.axes {
        report.line(format!("  ({x:>9.6}, {y:>9.6}, {z:>9.6})"));
    }
}

/// Warns of what is accepted but strange.
fn warn(subject: &Subject) {
    if subject.body.flags().unphysical {
        tracing::warn!(
            "no distribution of mass has these moments and this centre of mass (it needs Ai + Aj > Ak, or Ai + Aj = Ak \
             with rk = 0); the answer is that of the equations"
        );
    } else if subject.part.as_ref().is_some_and(|part| !part.physical) {
        tracing::warn!("no distribution of mass has these mass properties; the answer is that of the equations");
    }
}
