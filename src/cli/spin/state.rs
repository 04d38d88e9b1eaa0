//! `bifdiag state`: where a state lies, and whether it is a steady rotation.

use bifdiag_body::Number;
use bifdiag_body::part::Spin;
use bifdiag_documents::{CommandLine, StateQuestion, Subject};
use bifdiag_equilibria::critical::ExactSpin;
use bifdiag_equilibria::permanent::{AxisKind, NearestAxis, OneSpin, angle_between};
use bifdiag_exact::{self as exact, Accuracy, Solver, SpinQuestion};
use bifdiag_numbers::symmetric;
use bifdiag_schema::{AxisEnd, SpinChangeDocument, SpinDocument, StateDocument, SteadyDocument};
use clap::Args;
use dashu_ratio::RBig;

use super::axis::{AxisArgument, as_near, axis, listed, rests};
use super::given::{SPIN_DIGITS, as_given};
use super::steady::{changes, report_steady};
use crate::cli::export::answer;
use crate::cli::failure::{Failure, failed, incomplete};
use crate::cli::input::values::{self, Triple};
use crate::cli::input::{BodyArguments, head};
use crate::cli::terminal::{Report, Timings, all_apart, bound, significant, told_apart};

pub const STATE_EXAMPLES: &str = "\
Examples:
  bifdiag state --inertia-com 8e-5,8e-5,1.2e-4,0,0,0 --com 0,0,0.04 --mass 0.2 \\
      --spin \"3000 rpm\" --axis z
  bifdiag state --body paper --spin \"2 rad/s\" --axis 0,1,1 --vertical 0,0,1
  bifdiag state --body paper --omega 1,0,2 --vertical 0,0,1 --json

The body turns about a fixed point; --vertical points up, in the part's frame (without a part: in principal axes). \
With --spin and --axis, the axis points up by default.";

/// `bifdiag state`.
#[derive(Debug, Args)]
pub struct StateArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Spin about --axis, with its unit: rpm, Hz, rad/s, deg/s
    #[arg(long, value_name = "\"3000 rpm\"", allow_hyphen_values = true, help_heading = "State")]
    pub spin: Option<Spin>,
    /// Axis of the spin: x, y, z or a direction
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "State")]
    pub axis: Option<AxisArgument>,
    /// Angular velocity in rad/s, instead of --spin and --axis
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = values::triple, help_heading = "State")]
    pub omega: Option<Triple>,
    /// Upward direction (default: along --axis)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "State")]
    pub vertical: Option<AxisArgument>,
    /// Print the state as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

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
    let question = state.question(&subject);
    let found = timings.stage("state", || {
        let solver = Solver::new(subject.body.clone(), Accuracy::Exact);
        let omega = subject.to_principal(state.omega).map(|x| x / subject.second());
        exact::State::new(&solver, omega, &state.along(), &question)
    });
    let found = found.map_err(failed("the state overflows"))?;
    let document = bifdiag_documents::state(&subject, state.asked(&subject), &found);
    answer(arguments.json, &document, || text(&subject, &document, state.given(), (&question, &found)))
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

    /// |ω|, in a unit of time given in seconds.
    fn spin(&self, unit: &RBig) -> ExactSpin {
        match self.turning {
            Turning::About { spin, .. } => ExactSpin::rational(spin.absolute().exact_rad_per_s() * unit),
            Turning::Omega(omega) => {
                let omega = omega.values();
                ExactSpin::of_square(symmetric::dot(&omega, &omega) * unit.sqr())
            }
        }
    }

    /// A vector along ω, exact, in the axes in which the body was given.
    fn along(&self) -> [RBig; 3] {
        match self.turning {
            Turning::About { axis, .. } => axis.given.values(),
            Turning::Omega(omega) => omega.values(),
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

    /// In the body's units.
    fn question(&self, subject: &Subject) -> SpinQuestion {
        SpinQuestion {
            up: subject.to_principal(self.vertical.direction),
            exact_up: self.vertical.given.values(),
            spin: self.spin(&subject.unit_of_time()),
        }
    }

    fn given(&self) -> Option<&Spin> {
        match self.turning {
            Turning::About { spin, .. } => Some(spin),
            Turning::Omega(_) => None,
        }
    }

    fn asked(&self, subject: &Subject) -> StateQuestion {
        let spin = match self.turning {
            Turning::About { spin, .. } => bifdiag_documents::asked_spin(&spin.absolute()),
            Turning::Omega(_) => bifdiag_documents::spin(self.spin(&RBig::ONE).omega.to_f64().value()),
        };
        StateQuestion { command: self.command(subject), omega: self.omega, vertical: self.vertical.direction, spin }
    }
}

fn text(
    subject: &Subject,
    document: &StateDocument,
    given: Option<&Spin>,
    (question, found): (&SpinQuestion, &exact::State),
) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let spin = &document.spin;
    let [below, above] =
        document.steady.as_ref().map_or([None, None], |found| [&found.below, &found.above].map(Option::as_ref));
    let apart = |value: fn(&SpinDocument) -> f64| {
        let neighbour = |found: Option<&SpinChangeDocument>, none| found.map_or(none, |found| value(&found.spin));
        all_apart(&[neighbour(below, f64::NEG_INFINITY), value(spin), neighbour(above, f64::INFINITY)], SPIN_DIGITS)[1]
            .clone()
    };
    let [rpm, rad_per_s] = [apart(|spin| spin.rpm), apart(|spin| spin.rad_per_s)];
    let given = given.map_or_else(String::new, |given| as_given(given, [&rpm, &rad_per_s]));
    report.line(format!("spin {rpm} rpm = {rad_per_s} rad/s{given}"));
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
            match AxisKind::of(&subject.body, question.up, &question.exact_up) {
                AxisKind::Permanent { .. } => changes(&mut report, steady, *spin, document.note.is_none()),
                AxisKind::AtOneSpin(axis) if axis.squared_spin == Some(0.0) => {
                    report.line(rests("the vertical"));
                    if spin.rad_per_s != 0.0 {
                        report.line("at this spin the axis of a steady rotation is within 10⁻⁶ rad of it");
                    }
                }
                AxisKind::AtOneSpin(axis) => match own_spin(subject, document, question, &axis) {
                    Some(OwnSpin { end: AxisEnd::Plus, is_asked: true, .. }) => {
                        report.line("rotation about this axis is steady at this spin only");
                    }
                    own => {
                        // The spin is that of the nearest axis that has one.
                        if let Some(own) = own.filter(|_| axis.angle <= OTHER) {
                            report.line(own.text());
                        }
                        report.line("at this spin the axis of a steady rotation is within 10⁻⁶ rad of the vertical");
                    }
                },
                AxisKind::Principal => report.line(
                    "the vertical is a principal axis, but the centre of mass does not lie on it: at this spin the axis of a \
                     steady rotation is within 10⁻⁶ rad of it",
                ),
                AxisKind::Other(_) | AxisKind::Unknown => {}
            }
        }
        None => other_text(&mut report, subject, document, (question, found)),
    }
    report.text()
}

/// The axis of the rotation that is reported, where it is not the given one to the last digits.
fn meant(report: &mut Report, steady: &SteadyDocument, vertical: [f64; 3]) {
    let angle = angle_between(steady.axis, vertical);
    if angle > OTHER {
        let angle = significant(angle.to_degrees(), 3);
        report.line(format!(
            "using the nearest steady rotation, about {}, an axis {angle}° from the vertical",
            listed(steady.axis)
        ));
    }
}

/// The only spin at which rotation about the vertical is steady.
struct OwnSpin {
    /// In rpm, told apart from the one that was asked for.
    rpm: String,
    /// Which end is up then.
    end: AxisEnd,
    /// Whether it is the one that was asked for, within rounding.
    is_asked: bool,
}

impl OwnSpin {
    fn text(&self) -> String {
        let end = if self.end == AxisEnd::Minus { "its other end" } else { "this end" };
        format!("rotation about the vertical is steady at one spin only: {} rpm, with {end} up", self.rpm)
    }
}

fn own_spin(
    subject: &Subject,
    document: &StateDocument,
    question: &SpinQuestion,
    axis: &NearestAxis,
) -> Option<OwnSpin> {
    let one = OneSpin::of(&subject.body, axis, &question.exact_up)?;
    let (own, asked) = (bifdiag_documents::spin(one.omega * subject.second()).rpm, document.spin.rpm);
    let is_asked = (own - asked).abs() <= 4.0 * f64::EPSILON * asked;
    let [_, rpm] = told_apart([asked, if is_asked { asked } else { own }], SPIN_DIGITS);
    Some(OwnSpin { rpm, end: one.end, is_asked })
}

fn other_text(
    report: &mut Report,
    subject: &Subject,
    document: &StateDocument,
    (question, found): (&SpinQuestion, &exact::State),
) {
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
        format!("the motion is not a steady rotation about the vertical; {place}")
    });
    if let (Some(_), Some(margin)) = (&document.region, &document.margin) {
        // An error that reaches the printed digits is told.
        let error = if margin.error_bound > 1e-6 * margin.h {
            format!(", error bound {}", bound(margin.error_bound, 2))
        } else {
            String::new()
        };
        report.line(format!(
            "the nearest curve is at a distance of {} in h ({}{error})",
            significant(margin.h, 6),
            margin.nearest
        ));
    }
    let (Some(nearest), Some(steady)) = (&document.nearest, &found.nearest) else { return };
    let kind = AxisKind::of(&subject.body, question.up, &question.exact_up);
    match kind {
        AxisKind::AtOneSpin(axis) if axis.squared_spin == Some(0.0) => {
            report.line(rests("the vertical"));
        }
        AxisKind::AtOneSpin(axis) => {
            if let Some(own) = own_spin(subject, document, question, &axis) {
                report.line(own.text());
            }
        }
        AxisKind::Principal | AxisKind::Other(_) => report.line("rotation about the vertical is steady at no spin"),
        AxisKind::Permanent { .. } | AxisKind::Unknown => {}
    }
    let angle = significant(nearest.angle_deg, 3);
    report.line("");
    report.line(format!(
        "at this spin the axis of the nearest steady rotation is {}, {angle}° from the vertical",
        listed(nearest.axis)
    ));
    if let Some(others) = as_near(subject, &steady.as_near) {
        report.line(format!("{others}; what follows refers to the first"));
    }
    report_steady(report, nearest);
}
