//! Directions, arcs and arrow heads.

use bifdiag_plot::page::{Canvas, Ink, Point};

/// The direction at `degrees` from the x-axis, counterclockwise on the page.
pub(super) fn direction(degrees: f64) -> Point {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [cos, -sin]
}

/// The point at `distance` from `center` in the direction of `degrees`.
pub(super) fn polar(center: Point, distance: f64, degrees: f64) -> Point {
    let [x, y] = direction(degrees);
    [center[0] + distance * x, center[1] + distance * y]
}

/// An arc of a circle.
pub(super) fn arc(center: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    const PARTS: u32 = 96;
    (0..=PARTS).map(|k| polar(center, radius, from + (to - from) * f64::from(k) / f64::from(PARTS))).collect()
}

/// An arrow head at `tip` that comes along `along`.
pub(super) fn arrow_head(canvas: &Canvas, tip: Point, along: Point, ink: Ink) {
    const SIZE: f64 = 8.0;
    let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
    let [x, y] = along.map(|c| c / length * SIZE);
    let side = |s: f64| [tip[0] - x - s * 0.4 * y, tip[1] - y + s * 0.4 * x];
    canvas.polygon(&[tip, side(1.0), side(-1.0)], ink.color);
}
