//! The body that the options describe.

use clap::Args;
use schema::InertiaDocument;
use thiserror::Error;
use top::body::{Body, BodyError, InertiaError, MassProperties, Number, Preset};

use super::values::{self, Tensor, Triple};
use crate::cli::failure::{CommandError, Exit};
use crate::cli::terminal::Report;

/// The body, in one of three ways.
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
    /// Inertia tensor about the fixed point in kg m²: matrix entries, so that Ixy = -∫ x y dm
    #[arg(long, value_name = "Ixx,Iyy,Izz,Ixy,Ixz,Iyz", allow_hyphen_values = true, value_parser = values::tensor)]
    pub inertia: Option<Tensor>,
    /// Centre of mass from the fixed point in m (with --inertia)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::center_of_mass)]
    pub com: Option<Triple>,
    /// Mass in kg (with --inertia)
    #[arg(long, value_name = "m", allow_hyphen_values = true, value_parser = values::mass)]
    pub mass: Option<Number>,
    /// Acceleration of gravity in m/s² (with --inertia)
    #[arg(long = "g", value_name = "g", allow_hyphen_values = true, value_parser = values::gravity)]
    pub gravity: Option<Number>,
}

/// The options do not describe a body.
#[derive(Debug, Error)]
pub enum BodyInput {
    #[error("no body is given; use --A 2,1.1,1 --r 0.94868,0,0.61623, a named body such as --body paper, or --inertia")]
    NoBody,
    #[error("--A is missing: --r also needs the principal moments, such as --A 2,1.1,1")]
    NoMoments,
    #[error("--r is missing: --A also needs the centre of mass, such as --r 0.94868,0,0.61623")]
    NoCenter,
    #[error("{first} and {second} both describe the body; give one of --A with --r, --body, --inertia")]
    TwoBodies { first: &'static str, second: &'static str },
    #[error("{missing} is missing: {given} also needs it, such as {example}")]
    PartIncomplete { given: &'static str, missing: &'static str, example: &'static str },
    #[error("--inertia {value}: {source}")]
    Inertia { value: String, source: InertiaError },
    #[error("--A with --r: {0}")]
    Body(#[from] BodyError),
}

impl CommandError for BodyInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// A body, and the part from which it was computed.
#[derive(Clone, Debug)]
pub struct Subject {
    pub body: Body,
    pub inertia: Option<InertiaDocument>,
}

impl From<Body> for Subject {
    fn from(body: Body) -> Self {
        Self { body, inertia: None }
    }
}

impl BodyArguments {
    /// The body of the options.
    pub fn subject(&self) -> Result<Subject, BodyInput> {
        self.optional_subject()?.ok_or(BodyInput::NoBody)
    }

    /// The body of the options, or `None` if none of them was given.
    pub fn optional_subject(&self) -> Result<Option<Subject>, BodyInput> {
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
        let subject = match (&self.moments, &self.center, self.body) {
            (Some(_), None, _) => return Err(BodyInput::NoCenter),
            (None, Some(_), _) => return Err(BodyInput::NoMoments),
            (Some(moments), Some(center), _) => Body::new(moments.0.clone(), center.0.clone())?.into(),
            (None, None, Some(preset)) => preset.body().into(),
            (None, None, None) => match self.part()? {
                Some(part) => part,
                None => return Ok(None),
            },
        };
        subject.warn();
        Ok(Some(subject))
    }

    /// The options that are given, by name.
    pub fn given(&self) -> impl Iterator<Item = &'static str> {
        let options = [
            ("--A", self.moments.is_some()),
            ("--r", self.center.is_some()),
            ("--body", self.body.is_some()),
            ("--inertia", self.inertia.is_some()),
            ("--com", self.com.is_some()),
            ("--mass", self.mass.is_some()),
            ("--g", self.gravity.is_some()),
        ];
        options.into_iter().filter(|(_, given)| *given).map(|(name, _)| name)
    }

    /// The body of a full inertia tensor.
    fn part(&self) -> Result<Option<Subject>, BodyInput> {
        let (Some(tensor), Some(com), Some(mass), Some(gravity)) =
            (&self.inertia, &self.com, &self.mass, &self.gravity)
        else {
            let needed = [
                ("--inertia", "--inertia 0.30,0.21,0.17,0.01,0,-0.02 (kg m²)"),
                ("--com", "--com 0,0.02,0.15 (m)"),
                ("--mass", "--mass 2.5 (kg)"),
                ("--g", "--g 9.80665 (m/s²)"),
            ];
            let missing = needed.into_iter().find(|(option, _)| self.given().all(|given| given != *option));
            let (Some(given), Some((missing, example))) = (self.given().next(), missing) else { return Ok(None) };
            return Err(BodyInput::PartIncomplete { given, missing, example });
        };
        let part = MassProperties {
            tensor: tensor.0.clone(),
            center_of_mass: com.0.clone(),
            mass: mass.clone(),
            gravity: gravity.clone(),
        };
        let principal = part
            .to_principal_axes()
            .map_err(|source| BodyInput::Inertia { value: tensor.0.each_ref().map(Number::text).join(","), source })?;
        let inertia = documents::part(&part, &principal);
        Ok(Some(Subject { body: principal.body().clone(), inertia: Some(inertia) }))
    }
}

impl Subject {
    /// A and r, and how they came about.
    pub fn head(&self, report: &mut Report) {
        let join = |numbers: &[Number; 3]| numbers.each_ref().map(Number::text).join(", ");
        report.line(format!("A = ({})", join(self.body.moments())));
        report.line(format!("r = ({})", join(self.body.center())));
        if let Some(inertia) = &self.inertia {
            report.line("A in kg m², r in N m, h in J, l in kg m²/s; the principal axes are the columns of");
            for [x, y, z] in inertia.rotation {
                report.line(format!("  ({x:>9.6}, {y:>9.6}, {z:>9.6})"));
            }
        }
    }

    /// Warns of what is accepted but strange.
    fn warn(&self) {
        let unphysical = self.inertia.as_ref().map_or(self.body.flags().unphysical, |inertia| inertia.unphysical);
        if unphysical {
            tracing::warn!(
                "A violates the triangle inequality Ai + Aj >= Ak: no distribution of mass has these moments; \
                 the answer is that of the equations"
            );
        } else if self.inertia.as_ref().is_some_and(|inertia| !inertia.parallel_axes) {
            tracing::warn!(
                "this mass at this centre of mass alone needs larger moments than --inertia says; the tensor must be \
                 about the fixed point, not about the centre of mass"
            );
        }
    }
}
