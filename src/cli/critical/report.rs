//! What the terminal shows of relative equilibria.

use std::path::PathBuf;

use bifdiag_body::part::Spin;
use bifdiag_schema::{
    CriticalDocument, Damped, FrictionDocument, Multiplicity, RelativeEquilibriumDocument, SteadyAxesDocument,
    SteadyAxisDocument, eigenvalues_in_words, small_motions,
};

use crate::cli::input::head;
use crate::cli::spin::{SPIN_DIGITS, as_given};
use crate::cli::terminal::{Report, Table, all_apart, bound, fixed, significant};
use bifdiag_documents::Subject;
use bifdiag_documents::codes::multiplicity_word;
use bifdiag_documents::words::counted;

/// Significant digits of the table.
const DIGITS: usize = 10;

pub fn text(subject: &Subject, document: &CriticalDocument) -> String {
    let mut places = Table::new(&["h", "gamma", "omega", "index", "mult", "curve", "branch"]);
    let heights = energies(document.critical.iter(), document.error_bound);
    for (point, h) in document.critical.iter().zip(heights) {
        places.row([
            h,
            vector(point.gamma),
            significant(point.omega, 6),
            point.index.to_string(),
            multiplicity_word(point.multiplicity),
            point.branch.clone(),
            point.branch_name.clone(),
        ]);
    }
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!("l = {}", document.l));
    report.line("");
    report.line(places.text());
    let points: Vec<&RelativeEquilibriumDocument> = document.critical.iter().collect();
    let curves: Vec<String> = points.iter().map(|point| point.branch.clone()).collect();
    motions(&mut report, subject, &points, &curves);
    let omega = time_unit(subject).map_or_else(String::new, |unit| format!("; omega in rad/{unit}"));
    report.line(format!("gamma points down, along gravity, in principal axes{omega}"));
    report.line(format!("error bound of h: {}", bound(document.error_bound, 2)));
    if !document.complete {
        report.line("there may be more: l lies beside cusps closer than 2^-4000");
    }
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

/// Every axis about which a body turns steadily at a spin.
pub fn steady_axes(subject: &Subject, spin: &Spin, document: &SteadyAxesDocument) -> String {
    let mut places = Table::new(&["axis (up)", "h", "l", "index", "mult", "curve", "branch"]);
    let heights = energies(document.axes.iter().map(|axis| &axis.equilibrium), document.error_bound);
    for (SteadyAxisDocument { axis, l, equilibrium: point, .. }, h) in document.axes.iter().zip(heights) {
        places.row([
            vector(*axis),
            h,
            significant(*l, DIGITS),
            point.index.to_string(),
            multiplicity_word(point.multiplicity),
            point.branch.clone(),
            point.branch_name.clone(),
        ]);
    }
    let mut report = Report::default();
    head(subject, &mut report);
    let [rpm, rad_per_s] = [document.spin.rpm, document.spin.rad_per_s].map(|x| significant(x, SPIN_DIGITS));
    let rest = if document.spin.rad_per_s == 0.0 { " (at rest)" } else { "" };
    report.line(format!("steady axes at {rpm} rpm = {rad_per_s} rad/s{rest}{}", as_given(spin, [&rpm, &rad_per_s])));
    report.line("");
    report.line(places.text());
    let points: Vec<&RelativeEquilibriumDocument> = document.axes.iter().map(|axis| &axis.equilibrium).collect();
    let curves: Vec<String> = document.axes.iter().map(|axis| curve_of(axis, &document.axes)).collect();
    motions(&mut report, subject, &points, &curves);
    let frame = if document.part.is_some() { "in the part's frame" } else { "in principal axes" };
    report.line(format!("axis: the end that points up, {frame}; gamma in the JSON points down, in principal axes"));
    for axis in document.axes.iter().filter(|axis| axis.fold) {
        report.line(format!(
            "on {}: steady axes meet at this spin; at slightly slower spins they do not exist",
            axis.equilibrium.branch
        ));
    }
    report.line(format!("error bound of h: {}", bound(document.error_bound, 2)));
    if !document.complete {
        report.line("there may be more: roots are closer than 2^-4000");
    }
    report.text()
}

/// The energies, each told apart from those that differ from it by more than their errors.
fn energies<'a>(points: impl Iterator<Item = &'a RelativeEquilibriumDocument>, error_bound: f64) -> Vec<String> {
    let all: Vec<f64> = points.map(|point| point.h).collect();
    let written = |&h: &f64| {
        let differs = |other: &f64| (other - h).abs() > 2.0 * error_bound;
        let others: Vec<f64> = std::iter::once(h).chain(all.iter().copied().filter(differs)).collect();
        all_apart(&others, DIGITS).swap_remove(0)
    };
    all.iter().map(written).collect()
}

/// The unit of time of a part; a body given by A and r has none.
fn time_unit(subject: &Subject) -> Option<&str> {
    subject.part.as_ref().map(bifdiag_schema::PartDocument::time_unit)
}

fn vector(v: [f64; 3]) -> String {
    let [x, y, z] = v.map(|x| fixed(x, 6));
    format!("({x:>9}, {y:>9}, {z:>9})")
}

/// The curve of an axis; at one spin a curve can occur at several l, which are then added to its name.
fn curve_of(axis: &SteadyAxisDocument, axes: &[SteadyAxisDocument]) -> String {
    let branch = &axis.equilibrium.branch;
    let is_met_again = axes.iter().any(|other| other.equilibrium.branch == *branch && other.l != axis.l);
    if is_met_again { format!("{branch} (l = {})", significant(axis.l, DIGITS)) } else { branch.clone() }
}

/// Types, verdicts, small motions and eigenvalues as a table, and what its words mean.
fn motions(report: &mut Report, subject: &Subject, points: &[&RelativeEquilibriumDocument], curves: &[String]) {
    let mut motions = Table::new(&["curve", "type", "stability", "small motions", "eigenvalues"]);
    for (point, curve) in points.iter().zip(curves) {
        motions.row([
            curve.clone(),
            point.stability.word().to_owned(),
            point.nonlinear.to_string(),
            small_motions(&[point.eigenvalues], |time| significant(time, 6)),
            eigenvalues_in_words(&point.eigenvalues, |x| significant(x, 6)),
        ]);
    }
    report.line("");
    report.line(motions.text());
    report.line("");
    let (times, rates) = match time_unit(subject) {
        Some(unit) => (format!(", in {unit}"), format!("per {unit}")),
        None => (String::new(), "per unit of time".to_owned()),
    };
    report.line(format!(
        "period: of a small oscillation; growth: the time in which a small deviation grows by a factor of e{times}"
    ));
    report.line(format!("eigenvalues: of the linearised flow at fixed l, {rates}"));
    if points.iter().any(|point| matches!(point.multiplicity, Multiplicity::Points(2..))) {
        report.line(
            "mult 2: degenerate; several critical points meet in it: two at a cusp, three at a pitchfork (or a circle \
             and one), more where a cusp lies at a pitchfork",
        );
    }
    match points.iter().filter(|point| point.multiplicity == Multiplicity::Circle).count() {
        0 => {}
        1 => report.line(
            "circle: a whole circle of relative equilibria, represented by one of them and judged as a \
        whole",
        ),
        circles => {
            report.line(format!(
                "circle: {circles} whole circles of relative equilibria, each represented by one of them and judged \
                as a whole"
            ));
        }
    }
    let mut no_minima: Vec<&str> = points
        .iter()
        .zip(curves)
        .filter(|(point, _)| is_degenerate_circle(point))
        .map(|(_, curve)| curve.as_str())
        .collect();
    no_minima.dedup();
    if !no_minima.is_empty() {
        report.line(format!("degenerate: {}, no minimum in spite of index 0", no_minima.join(", ")));
    }
    report.line(with_friction(points, curves));
    if let Some(all) = points.iter().find(|point| point.multiplicity == Multiplicity::Sphere) {
        report.line(if all.omega == 0.0 {
            "sphere: at rest every orientation is an equilibrium; they are judged as a whole"
        } else {
            "sphere: rotation about every axis is a relative equilibrium"
        });
    }
}

/// A circle across which the Hessian vanishes, as at a cusp, and which is no minimum.
fn is_degenerate_circle(point: &RelativeEquilibriumDocument) -> bool {
    let FrictionDocument { conserving_l, growing, .. } = point.friction;
    point.multiplicity == Multiplicity::Circle && point.index == 0 && conserving_l == Some(Damped::Lost) && growing == 0
}

/// What friction that conserves l leaves: on which curves the body stays stable, and in how many directions it falls from others.
fn with_friction(points: &[&RelativeEquilibriumDocument], names: &[String]) -> String {
    let curves = |is: &dyn Fn(&FrictionDocument) -> bool| {
        let mut found: Vec<&str> = Vec::new();
        for (_, name) in points.iter().zip(names).filter(|(point, _)| is(&point.friction)) {
            if !found.contains(&name.as_str()) {
                found.push(name);
            }
        }
        found.join(", ")
    };
    let damped = |left: Option<Damped>| move |friction: &FrictionDocument| friction.conserving_l == left;
    let lost = |growing: u8| {
        let is = move |f: &FrictionDocument| f.conserving_l == Some(Damped::Lost) && f.growing == growing;
        let directions = if growing == 0 {
            // A degenerate point that is no minimum.
            "unstable".to_owned()
        } else {
            format!("unstable in {}", counted(growing, "direction", "directions"))
        };
        (directions, curves(&is))
    };
    let all = [
        ("stable".to_owned(), curves(&damped(Some(Damped::Survives)))),
        lost(0),
        lost(1),
        lost(2),
        ("open".to_owned(), curves(&damped(None))),
    ];
    let lines: Vec<String> =
        all.into_iter().filter(|(_, curves)| !curves.is_empty()).map(|(what, on)| format!("{what} on {on}")).collect();
    format!("with friction that conserves l:\n  {}", lines.join("\n  "))
}

/// What was written of a table.
pub fn written(rows: usize, files: &[PathBuf]) -> String {
    let mut report = Report::default();
    report.line(format!(
        "{} (a circle or sphere of them is one row)",
        counted(rows, "relative equilibrium", "relative equilibria")
    ));
    for path in files {
        report.line(format!("written: {}", path.display()));
    }
    report.text()
}
