//! Axes with ticks at round numbers, whose labels stay short at any magnification.

use std::ops::Range;

use plotters::chart::ChartBuilder;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use super::canvas::Canvas;
use super::color::{INK, Ink};
use super::geometry::{Rect, to_units};
use super::notation::{number, superscript};

/// Font size of tick labels.
pub const TICK_SIZE: f64 = 11.0;

/// A linear axis of plotters with given ticks.
pub struct Axis<'a> {
    /// The first and the last value.
    pub range: [f64; 2],
    /// Where ticks stand, with their labels.
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

/// Draws axes below and on the left of `rect`, where their labels may take this many pixels, and a frame round it.
pub fn draw_axes(canvas: &Canvas, rect: &Rect, [below, left]: [f64; 2], [x, y]: [Axis<'_>; 2]) {
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
/// The most characters of a tick label.
const LABEL_MAX: usize = 6;

/// The tick marks of one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Ticks {
    /// Positions.
    pub values: Vec<f64>,
    /// What is printed there.
    pub labels: Vec<String>,
    /// The quantity that the labels give, such as `h`, `(h − 3.147)·10⁵` or `spin·10⁻⁵ in rpm`.
    pub quantity: String,
}

/// The decimal exponent of x > 0: x = d.ddd·10^e.
fn exponent(x: f64) -> i32 {
    let text = format!("{x:e}");
    text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// count·10^e, correctly rounded.
fn decimal_value(count: i64, e: i32) -> f64 {
    format!("{count}e{e}").parse().unwrap_or(0.0)
}

/// The ticks of a quantity, whose name may end with ` in ` and its unit, on [from, to]: as many as possible up to `count`, 1, 2
/// or 5 times a power of ten apart.
pub fn ticks(name: &str, from: f64, to: f64, count: usize) -> Ticks {
    let (symbol, unit) = name.split_at(name.find(" in ").unwrap_or(name.len()));
    let none = Ticks { values: Vec::new(), labels: Vec::new(), quantity: name.to_owned() };
    let least = (to - from) / count.max(1) as f64;
    if !(least > 0.0 && least.is_finite()) {
        return none;
    }
    let e = exponent(least);
    let (factor, e) = [(1, e), (2, e), (5, e), (1, e + 1)]
        .into_iter()
        .find(|&(factor, e)| decimal_value(factor, e) >= least)
        .unwrap_or((2, e + 1));
    let step = decimal_value(factor, e);
    let (first, last) = ((from / step).ceil(), (to / step).floor());
    // Beyond 2^53 neighbouring ticks are not distinct numbers.
    if first.abs().max(last.abs()) > 9e15 || last < first {
        return none;
    }
    #[expect(clippy::cast_possible_truncation, reason = "checked above")]
    let counts: Vec<i64> = (first as i64..=last as i64).map(|k| k * factor).collect();
    let values = counts.iter().map(|&k| decimal_value(k, e)).collect();
    let longest = |labels: &[String]| labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
    let plain: Vec<String> = counts.iter().map(|&k| number(decimal_value(k, e))).collect();
    if longest(&plain) <= LABEL_MAX {
        return Ticks { values, labels: plain, quantity: name.to_owned() };
    }
    let scaled: Vec<String> = counts.iter().map(number).collect();
    if longest(&scaled) <= LABEL_MAX - 2 {
        return Ticks { values, labels: scaled, quantity: format!("{symbol}·10{}{unit}", superscript(-e)) };
    }
    // Labels count from a round number below the window.
    let spread = counts.last().unwrap_or(&0) - counts.first().unwrap_or(&0);
    let mut round = 10;
    while round <= spread {
        round *= 10;
    }
    let base = counts.first().unwrap_or(&0).div_euclid(round) * round;
    let labels = counts.iter().map(|k| number(k - base)).collect();
    let offset = number(decimal_value(base.abs(), e));
    let sign = if base < 0 { '+' } else { '−' };
    let quantity = match -e {
        0 => format!("{symbol} {sign} {offset}{unit}"),
        power => format!("({symbol} {sign} {offset})·10{}{unit}", superscript(power)),
    };
    Ticks { values, labels, quantity }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_ticks_are_round_numbers() {
        let ticks = ticks("h", -1.3, 2.4, 8);
        assert_eq!(ticks.labels, ["−1", "−0.5", "0", "0.5", "1", "1.5", "2"]);
        assert_eq!(ticks.values[1], -0.5);
        assert_eq!(ticks.quantity, "h");
    }

    #[test]
    fn a_strong_magnification_counts_from_a_round_number() {
        let ticks = ticks("l", 3.147_225_01, 3.147_225_04, 4);
        assert_eq!(ticks.quantity, "(l − 3.147225)·10⁸");
        assert_eq!(super::ticks("spin in rpm", 0.0, 3e9, 6).quantity, "spin·10⁻⁸ in rpm");
        assert_eq!(ticks.labels, ["1", "2", "3", "4"]);
        assert_eq!(ticks.values[0], 3.147_225_01);
    }

    #[test]
    fn large_and_small_scales_keep_short_labels() {
        for (from, to) in [(0.0, 3e8), (0.0, 2e-7), (-5e6, 1e6), (1e8, 1e8 + 3.0), (-1e-3, -0.999e-3)] {
            let ticks = ticks("h", from, to, 6);
            assert!(ticks.labels.len() >= 2, "{from} to {to}: {ticks:?}");
            assert!(ticks.labels.iter().all(|label| label.chars().count() <= LABEL_MAX), "{ticks:?}");
        }
    }

    #[test]
    fn an_empty_axis_has_no_ticks() {
        assert!(ticks("h", 1.0, 1.0, 5).values.is_empty());
        assert!(ticks("h", f64::NAN, 1.0, 5).values.is_empty());
    }
}
