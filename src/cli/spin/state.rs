//! `bifdiag state`: where a state lies, and what it is.

use bifdiag_body::Number;
use bifdiag_body::part::Spin;
use bifdiag_diagram::atlas::Spot;
use bifdiag_documents::{CommandLine, Subject};
use bifdiag_equilibria::critical::RelativeEquilibria;
use bifdiag_equilibria::permanent::angle_between;
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_numbers::symmetric::{self, Real};
use bifdiag_numbers::vector::{cross, dot, norm};
use bifdiag_schema::{StateDocument, SteadyDocument};
use clap::Args;
use dashu_ratio::RBig;

use super::axis::{Axis, AxisArgument, axis};
use super::steady::{Question, at_spin, changes, report_steady};
use crate::cli::export::answer;
use crate::cli::failure::{Failure, failed, incomplete};
use crate::cli::input::values::{self, Triple};
use crate::cli::input::{BodyArguments, head};
use crate::cli::terminal::{Report, Timings, significant};

pub const STATE_EXAMPLES: &str = "\
Examples:
  bifdiag state --inertia-com 8e-5,8e-5,1.2e-4,0,0,0 --com 0,0,0.04 --mass 0.2 \\
      --spin \"3000 rpm\" --axis z
  bifdiag state --body paper --spin \"2 rad/s\" --axis 0,1,1 --vertical 0,0,1
  bifdiag state --body paper --omega 1,0,2 --vertical 0,0,1 --json

A body turns about a fixed point; --vertical points up, in the part's frame (without a part: in principal axes). With --spin \
and --axis the default is: the axis points up.";

/// `bifdiag state`.
#[derive(Debug, Args)]
pub struct StateArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Rate of turning about --axis, with its unit: rpm, Hz, rad/s, deg/s
    #[arg(long, value_name = "\"3000 rpm\"", allow_hyphen_values = true, help_heading = "State")]
    pub spin: Option<Spin>,
    /// The axis of the spin: x, y, z or a direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "State")]
    pub axis: Option<AxisArgument>,
    /// The angular velocity in rad/s, instead of --spin and --axis
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::triple, help_heading = "State")]
    pub omega: Option<Triple>,
    /// The direction upward (default: along --axis)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "State")]
    pub vertical: Option<AxisArgument>,
    /// Print the state as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// h and l of a state are computed with a smaller error, relative to the size of their terms.
const ROUNDING: f64 = 1e-14;

/// Digits of a spin that is not rational.
const DIGITS: usize = 60;

/// An axis farther than this, in radians, from the given one is reported.
const OTHER: f64 = 1e-12;

/// How the body turns.
enum Turning<'a> {
    About { spin: &'a Spin, axis: &'a AxisArgument },
    Omega(&'a Triple),
}

/// A state in the frame of the question, in seconds.
struct State<'a> {
    turning: Turning<'a>,
    vertical: &'a AxisArgument,
    omega: [f64; 3],
}

pub fn run(arguments: &StateArguments, timings: &Timings) -> Result<(), Failure> {
    let state = State::of(arguments)?;
    let subject = arguments.body.subject()?;
    let document =
        timings.stage("state", || state.document(&subject)).map_err(failed("the state leaves the range of numbers"))?;
    answer(arguments.json, &document, || text(&subject, &document))
}

impl<'a> State<'a> {
    fn of(arguments: &'a StateArguments) -> Result<Self, Failure> {
        let two = |option: &str| {
            let right = "give --spin with --axis, or --omega";
            Failure::input(format!("{option} and --omega both say how the body turns; {right}"))
        };
        match (&arguments.spin, &arguments.axis, &arguments.omega) {
            (Some(_), _, Some(_)) => Err(two("--spin")),
            (_, Some(_), Some(_)) => Err(two("--axis")),
            (Some(_), None, None) => Err(incomplete("--spin", "--axis", "--axis z")),
            (None, Some(_), None) => Err(incomplete("--axis", "--spin", "--spin \"3000 rpm\"")),
            (None, None, None) => Err(Failure::input(
                "no state is given; use --spin \"3000 rpm\" --axis z, or --omega 1,0,2 --vertical 0,0,1",
            )),
            (None, None, Some(omega)) => {
                let vertical = arguments.vertical.as_ref();
                let vertical = vertical.ok_or_else(|| incomplete("--omega", "--vertical", "--vertical 0,0,1"))?;
                Ok(Self { turning: Turning::Omega(omega), vertical, omega: omega.rounded() })
            }
            (Some(spin), Some(axis), None) => {
                let omega = axis.direction.map(|x| x * spin.rad_per_s());
                let vertical = arguments.vertical.as_ref().unwrap_or(axis);
                Ok(Self { turning: Turning::About { spin, axis }, vertical, omega })
            }
        }
    }

    /// |ω| in rad/s, exact where it is rational.
    fn spin(&self) -> RBig {
        match self.turning {
            Turning::About { spin, .. } => spin.absolute().exact_rad_per_s(),
            Turning::Omega(omega) => {
                let omega = omega.values();
                Real::root_of(&symmetric::dot(&omega, &omega), DIGITS).lo
            }
        }
    }

    /// The options that mean this state.
    fn command(&self, subject: &Subject) -> CommandLine {
        let list = |numbers: &Triple| numbers.0.each_ref().map(Number::text).join(",");
        let command = subject.command("state");
        let command = match self.turning {
            Turning::About { spin, axis } => command.option("spin", spin).option("axis", list(&axis.given)),
            Turning::Omega(omega) => command.option("omega", list(omega)),
        };
        command.option("vertical", list(&self.vertical.given))
    }

    fn document(&self, subject: &Subject) -> Result<StateDocument, bifdiag_body::ParseNumberError> {
        let second = subject.second();
        let omega = subject.to_principal(self.omega).map(|x| x / second);
        let vertical = self.vertical.direction;
        let up = subject.to_principal(vertical);
        let (a, r) = (subject.body.moments_f64(), subject.body.center_f64());
        let momentum: [f64; 3] = std::array::from_fn(|k| a[k] * omega[k]);
        // γ = −up: U = −⟨γ, r⟩ = ⟨up, r⟩; l = ⟨Aω, γ⟩, of which the sign does not matter.
        let (h, l) = (0.5 * dot(omega, momentum) + dot(up, r), dot(momentum, up));
        let spin = self.spin();
        let mut document = StateDocument {
            head: bifdiag_documents::head(self.command(subject).json()),
            body: bifdiag_documents::given(&subject.body),
            omega: self.omega,
            vertical,
            spin: match self.turning {
                Turning::About { spin, .. } => bifdiag_documents::asked_spin(&spin.absolute()),
                Turning::Omega(_) => bifdiag_documents::spin(spin.to_f64().value()),
            },
            h,
            l,
            steady: None,
            region: None,
            margin: None,
            nearest: None,
            note: None,
            part: subject.part.clone(),
        };
        let prepared = Solver::new(subject.body.clone(), Accuracy::Exact);
        let question = Question {
            subject,
            vertical,
            up: self.vertical.in_principal_axes(subject),
            omega: spin * subject.unit_of_time(),
        };
        let steady = at_spin(&question, &prepared);
        if prepared.atlas().is_none() {
            document.note = Some("the regions of this body were not found".to_owned());
        }
        match steady {
            Some(steady) if steady.angle_deg == 0.0 && self.is_upright() => document.steady = Some(steady),
            None if self.is_upright() => {
                document.note = Some("whether the motion is steady was not decided: the numbers leave f64".to_owned());
            }
            other => {
                document.nearest = other;
                let [h, l] = [Number::from_f64(h)?, Number::from_f64(l)?];
                if let Ok(found) = prepared.classify(&h, &l) {
                    document.margin = Some(bifdiag_documents::margin(&found.margin));
                    // A curve rises by l/J, which is at most l/min A, and h and l are rounded.
                    let least = a.into_iter().fold(f64::INFINITY, f64::min);
                    let size = 0.5 * dot(omega, momentum).abs() + norm(r) + document.l * document.l / least;
                    if found.margin.h > ROUNDING * size {
                        match prepared.spot(&h, &l, &found.answer) {
                            Spot::Region(region) => document.region = Some(region.to_string()),
                            _ => document.note = Some("the region of its (h, l) is not known".to_owned()),
                        }
                    }
                } else {
                    document.note = Some("the region of its (h, l) is not known".to_owned());
                }
            }
        }
        Ok(document)
    }

    /// The angular velocity is along the vertical.
    fn is_upright(&self) -> bool {
        norm(cross(self.omega, self.vertical.direction)) <= 1e-9 * norm(self.omega)
    }
}

fn text(subject: &Subject, document: &StateDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let spin = &document.spin;
    report.line(format!("spin {} rpm = {} rad/s", significant(spin.rpm, 8), significant(spin.rad_per_s, 8)));
    report.line(format!(
        "h = {}, l = {} about the upward vertical",
        significant(document.h, 10),
        significant(document.l, 10)
    ));
    report.line("");
    match &document.steady {
        Some(steady) => {
            meant(&mut report, steady, document.vertical);
            report_steady(&mut report, steady);
            match Axis::of(subject, document.vertical) {
                Axis::Permanent { .. } => changes(&mut report, steady, document.note.is_none()),
                Axis::AtOneSpin { .. } => report.line("rotation about this axis is steady at this spin only"),
                Axis::Principal => report.line(
                    "the axis is principal, but the centre of mass does not lie on it: at this spin a steady rotation is \
                     within 10⁻⁶ of it",
                ),
                Axis::Other { .. } | Axis::Unknown => {}
            }
        }
        None => other_text(&mut report, subject, document),
    }
    report.text()
}

/// The axis of the rotation that is reported, where it is not the given one to the last digits.
fn meant(report: &mut Report, steady: &SteadyDocument, vertical: [f64; 3]) {
    let angle = angle_between(steady.axis, vertical);
    if angle > OTHER {
        let [x, y, z] = steady.axis.map(|x| significant(x, 6));
        let angle = significant(angle.to_degrees(), 3);
        report.line(format!("the nearest steady rotation, about ({x}, {y}, {z}), {angle}° away, is taken"));
    }
}

fn other_text(report: &mut Report, subject: &Subject, document: &StateDocument) {
    let place = match (&document.region, &document.margin, &document.note) {
        (Some(region), ..) => format!("its (h, l) lies in the region {region}"),
        (None, _, Some(note)) => note.clone(),
        (None, Some(margin), None) => {
            format!("its (h, l) lies on the curve {}, or within rounding of it", margin.nearest)
        }
        (None, None, None) => String::new(),
    };
    // Without an answer about steadiness only the note is left.
    report.line(if document.nearest.is_none() && document.margin.is_none() {
        place
    } else {
        format!("the motion is no steady rotation about the vertical; {place}")
    });
    if let (Some(_), Some(margin)) = (&document.region, &document.margin) {
        report.line(format!("the nearest curve is {} in h away ({})", significant(margin.h, 6), margin.nearest));
    }
    let Some(nearest) = &document.nearest else { return };
    match Axis::of(subject, document.vertical) {
        Axis::AtOneSpin { nearest: given, .. } => {
            if let (Some(spin), Some(up)) = (&given.spin, &given.up) {
                let rpm = significant(spin.rpm, 8);
                let end = if up == "-axis" { "its other end" } else { "this end" };
                report
                    .line(format!("rotation about the vertical is steady at one spin only: {rpm} rpm, with {end} up"));
            }
        }
        Axis::Principal | Axis::Other { .. } => report.line("rotation about the vertical is steady at no spin"),
        Axis::Permanent { .. } | Axis::Unknown => {}
    }
    let [x, y, z] = nearest.axis.map(|x| significant(x, 6));
    let angle = significant(nearest.angle_deg, 3);
    report.line("");
    report.line(format!(
        "at this spin the axis of the nearest steady rotation is ({x}, {y}, {z}), {angle}° from the vertical"
    ));
    if let Some(others) = as_near(subject, document, nearest) {
        report.line(others);
    }
    report_steady(report, nearest);
}

/// The other steady axes at this spin that are as near to the vertical.
fn as_near(subject: &Subject, document: &StateDocument, nearest: &SteadyDocument) -> Option<String> {
    let omega = RBig::try_from(document.spin.rad_per_s / subject.second()).ok()?;
    let all = RelativeEquilibria::new(&subject.body).ok()?.at_spin(&omega).ok()?.list;
    let axes = all.into_iter().map(|found| subject.to_given(found.gamma.map(|x| 0.0 - x)));
    let angle = |axis: [f64; 3]| angle_between(axis, document.vertical).to_degrees();
    let is_other = |axis: &[f64; 3]| {
        (angle(*axis) - nearest.angle_deg).abs() < TIE && angle_between(*axis, nearest.axis).to_degrees() > TIE
    };
    let others: Vec<String> =
        axes.filter(is_other).map(|axis| format!("({})", axis.map(|x| significant(x, 6)).join(", "))).collect();
    let verb = if others.len() == 1 { "is" } else { "are" };
    (!others.is_empty()).then(|| format!("as near {verb} {}; what follows is of the first", others.join(", ")))
}

/// Angles to the vertical that differ by less, in degrees, are the same.
const TIE: f64 = 1e-9;
