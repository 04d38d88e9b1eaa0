//! Axes with ticks at round numbers.

use std::ops::Range;

use plotters::chart::ChartBuilder;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use super::canvas::Canvas;
use super::geometry::{Rect, to_units};
use super::ink::{INK, Ink};
use super::ticks::Ticks;

/// Font size of tick labels.
pub(crate) const TICK_SIZE: f64 = 11.0;

/// A linear axis of plotters with given ticks.
pub(crate) struct Axis<'a> {
    pub range: [f64; 2],
    pub ticks: &'a Ticks,
}

impl Ranged for Axis<'_> {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let share = (value - self.range[0]) / (self.range[1] - self.range[0]);
        #[expect(clippy::cast_possible_truncation, reason = "ticks lie within the range")]
        let offset = (share * f64::from(limit.1 - limit.0)).round() as i32;
        limit.0 + offset
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // plotters asks a second time for the lines of a finer mesh, which is not drawn.
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks.values.clone() }
    }

    fn range(&self) -> Range<f64> {
        self.range[0]..self.range[1]
    }
}

impl ValueFormatter<f64> for Axis<'_> {
    fn format_ext(&self, value: &f64) -> String {
        let at = self.ticks.values.iter().position(|tick| tick == value);
        at.map_or_else(String::new, |at| self.ticks.labels[at].clone())
    }
}

/// Draws axes below and on the left of `rect`, where their labels may take so many pixels, and a frame round it.
pub(crate) fn draw_axes(canvas: &Canvas, rect: &Rect, [below, left]: [f64; 2], [x, y]: [Axis<'_>; 2]) {
    let frame = Ink { color: INK, width: 0.9 };
    canvas.plotters(|area| {
        let area = area.clone().shrink(
            (to_units(rect.x - left), to_units(rect.y)),
            (to_units(rect.width + left), to_units(rect.height + below)),
        );
        let mut chart = ChartBuilder::on(&area)
            .x_label_area_size(to_units(below))
            .y_label_area_size(to_units(left))
            .build_cartesian_2d(x, y)?;
        let mut mesh = chart.configure_mesh();
        let mesh = mesh.disable_mesh().axis_style(canvas.style(frame)).set_all_tick_mark_size(to_units(4.0));
        mesh.label_style(canvas.text_style(TICK_SIZE, INK)).draw()
    });
    canvas.outline(&rect.corners(), frame);
}
