//! The chaotic share over the (h, l) plane, with the curves of the diagram over it.

mod areas;

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use crate::section::{paint_scale, shade, unknown};
use areas::merged;
use bifdiag_page::{
    Anchor, CHART_TEXT, Canvas, Chart, FAINT_INK, INK, Ink, Labelled, PAPER, Path, Picture, PlotError, Point, Rect,
    Taken, Theme, Width, body_line, clip_polyline, is_proper, lines, render, round_point, text_width,
};

/// What the picture of a map shows.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosScene {
    /// The whole window first; where regions have several components, a panel for each further one.
    pub panels: Vec<ChaosPanel>,
    /// Curves of the diagram, through points (h, l).
    pub curves: Vec<Vec<[f64; 2]>>,
    /// Pole lines, in the same form: on them the section changes, and E does not.
    pub poles: Vec<Vec<[f64; 2]>>,
    /// The body: A, as text.
    pub moments: [String; 3],
    /// And r.
    pub center: [String; 3],
    /// What the legend says below: the open share, the error.
    pub notes: Vec<String>,
}

/// One component of E over a part of the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosPanel {
    /// Energies.
    pub h: [f64; 2],
    /// Vertical angular momenta.
    pub l: [f64; 2],
    /// The text above it.
    pub name: String,
    /// The cells.
    pub cells: Vec<ChaosCell>,
    /// Names of regions, and their positions.
    pub labels: Vec<([f64; 2], String)>,
}

/// A rectangle of the plane and the share in it.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosCell {
    /// Its energies.
    pub h: [f64; 2],
    /// Its momenta.
    pub l: [f64; 2],
    /// The share; `None` where it is not known.
    pub share: Option<f64>,
}

/// The upper left corner of the first panel; right of it is the scale.
const CORNER: Point = [74.0, 62.0];
const SCALE: f64 = 106.0;
/// Heights of the first panel and of a further one, over the width; and what lies between two.
const HEIGHT: f64 = 0.77;
const FURTHER: f64 = 0.46;
const BETWEEN: f64 = 84.0;
const TITLE: f64 = 14.0;
/// Between two lines of the notes, and at the right edge.
const LINE: f64 = 16.0;
const EDGE: f64 = 12.0;

/// Draws a map: h to the right, l upwards. The darker a cell, the smaller the share; what is not accessible is left white.
///
/// # Errors
/// [`PlotError::EmptyWindow`] when a range is empty, else what the drawing library reports.
pub fn draw_chaos(scene: &ChaosScene, theme: Theme, width: Width) -> Result<Picture, PlotError> {
    if let Some(empty) = scene.panels.iter().find(|panel| !is_proper(panel.h) || !is_proper(panel.l)) {
        return Err(PlotError::EmptyWindow { h: empty.h, l: empty.l });
    }
    let [x, y] = CORNER;
    let (paper, wide) = (width.pixels(), width.pixels() - x - SCALE);
    let first = Rect { x, y, width: wide, height: HEIGHT * wide };
    let further = FURTHER * wide;
    let rect = |number: usize| match number {
        0 => first,
        _ => Rect { y: first.bottom() + BETWEEN + (further + BETWEEN) * (number - 1) as f64, height: further, ..first },
    };
    let bottom = rect(scene.panels.len().saturating_sub(1)).bottom();
    let title = body_line(&scene.moments, &scene.center, paper - x - EDGE, TITLE);
    let notes: Vec<String> = scene.notes.iter().flat_map(|note| lines(note, CHART_TEXT, paper - x - EDGE)).collect();
    let height = (bottom + 66.0 + LINE * notes.len() as f64).ceil();
    render([paper, height], "The chaotic share of the energy surface", theme, |canvas| {
        canvas.text(&title, [x, 26.0], TITLE, INK, Anchor::Start);
        for (number, panel) in scene.panels.iter().enumerate() {
            draw_panel(canvas, panel, &rect(number), scene);
        }
        draw_bar(canvas, &Rect { x: first.right() + 26.0, width: 16.0, ..first });
        for (number, note) in notes.iter().enumerate() {
            let base = bottom + 62.0 + LINE * number as f64;
            canvas.text(note, [x, base], CHART_TEXT, FAINT_INK, Anchor::Start);
        }
    })
}

fn draw_panel(canvas: &Canvas, panel: &ChaosPanel, rect: &Rect, scene: &ChaosScene) {
    let chart = Chart::new(*rect, ["h", "l"], [panel.h, panel.l]);
    // One path for each colour, whose edges fall on whole pixels, so that no seam shows between two.
    let mut paths: BTreeMap<[u8; 3], (RGBColor, Path)> = BTreeMap::new();
    for area in merged(panel.cells.iter().map(|cell| (cell.h, cell.l, color(cell.share)))) {
        let [[x, y], [right, top]] = [0, 1].map(|end| {
            let [x, y] = chart.at([area.h[end], area.l[end]]);
            [x.clamp(rect.x, rect.right()), y.clamp(rect.y, rect.bottom())]
        });
        let RGBColor(red, green, blue) = area.color;
        let (_, path) = paths.entry([red, green, blue]).or_insert_with(|| (area.color, Path::default()));
        path.line(&[[x, y], [right, y], [right, top], [x, top]], true);
    }
    for (color, path) in paths.values() {
        canvas.draw(path, &format!("{} shape-rendering=\"crispEdges\"", canvas.fill(*color)));
    }
    for (lines, width) in [(&scene.poles, 0.6), (&scene.curves, 1.2)] {
        for line in lines {
            let points: Vec<Point> = line.iter().map(|point| chart.at(*point)).collect();
            for points in clip_polyline(&points, rect) {
                canvas.path(&points, Ink { color: PAPER, width: width + 1.4 });
                canvas.path(&points, Ink { color: INK, width });
            }
        }
    }
    let places: Vec<(Point, &String)> = panel.labels.iter().map(|(place, text)| (chart.at(*place), text)).collect();
    draw_labels(canvas, rect, &places);
    chart.draw(canvas);
    canvas.text(&panel.name, [rect.x, rect.y - 12.0], CHART_TEXT, INK, Anchor::Start);
}

/// Names of regions where they belong, or beside them, with leaders, where another name is in the way or the panel
/// ends.
fn draw_labels(canvas: &Canvas, rect: &Rect, labels: &[(Point, &String)]) {
    const HEIGHT: f64 = 16.0;
    const CLEARANCE: f64 = 2.0;
    const AWAY: [f64; 4] = [8.0, 16.0, 26.0, 40.0];
    let mut taken = Taken::default();
    taken.take_outline(rect);
    let ground = |[x, y]: Point, text: &str| {
        let width = text_width(text, CHART_TEXT) + 6.0;
        Rect { x: x - width / 2.0, y: y - HEIGHT / 2.0, width, height: HEIGHT }
    };
    for (at, text) in labels {
        let own = ground(*at, text);
        let size = [own.width, own.height];
        let beside = || {
            round_point(*at, size, &AWAY, 1.0).map(|rect| (0.0, rect)).filter(|(_, place)| rect.contains_rect(place))
        };
        let labelled = Labelled { tips: &[*at], lengths: [4.0, 60.0], clearance: CLEARANCE };
        let frame = if taken.admits_box(&own.grown(CLEARANCE)) {
            taken.take_box(own);
            own
        } else if let Some((place, leader)) = taken.place_with_leader(&labelled, beside(), |_| 0.0) {
            canvas.path(&leader, Ink { color: PAPER, width: 2.4 });
            canvas.path(&leader, Ink { color: INK, width: 0.8 });
            place
        } else {
            let [x, y] = [rect.right() - own.width, rect.bottom() - own.height];
            Rect { x: own.x.min(x).max(rect.x), y: own.y.min(y).max(rect.y), ..own }
        };
        canvas.polygon(&frame.corners(), PAPER);
        canvas.text(text, [frame.center()[0], frame.center()[1] + 4.0], CHART_TEXT, INK, Anchor::Middle);
    }
}

/// The colour of a share.
fn color(share: Option<f64>) -> RGBColor {
    share.map_or(unknown(), |share| shade(share.clamp(0.0, 1.0)))
}

/// The scale of shares.
fn draw_bar(canvas: &Canvas, bar: &Rect) {
    paint_scale(canvas, bar);
    canvas.outline(&bar.corners(), Ink { color: INK, width: 0.8 });
    for fifth in 0..=5_u32 {
        let share = f64::from(fifth) / 5.0;
        let y = bar.bottom() - bar.height * share;
        canvas.path(&[[bar.right(), y], [bar.right() + 4.0, y]], Ink { color: INK, width: 0.8 });
        canvas.text(&format!("{share:.1}"), [bar.right() + 7.0, y + 4.0], CHART_TEXT - 1.0, INK, Anchor::Start);
    }
    canvas.text("chaotic share", [bar.right() + 40.0, bar.y - 12.0], CHART_TEXT, INK, Anchor::End);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> ChaosScene {
        let cell = |h: f64, share| ChaosCell { h: [h, h + 1.0], l: [0.0, 2.0], share };
        let whole = ChaosPanel {
            h: [0.0, 2.0],
            l: [0.0, 2.0],
            name: "component 0".to_owned(),
            cells: vec![cell(0.0, Some(0.0)), cell(1.0, None)],
            labels: vec![([0.5, 1.0], "R1".to_owned())],
        };
        let further = ChaosPanel { h: [1.0, 2.0], name: "component 1".to_owned(), ..whole.clone() };
        ChaosScene {
            panels: vec![whole, further],
            curves: vec![vec![[-1.0, 1.0], [1.0, 1.0], [3.0, 1.0], [3.0, 5.0]], vec![[5.0, 5.0], [6.0, 6.0]]],
            poles: vec![vec![[0.0, 0.5], [2.0, 0.7]]],
            moments: ["2", "1.1", "1"].map(str::to_owned),
            center: ["1", "0", "0"].map(str::to_owned),
            notes: vec!["open: 3 %".to_owned()],
        }
    }

    #[test]
    fn a_picture_names_regions_and_components_and_has_a_scale() {
        let svg = draw_chaos(&scene(), Theme::Light, Width::PAGE).unwrap().svg;
        for text in
            [">R1<", ">chaotic share<", ">open: 3 %<", "</tspan> = (1, 0, 0)<", ">component 0<", ">component 1<"]
        {
            assert!(svg.contains(text), "{text}");
        }
        let mut empty = scene();
        empty.panels[1].h = [1.0, 1.0];
        assert!(matches!(draw_chaos(&empty, Theme::Light, Width::PAGE), Err(PlotError::EmptyWindow { .. })));
    }

    #[test]
    fn a_picture_has_the_width_that_was_asked() {
        for width in Width::ALL {
            let picture = draw_chaos(&scene(), Theme::Light, width).unwrap();
            let svg = format!("width=\"{}mm\"", width.millimetres());
            assert!(picture.svg.contains(&svg), "{svg}: {}", &picture.svg[..200]);
        }
    }
}
