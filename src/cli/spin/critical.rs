//! `bifdiag critical-spin`.

use bifdiag_body::part::{MeasuredPart, Part};
use bifdiag_documents::{CommandLine, Subject, words};
use bifdiag_equilibria::critical::{RelativeEquilibria, SteadyFamily};
use bifdiag_equilibria::permanent::{Near, NearestAxis, equally_near, exact_spin, nearest_steady};
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_numbers::Number;
use bifdiag_numbers::vector::dot;
use bifdiag_schema::{
    CriticalSpinDocument, Multiplicity, NearestAxisDocument, Reason, SpinDocument, SpinStretchDocument,
    SteadySpinDocument, Verdict,
};
use clap::Args;
use dashu_ratio::RBig;

use super::all;
use super::axis::{
    Axis, AxisArgument, MEANT, axis, end_up, fast_axes, fastest_along, followed_text, listed, principal_at,
};
use super::permanent::{AxisChanges, changes_about, one_of, table_of_changes};
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

Without --axis: every steady axis, the spins at which it appears and changes its stability, and how many there are.";

/// `bifdiag critical-spin`.
#[derive(Debug, Args)]
pub struct CriticalSpinArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// The axis of rotation: x, y, z or a direction; a permanent axis within 0.5 degrees of it is followed (default: all
    /// steady axes, and every spin at which one appears or changes)
    #[arg(long, value_name = "x,y,z", allow_hyphen_values = true, value_parser = axis, help_heading = "Rotation")]
    pub axis: Option<AxisArgument>,
    /// How well moments and weight are known: 1%, or axis=0.5%,across=1%,weight=2% (moments for the first two); bounds on the
    /// spins at which such parts change
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
            "--tolerance and ± in the numbers of the part both say how well it is known; leave out one of them",
        ));
    }
    let known = match (&arguments.tolerance, &measured) {
        (Some(tolerance), _) => Known::Relative(tolerance),
        (None, Some((part, measured))) => Known::Measured(part, measured),
        (None, None) => Known::Exactly,
    };
    let axis = match &arguments.axis {
        Some(axis) => axis.clone(),
        None if matches!(known, Known::Exactly) => return all::run(&subject, arguments.json, timings),
        None => the_permanent_axis(&subject)?,
    };
    let document = timings.stage("spins", || document(&subject, &axis, &known));
    answer(arguments.json, &document, || text(&subject, &document))
}

/// The axis that is permanent at every spin, where there is one alone.
fn the_permanent_axis(subject: &Subject) -> Result<AxisArgument, Failure> {
    let none = || {
        Failure::input(
            "no axis of this body is permanent at every spin: give --axis, or leave out the tolerance, and all steady axes are \
             listed",
        )
    };
    if subject.body.is_euler() {
        let principal = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| {
            let axis = subject.to_given(axis).map(|x| significant(x, 6)).join(",");
            format!("--axis={axis}")
        });
        return Err(Failure::input(format!(
            "without weight every principal axis is permanent: give {}, {} or {}, or leave out the tolerance, and all steady \
             axes are listed",
            principal[0], principal[1], principal[2]
        )));
    }
    let axis = AxisArgument::of_the_centre_of_mass(subject).map_err(|_no_direction| none())?;
    match Axis::of(subject, axis.direction) {
        Axis::Permanent { .. } => Ok(axis),
        _ => Err(none()),
    }
}

/// How well the numbers of the body are known.
enum Known<'a> {
    Exactly,
    Relative(&'a ToleranceArgument),
    Measured(&'a Part, &'a MeasuredPart),
}

/// The spins at which rotation about an axis changes.
fn document(subject: &Subject, given: &AxisArgument, known: &Known<'_>) -> CriticalSpinDocument {
    let (found, exactly) = (Axis::followed(subject, given.direction), Axis::of(subject, given.direction));
    let nearest = match &found {
        Axis::Permanent { nearest, .. } | Axis::AtOneSpin { nearest, .. } | Axis::Other { nearest } => {
            Some(nearest.clone())
        }
        Axis::Principal | Axis::Unknown => None,
    };
    let mut document = CriticalSpinDocument {
        head: bifdiag_documents::head(command(subject, given, known).json()),
        body: bifdiag_documents::given(&subject.body),
        axis: given.direction,
        permanent: matches!(found, Axis::Permanent { .. }),
        nearest: nearest.filter(|nearest| nearest.angle_deg > 0.0),
        steady: match exactly {
            Axis::AtOneSpin { axis, .. } => Some(steady_spin(subject, given, &axis).into_iter().collect()),
            Axis::Permanent { .. } | Axis::Unknown => None,
            Axis::Principal | Axis::Other { .. } => Some(Vec::new()),
        },
        families: Vec::new(),
        slow: None,
        changes: Vec::new(),
        stretches: Vec::new(),
        tolerance: None,
        note: None,
        part: subject.part.clone(),
    };
    let Axis::Permanent { axis, .. } = found else {
        beside(&mut document, subject, given, known);
        return document;
    };
    let prepared = Solver::new(subject.body.clone(), Accuracy::Exact);
    let atlas = prepared.atlas();
    if atlas.is_none() {
        document.note =
            Some("the regions of this body were not found: only changes of stability are listed".to_owned());
    }
    let second = subject.second();
    let AxisChanges { of_type_and_region: changes, slow, rotations } = changes_about(subject, axis, atlas);
    document.changes = changes;
    let exceptions = RelativeEquilibria::new(&subject.body).ok().and_then(|found| found.exceptions());
    let stretches = rotations
        .iter()
        .flat_map(|(up, rotation)| bifdiag_documents::spin_stretches(rotation, up, second, exceptions.as_deref()));
    document.stretches = stretches.collect();
    document.tolerance = match known {
        Known::Exactly => None,
        Known::Relative(tolerance) => Some(bifdiag_documents::tolerance(&rotations, &tolerance.0, second)),
        Known::Measured(part, measured) => {
            let up = subject.to_given(axis.direction);
            let end = |k: usize, up| rotations.get(k).map(|(name, rotation)| (*name, up, Near::Axis(rotation)));
            let ends = end(0, up).zip(end(1, up.map(|x| -x)));
            ends.map(|(plus, minus)| bifdiag_documents::measured_tolerance(part, measured, [plus, minus], second))
        }
    };
    document.slow = slow;
    document
}

/// What there is near an axis that is not permanent: the steady rotations that tend to the principal axis beside it at fast
/// spins, and what the tolerances do to them.
fn beside(document: &mut CriticalSpinDocument, subject: &Subject, given: &AxisArgument, known: &Known<'_>) {
    let prepared = RelativeEquilibria::new(&subject.body).ok();
    let families = prepared.as_ref().and_then(RelativeEquilibria::families).unwrap_or_default();
    let exceptions = prepared.as_ref().and_then(RelativeEquilibria::exceptions);
    let up = subject.to_principal(given.direction);
    let [plus, minus] = [up, up.map(|x| -x)].map(|up| fastest_along(&subject.body, &families, up));
    // Of a circle of axes the other end is shown by the same.
    let of_circle = |family: &&SteadyFamily| family.axes == Multiplicity::Circle;
    let shown = plus.iter().chain(minus.iter().filter(|family| !of_circle(family)));
    document.families = bifdiag_documents::steady_families(subject, &shown.collect::<Vec<_>>(), exceptions.as_deref());
    if plus.len() > 1 {
        document.note = Some(format!(
            "at fast spins the steady axes {} are equally near to the given one: {}",
            fast_axes(subject, &plus),
            match known {
                Known::Exactly => "all are listed",
                Known::Relative(_) | Known::Measured(..) =>
                    "all are listed; for bounds give an axis that is nearer to one of them",
            }
        ));
    }
    let ([plus], [minus]) = (&plus[..], &minus[..]) else { return };
    let both = [plus, minus];
    document.slow = Some(
        both.map(|family| family.stretches.first().map_or_else(String::new, |first| first.kind.word().to_owned())),
    );
    let slowest =
        both.map(|family| family.stretches.first().and_then(|first| first.from).map_or(0.0, |place| place.omega));
    let second = subject.second();
    let ends = |up: [f64; 3]| [("+axis", up, slowest[0]), ("-axis", up.map(|x| -x), slowest[1])];
    document.tolerance = match known {
        Known::Exactly => None,
        Known::Measured(part, measured) => Some(bifdiag_documents::measured_tolerance(
            part,
            measured,
            ends(given.direction).map(|(name, up, slowest)| (name, up, Near::NominalRotation { slowest })),
            second,
        )),
        Known::Relative(tolerance) => {
            if let Some(share) = tolerance.for_all() {
                Some(bifdiag_documents::tolerance_beside(&subject.body, share, ends(up), second))
            } else {
                document.note = Some(
                    "tolerances by name are for an axis that is permanent at every spin; give one share for all, such as 1%"
                        .to_owned(),
                );
                None
            }
        }
    };
}

fn command(subject: &Subject, given: &AxisArgument, known: &Known<'_>) -> CommandLine {
    let axis = given.given.0.each_ref().map(Number::text).join(",");
    match known {
        Known::Measured(part, measured) => {
            bifdiag_documents::measured_command("critical-spin", part, measured).option("axis", axis)
        }
        Known::Relative(tolerance) => {
            subject.command("critical-spin").option("axis", axis).option("tolerance", tolerance.text())
        }
        Known::Exactly => subject.command("critical-spin").option("axis", axis),
    }
}

/// The spin at which rotation about an axis of Staude's cone is steady, with the end that is up; none for one that is in
/// equilibrium at rest.
fn steady_spin(subject: &Subject, given: &AxisArgument, axis: &NearestAxis) -> Option<SteadySpinDocument> {
    let s = axis.squared_spin.filter(|s| *s != 0.0)?;
    let end = s.signum();
    let up = axis.axis.map(|x| end * x);
    let rational = |x: f64| RBig::try_from(x).unwrap_or_default();
    let exact_up = given.in_principal_axes(subject).map(|x| x * rational(end));
    let (exact_up, exact_omega) = match exact_spin(&subject.body, &exact_up) {
        Some(omega) => (exact_up, omega),
        None => (up.map(rational), rational(s.abs().sqrt())),
    };
    let omega = exact_omega.to_f64().value();
    let (a, r) = (subject.body.moments_f64(), subject.body.center_f64());
    let l = omega * dot(up, [0, 1, 2].map(|k| a[k] * up[k]));
    let found = nearest_steady(&subject.body, &exact_omega, &exact_up).filter(|found| found.angle <= MEANT);
    let point = found.as_ref().map(|found| &found.equilibrium);
    let nonlinear = point.map(|point| bifdiag_documents::nonlinear(&point.nonlinear));
    Some(SteadySpinDocument {
        up: end_up(s).to_owned(),
        spin: bifdiag_documents::spin(omega * subject.second()),
        l,
        h: 0.5 * omega * l + dot(up, r),
        stability: point.map(|point| point.stability.word().to_owned()),
        stable: point.zip(nonlinear).map(|(point, nonlinear)| Verdict::of(&nonlinear, point.stability.term())),
        nonlinear,
        friction: point.map(|point| bifdiag_documents::friction(&point.friction, &point.eigenvalues.pairs)),
    })
}

fn text(subject: &Subject, document: &CriticalSpinDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let [x, y, z] = document.axis.map(|x| significant(x, 6));
    report.line(format!("axis ({x}, {y}, {z})"));
    report.line("");
    match &document.nearest {
        Some(nearest) if document.permanent => report.line(followed_text(nearest)),
        Some(nearest) => {
            let [x, y, z] = nearest.axis.map(|x| significant(x, 6));
            let angle = significant(nearest.angle_deg, 3);
            let end = if nearest.up.as_deref() == Some("-axis") { ", with its other end up" } else { "" };
            let spin = match &nearest.spin {
                Some(spin) => format!(", at {} rpm only{end}", significant(spin.rpm, 6)),
                None => String::new(),
            };
            report.line(format!("the nearest permanent axis is ({x}, {y}, {z}), {angle}° away{spin}"));
            as_near(&mut report, subject, document, nearest);
        }
        None => {}
    }
    at_one_spin(&mut report, document);
    if !document.permanent {
        not_permanent(&mut report, subject, document);
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
        report.line(format!("at slow spins: +axis up {plus}, -axis up {minus}"));
    }
    if let Some(one_of) = one_of(subject, document.axis) {
        report.line(one_of);
    }
    let unknown = document.note.is_some();
    if document.changes.is_empty() {
        report.line(if unknown {
            "its type changes at no spin"
        } else {
            "its type and the regions beside it change at no spin"
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
        let rpm = |spin: &Option<SpinDocument>, none: &str| match spin {
            Some(spin) => significant(spin.rpm, 8),
            None => none.to_owned(),
        };
        table.row([
            stretch.up.clone(),
            rpm(&stretch.from, "rest"),
            rpm(&stretch.to, "inf"),
            words::verdict(&stretch.nonlinear),
            words::with_friction(&stretch.friction),
        ]);
    }
    report.line(format!("\n{}", table.text().trim_end()));
    let by_arnold = || document.stretches.iter().filter(|stretch| stretch.nonlinear.why == Reason::Arnold);
    if by_arnold().any(|stretch| stretch.isolated.is_none()) {
        report.line("by Arnold's theorem: but for isolated spins, which were not found");
    } else if by_arnold().next().is_some() {
        let named = |stretch: &SpinStretchDocument| format!("{} up", stretch.up);
        let isolated =
            by_arnold().flat_map(|stretch| stretch.isolated.iter().flatten().map(move |one| (named(stretch), *one)));
        all::exceptions(report, isolated);
    }
}

/// The other permanent axes at the same angle.
fn as_near(report: &mut Report, subject: &Subject, document: &CriticalSpinDocument, nearest: &NearestAxisDocument) {
    if !subject.body.is_euler() {
        let others =
            equally_near(&subject.body, subject.to_principal(document.axis), subject.to_principal(nearest.axis));
        if !others.is_empty() {
            let axes: Vec<String> = others.into_iter().map(|axis| listed(subject.to_given(axis))).collect();
            let verb = if axes.len() == 1 { "is" } else { "are" };
            report.line(format!("as near {verb} {}", axes.join(", ")));
        }
        return;
    }
    let near = principal_at(subject, document.axis, nearest.angle_deg);
    let listed: Vec<String> = near.iter().map(|axis| listed(*axis)).collect();
    if listed.len() > 1 {
        report.line(format!("at this angle are {}", listed.join(", ")));
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
            steady.up
        ));
        let stability = match (&steady.nonlinear, &steady.friction, &steady.stability) {
            (Some(verdict), Some(friction), Some(stability)) => {
                format!(", {}: {stability}; with friction {}", words::verdict(verdict), words::with_friction(friction))
            }
            _ => ", its stability was not found".to_owned(),
        };
        report.line(format!("h = {}, l = {}{stability}", significant(steady.h, 10), significant(steady.l, 10)));
    }
}

/// Why an axis is steady at no spin or at one only.
fn not_permanent(report: &mut Report, subject: &Subject, document: &CriticalSpinDocument) {
    match Axis::of(subject, document.axis) {
        Axis::AtOneSpin { axis, .. } if axis.squared_spin == Some(0.0) => report.line(
            "the centre of mass lies on this axis, which is not principal: the body rests with either end up, but rotation \
             about it is steady at no spin",
        ),
        Axis::Principal => report.line(
            "this axis is principal, but the centre of mass does not lie on it: rotation about it is steady at no spin",
        ),
        Axis::Other { .. } => report.line("rotation about this axis is steady at no spin"),
        Axis::Unknown => report.line("whether rotation about this axis is steady at some spin was not found"),
        Axis::AtOneSpin { .. } | Axis::Permanent { .. } => {}
    }
}

fn note(report: &mut Report, document: &CriticalSpinDocument) {
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
}
