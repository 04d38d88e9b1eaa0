//! Where the panels of sections lie on the page, and what is written round them.

use std::f64::consts::{PI, TAU};

use super::scene::{Projection, SectionScene};
use bifdiag_dynamics::section::{Portrait, SectionChart};
use bifdiag_page::{Anchor, Canvas, HEIGHT, INK, Ink, Path, Point, Rect, Width, number, short_number};

/// How long the mark of a tick is.
const MARK: f64 = 4.0;
/// Plot area of a panel.
const PANEL: [f64; 2] = [384.0, 240.0];
/// Panels are so high at least, however many there are.
const PANEL_LEAST: f64 = 120.0;
/// What is left for the legend below both panels and below one.
const LEGEND: [f64; 2] = [90.0, 140.0];
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
    pub chart: SectionChart,
    /// −1 or +1.
    pub sheet: i8,
    pub rect: Rect,
    /// The ranges of x and y of the chart that are shown.
    pub window: [[f64; 2]; 2],
}

impl SheetPanel {
    /// Position on the page of (x, y) of the chart: x to the right, y downwards.
    pub fn position(&self, [x, y]: [f64; 2]) -> Point {
        let share = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let [across, down] = [share(x, self.window[0]), share(y, self.window[1])];
        [self.rect.x + across * self.rect.width, self.rect.y + down * self.rect.height]
    }

    pub fn positions(&self, points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|point| self.position(*point)).collect()
    }

    fn name(&self) -> &'static str {
        match (self.chart, self.sheet > 0) {
            (SectionChart::Torus, false) => "T⁻",
            (SectionChart::Torus, true) => "T⁺",
            (SectionChart::Sphere, false) => "S⁻",
            (SectionChart::Sphere, true) => "S⁺",
        }
    }
}

/// The whole of a chart.
const WHOLE: [[f64; 2]; 2] = [[0.0, TAU], [0.0, PI]];
/// A chart is cropped where that leaves less than this part of it, with a margin round what is accessible.
const CROPPED: f64 = 0.6;
const MARGIN: f64 = 0.05;

/// The part of a chart in which something is.
fn window(portrait: &Portrait, chart: SectionChart) -> [[f64; 2]; 2] {
    let area = portrait.accessible(chart);
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for point in area.loops.iter().flatten() {
        for (range, value) in ranges.iter_mut().zip(point) {
            *range = [range[0].min(*value), range[1].max(*value)];
        }
    }
    let mut cropped = WHOLE;
    let mut share = 1.0;
    for ([from, to], whole) in ranges.into_iter().zip(&mut cropped) {
        let margin = MARGIN * (to - from);
        let all = whole[1] - whole[0];
        *whole = [(from - margin).max(whole[0]), (to + margin).min(whole[1])];
        share *= (whole[1] - whole[0]) / all;
    }
    if share > 0.0 && share < CROPPED { cropped } else { WHOLE }
}

/// The page.
pub(super) struct Layout {
    pub panels: Vec<SheetPanel>,
    pub width: f64,
    /// Lower end of the panels with their labels.
    pub bottom: f64,
}

impl Layout {
    /// Both sheets beside each other on a page, below each other in a column.
    pub fn new(scenes: &[SectionScene<'_>], projection: Projection, with_bar: bool, paper: Width) -> Self {
        let charts: &[SectionChart] = match projection {
            Projection::Torus => &[SectionChart::Torus],
            Projection::Sphere => &[SectionChart::Sphere],
            Projection::Both => &[SectionChart::Sphere, SectionChart::Torus],
        };
        let bar = if with_bar { BAR } else { 0.0 };
        let across = if paper.is_column() { 1.0 } else { 2.0 };
        let room = (paper.pixels() - LEFT - RIGHT - bar - (across - 1.0) * BETWEEN) / across;
        let most = PANEL.map(|side| side * paper.scale().max(1.0));
        let width = room.min(most[0]);
        let rows = (2 * scenes.len() * charts.len()) as f64 / across;
        let room = ((HEIGHT - TITLE - LEGEND[usize::from(paper.is_column())]) / rows - ABOVE - BELOW).max(PANEL_LEAST);
        let height = (width * PANEL[1] / PANEL[0]).min(most[1]).min(room).round();
        let mut panels = Vec::new();
        let mut top = TITLE;
        for (scene, own) in scenes.iter().enumerate() {
            for &chart in charts {
                let window = window(own.portrait, chart);
                let below = ABOVE + height + BELOW;
                let other = if paper.is_column() { [0.0, below] } else { [width + BETWEEN, 0.0] };
                for (sheet, [right, down]) in [(-1, [0.0; 2]), (1, other)] {
                    let rect = Rect { x: LEFT + right, y: top + ABOVE + down, width, height };
                    panels.push(SheetPanel { scene, chart, sheet, rect, window });
                }
                top += other[1] + below;
            }
        }
        let right = LEFT + across * width + (across - 1.0) * BETWEEN + RIGHT;
        Self { panels, width: right + bar, bottom: top }
    }

    /// Width of the contents below the panels.
    pub fn room(&self) -> f64 {
        self.width - LEFT - RIGHT
    }

    /// The place of the colour bar.
    pub fn bar(&self) -> Rect {
        let first = self.panels[0].rect;
        Rect { x: self.width - BAR, y: first.y, width: BAR_WIDTH, height: first.height }
    }

    /// Names of the panels, (h, l) of the scenes, and ticks.
    pub fn draw_captions(&self, canvas: &Canvas, scenes: &[SectionScene<'_>]) {
        for (number, panel) in self.panels.iter().enumerate() {
            let rect = panel.rect;
            let above = rect.y - 9.0;
            canvas.text(panel.name(), [rect.center()[0], above], CAPTION_SIZE + 1.0, INK, Anchor::Middle);
            let scene = &scenes[panel.scene];
            let is_first = number.checked_sub(1).is_none_or(|before| self.panels[before].scene != panel.scene);
            if is_first {
                let (h, l) = scene.portrait.energy_momentum();
                let [h, l] = [("h", h), ("l", l)].map(|(name, value)| rounded(name, value));
                let place = format!("{h},  {l}");
                canvas.text(&place, [rect.x, above], CAPTION_SIZE, INK, Anchor::Start);
                let other = self.panels[number + 1].rect;
                canvas.text(scene.caption, [other.right(), other.y - 9.0], CAPTION_SIZE, INK, Anchor::End);
            }
            draw_ticks(canvas, panel);
        }
    }
}

/// A number short enough to leave room for the panel's name, marked with ≈ if rounded.
fn rounded(name: &str, value: f64) -> String {
    let (full, short) = (number(value), short_number(value, 6));
    format!("{name} {} {short}", if short == full { "=" } else { "≈" })
}

/// Fractions of π in a range, so fine that there are at least three of them.
fn ticks([from, to]: [f64; 2]) -> Vec<(f64, String)> {
    let mut parts = 2_u32;
    loop {
        let step = PI / f64::from(parts);
        let [first, last] = [(from / step - 1e-9).ceil(), (to / step + 1e-9).floor()];
        if last - first >= 2.0 || parts > 1 << 16 {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to twice the parts")]
            let [first, last] = [first.max(0.0) as u32, last.max(0.0) as u32];
            return (first..=last).map(|count| (f64::from(count) * step, fraction(count, parts))).collect();
        }
        parts *= 2;
    }
}

/// So many parts of π; the parts are a power of two.
fn fraction(count: u32, parts: u32) -> String {
    let common = 1 << count.trailing_zeros().min(parts.trailing_zeros());
    let over = |parts: u32| if parts == 1 { String::new() } else { format!("/{parts}") };
    match count / common {
        0 => "0".to_owned(),
        1 => format!("π{}", over(parts / common)),
        many => format!("{many}π{}", over(parts / common)),
    }
}

/// The ticks below a panel and beside it with their labels; those of ϑ on the left one only.
fn draw_ticks(canvas: &Canvas, panel: &SheetPanel) {
    let rect = panel.rect;
    let (psi, theta) = match panel.chart {
        SectionChart::Torus => ("ψ′", "ϑ′"),
        SectionChart::Sphere => ("ψ", "ϑ"),
    };
    let is_left = rect.x <= LEFT;
    let [corner_x, corner_y] = panel.window.map(|range| range[0]);
    let mut marks = Path::default();
    for (value, label) in ticks(panel.window[0]) {
        let [x, _] = panel.position([value, corner_y]);
        marks.line(&[[x, rect.bottom()], [x, rect.bottom() + MARK]], false);
        canvas.text(&label, [x, rect.bottom() + 17.0], TICK_SIZE, INK, Anchor::Middle);
    }
    let beside: Vec<(f64, String)> = ticks(panel.window[1])
        .into_iter()
        .map(|(value, label)| (panel.position([corner_x, value])[1], label))
        .collect();
    for (y, label) in &beside {
        marks.line(&[[rect.x - MARK, *y], [rect.x, *y]], false);
        if is_left {
            canvas.text(label, [rect.x - 9.0, y + 0.36 * TICK_SIZE], TICK_SIZE, INK, Anchor::End);
        }
    }
    canvas.draw(&marks, &canvas.stroke(Ink { color: INK, width: 0.9 }));
    canvas.text(psi, [rect.x + 0.5 * rect.width, rect.bottom() + 33.0], CAPTION_SIZE, INK, Anchor::Middle);
    if is_left {
        // Between two ticks: beside one it would read as a factor of the number.
        let name_at = match beside.as_slice() {
            [(first, _), (second, _), ..] => 0.5 * (first + second),
            _ => rect.y + 0.25 * rect.height,
        };
        canvas.text(theta, [rect.x - 9.0, name_at + 0.36 * CAPTION_SIZE], CAPTION_SIZE, INK, Anchor::End);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_fractions_of_pi() {
        let labels = |range| ticks(range).into_iter().map(|(_, label)| label).collect::<Vec<_>>();
        assert_eq!(labels([0.0, TAU]), ["0", "π/2", "π", "3π/2", "2π"]);
        assert_eq!(labels([0.0, PI]), ["0", "π/2", "π"]);
        assert_eq!(labels([1.0, 1.9]), ["3π/8", "7π/16", "π/2", "9π/16"]);
    }
}
