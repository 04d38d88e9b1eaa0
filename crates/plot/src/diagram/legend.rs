//! The legend below the panels.

use std::collections::BTreeMap;

use super::markers::{MARKER, event_marker, sample_dot};
use super::palette::BranchStyle;
use super::stroke::{self, DOUBLE_WIDTH, Verdict, WIDTH};
use crate::page::{Canvas, FAINT_INK, Legend, POLE, Pattern, Point, pattern};
use schema::{AtlasDocument, CurveKind, EventKind};

const SAMPLE: f64 = 42.0;

/// What is explained.
pub(super) enum Symbol {
    Line(Pattern, f64),
    Event(EventKind),
    Sample,
}

/// What the diagram of `atlas` needs explained, in rows of `width` pixels.
pub(super) fn legend(atlas: &AtlasDocument, styles: &BTreeMap<&str, BranchStyle>, width: f64) -> Legend<Symbol> {
    let mut entries = Vec::new();
    let mut branches: Vec<(&&str, &BranchStyle)> = styles.iter().collect();
    branches.sort_by_key(|(_, style)| style.rank);
    for (branch, style) in branches {
        let double = atlas.curves.iter().any(|curve| curve.branch == **branch && curve.multiplicity > 1);
        let (thickness, name) =
            if double { (DOUBLE_WIDTH, format!("{} (double)", style.name)) } else { (WIDTH, style.name.clone()) };
        entries.push((Symbol::Line(vec![(Some(style.color), 1.0)], thickness), name));
    }
    for (kind, name) in [(CurveKind::PolePlus, "pole +r̂ enters U"), (CurveKind::PoleMinus, "pole −r̂ enters U")] {
        if atlas.curves.iter().any(|curve| curve.kind == kind) {
            entries.push((Symbol::Line(stroke::pole_pattern(kind), WIDTH), name.to_owned()));
        }
    }
    for (verdict, name) in [
        (Verdict::Stable, "eigenvalues imaginary"),
        (Verdict::Unstable, "unstable"),
        (Verdict::Open, "eigenvalue zero"),
    ] {
        let mut spans = atlas.curves.iter().flat_map(|curve| &curve.stability);
        if spans.any(|span| stroke::verdict(span) == verdict) {
            entries.push((Symbol::Line(stroke::curve_pattern(&[FAINT_INK], verdict), WIDTH), name.to_owned()));
        }
    }
    if atlas.curves.iter().any(|curve| !curve.coincides_with.is_empty()) {
        entries.push((
            Symbol::Line(stroke::curve_pattern(&[FAINT_INK, POLE], Verdict::Stable), WIDTH),
            "coincident curves".to_owned(),
        ));
    }
    for (kind, name) in
        [(EventKind::Cusp, "cusp"), (EventKind::Pitchfork, "pitchfork"), (EventKind::Crossing, "crossing")]
    {
        if atlas.events.iter().any(|event| event.kind == kind) {
            entries.push((Symbol::Event(kind), name.to_owned()));
        }
    }
    entries.push((Symbol::Sample, "sample point of a region".to_owned()));
    Legend::new(entries, symbol_width, width)
}

/// Draws a symbol.
pub(super) fn paint_symbol(canvas: &Canvas<'_>, symbol: &Symbol, [x, middle]: Point) {
    let width = symbol_width(symbol);
    match symbol {
        Symbol::Line(pattern, thickness) => {
            pattern::draw(canvas, &[[x, middle], [x + width, middle]], pattern, *thickness);
        }
        Symbol::Event(kind) => event_marker(canvas, *kind, [x + width / 2.0, middle]),
        Symbol::Sample => sample_dot(canvas, [x + width / 2.0, middle]),
    }
}

fn symbol_width(symbol: &Symbol) -> f64 {
    match symbol {
        Symbol::Line(..) => SAMPLE,
        Symbol::Event(_) | Symbol::Sample => 3.0 * MARKER,
    }
}
