//! The chaotic share over the (h, l) plane, with the curves of the diagram over it.

mod areas;

use std::collections::BTreeMap;

use plotters::style::RGBColor;

use crate::page::{
    Anchor, Axis, Canvas, FAINT_INK, INK, Ink, PAPER, Path, Picture, PlotError, Point, Rect, Theme, clip_polyline,
    draw_axes, is_proper, render, text_width, ticks,
};
use crate::section::{paint_scale, shade, unknown};
use areas::merged;

/// What the picture of a map shows.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosScene {
    /// The whole window first; where regions have several components, a panel for each further one.
    pub panels: Vec<ChaosPanel>,
    /// Curves of the diagram, through points (h, l).
    pub curves: Vec<Vec<[f64; 2]>>,
    /// Pole lines, likewise: on them the section changes, and E does not.
    pub poles: Vec<Vec<[f64; 2]>>,
    /// The body.
    pub title: String,
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
    /// What stands over it.
    pub name: String,
    /// The cells.
    pub cells: Vec<ChaosCell>,
    /// Names of regions, and where they stand.
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

const RECT: Rect = Rect { x: 74.0, y: 62.0, width: 520.0, height: 400.0 };
/// Height of a further panel, and what lies between two.
const FURTHER: f64 = 240.0;
const BETWEEN: f64 = 84.0;
const BAR: Rect = Rect { x: 620.0, y: 62.0, width: 16.0, height: 400.0 };
const TEXT: f64 = 12.0;
/// Between two lines of the notes.
const LINE: f64 = 16.0;

/// Draws a map: h to the right, l upwards. The darker a cell, the smaller the share; what is not accessible is left white.
///
/// # Errors
/// [`PlotError::EmptyWindow`] when a range is empty, else what the drawing library reports.
pub fn draw_chaos(scene: &ChaosScene, theme: Theme) -> Result<Picture, PlotError> {
    if let Some(empty) = scene.panels.iter().find(|panel| !is_proper(panel.h) || !is_proper(panel.l)) {
        return Err(PlotError::EmptyWindow { h: empty.h, l: empty.l });
    }
    let rect = |number: usize| match number {
        0 => RECT,
        _ => Rect { y: RECT.bottom() + BETWEEN + (FURTHER + BETWEEN) * (number - 1) as f64, height: FURTHER, ..RECT },
    };
    let bottom = rect(scene.panels.len().saturating_sub(1)).bottom();
    let height = bottom + 66.0 + LINE * scene.notes.len() as f64;
    render([700.0, height], "The chaotic share of the energy surface", theme, |canvas| {
        canvas.text(&scene.title, [RECT.x, 26.0], TEXT + 2.0, INK, Anchor::Start);
        for (number, panel) in scene.panels.iter().enumerate() {
            draw_panel(canvas, panel, &rect(number), scene);
        }
        draw_bar(canvas);
        for (number, note) in scene.notes.iter().enumerate() {
            let base = bottom + 62.0 + LINE * number as f64;
            canvas.text(note, [RECT.x, base], TEXT, FAINT_INK, Anchor::Start);
        }
    })
}

fn draw_panel(canvas: &Canvas, panel: &ChaosPanel, rect: &Rect, scene: &ChaosScene) {
    let across = |h: f64| rect.x + rect.width * (h - panel.h[0]) / (panel.h[1] - panel.h[0]);
    let up = |l: f64| rect.bottom() - rect.height * (l - panel.l[0]) / (panel.l[1] - panel.l[0]);
    let at = |[h, l]: [f64; 2]| [across(h), up(l)];
    // One path for each colour, whose edges fall on whole pixels, so that no seam shows between two.
    let mut paths: BTreeMap<[u8; 3], (RGBColor, Path)> = BTreeMap::new();
    for area in merged(panel.cells.iter().map(|cell| (cell.h, cell.l, color(cell.share)))) {
        let [x, right] = area.h.map(|h| across(h).clamp(rect.x, rect.right()));
        let [y, top] = area.l.map(|l| up(l).clamp(rect.y, rect.bottom()));
        let RGBColor(red, green, blue) = area.color;
        let (_, path) = paths.entry([red, green, blue]).or_insert_with(|| (area.color, Path::default()));
        path.line(&[[x, y], [right, y], [right, top], [x, top]], true);
    }
    for (color, path) in paths.values() {
        canvas.draw(path, &format!("{} shape-rendering=\"crispEdges\"", canvas.fill(*color)));
    }
    for (lines, width) in [(&scene.poles, 0.6), (&scene.curves, 1.2)] {
        for line in lines {
            let points: Vec<Point> = line.iter().copied().map(at).collect();
            for points in clip_polyline(&points, rect) {
                canvas.path(&points, Ink { color: PAPER, width: width + 1.4 });
                canvas.path(&points, Ink { color: INK, width });
            }
        }
    }
    for (place, text) in &panel.labels {
        let [x, y] = at(*place);
        let half = text_width(text, TEXT) / 2.0 + 3.0;
        let ground = Rect { x: x - half, y: y - 8.0, width: 2.0 * half, height: 16.0 };
        canvas.polygon(&ground.corners(), PAPER);
        canvas.text(text, [x, y + 4.0], TEXT, INK, Anchor::Middle);
    }
    let (below, left) = (ticks("h", panel.h[0], panel.h[1], 8), ticks("l", panel.l[0], panel.l[1], 8));
    let axes = [Axis { range: panel.h, ticks: &below }, Axis { range: panel.l, ticks: &left }];
    draw_axes(canvas, rect, [24.0, 52.0], axes);
    canvas.text(&below.quantity, [rect.center()[0], rect.bottom() + 42.0], TEXT, INK, Anchor::Middle);
    canvas.text(&left.quantity, [16.0, rect.y - 12.0], TEXT, INK, Anchor::Start);
    canvas.text(&panel.name, [rect.x, rect.y - 12.0], TEXT, INK, Anchor::Start);
}

/// The colour of a share.
fn color(share: Option<f64>) -> RGBColor {
    share.map_or(unknown(), |share| shade(share.clamp(0.0, 1.0)))
}

/// The scale of shares.
fn draw_bar(canvas: &Canvas) {
    paint_scale(canvas, &BAR);
    canvas.outline(&BAR.corners(), Ink { color: INK, width: 0.8 });
    for fifth in 0..=5_u32 {
        let share = f64::from(fifth) / 5.0;
        let y = BAR.bottom() - BAR.height * share;
        canvas.path(&[[BAR.right(), y], [BAR.right() + 4.0, y]], Ink { color: INK, width: 0.8 });
        canvas.text(&format!("{share:.1}"), [BAR.right() + 7.0, y + 4.0], TEXT - 1.0, INK, Anchor::Start);
    }
    canvas.text("chaotic share", [BAR.right() + 40.0, BAR.y - 12.0], TEXT, INK, Anchor::End);
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
            title: "A body".to_owned(),
            notes: vec!["open: 3 %".to_owned()],
        }
    }

    #[test]
    fn a_picture_names_regions_and_components_and_has_a_scale() {
        let svg = draw_chaos(&scene(), Theme::Light).unwrap().svg;
        for text in [">R1<", ">chaotic share<", ">open: 3 %<", ">A body<", ">component 0<", ">component 1<"] {
            assert!(svg.contains(text), "{text}");
        }
        let mut empty = scene();
        empty.panels[1].h = [1.0, 1.0];
        assert!(matches!(draw_chaos(&empty, Theme::Light), Err(PlotError::EmptyWindow { .. })));
    }
}
