//! `bifdiag critical-spin`.

use bifdiag_documents::{AxisQuestion, Subject, words};
use bifdiag_equilibria::permanent::{AxisKind, angle_between, equally_near, is_axis_of_circular_cone, permanent_axis};
use bifdiag_exact::AxisSpins;
use bifdiag_schema::{AxisEnd, CriticalSpinDocument, NearestAxisDocument, Reason, SpinStretchDocument};
use bifdiag_survey::tolerance::{Tolerances, Tolerated};
use clap::Args;

use super::all;
use super::axis::{AxisArgument, angle_text, axis, followed_text, listed, one_of, principal_near, rests};
use super::changes::table_of_changes;
use super::tolerance::{self, ToleranceArgument};
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::{BodyArguments, head};
use crate::cli::terminal::{Report, Table, Timings, significant};

pub const CRITICAL_SPIN_EXAMPLES: &str = "\
Examples:
  bifdiag critical-spin --inertia-com 8e-5,8e-5,1.2e-4,0,0,0 --com 0,0,0.04 \\
      --mass 0.2 --axis z --tolerance 1%
  bifdiag critical-spin --A 2,1.1,1 --r 0,0,1 --axis 0,0,1 --json
  bifdiag critical-spin --body paper

Without --axis: every steady axis, the spins at which it appears and changes its stability, and how many there are; with ± or \
--tolerance only the axis that is permanent at every spin, if there is one alone.";

/// `bifdiag critical-spin`.
#[derive(Debug, Args)]
pub struct CriticalSpinArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Axis of rotation: x, y, z or a direction; an axis within 0.5 degrees of it that is permanent at every spin is used
    /// instead (default: all steady axes, and every spin at which one appears or changes its stability; with ± or
    /// --tolerance the one permanent axis)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "Rotation")]
    pub axis: Option<AxisArgument>,
    /// Uncertainty of moments and weight: 1%, or axis=0.5%,across=1%,weight=2% (moments for the first two); gives
    /// bounds on the spins at which such parts change
    #[arg(long, value_name = "1%", value_parser = tolerance::tolerance, help_heading = "Rotation")]
    pub tolerance: Option<ToleranceArgument>,
    /// Print the spins as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

pub fn run(arguments: &CriticalSpinArguments, timings: &Timings) -> Result<(), Failure> {
    let (subject, measured) = arguments.body.measured_subject()?;
    if measured.is_some() && arguments.tolerance.is_some() {
        return Err(Failure::input(
            "--tolerance and ± in the numbers of the part both give its uncertainty; leave out one of them",
        ));
    }
    let tolerances = match (&arguments.tolerance, &measured) {
        (Some(tolerance), _) => Tolerances::Shares(&tolerance.0),
        (None, Some((part, measured))) => Tolerances::Measured(part, measured),
        (None, None) => Tolerances::Exact,
    };
    let axis = match &arguments.axis {
        Some(axis) => axis.clone(),
        None if matches!(tolerances, Tolerances::Exact) => return all::run(&subject, arguments.json, timings),
        None => the_permanent_axis(&subject)?,
    };
    let up = subject.to_principal(axis.direction);
    let (found, tolerated) = timings.stage("spins", || {
        let found = AxisSpins::new(&subject.body, up, &axis.given.values());
        let followed = match found.kind {
            AxisKind::Permanent { axis, .. } => subject.to_given(axis.direction),
            _ => axis.direction,
        };
        let tolerated = Tolerated::new(&subject.body, &found, tolerances, followed);
        (found, tolerated)
    });
    let question = AxisQuestion { axis: axis.direction, given: &axis.given.0, tolerances };
    let document = bifdiag_documents::critical_spin(&subject, &question, &found, tolerated.as_ref());
    answer(arguments.json, &document, || text(&subject, &document, (&found, &axis)))
}

/// The axis that is permanent at every spin, where there is one alone.
fn the_permanent_axis(subject: &Subject) -> Result<AxisArgument, Failure> {
    let none = || {
        Failure::input(
            "no axis of this body is permanent at every spin: give --axis, or leave out --tolerance and ± to list all \
            steady axes",
        )
    };
    if subject.body.is_euler() {
        let principal = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| {
            let axis = subject.to_given(axis).map(|x| significant(x, 6)).join(",");
            format!("--axis={axis}")
        });
        return Err(Failure::input(format!(
            "without weight every principal axis is permanent: give {}, {} or {}, or leave out --tolerance and ± to list \
            all steady axes",
            principal[0], principal[1], principal[2]
        )));
    }
    let axis = AxisArgument::of_the_centre_of_mass(subject).map_err(|_no_direction| none())?;
    match AxisKind::of(&subject.body, subject.to_principal(axis.direction), &axis.given.values()) {
        AxisKind::Permanent { .. } => Ok(axis),
        _ => Err(none()),
    }
}

fn text(subject: &Subject, document: &CriticalSpinDocument, (found, given): (&AxisSpins, &AxisArgument)) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let [x, y, z] = document.axis.map(|x| significant(x, 6));
    report.line(format!("axis ({x}, {y}, {z})"));
    report.line("");
    match &document.nearest {
        Some(nearest) if document.permanent => report.line(followed_text(nearest)),
        Some(nearest) => {
            let angle = angle_text(nearest.angle_deg);
            let end = match nearest.up {
                Some(AxisEnd::Plus) => ", with this end up",
                Some(AxisEnd::Minus) => ", with its other end up",
                None => "",
            };
            let on_cone = if has_equal_moments(subject) {
                "axis of Staude's cone outside the plane of equal moments"
            } else {
                "axis of Staude's cone"
            };
            let (what, note) = match nearest.spin {
                // That of the centre of mass.
                Some(spin) if spin.rpm == 0.0 => (on_cone, format!(": {}", rests("it"))),
                Some(spin) => ("axis of a steady rotation", format!(", at {} rpm only{end}", significant(spin.rpm, 6))),
                None if is_permanent(subject, nearest.axis) => ("permanent axis", String::new()),
                None => (on_cone, ": it is principal, and rotation about it is steady at no spin".to_owned()),
            };
            report.line(format!("the nearest {what} is {}, {angle}° away{note}", listed(nearest.axis)));
            as_near(&mut report, subject, document, (nearest, given));
        }
        None => {}
    }
    at_one_spin(&mut report, document);
    if !document.permanent {
        not_permanent(&mut report, &found.itself);
        if !document.families.is_empty() {
            report.line("");
            report.line("steady rotations that are nearest to it at fast spins:");
            all::families(&mut report, &document.families.iter().collect::<Vec<_>>(), document.part.is_some());
        }
        tolerance::report(&mut report, document);
        note(&mut report, document);
        return report.text();
    }
    if let Some([plus, minus]) = &document.slow {
        report.line(format!("at slow spins: +axis up {}, -axis up {}", plus.word(), minus.word()));
    }
    if let Some(one_of) = one_of(subject, document.axis) {
        report.line(one_of);
    }
    let unknown = document.note.is_some();
    if document.changes.is_empty() {
        report.line(if unknown {
            "its type does not change with the spin"
        } else {
            "its type and the regions beside it do not change with the spin"
        });
    } else {
        report.line(table_of_changes(&document.changes, if unknown { "not known" } else { "same" }));
    }
    stretches(&mut report, document);
    tolerance::report(&mut report, document);
    note(&mut report, document);
    report.text()
}

/// The verdicts between the changes as a table.
fn stretches(report: &mut Report, document: &CriticalSpinDocument) {
    let mut table = Table::new(&["up", "from rpm", "to rpm", "stability", "with friction"]);
    for stretch in &document.stretches {
        let of_end = document.stretches.iter().filter(|other| other.up == stretch.up);
        let spins = all::Spins::new(of_end.flat_map(|other| other.from.into_iter().chain(other.to)));
        table.row([
            stretch.up.word().to_owned(),
            spins.text(stretch.from, "rest"),
            spins.text(stretch.to, "inf"),
            words::verdict(&stretch.nonlinear),
            words::with_friction(&stretch.friction),
        ]);
    }
    report.line(format!("\n{}", table.text().trim_end()));
    let by_arnold = || document.stretches.iter().filter(|stretch| stretch.nonlinear.why == Reason::Arnold);
    if by_arnold().any(|stretch| stretch.isolated.is_none()) {
        report.line("by Arnold's theorem; its usual conditions fail at isolated spins, of which not all were found: none is listed");
    } else if by_arnold().next().is_some() {
        let named = |stretch: &SpinStretchDocument| format!("{} up", stretch.up.word());
        let isolated =
            by_arnold().flat_map(|stretch| stretch.isolated.iter().flatten().map(move |one| (named(stretch), *one)));
        all::exceptions(report, isolated);
    }
}

/// Whether rotation about an axis is steady at every spin.
fn is_permanent(subject: &Subject, axis: [f64; 3]) -> bool {
    let axis = subject.to_principal(axis);
    permanent_axis(&subject.body, axis).is_some_and(|permanent| angle_between(permanent.direction, axis) < SAME)
}

/// Whether two principal moments are equal.
fn has_equal_moments(subject: &Subject) -> bool {
    let [first, second, third] = subject.body.moments();
    first == second || second == third || third == first
}

/// Axes that are nearer to each other, in radians, are one.
const SAME: f64 = 1e-9;

/// The other permanent axes at the same angle.
fn as_near(
    report: &mut Report,
    subject: &Subject,
    document: &CriticalSpinDocument,
    (nearest, given): (&NearestAxisDocument, &AxisArgument),
) {
    if !subject.body.is_euler() {
        if is_axis_of_circular_cone(&subject.body, &given.given.values()) {
            report.line("Staude's cone is circular about the axis that was given: all of its axes are equally near");
            return;
        }
        let others =
            equally_near(&subject.body, subject.to_principal(document.axis), subject.to_principal(nearest.axis));
        if let Some(others) = super::axis::as_near(subject, &others) {
            report.line(others);
        }
        return;
    }
    let near = principal_near(subject, document.axis, nearest.angle_deg);
    let listed: Vec<String> = near.iter().map(|axis| listed(*axis)).collect();
    let is_other = |axis: [f64; 3]| angle_between(axis, nearest.axis) > SAME;
    let others: Vec<&str> =
        near.iter().zip(&listed).filter(|(axis, _)| is_other(**axis)).map(|(_, listed)| &**listed).collect();
    if !others.is_empty() {
        report.line(format!("also at this angle: {}", others.join(", ")));
    }
    for (axis, listed) in near.iter().zip(&listed) {
        if one_of(subject, *axis).is_some() {
            report.line(format!("{listed} is one of a circle of permanent axes"));
        }
    }
}

/// At which spin rotation about the axis itself is steady.
fn at_one_spin(report: &mut Report, document: &CriticalSpinDocument) {
    let which = if document.permanent { "the given axis itself" } else { "this axis" };
    for steady in document.steady.iter().flatten() {
        let [rpm, rad_per_s] = [steady.spin.rpm, steady.spin.rad_per_s].map(|x| significant(x, 8));
        report.line(format!(
            "rotation about {which} is steady at one spin only: {rpm} rpm = {rad_per_s} rad/s, {} up",
            steady.up.word()
        ));
        let stability = match (&steady.nonlinear, &steady.friction, &steady.stability) {
            (Some(verdict), Some(friction), Some(stability)) => {
                format!(
                    ", {}: {}; with friction {}",
                    words::verdict(verdict),
                    stability.word(),
                    words::with_friction(friction)
                )
            }
            _ => ", its stability was not found".to_owned(),
        };
        report.line(format!("h = {}, l = {}{stability}", significant(steady.h, 10), significant(steady.l, 10)));
    }
}

/// Why an axis is steady at no spin or at one only.
fn not_permanent(report: &mut Report, kind: &AxisKind) {
    match kind {
        AxisKind::AtOneSpin(axis) if axis.squared_spin == Some(0.0) => {
            report.line(format!("the centre of mass lies on this axis, which is not principal: {}", rests("it")));
        }
        AxisKind::Principal => report.line(
            "this axis is principal, but the centre of mass does not lie on it: rotation about it is steady at no spin",
        ),
        AxisKind::Other(_) => report.line("rotation about the axis that was given is steady at no spin"),
        AxisKind::Unknown => report.line("whether rotation about this axis is steady at some spin was not found"),
        AxisKind::AtOneSpin(_) | AxisKind::Permanent { .. } => {}
    }
}

fn note(report: &mut Report, document: &CriticalSpinDocument) {
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
}
