//! The title, units, what the picture cannot show, and the table of small motions: for each stretch of a curve that is seen,
//! whether the relative equilibria on it are stable, and periods and growth times near both ends of what is seen.

use super::insets::Magnifications;
use super::labels::{H, L, region_type};
use super::panel::Panel;
use super::scene::Scene;
use super::stroke::{Stroke, curve_width};
use super::trace::trace;
use bifdiag_page::{Heading, Symbol, body_line, short_number, short_time, text_width};
use bifdiag_schema::{AtlasDocument, CurveDocument, Reason, small_motions};

/// Font size of the notes.
pub(super) const NOTE_SIZE: f64 = 11.0;

/// Significant digits in the table of motions.
const DIGITS: usize = 4;

/// So far inside what is seen, relative to its length: at an end two equilibria may meet.
const INSIDE: f64 = 0.02;

/// How far the points by which the end of what is seen is found may be off, relative to the window's extent in h.
const FINE: f64 = 1e-7;
/// A stretch of l that is a smaller share of the window only touches its edge.
const EDGE: f64 = 1e-9;

/// The body in a line of at most `width` pixels at this font size, its numbers rounded where that is needed, and all that
/// is known of it for programs.
pub(super) fn heading(atlas: &AtlasDocument, width: f64, size: f64) -> Heading {
    let AtlasDocument { body: own, head, .. } = atlas;
    let title = body_line(&own.given.moments, &own.given.center, width, size);
    let mut metadata = exact(atlas);
    for (name, value) in [("version", &head.version), ("command", &head.command)] {
        if !value.is_empty() {
            metadata.extend(["; ", name, ": ", value]);
        }
    }
    Heading { title, metadata }
}

/// The body with all digits.
fn exact(atlas: &AtlasDocument) -> String {
    let own = &atlas.body.given;
    format!("A = ({}), r = ({})", own.moments.join(", "), own.center.join(", "))
}

/// What the diagram shows, in a sentence.
pub(super) fn about(atlas: &AtlasDocument, straight: bool) -> String {
    let axes = if straight {
        "l to the right, h upwards, straightened so that each region can be seen; faint lines are levels of h"
    } else {
        "h to the right, l upwards"
    };
    let remark = remark(atlas);
    let remark = if remark.is_empty() { String::new() } else { format!("; {remark}") };
    let own = &atlas.body.given;
    // The numbers of a part were computed, to many digits.
    let body = match atlas.body.part {
        Some(_) => body_line(&own.moments, &own.center, f64::INFINITY, NOTE_SIZE),
        None => exact(atlas),
    };
    format!("Bifurcation diagram of the body {body}{remark}: {axes}.")
}

/// What is said below the title: what is special about the body.
pub(super) fn remark(atlas: &AtlasDocument) -> &'static str {
    if atlas.body.flags.unphysical { "no mass has these moments and this centre" } else { "" }
}

/// Units of h and l of a real part; empty for a body of numbers.
pub(super) fn units(atlas: &AtlasDocument) -> [String; 2] {
    let Some(part) = &atlas.body.part else { return [String::new(), String::new()] };
    match part.units.split(',').map(str::trim).collect::<Vec<_>>()[..] {
        ["kg", "m", "s"] => ["J".to_owned(), "J s".to_owned()],
        [mass, length, time] => {
            let momentum = format!("{mass} {length}²/{time}");
            [format!("{momentum}²"), momentum]
        }
        _ => [String::new(), String::new()],
    }
}

/// What is true of a whole line by Arnold's theorem but for single l, which are not drawn.
pub(super) fn exceptions(atlas: &AtlasDocument) -> Option<&'static str> {
    let mut spans = atlas.curves.iter().flat_map(|curve| &curve.stability);
    let are_there = atlas.verdict_changes.as_ref().is_none_or(|changes| !changes.is_empty());
    (are_there && spans.any(|span| span.nonlinear.why == Reason::Arnold)).then_some(
        "Stable by Arnold's theorem: but for single l at which its usual conditions fail; they are not marked.",
    )
}

/// What the picture cannot show, in lines of at most `width` pixels.
pub(super) fn notes(atlas: &AtlasDocument, magnified: &Magnifications, width: f64) -> Vec<String> {
    let mut lines = Vec::new();
    for (heading, regions) in
        [("Too narrow to be drawn:", &magnified.invisible), ("Outside the window:", &magnified.outside)]
    {
        if regions.is_empty() {
            continue;
        }
        let items = regions.iter().map(|&index| {
            let region = &atlas.regions[index];
            let kind = region_type(region);
            // The width of a region in which no double is known to lie is not known either.
            let is_known = region.sample.margin.h > region.sample.margin.error_bound;
            let wide = atlas.h_width(&region.id).filter(|_| is_known);
            let wide = wide.map_or_else(String::new, |wide| format!(", about {} wide in {H}", short_number(wide, 2)));
            let [h, l] = [region.sample.h, region.sample.l].map(|value| short_number(value, 8));
            format!("{} ({kind}) near {H} = {h}, {L} = {l}{wide}", region.id)
        });
        wrap(heading, items, width, &mut lines);
    }
    let undecided = atlas.summary.undecided.len();
    if undecided > 0 {
        let items = atlas.summary.undecided.iter().map(|what| {
            let [h, l] = [what.h, what.l].map(|value| short_number(value, 8));
            format!("{} near {H} = {h}, {L} = {l}", what.what)
        });
        wrap(&format!("Undecided in f64 ({undecided}):"), items, width, &mut lines);
    }
    lines
}

/// Adds a heading and items to lines of at most `width` pixels.
fn wrap(heading: &str, items: impl Iterator<Item = String>, width: f64, lines: &mut Vec<String>) {
    let mut line = heading.to_owned();
    for (place, item) in items.enumerate() {
        let separator = if place == 0 { " " } else { "; " };
        if text_width(&line, NOTE_SIZE) + text_width(&item, NOTE_SIZE) > width - 2.0 * NOTE_SIZE {
            line.push_str(separator.trim_end());
            lines.push(std::mem::replace(&mut line, item));
        } else {
            line.push_str(separator);
            line.push_str(&item);
        }
    }
    line.push('.');
    lines.push(line);
}

/// One row for each stretch that is seen, behind the symbol of its line; none where the source has no equilibria.
pub(super) fn motions(scene: &Scene<'_>, strokes: &[Stroke], panels: &[Panel]) -> Vec<(Symbol, Vec<String>)> {
    let mut rows = Vec::new();
    for (index, curve) in scene.atlas.curves.iter().enumerate() {
        for stroke in strokes {
            let Some(line) = stroke.lines.iter().find(|line| line.curve == index) else { continue };
            let Some(l) = panels.iter().find_map(|panel| seen(scene, panel, stroke)) else { continue };
            rows.extend(
                cells(scene, curve, l)
                    .map(|cells| (Symbol::Line(line.pattern.clone(), curve_width(line.verdict)), cells)),
            );
        }
    }
    rows
}

/// The headings of these rows.
pub(super) fn columns(atlas: &AtlasDocument) -> Vec<String> {
    let unit = atlas.body.part.as_ref().map_or_else(String::new, |part| format!(" in {}", part.time_unit()));
    let percent = 100.0 * INSIDE;
    let motions = format!("small motions {percent} % inside: period, or time of growth by a factor of e{unit}");
    vec!["curve".to_owned(), format!("from {L} to {L}"), "linear type".to_owned(), "stability".to_owned(), motions]
}

/// The ends of the part of a stretch that a panel shows.
fn seen(scene: &Scene<'_>, panel: &Panel, stroke: &Stroke) -> Option<[f64; 2]> {
    let window = &panel.view.window;
    let points = panel.traces[stroke.curve].part(stroke.l[0], stroke.l[1]);
    if panel.straight.is_some() {
        // All h are seen, at the l of the traces.
        let (first, last) = (points.first()?, points.last()?);
        return (first[1] < last[1]).then_some([first[1], last[1]]);
    }
    // h rises with l along every curve. Between two points it is found by finer ones.
    let rises_through = |h: f64| {
        let beyond = points.partition_point(|point| point[0] < h);
        let (Some(before), Some(after)) = (beyond.checked_sub(1).map(|before| points[before]), points.get(beyond))
        else {
            return points.get(beyond).or(points.last()).map(|end| end[1]);
        };
        let curve = &scene.atlas.curves[stroke.curve];
        let fine = trace(scene, curve, [before[1], after[1]], FINE * (window.h[1] - window.h[0])).unwrap_or_default();
        let next = fine.points.partition_point(|point| point[0] < h).clamp(1, fine.points.len().max(2) - 1);
        let [from, to] = [*fine.points.get(next - 1)?, *fine.points.get(next)?];
        let share = if to[0] > from[0] { ((h - from[0]) / (to[0] - from[0])).clamp(0.0, 1.0) } else { 0.0 };
        Some(from[1] + share * (to[1] - from[1]))
    };
    let [start, end] = [rises_through(window.h[0])?.max(window.l[0]), rises_through(window.h[1])?.min(window.l[1])];
    // A curve that only touches the edge is not seen.
    (end - start > EDGE * (window.l[1] - window.l[0])).then_some([start, end])
}

fn cells(scene: &Scene<'_>, curve: &CurveDocument, l: [f64; 2]) -> Option<Vec<String>> {
    let source = scene.source?;
    let at = |l: f64| source.equilibria(l).into_iter().find(|point| point.branch == curve.id);
    let inside = INSIDE * (l[1] - l[0]);
    let (first, last) = (at(l[0] + inside)?, at(l[1] - inside)?);
    let name = format!("{}, {}", curve.id, curve.branch_name);
    let written = |digits| l.map(|l| short_number(l, digits));
    let apart = (DIGITS..17).map(written).find(|[from, to]| from != to);
    let range = apart.unwrap_or_else(|| written(DIGITS)).join(" … ");
    let motions = small_motions(&[first.eigenvalues, last.eigenvalues], short_time);
    Some(vec![name, range, first.stability.word().to_owned(), first.nonlinear.to_string(), motions])
}
