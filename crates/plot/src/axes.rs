//! Axes with ticks at round numbers.

use plotters::chart::ChartBuilder;

use super::PlotError;
use super::canvas::{Anchor, Canvas, Ink, style, text_style, to_units};
use super::font::text_width;
use super::layout::{BELOW, LEFT};
use super::notation::{H, L};
use super::palette::INK;
use super::panel::{Panel, View};
use super::ticks::{Axis, ticks};

/// Font size of tick labels.
const SIZE: f64 = 11.0;

/// Draws the axes of a panel and its frame; those of the main panel (index 0) tell what h and l are.
pub(super) fn draw(canvas: &Canvas<'_>, panel: &Panel, index: usize) -> Result<(), PlotError> {
    let View { window, rect } = panel.view;
    let spacing = if index == 0 { 70.0 } else { 58.0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few dozen at most")]
    let count = |length: f64, spacing: f64| (length / spacing).floor() as usize;
    let h_ticks = ticks(H, window.h[0], window.h[1], count(rect.width, spacing));
    let l_ticks = ticks(L, window.l[0], window.l[1], count(rect.height, 0.7 * spacing));
    let area = canvas.area().clone().shrink(
        (to_units(rect.x - LEFT), to_units(rect.y)),
        (to_units(rect.width + LEFT), to_units(rect.height + BELOW)),
    );
    let frame = style(Ink { color: INK, width: 0.9 });
    let mut chart = ChartBuilder::on(&area)
        .x_label_area_size(to_units(BELOW))
        .y_label_area_size(to_units(LEFT))
        .build_cartesian_2d(
            Axis { range: window.h, ticks: h_ticks.clone() },
            Axis { range: window.l, ticks: l_ticks.clone() },
        )?;
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(frame)
        .set_all_tick_mark_size(to_units(4.0))
        .label_style(text_style(SIZE, INK))
        .draw()?;
    canvas.outline(&rect.corners(), Ink { color: INK, width: 0.9 })?;
    // In full where the labels are not scaled, in the main panel.
    let name = |quantity: &str, meaning: &str| match quantity {
        H | L if index == 0 => format!("{meaning} {quantity}"),
        scaled => scaled.to_owned(),
    };
    let (h_name, l_name) = (name(&h_ticks.quantity, "energy"), name(&l_ticks.quantity, "vertical angular momentum"));
    let h_at = [rect.x + rect.width / 2.0, rect.y + rect.height + 36.0];
    canvas.text(&h_name, h_at, SIZE + 1.0, INK, Anchor::Middle)?;
    let l_at = [(rect.x - 12.0 - text_width(&l_name, SIZE + 1.0)).max(rect.x - LEFT + 14.0), rect.y - 12.0];
    canvas.text(&l_name, l_at, SIZE + 1.0, INK, Anchor::Start)
}
