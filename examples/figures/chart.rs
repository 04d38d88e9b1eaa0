//! Charts of measurements: markers and lines over logarithmic or linear axes, panels side by side above one legend.

use bifdiag_plot::page::{
    Anchor, Canvas, FAINT_INK, INK, Ink, Point, Rect, Rows, render, rgb, rgbs, superscript, text_width,
};
use bifdiag_plot::{Picture, PlotError, Theme};
use plotters::style::RGBColor;

/// How an axis maps its values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Decades of equal length; only positive values are drawn.
    Logarithmic,
    /// Logarithmic, large values first.
    Descending,
    /// 0 to 100.
    Percent,
}

/// One quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartAxis {
    /// What is measured, with its unit.
    pub label: String,
    /// How it is mapped.
    pub scale: Scale,
}

/// Measurements of one method.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Number of the name in [`Chart::names`] that gives colour and marker.
    pub name: usize,
    /// [x, y].
    pub points: Vec<[f64; 2]>,
    /// Joined by a line.
    pub joined: bool,
    /// Where y lies with the confidence that the axis names, for each point; empty where nothing is said.
    pub intervals: Vec<[f64; 2]>,
}

/// One panel.
#[derive(Clone, Debug, PartialEq)]
pub struct ChartPanel {
    /// Above the panel.
    pub title: String,
    /// Horizontal.
    pub x: ChartAxis,
    /// Vertical.
    pub y: ChartAxis,
    /// What is drawn.
    pub series: Vec<Series>,
}

/// Panels side by side with one legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Title of the document; not drawn.
    pub title: String,
    /// Names of the methods, in the order of the legend.
    pub names: Vec<String>,
    /// From left to right.
    pub panels: Vec<ChartPanel>,
}

/// The widest panel, and the widest page: so wide 11 pixels are 6 pt in print.
const WIDTH: f64 = 330.0;
const PAGE: f64 = 924.0;
const HEIGHT: f64 = 300.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 34.0;
const BELOW: f64 = 52.0;
const LEGEND_ROW: f64 = 20.0;
const SIZE: f64 = 11.0;
const MARK: f64 = 3.6;
const GRID: RGBColor = rgb(0xe4_e4_e4);

/// Apart in print and for colour-blind readers; the marker tells, too.
const COLORS: [RGBColor; 8] =
    rgbs([0x12_50_a8, 0xc2_14_2d, 0x00_8a_5e, 0xe6_76_00, 0x8e_3b_9e, 0x7a_4a_21, 0x1f_a3_c4, 0x6b_6b_6b]);

/// Draws a chart. Equal arguments give equal bytes.
///
/// # Errors
/// A failure of the drawing library.
pub fn draw_chart(chart: &Chart, theme: Theme) -> Result<Picture, PlotError> {
    let panels = chart.panels.len().max(1) as f64;
    let plot = (PAGE / panels - LEFT - RIGHT).min(WIDTH);
    let pitch = LEFT + plot + RIGHT;
    // What stands above the last panel is not cut.
    let above = chart
        .panels
        .last()
        .map_or(0.0, |panel| text_width(&panel.title, SIZE + 1.0).max(text_width(&panel.y.label, SIZE)) + LEFT + 4.0);
    let width = (panels * pitch).max((panels - 1.0) * pitch + above).ceil();
    let entries = chart.names.iter().map(|name| [text_width(name, SIZE) + 44.0, LEGEND_ROW]);
    let entries = Rows::new(entries, 0.0, width - LEFT - RIGHT);
    let legend = TOP + HEIGHT + BELOW;
    render([width, legend + entries.height + 10.0], chart.title.as_str(), theme, |canvas| {
        for (number, panel) in chart.panels.iter().enumerate() {
            let frame = Rect { x: number as f64 * pitch + LEFT, y: TOP, width: plot, height: HEIGHT };
            draw_panel(canvas, panel, &frame);
        }
        for (name, (text, corner)) in chart.names.iter().zip(entries.corners).enumerate() {
            let [x, y] = [LEFT + corner[0], legend + corner[1] + 0.5 * LEGEND_ROW];
            let mut own = chart.panels.iter().flat_map(|panel| &panel.series).filter(|series| series.name == name);
            if own.any(|series| series.joined) {
                canvas.path(&[[x, y], [x + 22.0, y]], Ink { color: color(name), width: 1.4 });
            }
            mark(canvas, name, [x + 11.0, y]);
            canvas.text(text, [x + 28.0, y + 4.0], SIZE, INK, Anchor::Start);
        }
    })
}

fn color(name: usize) -> RGBColor {
    COLORS[name % COLORS.len()]
}

/// A marker whose shape tells the method.
fn mark(canvas: &Canvas, name: usize, at: Point) {
    let place = |dx: f64, dy: f64| [at[0] + dx * MARK, at[1] + dy * MARK];
    let color = color(name);
    match name % 6 {
        0 => canvas.disc(at, MARK, color),
        1 => canvas.polygon(&Rect::around(at, 0.9 * MARK).corners(), color),
        2 => canvas.polygon(&[place(0.0, -1.2), place(1.1, 0.8), place(-1.1, 0.8)], color),
        3 => canvas.polygon(&[place(0.0, -1.3), place(1.3, 0.0), place(0.0, 1.3), place(-1.3, 0.0)], color),
        4 => canvas.polygon(&[place(0.0, 1.2), place(1.1, -0.8), place(-1.1, -0.8)], color),
        _ => canvas.ring(at, MARK, Ink { color, width: 1.4 }),
    }
}

/// An axis with its range: exponents of ten, or per cent.
struct Range {
    scale: Scale,
    from: f64,
    to: f64,
}

impl Range {
    fn new(scale: Scale, values: impl Iterator<Item = f64>) -> Self {
        if scale == Scale::Percent {
            return Self { scale, from: -3.0, to: 103.0 };
        }
        let usable = values.filter(|v| *v > 0.0 && v.is_finite()).map(libm::log10);
        let (low, high) = usable.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        if low > high {
            return Self { scale, from: 0.0, to: 1.0 };
        }
        Self { scale, from: (low - 0.15).floor(), to: (high + 0.15).ceil() }
    }

    /// 0 to 1, or `None` off the axis.
    fn share(&self, value: f64) -> Option<f64> {
        let at = match self.scale {
            Scale::Percent => value,
            _ if value > 0.0 && value.is_finite() => libm::log10(value),
            _ => return None,
        };
        let share = (at - self.from) / (self.to - self.from);
        Some(if self.scale == Scale::Descending { 1.0 - share } else { share })
    }

    /// Values with labels.
    fn ticks(&self, most: f64) -> Vec<(f64, String)> {
        if self.scale == Scale::Percent {
            return (0..=5).map(|k| (f64::from(20 * k), (20 * k).to_string())).collect();
        }
        #[expect(clippy::cast_possible_truncation, reason = "exponents of doubles")]
        let (from, to) = (self.from as i32, self.to as i32);
        let step = (1..=50).find(|step| f64::from((to - from) / step) <= most).unwrap_or(50);
        (from..=to)
            .filter(|exponent| exponent.rem_euclid(step) == 0)
            .map(|exponent| (libm::exp10(f64::from(exponent)), format!("10{}", superscript(exponent))))
            .collect()
    }
}

fn draw_panel(canvas: &Canvas, panel: &ChartPanel, frame: &Rect) {
    let all = |k: usize| panel.series.iter().flat_map(move |series| series.points.iter().map(move |p| p[k]));
    let (x, y) = (Range::new(panel.x.scale, all(0)), Range::new(panel.y.scale, all(1)));
    let (left, right, bottom) = (frame.x, frame.right(), frame.bottom());
    let place = |p: [f64; 2]| Some([left + frame.width * x.share(p[0])?, bottom - HEIGHT * y.share(p[1])?]);
    let grid = Ink { color: GRID, width: 0.8 };
    for (value, label) in x.ticks(frame.width / 40.0) {
        let at = left + frame.width * x.share(value).unwrap_or(0.0);
        canvas.path(&[[at, TOP], [at, bottom]], grid);
        canvas.text(&label, [at, bottom + 16.0], SIZE, INK, Anchor::Middle);
    }
    for (value, label) in y.ticks(9.0) {
        let at = bottom - HEIGHT * y.share(value).unwrap_or(0.0);
        canvas.path(&[[left, at], [right, at]], grid);
        canvas.text(&label, [left - 6.0, at + 4.0], SIZE, INK, Anchor::End);
    }
    canvas.outline(&frame.corners(), Ink { color: INK, width: 0.9 });
    for series in &panel.series {
        let points: Vec<Point> = series.points.iter().filter_map(|p| place(*p)).collect();
        if series.joined {
            canvas.path(&points, Ink { color: color(series.name), width: 1.4 });
        }
        for (at, [from, to]) in series.points.iter().zip(&series.intervals) {
            if let (Some(low), Some(high)) = (place([at[0], *from]), place([at[0], *to])) {
                canvas.path(&[low, high], Ink { color: color(series.name), width: 1.0 });
            }
        }
        for point in points {
            mark(canvas, series.name, point);
        }
    }
    canvas.text(&panel.x.label, [left + frame.width / 2.0, bottom + 36.0], SIZE, INK, Anchor::Middle);
    canvas.text(&panel.title, [left, TOP - 20.0], SIZE + 1.0, INK, Anchor::Start);
    canvas.text(&panel.y.label, [left, TOP - 6.0], SIZE, FAINT_INK, Anchor::Start);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decades_are_equally_long_and_zero_is_off_the_axis() {
        let range = Range::new(Scale::Logarithmic, [1e-3, 1e3].into_iter());
        let at = |x: f64| range.share(x).unwrap();
        assert!((at(1e-2) - at(1e-3) - (at(1e2) - at(1e1))).abs() < 1e-12);
        assert_eq!(range.share(0.0), None);
        assert!(range.ticks(20.0).iter().any(|(_, label)| label == "10⁻³"));
    }
}
