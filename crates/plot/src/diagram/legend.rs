//! The legend: what is drawn, and nothing else; and the key of the regions that no label tells in full.

use std::collections::BTreeMap;

use super::labels::Name;
use super::markers::{MARKER, event_marker, sample_dot};
use super::outline::Ground;
use super::palette::{BranchStyle, is_pole};
use super::panel::Panel;
use super::placement::Texts;
use super::scene::Scene;
use super::stroke::{self, Stroke, Verdict, WIDTH};
use crate::page::{Canvas, FAINT_INK, Ink, Legend, Pattern, Point, Rect, pattern, short_number};
use bifdiag_schema::{AtlasDocument, CurveKind, EventKind};

const SAMPLE: f64 = 34.0;
const SWATCH: f64 = 16.0;

/// What is explained.
pub(super) enum Symbol {
    Line(Pattern),
    /// Two lines side by side.
    Coincident(Pattern, Pattern),
    Event(EventKind),
    Sample,
    Region(Ground),
}

/// What the panels need explained, in rows of `width` pixels; `dots` says what the dots are.
pub(super) fn legend(
    scene: &Scene<'_>,
    styles: &BTreeMap<&str, BranchStyle>,
    strokes: &[Stroke],
    panels: &[Panel],
    texts: &Texts,
    dots: &str,
    width: f64,
) -> Legend<Symbol> {
    let atlas = scene.atlas;
    let drawn: Vec<&Stroke> = strokes.iter().filter(|stroke| stroke::is_drawn(stroke, panels)).collect();
    let shows = |curve: usize| drawn.iter().any(|stroke| stroke.lines.iter().any(|line| line.curve == curve));
    let curves = || atlas.curves.iter().enumerate().filter(|(index, _)| shows(*index)).map(|(_, curve)| curve);
    let mut entries = Vec::new();
    let mut branches: Vec<(&&str, &BranchStyle)> = styles.iter().collect();
    branches.sort_by_key(|(_, style)| style.rank);
    for (branch, style) in branches {
        let of_branch = || curves().filter(|curve| curve.branch == **branch && !is_pole(curve));
        if of_branch().next().is_some() {
            let double = of_branch().any(|curve| curve.multiplicity > 1);
            let name = if double { format!("{} (double)", style.name) } else { style.name.clone() };
            entries.push((Symbol::Line(vec![(Some(style.color), 1.0)]), name));
        }
    }
    for (kind, name) in [(CurveKind::PolePlus, "pole +r̂ enters U"), (CurveKind::PoleMinus, "pole −r̂ enters U")] {
        if curves().any(|curve| curve.kind == kind) {
            entries.push((Symbol::Line(stroke::pole_pattern(kind)), name.to_owned()));
        }
    }
    for (verdict, name) in [
        (Verdict::Stable, "solid: all eigenvalues imaginary"),
        (Verdict::Unstable, "dashed: unstable"),
        (Verdict::Open, "dotted: an eigenvalue is zero"),
    ] {
        if drawn.iter().flat_map(|stroke| &stroke.lines).any(|line| line.verdict == Some(verdict)) {
            entries.push((Symbol::Line(stroke::curve_pattern(FAINT_INK, verdict)), name.to_owned()));
        }
    }
    if let Some([one, other, ..]) = drawn.iter().map(|stroke| &stroke.lines[..]).find(|lines| lines.len() > 1) {
        let symbol = Symbol::Coincident(one.pattern.clone(), other.pattern.clone());
        entries.push((symbol, "side by side: coincident".to_owned()));
    }
    let seen = |h: f64, l: f64| panels.iter().any(|panel| panel.view.rect.contains(panel.view.position([h, l])));
    for (kind, name) in
        [(EventKind::Cusp, "cusp"), (EventKind::Pitchfork, "pitchfork"), (EventKind::Crossing, "crossing")]
    {
        if atlas.events.iter().any(|event| event.kind == kind && seen(event.h, event.l)) {
            entries.push((Symbol::Event(kind), name.to_owned()));
        }
    }
    if scene.dots.iter().any(|dot| seen(dot.at[0], dot.at[1])) {
        entries.push((Symbol::Sample, dots.to_owned()));
    }
    entries.extend(texts.key.iter().map(|&(region, labelled)| {
        let text = key_entry(atlas, region, labelled, &texts.names[region]);
        (Symbol::Region(Ground::of(&atlas.regions[region])), text)
    }));
    Legend::new(entries, symbol_width, width)
}

/// A region in the key: its place too, where no label stands in the picture.
fn key_entry(atlas: &AtlasDocument, region: usize, labelled: bool, name: &Name) -> String {
    let sample = &atlas.regions[region].sample;
    let place = if labelled {
        String::new()
    } else {
        format!(" at h = {}, l = {}", short_number(sample.h, 6), short_number(sample.l, 6))
    };
    format!("{}: {}{place}", name.id, name.sentence())
}

/// Draws a symbol.
pub(super) fn paint_symbol(canvas: &Canvas, symbol: &Symbol, [x, middle]: Point) {
    let width = symbol_width(symbol);
    let line = |pattern: &Pattern, y: f64| pattern::draw(canvas, &[[x, y], [x + width, y]], pattern, WIDTH);
    match symbol {
        Symbol::Line(pattern) => line(pattern, middle),
        Symbol::Coincident(one, other) => {
            line(one, middle - stroke::APART / 2.0);
            line(other, middle + stroke::APART / 2.0);
        }
        Symbol::Event(kind) => event_marker(canvas, *kind, [x + width / 2.0, middle]),
        Symbol::Sample => sample_dot(canvas, [x + width / 2.0, middle]),
        Symbol::Region(ground) => {
            let swatch = Rect { x, y: middle - 6.0, width, height: 12.0 };
            ground.paint_rect(canvas, &swatch);
            canvas.outline(&swatch.corners(), Ink { color: FAINT_INK, width: 0.5 });
        }
    }
}

fn symbol_width(symbol: &Symbol) -> f64 {
    match symbol {
        Symbol::Line(_) | Symbol::Coincident(..) => SAMPLE,
        Symbol::Event(_) | Symbol::Sample => 3.0 * MARKER,
        Symbol::Region(_) => SWATCH,
    }
}
