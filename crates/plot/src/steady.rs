//! Steady axes over the spin: the angle of each from the centre of mass, coloured by stability.

use plotters::style::RGBColor;

use bifdiag_page::{
    Anchor, Chart, Dash, INK, Legend, Picture, PlotError, Point, Rect, Symbol, TICK_SIZE, Theme, render, rgb,
};

/// What is known of the stability along a piece of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steadiness {
    /// Stable, with friction that conserves l too.
    Lasting,
    /// Stable, but not with such friction.
    Frictionless,
    /// No eigenvalue grows, and stability itself is not decided.
    Open,
    /// Unstable.
    Unstable,
}

/// One family of steady axes.
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyCurve {
    /// The branch.
    pub name: String,
    /// Pieces by rising spin, each with its points: rpm and angle in degrees.
    pub runs: Vec<(Steadiness, Vec<[f64; 2]>)>,
}

/// All steady axes over a range of spins.
#[derive(Clone, Debug, PartialEq)]
pub struct SteadyScene {
    /// The range in rpm.
    pub range: [f64; 2],
    /// The families.
    pub curves: Vec<SteadyCurve>,
}

const RECT: Rect = Rect { x: 74.0, y: 48.0, width: 500.0, height: 360.0 };
const SIZE: [f64; 2] = [650.0, 520.0];
/// Between the names of curves that end side by side.
const ROW: f64 = 13.0;

impl Steadiness {
    pub(crate) const ALL: [Self; 4] = [Self::Lasting, Self::Frictionless, Self::Open, Self::Unstable];

    fn color(self) -> RGBColor {
        match self {
            Self::Lasting | Self::Frictionless => rgb(0x12_50_a8),
            Self::Open => rgb(0x0e_7c_5a),
            Self::Unstable => rgb(0xc2_14_2d),
        }
    }

    fn pattern(self) -> Vec<Dash> {
        let color = Some(self.color());
        match self {
            Self::Lasting | Self::Frictionless => vec![(color, 1.0)],
            Self::Open => vec![(color, 9.0), (None, 3.0), (color, 2.0), (None, 3.0)],
            Self::Unstable => vec![(color, 6.0), (None, 4.0)],
        }
    }

    fn width(self) -> f64 {
        match self {
            Self::Lasting => 2.2,
            Self::Frictionless => 1.0,
            Self::Open | Self::Unstable => 2.0,
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Self::Lasting => "stable, with friction too",
            Self::Frictionless => "stable without friction, single spins aside",
            Self::Open => "no eigenvalue grows, stability itself not shown",
            Self::Unstable => "unstable",
        }
    }
}

impl SteadyCurve {
    /// Whether any of it lies in a range of spins.
    #[must_use]
    pub fn is_within(&self, range: [f64; 2]) -> bool {
        self.runs.iter().any(|(_, points)| is_drawn(points, range))
    }
}

/// Whether a line, and not at most a point, lies in the range.
fn is_drawn(points: &[Point], range: [f64; 2]) -> bool {
    within(points, range).len() > 1
}

/// Draws the angle of every steady axis from the centre of mass over the spin.
///
/// # Errors
/// [`PlotError`].
pub fn draw_steady(scene: &SteadyScene, theme: Theme) -> Result<Picture, PlotError> {
    let upwards = "angle between the upward end of the axis and the centre of mass, in degrees";
    let chart = Chart::new(RECT, ["spin in rpm", upwards], [scene.range, [0.0, 180.0]]).with_room_above(24.0);
    render(SIZE, "Steady axes over the spin", theme, |canvas| {
        chart.draw(canvas);
        let mut ends: Vec<(Point, &str)> = Vec::new();
        for curve in &scene.curves {
            for (kind, points) in &curve.runs {
                chart.line(canvas, &within(points, scene.range), &kind.pattern(), kind.width());
            }
            let last = curve.runs.iter().rev().find_map(|(_, points)| within(points, scene.range).last().copied());
            ends.extend(last.map(|last| (chart.at(last), curve.name.as_str())));
        }
        names(canvas, ends);
        let runs = || scene.curves.iter().flat_map(|curve| &curve.runs);
        let is_drawn = |kind: &Steadiness| runs().any(|(own, points)| own == kind && is_drawn(points, scene.range));
        let entry = |kind: Steadiness| (Symbol::Line(kind.pattern(), kind.width()), kind.meaning().to_owned());
        let legend =
            Legend::new(Steadiness::ALL.into_iter().filter(is_drawn).map(entry).collect(), SIZE[0] - 2.0 * 30.0);
        legend.draw(canvas, [30.0, RECT.bottom() + 58.0]);
    })
}

/// The names of curves behind their ends, one below another where they would meet.
fn names(canvas: &bifdiag_page::Canvas, mut ends: Vec<(Point, &str)>) {
    ends.sort_by(|p, q| p.0[1].total_cmp(&q.0[1]));
    let mut lowest = f64::NEG_INFINITY;
    for ([x, y], name) in ends {
        let y = (y + 4.0).max(lowest + ROW);
        lowest = y;
        canvas.text(name, [x + 5.0, y], TICK_SIZE, INK, Anchor::Start);
    }
}

/// The part of a polyline over a range, cut at its ends.
fn within(points: &[Point], [from, to]: [f64; 2]) -> Vec<Point> {
    let mut inside = Vec::new();
    let mut before: Option<Point> = None;
    for &point in points {
        if let Some(last) = before {
            for end in [from, to] {
                if (last[0] < end) == (end < point[0]) && last[0] != end && point[0] != end {
                    let share = (end - last[0]) / (point[0] - last[0]);
                    inside.push([end, last[1] + share * (point[1] - last[1])]);
                }
            }
        }
        if (from..=to).contains(&point[0]) {
            inside.push(point);
        }
        before = Some(point);
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_cut_at_the_ends_of_the_range() {
        let line = [[0.0, 0.0], [10.0, 100.0], [20.0, 150.0]];
        assert_eq!(within(&line, [5.0, 15.0]), [[5.0, 50.0], [10.0, 100.0], [15.0, 125.0]]);
        assert_eq!(within(&line, [0.0, 20.0]), line);
        assert_eq!(within(&line, [1.0, 2.0]), [[1.0, 10.0], [2.0, 20.0]]);
        assert_eq!(within(&line, [30.0, 40.0]), [[0.0; 2]; 0]);
    }
}
