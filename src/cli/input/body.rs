//! The body that the options describe.

use bifdiag_body::part::{MeasuredPart, Part, Units};
use bifdiag_body::{Body, Number, Preset};
use bifdiag_documents::Subject;
use bifdiag_schema::FurtherIntegralDocument;
use clap::Args;

use super::part::{GivenPart, PartArguments, shown, shown_of_part};
use super::values::{self, Triple};
use crate::cli::failure::Failure;
use crate::cli::terminal::{Report, fixed, significant};

/// The body, by its principal moments or by name.
#[derive(Debug, Args)]
#[command(next_help_heading = "Body")]
pub struct PlainBodyArguments {
    /// Principal moments of inertia
    #[arg(long = "A", value_name = "A1,A2,A3", allow_hyphen_values = true, value_parser = values::moments)]
    pub moments: Option<Triple>,
    /// Centre of mass in principal axes, multiplied by m g
    #[arg(long = "r", value_name = "r1,r2,r3", allow_hyphen_values = true, value_parser = values::center)]
    pub center: Option<Triple>,
    /// A named body; `bifdiag bodies` lists them
    #[arg(long, value_name = "NAME", hide_possible_values = true, ignore_case = true, value_parser = values::preset())]
    pub body: Option<&'static Preset>,
}

/// The body, in one of three ways: by its principal moments, by name, or as a real part.
#[derive(Debug, Args)]
pub struct BodyArguments {
    #[command(flatten)]
    pub plain: PlainBodyArguments,
    #[command(flatten)]
    pub part: PartArguments,
}

/// A point of the plane.
#[derive(Debug, Args)]
#[command(next_help_heading = "Point")]
pub struct PointArguments {
    /// Energy
    #[arg(long = "h", value_name = "h", allow_hyphen_values = true, value_parser = values::number)]
    pub energy: Option<Number>,
    /// Vertical angular momentum; its sign does not matter
    #[arg(long = "l", value_name = "l", allow_hyphen_values = true, value_parser = values::number)]
    pub momentum: Option<Number>,
}

/// A body, and how its part was measured where the numbers of the part are not exact.
pub type MeasuredSubject = (Subject, Option<(Part, MeasuredPart)>);

impl PlainBodyArguments {
    /// The body of the options.
    pub fn subject(&self) -> Result<Subject, Failure> {
        self.optional_subject()?.ok_or_else(|| no_body(PLAIN))
    }

    /// The body of the options, or `None` if none of them was given.
    pub fn optional_subject(&self) -> Result<Option<Subject>, Failure> {
        let body: Body = match (&self.moments, &self.center, self.body) {
            (Some(_), _, Some(_)) => return Err(two_bodies("--A", "--body", "")),
            (None, Some(_), Some(_)) => return Err(two_bodies("--r", "--body", "")),
            (Some(_), None, None) => {
                let right = "--A also needs the centre of mass, such as --r 0.94868,0,0.61623";
                return Err(Failure::input(format!("--r is missing: {right}")));
            }
            (None, Some(_), None) => {
                let right = "--r also needs the principal moments, such as --A 2,1.1,1";
                return Err(Failure::input(format!("--A is missing: {right}")));
            }
            (Some(moments), Some(center), None) => Body::new(moments.0.clone(), center.0.clone())
                .map_err(|error| Failure::input(format!("--A with --r: {error}")))?,
            (None, None, Some(preset)) => preset.body(),
            (None, None, None) => return Ok(None),
        };
        let subject = Subject::from(body);
        warn(&subject);
        Ok(Some(subject))
    }

    /// The options that are given, by name.
    pub fn given(&self) -> impl Iterator<Item = &'static str> + use<> {
        let options =
            [("--A", self.moments.is_some()), ("--r", self.center.is_some()), ("--body", self.body.is_some())];
        options.into_iter().filter(|(_, given)| *given).map(|(name, _)| name)
    }
}

impl BodyArguments {
    /// The body of the options.
    pub fn subject(&self) -> Result<Subject, Failure> {
        self.optional_subject()?.ok_or_else(|| no_body(WITH_PARTS))
    }

    /// The body of the options, or `None` if none of them was given.
    pub fn optional_subject(&self) -> Result<Option<Subject>, Failure> {
        self.given_body(PartArguments::part).map(|given| given.map(|(subject, _)| subject))
    }

    /// The body of the options, and how its part was measured where its numbers are not exact.
    pub fn measured_subject(&self) -> Result<MeasuredSubject, Failure> {
        self.given_body(PartArguments::measured_part)?.ok_or_else(|| no_body(WITH_PARTS))
    }

    fn given_body(
        &self,
        read: impl Fn(&PartArguments) -> Result<Option<GivenPart>, Failure>,
    ) -> Result<Option<MeasuredSubject>, Failure> {
        if let (Some(first), Some(second)) = (self.plain.given().next(), self.part.given().next()) {
            return Err(self.part.source().map_or_else(
                || {
                    Failure::input(format!(
                        "{second} is for a part (--inertia, --inertia-com or --part); leave it out with {first}"
                    ))
                },
                |source| two_bodies(first, source, ", --inertia, --inertia-com, --part"),
            ));
        }
        if let Some(subject) = self.plain.optional_subject()? {
            return Ok(Some((subject, None)));
        }
        let Some(given) = read(&self.part)? else { return Ok(None) };
        let subject = Subject::new(&given.part, given.principal);
        let measured = given.measured.map(|measured| (given.part, measured));
        warn(&subject);
        Ok(Some((subject, measured)))
    }

    /// The options that are given, by name.
    pub fn given(&self) -> impl Iterator<Item = &'static str> {
        self.plain.given().chain(self.part.given())
    }
}

fn two_bodies(first: &str, second: &str, others: &str) -> Failure {
    Failure::input(format!("{first} and {second} both describe the body; give one of --A with --r, --body{others}"))
}

/// What may be given where a part may not, and where it may.
const PLAIN: &str = "or a named body such as --body paper";
const WITH_PARTS: &str = "a named body such as --body paper, or a real part: --inertia-com";

fn no_body(others: &str) -> Failure {
    Failure::input(format!("no body is given; use --A 2,1.1,1 --r 0.94868,0,0.61623, {others}"))
}

/// A and r, and how they came about.
pub fn head(subject: &Subject, report: &mut Report) {
    /// Digits of numbers that were computed.
    const DIGITS: usize = 10;
    let number = |number: &Number| match &subject.part {
        Some(_) => shown_of_part(number.text(), DIGITS),
        None => shown(number.text()),
    };
    let join = |numbers: &[Number; 3]| numbers.each_ref().map(number).join(", ");
    report.line(format!("A = ({})", join(subject.body.moments())));
    report.line(format!("r = ({})", join(subject.body.center())));
    let Some(part) = &subject.part else { return };
    if let Some(units) = &subject.units {
        let [moment, energy, momentum] = [units.moment(), units.energy(), units.momentum()];
        report.line(format!("A in {moment}, r and h in {energy}, l in {momentum}; the principal axes are the rows of"));
    }
    for axis in part.principal.axes {
        let [x, y, z] = axis.map(|x| fixed(x, 6));
        report.line(format!("  ({x:>9}, {y:>9}, {z:>9})"));
    }
}

/// The units of what is printed of a motion of a part; a body in numbers has none.
pub fn motion_units(subject: &Subject, report: &mut Report) {
    if let Some([.., time]) = subject.units.as_ref().map(Units::names) {
        report.line(format!("times in {time}, angular velocities in rad/{time}"));
    }
}

/// The integrable cases to which a body belongs, if there are any.
pub fn integrable(body: &Body, report: &mut Report) {
    for case in bifdiag_documents::integrable(body) {
        report.line(bifdiag_documents::integrable_words(&case));
    }
}

/// The further integrals of an integrable body, with their values and deviations.
pub fn add_integrals(report: &mut Report, integrals: &[FurtherIntegralDocument]) {
    for FurtherIntegralDocument { of, kept, at_start, orbit, drift } in integrals {
        report.line(bifdiag_documents::integrable_words(of));
        let (value, drift) = (significant(*at_start, 10), significant(*drift, 2));
        let value = match orbit {
            Some(orbit) => format!("{value} at the start of orbit {orbit}, where it is largest in magnitude"),
            None => format!("{value} at the start"),
        };
        report.line(if *kept {
            let growing = if of.holds == "where it is 0" { "; errors off 0 may grow exponentially" } else { "" };
            format!("  {value}; largest deviation {drift}{growing}")
        } else {
            format!("  {value}; constant {} only, and on steady rotations: largest deviation {drift}", of.holds)
        });
    }
}

/// Warns of what is accepted but strange.
fn warn(subject: &Subject) {
    if subject.body.flags().unphysical {
        tracing::warn!(
            "no mass distribution has these moments and this centre of mass (it needs Ai + Aj > Ak, or Ai + Aj = Ak \
            with rk = 0); the equations hold all the same"
        );
    } else if subject.part.as_ref().is_some_and(|part| !part.physical) {
        tracing::warn!("no mass distribution has these mass properties; the equations hold all the same");
    }
}
