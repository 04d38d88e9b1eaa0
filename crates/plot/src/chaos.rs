//! The chaotic share over the (h, l) plane, with the curves of the diagram over it.

use plotters::style::RGBColor;

use crate::page::{
    Anchor, Axis, Canvas, FAINT_INK, INK, Ink, PAPER, Picture, PlotError, Point, Rect, Theme, clip_polyline, draw_axes,
    is_proper, render, text_width, ticks,
};
use crate::section::{paint_scale, shade, unknown};

/// What the picture of a map shows.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosScene {
    /// Energies.
    pub h: [f64; 2],
    /// Vertical angular momenta.
    pub l: [f64; 2],
    /// The cells.
    pub cells: Vec<ChaosCell>,
    /// Curves of the diagram, through points (h, l).
    pub curves: Vec<Vec<[f64; 2]>>,
    /// Names of regions, and where they stand.
    pub labels: Vec<([f64; 2], String)>,
    /// The body.
    pub title: String,
    /// What the legend says below: the open share, the error.
    pub notes: Vec<String>,
}

/// A rectangle of the plane and the shares in it.
#[derive(Clone, Debug, PartialEq)]
pub struct ChaosCell {
    /// Its energies.
    pub h: [f64; 2],
    /// Its momenta.
    pub l: [f64; 2],
    /// The shares of the components, which stand one above the other along l; `None` where a share is not known.
    pub shares: Vec<Option<f64>>,
}

const RECT: Rect = Rect { x: 74.0, y: 62.0, width: 520.0, height: 400.0 };
const BAR: Rect = Rect { x: 620.0, y: 62.0, width: 16.0, height: 400.0 };
const TEXT: f64 = 12.0;
/// Between two lines of the notes.
const LINE: f64 = 16.0;

/// Draws a map: h to the right, l upwards. The darker a cell, the smaller the share; what is not accessible is left white.
///
/// # Errors
/// [`PlotError::EmptyWindow`] when a range is empty, else what the drawing library reports.
pub fn draw_chaos(scene: &ChaosScene, theme: Theme) -> Result<Picture, PlotError> {
    if !is_proper(scene.h) || !is_proper(scene.l) {
        return Err(PlotError::EmptyWindow { h: scene.h, l: scene.l });
    }
    let across = |h: f64| RECT.x + RECT.width * (h - scene.h[0]) / (scene.h[1] - scene.h[0]);
    let up = |l: f64| RECT.bottom() - RECT.height * (l - scene.l[0]) / (scene.l[1] - scene.l[0]);
    let at = |[h, l]: [f64; 2]| [across(h), up(l)];
    let (below, left) = (ticks("h", scene.h[0], scene.h[1], 8), ticks("l", scene.l[0], scene.l[1], 8));
    let height = RECT.bottom() + 66.0 + LINE * scene.notes.len() as f64;
    render([700.0, height], "The chaotic share of the energy surface", theme, |canvas| {
        canvas.text(&scene.title, [RECT.x, 26.0], TEXT + 2.0, INK, Anchor::Start);
        for cell in &scene.cells {
            draw_cell(canvas, cell, &across, &up);
        }
        for curve in &scene.curves {
            let points: Vec<Point> = curve.iter().copied().map(at).collect();
            for points in clip_polyline(&points, &RECT) {
                canvas.path(&points, Ink { color: PAPER, width: 2.6 });
                canvas.path(&points, Ink { color: INK, width: 1.2 });
            }
        }
        for (place, text) in &scene.labels {
            let [x, y] = at(*place);
            let half = text_width(text, TEXT) / 2.0 + 3.0;
            let ground = Rect { x: x - half, y: y - 8.0, width: 2.0 * half, height: 16.0 };
            canvas.polygon(&ground.corners(), PAPER);
            canvas.text(text, [x, y + 4.0], TEXT, INK, Anchor::Middle);
        }
        let axes = [Axis { range: scene.h, ticks: &below }, Axis { range: scene.l, ticks: &left }];
        draw_axes(canvas, &RECT, [24.0, 52.0], axes);
        canvas.text(&below.quantity, [RECT.center()[0], RECT.bottom() + 42.0], TEXT, INK, Anchor::Middle);
        canvas.text(&left.quantity, [16.0, RECT.y - 12.0], TEXT, INK, Anchor::Start);
        draw_bar(canvas);
        for (number, note) in scene.notes.iter().enumerate() {
            let base = RECT.bottom() + 62.0 + LINE * number as f64;
            canvas.text(note, [RECT.x, base], TEXT, FAINT_INK, Anchor::Start);
        }
    })
}

/// The colour of a share.
fn color(share: Option<f64>) -> RGBColor {
    share.map_or(unknown(), |share| shade(share.clamp(0.0, 1.0)))
}

fn draw_cell(canvas: &Canvas, cell: &ChaosCell, across: &impl Fn(f64) -> f64, up: &impl Fn(f64) -> f64) {
    let step = (cell.l[1] - cell.l[0]) / cell.shares.len().max(1) as f64;
    for (number, share) in cell.shares.iter().enumerate() {
        let bottom = cell.l[0] + step * number as f64;
        // A little over the edge, so that no seam shows.
        let (x, right) = (across(cell.h[0]), (across(cell.h[1]) + 0.4).min(RECT.right()));
        let (y, top) = (up(bottom), (up(bottom + step) - 0.4).max(RECT.y));
        canvas.polygon(&[[x, y], [right, y], [right, top], [x, top]], color(*share));
    }
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
        let cell = |h: f64, shares| ChaosCell { h: [h, h + 1.0], l: [0.0, 2.0], shares };
        ChaosScene {
            h: [0.0, 2.0],
            l: [0.0, 2.0],
            cells: vec![cell(0.0, vec![Some(0.0)]), cell(1.0, vec![Some(1.0), None])],
            curves: vec![vec![[-1.0, 1.0], [1.0, 1.0], [3.0, 1.0], [3.0, 5.0]], vec![[5.0, 5.0], [6.0, 6.0]]],
            labels: vec![([0.5, 1.0], "R1".to_owned())],
            title: "A body".to_owned(),
            notes: vec!["open: 3 %".to_owned()],
        }
    }

    #[test]
    fn a_picture_names_regions_and_has_a_scale() {
        let svg = draw_chaos(&scene(), Theme::Light).unwrap().svg;
        for text in [">R1<", ">chaotic share<", ">open: 3 %<", ">A body<"] {
            assert!(svg.contains(text), "{text}");
        }
        let empty = ChaosScene { h: [1.0, 1.0], ..scene() };
        assert!(matches!(draw_chaos(&empty, Theme::Light), Err(PlotError::EmptyWindow { .. })));
    }
}
