//! The legend below the panels.

use std::collections::BTreeMap;

use super::markers::{MARKER, event_marker, sample_dot};
use super::palette::BranchStyle;
use super::stroke::{self, DOUBLE_WIDTH, Verdict, WIDTH};
use crate::page::{Anchor, Canvas, FAINT_INK, INK, POLE, Pattern, Point, Rows, pattern, text_width};
use schema::{AtlasDocument, CurveKind, EventKind};

const SIZE: f64 = 11.5;
const SAMPLE: f64 = 42.0;
const GAP: f64 = 7.0;
const BETWEEN: f64 = 22.0;
/// Height of a row of entries.
const ROW: f64 = 20.0;
enum Symbol {
    Line(Pattern, f64),
    Event(EventKind),
    Sample,
}

/// The entries of a legend.
pub(super) struct Legend {
    entries: Vec<(Symbol, String)>,
    rows: Rows,
}

impl Legend {
    /// What the diagram of `atlas` needs explained, in rows of `width` pixels.
    pub(super) fn new(atlas: &AtlasDocument, styles: &BTreeMap<&str, BranchStyle>, width: f64) -> Self {
        let mut entries = Vec::new();
        let mut branches: Vec<(&&str, &BranchStyle)> = styles.iter().collect();
        branches.sort_by_key(|(_, style)| style.rank);
        for (branch, style) in branches {
            let double = atlas.curves.iter().any(|curve| curve.branch == **branch && curve.multiplicity > 1);
            let (thickness, name) =
                if double { (DOUBLE_WIDTH, format!("{} (double)", style.name)) } else { (WIDTH, style.name.clone()) };
            entries.push((Symbol::Line(vec![(Some(style.color), 1.0)], thickness), name));
        }
        for (kind, name) in [(CurveKind::PolePlus, "pole +r̂ enters U"), (CurveKind::PoleMinus, "pole −r̂ enters U")]
        {
            if atlas.curves.iter().any(|curve| curve.kind == kind) {
                entries.push((Symbol::Line(stroke::pole_pattern(kind), WIDTH), name.to_owned()));
            }
        }
        for (verdict, name) in
            [(Verdict::Stable, "stable"), (Verdict::Unstable, "unstable"), (Verdict::Open, "spectrum degenerate")]
        {
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
        let widths = entries.iter().map(|(symbol, name)| symbol_width(symbol) + GAP + text_width(name, SIZE));
        let rows = Rows::new(widths, BETWEEN, width, ROW);
        Self { entries, rows }
    }

    pub(super) fn height(&self) -> f64 {
        self.rows.height
    }

    pub(super) fn draw(&self, canvas: &Canvas<'_>, at: Point) {
        for ((symbol, name), place) in self.entries.iter().zip(&self.rows.corners) {
            let (x, middle) = (at[0] + place[0], at[1] + place[1] + ROW / 2.0);
            let width = symbol_width(symbol);
            match symbol {
                Symbol::Line(pattern, thickness) => {
                    pattern::draw(canvas, &[[x, middle], [x + width, middle]], pattern, *thickness);
                }
                Symbol::Event(kind) => event_marker(canvas, *kind, [x + width / 2.0, middle]),
                Symbol::Sample => sample_dot(canvas, [x + width / 2.0, middle]),
            }
            canvas.text(name, [x + width + GAP, middle + 0.36 * SIZE], SIZE, INK, Anchor::Start);
        }
    }
}

fn symbol_width(symbol: &Symbol) -> f64 {
    match symbol {
        Symbol::Line(..) => SAMPLE,
        Symbol::Event(_) | Symbol::Sample => 3.0 * MARKER,
    }
}
