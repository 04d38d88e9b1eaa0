//! `bifdiag critical-spin`.

use documents::{CommandLine, Subject};
use part::{MeasuredPart, Part};
use schema::CriticalSpinDocument;
use top::atlas::Atlas;
use top::body::BodyAxis;
use top::permanent::{AxisRotation, SpinType};

use super::arguments::CriticalSpinArguments;
use super::direction::{from_principal, second};
use super::error::StateInput;
use super::rotation::{Axis, rotation};
use super::tolerance::{self, ToleranceArgument};
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, Timings, significant};

pub fn run(arguments: &CriticalSpinArguments, timings: &Timings) -> Result<(), Failure> {
    let (subject, measured) = arguments.body.measured_subject()?;
    if measured.is_some() && arguments.tolerance.is_some() {
        return Err(StateInput::TwoTolerances.into());
    }
    let known = match (&arguments.tolerance, &measured) {
        (Some(tolerance), _) => Known::Relative(tolerance),
        (None, Some((part, measured))) => Known::Measured(part, measured),
        (None, None) => Known::Exactly,
    };
    let document = timings.stage("spins", || document(&subject, arguments.axis.0, &known));
    Ok(answer(arguments.json, &document, || text(&subject, &document))?)
}

/// How well the numbers of the body are known.
enum Known<'a> {
    Exactly,
    Relative(&'a ToleranceArgument),
    Measured(&'a Part, &'a MeasuredPart),
}

/// The spins at which rotation about an axis changes.
fn document(subject: &Subject, axis: [f64; 3], known: &Known<'_>) -> CriticalSpinDocument {
    let found = Axis::of(subject, axis);
    let (permanent, nearest) = match found {
        Axis::Permanent { nearest, .. } => (true, nearest),
        Axis::Other { nearest } => (false, nearest),
    };
    let mut document = CriticalSpinDocument {
        head: documents::head(command(subject, axis, known).json()),
        body: documents::given(&subject.body),
        axis,
        permanent,
        nearest: (nearest.angle_deg > 0.0).then_some(nearest),
        slow: None,
        changes: Vec::new(),
        tolerance: None,
        note: None,
        part: subject.part.clone(),
    };
    let Axis::Permanent { axis, sign, .. } = found else {
        if !matches!(known, Known::Exactly) {
            document.note =
                Some("tolerances are told for an axis that is permanent for the nominal numbers".to_owned());
        }
        return document;
    };
    let atlas = Atlas::new(&subject.body);
    if atlas.is_err() {
        document.note =
            Some("the regions of this body were not found: only changes of stability are listed".to_owned());
    }
    let second = second(subject.part.as_ref());
    let mut slow = Vec::new();
    let mut rotations = Vec::new();
    for (up, sign) in [("+axis", sign), ("-axis", -sign)] {
        let Some(rotation) = rotation(subject, axis, sign) else { continue };
        document.changes.extend(documents::spin_changes(&rotation, up, atlas.as_ref().ok(), second));
        slow.push(at_slow_spins(&rotation).name().to_owned());
        rotations.push((up, rotation));
    }
    document.tolerance = match known {
        Known::Exactly => None,
        Known::Relative(tolerance) => Some(documents::tolerance(&rotations, &tolerance.0, second)),
        Known::Measured(part, measured) => {
            let unit = BodyAxis::ALL.map(|k| if k == axis { f64::from(sign) } else { 0.0 });
            let up = from_principal(subject.part.as_ref(), unit);
            let ends = [("+axis", up), ("-axis", up.map(|x| -x))];
            Some(documents::measured_tolerance(part, measured, ends, second))
        }
    };
    document.slow = slow.try_into().ok();
    document
}

fn command(subject: &Subject, axis: [f64; 3], known: &Known<'_>) -> CommandLine {
    let axis = axis.map(|x| format!("{x:?}")).join(",");
    match known {
        Known::Measured(part, measured) => {
            documents::measured_command("critical-spin", part, measured).option("axis", axis)
        }
        Known::Relative(tolerance) => {
            subject.command("critical-spin").option("axis", axis).option("tolerance", tolerance.text())
        }
        Known::Exactly => subject.command("critical-spin").option("axis", axis),
    }
}

/// The type at the slowest spins.
fn at_slow_spins(rotation: &AxisRotation) -> SpinType {
    let changes = rotation.changes();
    let any = || rotation.type_at_spin(1.0).unwrap_or(SpinType::Elliptic);
    changes.first().map_or_else(any, |first| first.from)
}

fn text(subject: &Subject, document: &CriticalSpinDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let [x, y, z] = document.axis.map(|x| significant(x, 6));
    report.line(format!("axis ({x}, {y}, {z})"));
    report.line("");
    if let Some(nearest) = &document.nearest {
        let [x, y, z] = nearest.axis.map(|x| significant(x, 6));
        let angle = significant(nearest.angle_deg, 3);
        let spin = match (&nearest.spin, document.permanent) {
            (_, true) => ", which is taken".to_owned(),
            (Some(spin), _) => format!(", at {} rpm only", significant(spin.rpm, 6)),
            (None, _) => String::new(),
        };
        report.line(format!("the nearest permanent axis is ({x}, {y}, {z}), {angle}° away{spin}"));
    }
    if !document.permanent {
        report.line("rotation about this axis is not permanent: the body would leave it at any spin");
        note(&mut report, document);
        return report.text();
    }
    if let Some([plus, minus]) = &document.slow {
        report.line(format!("at slow spins: +axis up {plus}, -axis up {minus}"));
    }
    if document.changes.is_empty() {
        report.line("nothing changes with the spin");
        return report.text();
    }
    let mut table = Table::new(&["up", "rpm", "rad/s", "below", "above", "regions", "h", "l", "error (rad/s)"]);
    for change in &document.changes {
        table.row([
            change.up.clone(),
            significant(change.spin.rpm, 8),
            significant(change.spin.rad_per_s, 8),
            change.from.clone(),
            change.to.clone(),
            change.event.clone().unwrap_or_else(|| "same".to_owned()),
            significant(change.h, 6),
            significant(change.l, 6),
            significant(change.error_bound, 1),
        ]);
    }
    report.line(table.text());
    tolerance::report(&mut report, document);
    note(&mut report, document);
    report.text()
}

fn note(report: &mut Report, document: &CriticalSpinDocument) {
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
}
