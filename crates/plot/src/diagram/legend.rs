//! The legend: what is drawn, and nothing else; and the key of the regions that no label names in full.

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use super::labels::{Name, event_marker, sample_dot};
use super::paint::WAY;
use super::palette::{BranchStyle, ground_of, is_pole};
use super::panel::Panel;
use super::placement::Texts;
use super::scene::Scene;
use super::stroke::{self, Stroke, Verdict, WIDTH};
use bifdiag_page::{Canvas, FAINT_INK, Legend, Symbol, short_number};
use bifdiag_schema::{AtlasDocument, CurveKind, EventDocument, EventKind};

/// What the panels need explained, in rows of `width` pixels; `dots` says what the dots are.
pub(super) fn legend(
    scene: &Scene<'_>,
    styles: &BTreeMap<&str, BranchStyle>,
    strokes: &[Stroke],
    panels: &[Panel],
    texts: &Texts,
    dots: &str,
    width: f64,
) -> Legend {
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
            entries.push((Symbol::Line(vec![(Some(style.color), 1.0)], WIDTH), name));
        }
    }
    for (kind, name) in [(CurveKind::PolePlus, "pole +r̂ enters U"), (CurveKind::PoleMinus, "pole −r̂ enters U")] {
        if curves().any(|curve| curve.kind == kind) {
            entries.push((Symbol::Line(stroke::pole_pattern(kind), WIDTH), name.to_owned()));
        }
    }
    for (verdict, name) in [
        (Verdict::Lasting, "solid: stable, with friction too"),
        (Verdict::Frictionless, "thin: stable without friction"),
        (Verdict::Unstable, "dashed: unstable"),
        (Verdict::Open, "dotted: stability open"),
    ] {
        if drawn.iter().flat_map(|stroke| &stroke.lines).any(|line| line.verdict == Some(verdict)) {
            let symbol = Symbol::Line(stroke::curve_pattern(FAINT_INK, verdict), stroke::curve_width(Some(verdict)));
            entries.push((symbol, name.to_owned()));
        }
    }
    if let Some(stroke) = drawn.iter().find(|stroke| stroke.lines.len() > 1) {
        let symbol = Symbol::Line(stroke::in_turn(&stroke.lines), stroke::width(&stroke.lines));
        entries.push((symbol, "in turn: coincident".to_owned()));
    }
    let is_seen = |event: &EventDocument| panels.iter().any(|panel| panel.event(scene, event).is_some());
    for (kind, name, shape) in [
        (EventKind::Cusp, "cusp", "diamond"),
        (EventKind::Pitchfork, "pitchfork", "triangle"),
        (EventKind::Crossing, "crossing", "ring"),
    ] {
        if atlas.events.iter().any(|event| event.kind == kind && is_seen(event)) {
            let mark = move |canvas: &Canvas, at| event_marker(canvas, kind, at);
            entries.push((Symbol::Mark(shape, Box::new(mark)), name.to_owned()));
        }
    }
    if scene.dots.iter().any(|dot| panels.iter().any(|panel| panel.position(dot.at).is_some())) {
        entries.push((Symbol::Mark("dot", Box::new(sample_dot)), dots.to_owned()));
    }
    if !scene.way.is_empty() {
        entries.push((Symbol::Line(vec![(Some(WAY.color), 1.0)], WAY.width), "the path".to_owned()));
    }
    // Regions of one ground share a swatch.
    let mut key: Vec<(Vec<RGBColor>, String)> = Vec::new();
    for &(region, labelled) in &texts.key {
        let text = key_entry(atlas, region, labelled, &texts.names[region]);
        let ground = ground_of(&atlas.regions[region]);
        match key.iter_mut().find(|(other, _)| *other == ground) {
            Some((_, texts)) => texts.extend([";  ", &text]),
            None => key.push((ground, text)),
        }
    }
    entries.extend(key.into_iter().map(|(ground, text)| (Symbol::Swatch(ground), text)));
    Legend::new(entries, width)
}

/// A region in the key: with its position if it has no label in the picture.
fn key_entry(atlas: &AtlasDocument, region: usize, labelled: bool, name: &Name) -> String {
    let sample = &atlas.regions[region].sample;
    let place = if labelled {
        String::new()
    } else {
        format!(" at h = {}, l = {}", short_number(sample.h, 6), short_number(sample.l, 6))
    };
    format!("{}: {}{place}", name.id, name.sentence())
}
