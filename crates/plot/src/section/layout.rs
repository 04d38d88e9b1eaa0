//! Where the panels of sections lie on the page, and what is written round them.

use std::f64::consts::{PI, TAU};

use super::scene::{Projection, SectionScene};
use crate::page::{Anchor, Canvas, INK, Point, Rect, number, short_number};
use dynamics::section::Chart;

/// Plot area of a panel.
const PANEL: [f64; 2] = [384.0, 240.0];
const LEFT: f64 = 56.0;
const BETWEEN: f64 = 40.0;
const RIGHT: f64 = 20.0;
/// Room for the colour bar and its labels.
const BAR: f64 = 92.0;
const BAR_WIDTH: f64 = 13.0;
const TITLE: f64 = 34.0;
/// Room above and below the panels of a row.
const ABOVE: f64 = 30.0;
const BELOW: f64 = 42.0;
const CAPTION_SIZE: f64 = 12.0;
const TICK_SIZE: f64 = 11.0;

/// Base line of the title.
pub(super) const TITLE_AT: Point = [LEFT, TITLE - 8.0];

/// One sheet of one chart of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SheetPanel {
    /// Index of the scene.
    pub scene: usize,
    pub chart: Chart,
    /// −1 or +1.
    pub sheet: i8,
    pub rect: Rect,
}

impl SheetPanel {
    /// Position on the page of (x, y) of the chart: x to the right, y downwards.
    pub fn position(&self, [x, y]: [f64; 2]) -> Point {
        [self.rect.x + x / TAU * self.rect.width, self.rect.y + y / PI * self.rect.height]
    }

    pub fn positions(&self, points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|point| self.position(*point)).collect()
    }

    fn name(&self) -> &'static str {
        match (self.chart, self.sheet > 0) {
            (Chart::Torus, false) => "T⁻",
            (Chart::Torus, true) => "T⁺",
            (Chart::Sphere, false) => "S⁻",
            (Chart::Sphere, true) => "S⁺",
        }
    }
}

/// The page.
pub(super) struct Layout {
    pub panels: Vec<SheetPanel>,
    pub width: f64,
    /// Lower end of the panels with their labels.
    pub bottom: f64,
}

impl Layout {
    pub fn new(scenes: &[SectionScene<'_>], projection: Projection, with_bar: bool) -> Self {
        let charts: &[Chart] = match projection {
            Projection::Torus => &[Chart::Torus],
            Projection::Sphere => &[Chart::Sphere],
            Projection::Both => &[Chart::Sphere, Chart::Torus],
        };
        let [mut width, height] = PANEL;
        if with_bar {
            // A page of at most 924 pixels: so wide 11 pixels are 6 pt in print.
            width -= 26.0;
        }
        let mut panels = Vec::new();
        let mut top = TITLE;
        for scene in 0..scenes.len() {
            for &chart in charts {
                let y = top + ABOVE;
                for (sheet, x) in [(-1, LEFT), (1, LEFT + width + BETWEEN)] {
                    panels.push(SheetPanel { scene, chart, sheet, rect: Rect { x, y, width, height } });
                }
                top = y + height + BELOW;
            }
        }
        let right = LEFT + 2.0 * width + BETWEEN + RIGHT;
        Self { panels, width: right + if with_bar { BAR } else { 0.0 }, bottom: top }
    }

    /// Where the colour bar stands.
    pub fn bar(&self) -> Rect {
        let first = self.panels[0].rect;
        Rect { x: self.width - BAR, y: first.y, width: BAR_WIDTH, height: first.height }
    }

    /// Names of the panels, (h, l) of the scenes, and ticks.
    pub fn draw_captions(&self, canvas: &Canvas, scenes: &[SectionScene<'_>]) {
        let mut captioned = None;
        for panel in &self.panels {
            let rect = panel.rect;
            let above = rect.y - 9.0;
            canvas.text(panel.name(), [rect.center()[0], above], CAPTION_SIZE + 1.0, INK, Anchor::Middle);
            let scene = &scenes[panel.scene];
            if captioned != Some(panel.scene) {
                captioned = Some(panel.scene);
                let (h, l) = scene.portrait.energy_momentum();
                let [h, l] = [("h", h), ("l", l)].map(|(name, value)| rounded(name, value));
                let place = format!("{h},  {l}");
                canvas.text(&place, [rect.x, above], CAPTION_SIZE, INK, Anchor::Start);
                let other = [self.panels[1].rect.right(), above];
                canvas.text(scene.caption, other, CAPTION_SIZE, INK, Anchor::End);
            }
            draw_ticks(canvas, panel);
        }
    }
}

/// A number that leaves room for the panel's name, told to be rounded where it is.
fn rounded(name: &str, value: f64) -> String {
    let (full, short) = (number(value), short_number(value, 6));
    format!("{name} {} {short}", if short == full { "=" } else { "≈" })
}

/// Labels of the ticks below a panel, and beside it if it is the left one.
fn draw_ticks(canvas: &Canvas, panel: &SheetPanel) {
    let rect = panel.rect;
    let (psi, theta) = match panel.chart {
        Chart::Torus => ("ψ′", "ϑ′"),
        Chart::Sphere => ("ψ", "ϑ"),
    };
    for (k, label) in ["0", "π/2", "π", "3π/2", "2π"].into_iter().enumerate() {
        let at = [rect.x + 0.25 * k as f64 * rect.width, rect.bottom() + 17.0];
        canvas.text(label, at, TICK_SIZE, INK, Anchor::Middle);
    }
    let name = [rect.x + 0.5 * rect.width, rect.bottom() + 33.0];
    canvas.text(psi, name, CAPTION_SIZE, INK, Anchor::Middle);
    if panel.sheet > 0 {
        return;
    }
    for (k, label) in ["0", "π/2", "π"].into_iter().enumerate() {
        let at = [rect.x - 9.0, rect.y + 0.5 * k as f64 * rect.height + 0.36 * TICK_SIZE];
        canvas.text(label, at, TICK_SIZE, INK, Anchor::End);
    }
    let name = [rect.x - 36.0, rect.y + 0.5 * rect.height + 0.36 * CAPTION_SIZE];
    canvas.text(theta, name, CAPTION_SIZE, INK, Anchor::End);
}
