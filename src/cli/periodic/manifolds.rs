//! `bifdiag periodic manifolds`: stable and unstable manifolds of periodic orbits in the section, and where they cross.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering;

use bifdiag_documents::Subject;
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, SectionError, TorusPoint};
use bifdiag_periodic::manifold::{Curve, ManifoldError, ManifoldOptions, Manifolds, manifolds};
use bifdiag_schema::{ManifoldEnd, ManifoldKind, ManifoldsDocument};
use clap::Args;

use super::short::{listed, point_and_crossings, yes};
use crate::cli::export::{Columns, DataTarget, FileSet, PictureArguments, Values, answer};
use crate::cli::failure::{Failure, failed};
use crate::cli::input::{BodyArguments, PointArguments, head, motion_units, values};
use crate::cli::section::poincare_failure;
use crate::cli::terminal::interrupt::stoppable;
use crate::cli::terminal::{Progress, Report, Table, Timings, counted, print, significant, wrapped};
use crate::pictures;

pub const MANIFOLDS_EXAMPLES: &str = "\
Examples:
  bifdiag periodic manifolds --body paper --h 6.5 --l 3.25
  bifdiag periodic manifolds --body paper --h 6.5 --l 3.25 --length 5 --out dir
  bifdiag periodic manifolds --body paper --h 6.5 --l 3.25 --data curves.csv

The curves of motions that leave the unstable periodic orbits at (h, l), and of those that come to them, in the part of P where \
<gamma,r> is largest; and the orbits that connect them (homoclinic, heteroclinic), refined to 1e-10. --data writes a row for each \
point of a curve, with theta, psi, sheet as in `bifdiag section`.";

/// `bifdiag periodic manifolds`.
#[derive(Debug, Args)]
pub struct ManifoldsArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    /// Of the orbits with at most N crossings of P in a period, inward and outward
    #[arg(long, value_name = "N", default_value_t = 2, help_heading = "Orbits")]
    pub crossings: u32,
    /// Follow each curve for this length, in units in which |gamma| and a bound of |l| are 1
    #[arg(long, value_name = "L", default_value_t = 10.0, value_parser = length, allow_hyphen_values = true, help_heading = "Orbits")]
    pub length: f64,
    /// Draw the curves over the section, to DIR/manifolds.svg
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArguments,
    /// Write the points of the curves to FILE (.parquet, .csv, .jsonl, .npz; -: CSV to stdout)
    #[arg(long, value_name = "FILE", value_parser = DataTarget::parse, help_heading = "Output")]
    pub data: Option<DataTarget>,
    /// Print the curves and the orbits that connect them as JSON
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

/// The longest curve.
const LONGEST: f64 = 1000.0;

fn length(text: &str) -> Result<f64, Failure> {
    let length = values::float(text)?;
    if length > 0.0 && length <= LONGEST {
        Ok(length)
    } else {
        Err(Failure::input(format!("{text}: a length above 0 and up to {LONGEST} is possible, such as 10")))
    }
}

pub fn run(arguments: &ManifoldsArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    if arguments.json && arguments.data == Some(DataTarget::Stdout) {
        return Err(Failure::input("--json and --data - both write to stdout; give --data a file"));
    }
    let subject = arguments.body.subject()?;
    let (h, l) = point_and_crossings(&arguments.point, arguments.crossings)?;
    let setting = SectionSetting::new(&subject.body, h, l).map_err(poincare_failure)?;
    let monitor = Arc::new(Monitor::default());
    let stop = Arc::clone(&monitor);
    let interruptible = stoppable(move || stop.stop.store(true, Ordering::Relaxed));
    let listed = listed(&setting, arguments.crossings, &monitor, timings, quiet)?;
    let options = ManifoldOptions { length: arguments.length };
    let progress = Progress::open("motions followed", quiet);
    let work = || progress.watching(&monitor.orbits, || manifolds(&setting, &listed, &options, &monitor));
    let found = timings.stage("manifolds", work);
    drop(interruptible);
    let found = found.map_err(|error| match error {
        ManifoldError::Section(SectionError::Interrupted) => Failure::work("interrupted"),
        error => failed("the manifolds could not be followed")(error),
    })?;
    let asked = (arguments.crossings, arguments.length);
    let document = bifdiag_documents::manifolds(&subject, [h, l], asked, &listed, &found);
    let mut files = FileSet::new(arguments.out.as_deref().unwrap_or(Path::new(".")));
    if arguments.out.is_some() {
        let draw = || pictures::manifolds(&setting, &listed, &found, arguments.picture.theme);
        let picture = timings.stage("picture", draw).map_err(failed("the picture could not be drawn"))?;
        files.remove_pictures("manifolds");
        files.pictures("manifolds", &picture, &arguments.picture, timings)?;
    }
    match &arguments.data {
        Some(DataTarget::File { path, format }) => {
            files.add_at(path, format.bytes(&columns(&setting, &found, &document)?)?);
        }
        Some(DataTarget::Stdout) => {
            files.write()?;
            return print(crate::cli::export::DataFormat::Csv.bytes(&columns(&setting, &found, &document)?)?);
        }
        None => {}
    }
    let written = files.write()?;
    answer(arguments.json, &document, || text(&subject, &document, &written))
}

/// A row for each point of each curve.
fn columns(setting: &SectionSetting, found: &Manifolds, document: &ManifoldsDocument) -> Result<Columns, Failure> {
    struct Row {
        orbit: usize,
        kind: ManifoldKind,
        point: usize,
        side: i8,
        piece: usize,
        state: State,
        place: TorusPoint,
    }
    let mut rows: Vec<Row> = Vec::new();
    for manifold in &found.manifolds {
        for Curve { point, side, pieces, .. } in &manifold.curves {
            for (piece, vertices) in pieces.iter().enumerate() {
                rows.extend(vertices.iter().map(|vertex| {
                    let state = found.state(setting, vertex);
                    let place = setting.torus().point(&state);
                    Row { orbit: manifold.orbit, kind: manifold.kind, point: *point, side: *side, piece, state, place }
                }));
            }
        }
    }
    let count = |value: fn(&Row) -> usize| {
        Values::Int32(rows.iter().map(|row| i32::try_from(value(row)).unwrap_or(i32::MAX)).collect())
    };
    let kinds = ManifoldKind::ALL.iter().map(|kind| kind.word()).collect::<Vec<_>>();
    let code = |kind: ManifoldKind| ManifoldKind::ALL.iter().position(|word| *word == kind).unwrap_or_default();
    let top = setting.torus().top();
    let columns = [
        ("orbit", count(|row| row.orbit)),
        (
            "kind",
            Values::words(
                &kinds,
                Values::Int32(rows.iter().map(|row| i32::try_from(code(row.kind)).unwrap_or_default()).collect()),
            )?,
        ),
        ("point", count(|row| row.point)),
        ("side", Values::Int8(rows.iter().map(|row| row.side).collect())),
        ("piece", count(|row| row.piece)),
        ("gamma", Values::vectors(rows.iter().map(|row| row.state.gamma))),
        ("omega", Values::vectors(rows.iter().map(|row| top.inverse_inertia(row.state.l)))),
        ("theta", Values::floats(rows.iter().map(|row| row.place.theta))),
        ("psi", Values::floats(rows.iter().map(|row| row.place.psi))),
        ("sheet", Values::Int8(rows.iter().map(|row| row.place.sheet).collect())),
    ];
    Ok(Columns::new(columns, document)?)
}

/// Significant digits.
const DIGITS: usize = 6;
/// Connections that are told one by one.
const TOLD: usize = 20;

fn text(subject: &Subject, document: &ManifoldsDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!(
        "unstable periodic orbits at h = {}, l = {} that cross P, at most {} times in a period:",
        document.h, document.l, document.crossings
    ));
    report.line("");
    if document.orbits.iter().all(|orbit| !orbit.stability.is_unstable()) {
        report.line("none that is isolated");
    } else {
        report.line(of_orbits(document).text());
    }
    if !document.manifolds.is_empty() {
        report.line("");
        report.line("their curves:");
        report.line(of_curves(document).text());
        report.line("");
        let colon = if document.connections.is_empty() { "" } else { ":" };
        let connections = counted(document.connections.len(), "orbit connects them", "orbits connect them");
        report.line(format!("{connections}{colon}"));
        if !document.connections.is_empty() {
            report.line(of_connections(document).text());
        }
        if document.connections.len() > TOLD {
            report.line(format!("  and {} more; --json lists each", document.connections.len() - TOLD));
        }
        for contact in &document.contacts {
            report.line(format!(
                "unstable curves of orbit {} run along stable ones of orbit {}: as far as they do, they are not told apart",
                contact.from, contact.to
            ));
        }
    }
    motion_units(subject, &mut report);
    report.line("");
    report.line(if document.complete { "complete:" } else { "not complete:" });
    report.line(wrapped(&document.why));
    report.written(written);
    report.text()
}

fn vector(v: [f64; 3]) -> String {
    v.map(|x| significant(if x.abs() < 1e-9 { 0.0 } else { x }, DIGITS)).join(" ")
}

fn of_orbits(document: &ManifoldsDocument) -> Table {
    let mut table = Table::new(&["orbit", "crossings", "T", "multiplier", "symmetric", "proved", "gamma"]);
    for (number, orbit) in document.orbits.iter().enumerate().filter(|(_, orbit)| orbit.stability.is_unstable()) {
        table.row([
            number.to_string(),
            orbit.crossings.to_string(),
            significant(orbit.period, DIGITS),
            significant(orbit.multipliers[0][0], DIGITS),
            yes(orbit.symmetric),
            yes(orbit.proved),
            vector(orbit.gamma),
        ]);
    }
    table
}

fn of_curves(document: &ManifoldsDocument) -> Table {
    let mut table = Table::new(&["orbit", "manifold", "point", "side", "length", "breaks", "end"]);
    for manifold in &document.manifolds {
        for curve in &manifold.curves {
            let end = match curve.end {
                ManifoldEnd::Length => "length reached",
                ManifoldEnd::Orbit => "within 0.0001 of a periodic orbit",
                ManifoldEnd::Work => "followed no further",
            };
            table.row([
                manifold.orbit.to_string(),
                manifold.kind.word().to_owned(),
                curve.point.to_string(),
                if curve.side > 0 { "+" } else { "-" }.to_owned(),
                significant(curve.length, 4),
                (curve.tangencies + curve.gaps).to_string(),
                end.to_owned(),
            ]);
        }
    }
    table
}

fn of_connections(document: &ManifoldsDocument) -> Table {
    let mut table = Table::new(&["from", "to", "points", "angle", "gamma", "omega"]);
    for connection in document.connections.iter().take(TOLD) {
        table.row([
            connection.from.to_string(),
            connection.to.to_string(),
            connection.points.to_string(),
            significant(connection.angle, 3),
            vector(connection.gamma),
            vector(connection.omega),
        ]);
    }
    table
}
