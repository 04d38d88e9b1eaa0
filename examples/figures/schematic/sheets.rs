//! The section as a circle, its projection onto two copies of the Poisson sphere as bars.
//!
//! The flow runs in parallel lines, up and to the left; it touches the circle at 35° and 215°, enters below right of
//! the line between the two and leaves above left of it.

use plotters::style::RGBColor;

use super::shapes::{arc, arrow_head, direction, polar};
use bifdiag_plot::page::{
    Anchor, Canvas, FAINT_INK, INK, Ink, Picture, PlotError, Point, Rect, Theme, render, rgb, text_width,
};

const RADIUS: f64 = 84.0;
/// Where the flow touches the circle, in degrees.
const TANGENCIES: [f64; 2] = [35.0, 215.0];
/// Direction of the flow.
const FLOW: f64 = 125.0;
/// x of the two bars, from the circle's centre.
const BARS: [f64; 2] = [152.0, 206.0];
const INCOMING: RGBColor = rgb(0x12_50_a8);
const OUTGOING: RGBColor = rgb(0xe0_8a_00);
const TEXT: f64 = 12.0;
const FLOW_INK: Ink = Ink { color: FAINT_INK, width: 1.1 };
/// A projection line.
const GUIDE: Ink = Ink { color: rgb(0xb0_b0_b0), width: 0.7 };

/// Fig. schema12: sheets by the sign of Ṡ and by the sign of Δ.
pub(super) fn both_divisions(theme: Theme) -> Result<Picture, PlotError> {
    let centers = [[138.0, 172.0], [468.0, 172.0]];
    render([720.0, 330.0], "The section and its projections", theme, |canvas| {
        for (center, by_delta) in centers.into_iter().zip([false, true]) {
            for at in if by_delta { [90.0, -90.0] } else { TANGENCIES } {
                guide(canvas, center, at, BARS[1]);
            }
            for offset in [-RADIUS, -0.42 * RADIUS, 0.38 * RADIUS, RADIUS] {
                flow_line(canvas, center, offset);
            }
            circle(canvas, center);
            for tangency in TANGENCIES {
                canvas.disc(polar(center, RADIUS, tangency), 5.0, INK);
            }
            if by_delta {
                squares(canvas, center);
                divided_by_delta(canvas, center);
            } else {
                divided_by_rate(canvas, center);
            }
            let heading = if by_delta { "sheets by the sign of Δ: 1:1" } else { "sheets by the sign of Ṡ: not 1:1" };
            canvas.text(heading, [center[0] + 40.0, 30.0], TEXT + 1.0, INK, Anchor::Middle);
        }
        legend(canvas, [60.0, 312.0]);
        explain(canvas, [380.0, 312.0], "tangency, Ṡ = 0", "flow");
    })
}

/// Fig. schema3: orbits near tangency meet one sheet only.
pub(super) fn near_tangency(theme: Theme) -> Result<Picture, PlotError> {
    let center = [138.0, 128.0];
    render([400.0, 292.0], "Orbits near tangency meet one sheet only", theme, |canvas| {
        // Through the circle at 35° ± 22° and 215° ± 22°.
        let reach = RADIUS * libm::cos(22.0_f64.to_radians());
        let crossings = [(13.0, 1), (57.0, 1), (193.0, 0), (237.0, 0)];
        for (at, bar) in crossings {
            guide(canvas, center, at, BARS[bar]);
        }
        for offset in [-reach, reach] {
            flow_line(canvas, center, offset);
        }
        circle(canvas, center);
        squares(canvas, center);
        divided_by_delta(canvas, center);
        for (at, bar) in crossings {
            let point = polar(center, RADIUS, at);
            canvas.disc(point, 4.0, INK);
            canvas.disc([center[0] + BARS[bar], point[1]], 4.0, INK);
        }
        legend(canvas, [28.0, 256.0]);
        explain(canvas, [28.0, 278.0], "crossing", "orbit");
    })
}

/// The circle, coloured by the direction in which the flow crosses it.
fn circle(canvas: &Canvas, center: Point) {
    let [first, second] = TANGENCIES;
    canvas.path(&arc(center, RADIUS, first, second), Ink { color: OUTGOING, width: 3.0 });
    canvas.path(&arc(center, RADIUS, second, first + 360.0), Ink { color: INCOMING, width: 3.0 });
    canvas.text("P", [center[0] - 22.0, center[1] + 4.0], TEXT + 1.0, INK, Anchor::Middle);
}

/// A trajectory at a signed distance from the centre, on the side of the first tangency if positive.
fn flow_line(canvas: &Canvas, center: Point, offset: f64) {
    let foot = polar(center, offset, TANGENCIES[0]);
    let reach = 0.5 * RADIUS + (RADIUS * RADIUS - offset * offset).max(0.0).sqrt();
    let (tail, tip) = (polar(foot, -reach, FLOW), polar(foot, reach, FLOW));
    canvas.path(&[tail, tip], FLOW_INK);
    arrow_head(canvas, tip, direction(FLOW), FLOW_INK);
}

/// Where the sheets by Δ meet.
fn squares(canvas: &Canvas, center: Point) {
    for at in [90.0, -90.0] {
        canvas.polygon(&Rect::around(polar(center, RADIUS, at), 5.0).corners(), INK);
    }
}

fn guide(canvas: &Canvas, center: Point, at: f64, bar: f64) {
    let from = polar(center, RADIUS, at);
    canvas.path(&[from, [center[0] + bar, from[1]]], GUIDE);
}

/// A part of a bar between the heights of two points of the circle.
fn bar(canvas: &Canvas, center: Point, x: f64, [from, to]: [f64; 2], color: RGBColor) {
    let y = |at: f64| polar(center, RADIUS, at)[1];
    canvas.path(&[[center[0] + x, y(from)], [center[0] + x, y(to)]], Ink { color, width: 4.0 });
}

fn names(canvas: &Canvas, center: Point) {
    for (x, name) in BARS.into_iter().zip(["S⁻", "S⁺"]) {
        canvas.text(name, [center[0] + x, center[1] + RADIUS + 24.0], TEXT + 1.0, INK, Anchor::Middle);
    }
}

/// Bars by the sign of Ṡ: two strands where two points of the circle have the same image.
fn divided_by_rate(canvas: &Canvas, center: Point) {
    let [upper, lower] = TANGENCIES;
    for (x, color, once, twice) in
        [(BARS[0], INCOMING, [lower, upper], [-90.0, lower]), (BARS[1], OUTGOING, [lower, upper], [upper, 90.0])]
    {
        bar(canvas, center, x, once, color);
        for aside in [-4.0, 4.0] {
            bar(canvas, center, x + aside, twice, color);
        }
    }
    names(canvas, center);
}

/// Bars by the sign of Δ: the left and the right half of the circle.
fn divided_by_delta(canvas: &Canvas, center: Point) {
    let [upper, lower] = TANGENCIES;
    bar(canvas, center, BARS[0], [90.0, lower], OUTGOING);
    bar(canvas, center, BARS[0], [lower, -90.0], INCOMING);
    bar(canvas, center, BARS[1], [90.0, upper], OUTGOING);
    bar(canvas, center, BARS[1], [upper, -90.0], INCOMING);
    names(canvas, center);
}

fn legend(canvas: &Canvas, [x, y]: Point) {
    for (x, color, text) in [(x, INCOMING, "incoming, Ṡ < 0"), (x + 160.0, OUTGOING, "outgoing, Ṡ > 0")] {
        canvas.path(&[[x, y - 4.0], [x + 26.0, y - 4.0]], Ink { color, width: 3.0 });
        canvas.text(text, [x + 34.0, y], TEXT, INK, Anchor::Start);
    }
}

/// What dots, squares and arrows are.
fn explain(canvas: &Canvas, [x, y]: Point, dot: &str, arrow: &str) {
    let middle = y - 4.0;
    canvas.disc([x + 5.0, middle], 4.0, INK);
    canvas.text(dot, [x + 16.0, y], TEXT, INK, Anchor::Start);
    let x = x + 40.0 + text_width(dot, TEXT);
    canvas.polygon(&Rect::around([x, middle], 5.0).corners(), INK);
    canvas.text("Δ = 0", [x + 12.0, y], TEXT, INK, Anchor::Start);
    let x = x + 72.0;
    canvas.path(&[[x, middle], [x + 26.0, middle]], FLOW_INK);
    arrow_head(canvas, [x + 26.0, middle], direction(0.0), FLOW_INK);
    canvas.text(arrow, [x + 34.0, y], TEXT, INK, Anchor::Start);
}
