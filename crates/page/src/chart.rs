//! A chart: two quantities with their axes round a frame. What is drawn in it is given in their values.

use super::axes::{Axis, Ticks, draw_axes, ticks};
use super::canvas::{Anchor, Canvas};
use super::color::INK;
use super::geometry::{Point, Rect};
use super::path::Dash;

/// Font size of the names of quantities and of other text around a chart.
pub const CHART_TEXT: f64 = 12.0;
/// Room of the labels of ticks below a chart and on its left.
const LABELS: [f64; 2] = [24.0, 52.0];
/// Wanted distance of ticks in pixels.
const APART: [f64; 2] = [66.0, 42.0];
/// Where the name of what is upwards begins.
const NAME_AT: f64 = 16.0;

/// Two quantities and where they are on the page.
pub struct Chart {
    /// The frame.
    pub rect: Rect,
    ranges: [[f64; 2]; 2],
    ticks: [Ticks; 2],
    /// Distance of the name of the vertical axis above the frame.
    above: f64,
}

impl Chart {
    /// What is to the right and what is upwards, with the ranges that are shown.
    #[must_use]
    pub fn new(rect: Rect, names: [&str; 2], ranges: [[f64; 2]; 2]) -> Self {
        let counts = [rect.width / APART[0], rect.height / APART[1]];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few dozen at most")]
        let of = |k: usize| ticks(names[k], ranges[k][0], ranges[k][1], counts[k] as usize);
        Self { rect, ranges, ticks: [of(0), of(1)], above: 14.0 }
    }

    /// The same with room above the frame.
    #[must_use]
    pub fn with_room_above(self, above: f64) -> Self {
        Self { above, ..self }
    }

    /// Where a pair of values is.
    #[must_use]
    pub fn at(&self, [x, y]: Point) -> Point {
        let share = |k: usize, value: f64| (value - self.ranges[k][0]) / (self.ranges[k][1] - self.ranges[k][0]);
        [self.rect.x + self.rect.width * share(0, x), self.rect.bottom() - self.rect.height * share(1, y)]
    }

    /// The largest value upwards.
    #[must_use]
    pub fn top(&self) -> f64 {
        self.ranges[1][1]
    }

    /// A line through pairs of values.
    pub fn line(&self, canvas: &Canvas, points: &[Point], pattern: &[Dash], width: f64) {
        let points: Vec<Point> = points.iter().map(|point| self.at(*point)).collect();
        canvas.dashed(&points, pattern, width);
    }

    /// The axes, their names and the frame.
    pub fn draw(&self, canvas: &Canvas) {
        let [x, y] = [0, 1].map(|k| Axis { range: self.ranges[k], ticks: &self.ticks[k] });
        draw_axes(canvas, &self.rect, LABELS, [x, y]);
        let [below, left] = self.ticks.each_ref().map(|ticks| ticks.quantity.as_str());
        canvas.text(below, [self.rect.center()[0], self.rect.bottom() + 42.0], CHART_TEXT, INK, Anchor::Middle);
        canvas.text(left, [NAME_AT, self.rect.y - self.above], CHART_TEXT, INK, Anchor::Start);
    }
}
