//! `bifdiag critical-spin`.

use documents::Subject;
use schema::CriticalSpinDocument;
use top::atlas::Atlas;
use top::permanent::{AxisRotation, SpinType};

use super::arguments::CriticalSpinArguments;
use super::direction::second;
use super::rotation::{Axis, rotation};
use super::tolerance::{self, ToleranceArgument};
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::{Report, Table, Timings, significant};

pub fn run(arguments: &CriticalSpinArguments, timings: &Timings) -> Result<(), Failure> {
    let subject = arguments.body.subject()?;
    let document = timings.stage("spins", || document(&subject, arguments.axis.0, arguments.tolerance.as_ref()));
    Ok(answer(arguments.json, &document, || text(&subject, &document))?)
}

/// The spins at which rotation about an axis changes.
fn document(subject: &Subject, axis: [f64; 3], tolerance: Option<&ToleranceArgument>) -> CriticalSpinDocument {
    let found = Axis::of(subject, axis);
    let (permanent, nearest) = match found {
        Axis::Permanent { nearest, .. } => (true, nearest),
        Axis::Other { nearest } => (false, nearest),
    };
    let mut document = CriticalSpinDocument {
        head: documents::head(
            subject
                .command("critical-spin")
                .option("axis", axis.map(|x| format!("{x:?}")).join(","))
                .option_if("tolerance", tolerance.map(ToleranceArgument::text))
                .json(),
        ),
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
    let Axis::Permanent { axis, sign, .. } = found else { return document };
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
    document.tolerance = tolerance.map(|tolerance| documents::tolerance(&rotations, &tolerance.0, second));
    document.slow = slow.try_into().ok();
    document
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
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}
