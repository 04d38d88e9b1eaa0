//! Manifolds as text and as a table of their points.

use std::path::PathBuf;

use bifdiag_documents::Subject;
use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::{PpTorus, TorusPoint};
use bifdiag_periodic::manifold::{Curve, Manifolds};
use bifdiag_schema::{ManifoldEnd, ManifoldKind, ManifoldsDocument, Stability, eigenvalues_in_words};

use super::short::yes;
use crate::cli::export::{Columns, Values};
use crate::cli::failure::Failure;
use crate::cli::input::{head, motion_units};
use crate::cli::terminal::{Report, Table, counted, significant, wrapped};

/// A row for each point of each curve.
pub fn columns(torus: &PpTorus, found: &Manifolds, document: &ManifoldsDocument) -> Result<Columns, Failure> {
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
                    let state = found.state(vertex);
                    let place = torus.point(&state);
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
    let top = torus.top();
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
/// Connections that are listed individually.
const LISTED: usize = 20;

pub fn text(subject: &Subject, document: &ManifoldsDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    let point = format!("at h = {}, l = {}", document.h, document.l);
    if document.equilibria.is_empty() {
        let most = document.crossings;
        report.line(format!("unstable periodic orbits {point} that cross P, at most {most} times in a period:"));
    } else {
        report.line(format!("unstable equilibria {point}:"));
    }
    report.line("");
    if !document.equilibria.is_empty() {
        report.line(of_equilibria(document).text());
    } else if document.orbits.iter().all(|orbit| !orbit.stability.is_unstable()) {
        report.line("none that is isolated");
    } else {
        report.line(of_orbits(document).text());
    }
    if !document.manifolds.is_empty() {
        let are_motions = are_motions(document);
        report.line("");
        report.line(if are_motions { "the motions of their manifolds:" } else { "their curves:" });
        report.line(if are_motions { of_motions(document) } else { of_curves(document) }.text());
        report.line("");
        let colon = if document.connections.is_empty() { "" } else { ":" };
        let connections = counted(document.connections.len(), "orbit connects them", "orbits connect them");
        report.line(format!("{connections}{colon}"));
        if !document.connections.is_empty() {
            report.line(of_connections(document).text());
        }
        if document.connections.len() > LISTED {
            report.line(format!("  and {} more; --json lists each", document.connections.len() - LISTED));
        }
        for contact in &document.contacts {
            let (source, from, to) = (source(document), contact.from, contact.to);
            report.line(if are_motions {
                format!(
                    "motions that leave {source} {from} and motions that approach {source} {to} agree at all points to 1e-10: \
                     they are the same, or differ by less"
                )
            } else {
                format!(
                    "unstable curves of {source} {from} run along stable ones of {source} {to}: there they cannot be \
                    distinguished"
                )
            });
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

fn of_equilibria(document: &ManifoldsDocument) -> Table {
    let mut table = Table::new(&["equilibrium", "curve", "type", "eigenvalues", "gamma", "omega"]);
    for (number, found) in document.equilibria.iter().enumerate() {
        table.row([
            number.to_string(),
            found.branch.clone(),
            found.stability.word().to_owned(),
            eigenvalues_in_words(&found.eigenvalues, |x| significant(x, DIGITS)),
            vector(found.gamma),
            significant(found.omega, DIGITS),
        ]);
    }
    table
}

/// Whether the manifolds are motions, which no curve joins: for equilibria with one real and one imaginary pair.
fn are_motions(document: &ManifoldsDocument) -> bool {
    let equilibria = &document.equilibria;
    !equilibria.is_empty() && equilibria.iter().all(|found| found.stability == Stability::SaddleCentre)
}

/// What the manifolds belong to.
fn source(document: &ManifoldsDocument) -> &'static str {
    if document.equilibria.is_empty() { "orbit" } else { "equilibrium" }
}

fn of_curves(document: &ManifoldsDocument) -> Table {
    let mut names = vec!["orbit", "manifold", "point", "side", "length", "breaks", "end"];
    names[0] = source(document);
    let mut table = Table::new(&names);
    for manifold in &document.manifolds {
        for curve in &manifold.curves {
            table.row([
                manifold.orbit.to_string(),
                manifold.kind.word().to_owned(),
                curve.point.to_string(),
                side(curve.side),
                significant(curve.length, 4),
                (curve.tangencies + curve.rests + curve.gaps).to_string(),
                end(document, curve.end),
            ]);
        }
    }
    table
}

/// The motions of equilibria with one real and one imaginary pair.
fn of_motions(document: &ManifoldsDocument) -> Table {
    let mut table = Table::new(&["equilibrium", "manifold", "side", "points", "nearest", "end"]);
    for manifold in &document.manifolds {
        for curve in &manifold.curves {
            table.row([
                manifold.orbit.to_string(),
                manifold.kind.word().to_owned(),
                side(curve.side),
                curve.points.to_string(),
                curve.nearest.map_or_else(|| "-".to_owned(), |nearest| significant(nearest, 3)),
                end(document, curve.end),
            ]);
        }
    }
    table
}

fn side(side: i8) -> String {
    if side > 0 { "+" } else { "-" }.to_owned()
}

fn end(document: &ManifoldsDocument, end: ManifoldEnd) -> String {
    match end {
        ManifoldEnd::Length => "length reached",
        ManifoldEnd::Orbit if document.equilibria.is_empty() => "within 0.0001 of a periodic orbit",
        ManifoldEnd::Orbit if are_motions(document) => "within 0.00001 of an equilibrium",
        ManifoldEnd::Orbit => "within 0.0001 of an equilibrium",
        ManifoldEnd::Work => "followed no further",
        ManifoldEnd::Accuracy => "known to 1e-8 up to here",
    }
    .to_owned()
}

fn of_connections(document: &ManifoldsDocument) -> Table {
    let mut table = Table::new(&["from", "to", "points", "angle", "gamma", "omega"]);
    for connection in document.connections.iter().take(LISTED) {
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
