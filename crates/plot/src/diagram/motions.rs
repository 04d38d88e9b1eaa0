//! The table of small motions: for each stretch of a curve that is seen, whether the relative equilibria on it are stable, and
//! periods and growth times near both ends of what is seen.

use bifdiag_schema::{AtlasDocument, CurveDocument, small_motions};

use super::labels::L;
use super::panel::Panel;
use super::scene::Scene;
use super::stroke::Stroke;
use crate::page::{Pattern, Table, short_number, short_time};

/// Width of the samples of lines.
pub(super) const SAMPLE: f64 = 28.0;

const DIGITS: usize = 4;

/// So far inside what is seen, relative to its length: at an end two equilibria may meet.
const INSIDE: f64 = 0.02;

/// One row for each stretch that is seen, `room` pixels wide; none where there is no room for a table or the source tells no
/// equilibria.
pub(super) fn table(scene: &Scene<'_>, strokes: &[Stroke], panels: &[Panel], room: f64) -> Table<Pattern> {
    let mut rows = Vec::new();
    let panels = if scene.plan.motions { panels } else { &[] };
    for (index, curve) in scene.atlas.curves.iter().enumerate() {
        for stroke in strokes {
            let Some(line) = stroke.lines.iter().find(|line| line.curve == index) else { continue };
            let Some(l) = panels.iter().find_map(|panel| seen(panel, stroke)) else { continue };
            rows.extend(cells(scene, curve, l).map(|cells| (line.pattern.clone(), cells)));
        }
    }
    Table::new(SAMPLE, heading(scene.atlas), rows, room)
}

/// What is told of rows that are left out.
pub(super) fn rest(rows: usize) -> String {
    format!("… and {rows} more: bifdiag critical tells them at each {L}")
}

fn heading(atlas: &AtlasDocument) -> Vec<String> {
    let unit = atlas.body.part.as_ref().map_or_else(String::new, |part| format!(" in {}", part.time_unit()));
    let motions = format!("there: period of small oscillations, growth by the factor e{unit}");
    vec!["curve".to_owned(), format!("from {L} to {L}"), "linear type".to_owned(), "stable".to_owned(), motions]
}

/// Near both ends of the part of a stretch that a panel shows.
fn seen(panel: &Panel, stroke: &Stroke) -> Option<[f64; 2]> {
    let window = &panel.view.window;
    let points = panel.traces[stroke.curve].part(stroke.l[0], stroke.l[1]);
    let inside = points
        .iter()
        .filter(|[h, l]| (window.h[0]..=window.h[1]).contains(h) && (window.l[0]..=window.l[1]).contains(l));
    let [from, to] = inside.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], [_, l]| [from.min(*l), to.max(*l)]);
    (from < to).then_some([from + INSIDE * (to - from), to - INSIDE * (to - from)])
}

fn cells(scene: &Scene<'_>, curve: &CurveDocument, l: [f64; 2]) -> Option<Vec<String>> {
    let source = scene.source?;
    let at = |l: f64| source.equilibria(l).into_iter().find(|point| point.branch == curve.id);
    let (first, last) = (at(l[0])?, at(l[1])?);
    let name = format!("{}, {}", curve.id, curve.branch_name);
    let range = l.map(|l| short_number(l, DIGITS)).join(" … ");
    let motions = small_motions(&[first.eigenvalues, last.eigenvalues], short_time);
    Some(vec![name, range, first.stability.word().to_owned(), first.stable.word().to_owned(), motions])
}
