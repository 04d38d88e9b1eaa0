//! Schematic pictures of what a section is: nothing in them is computed from a body.

mod cylinder;
mod sheets;

use super::canvas::{Canvas, Ink, Point};
use super::{Picture, PlotError};

/// A schematic picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Sheets by the sign of Ṡ overlap in projection; sheets by the sign of Δ do not.
    Sheets,
    /// Orbits near a point of tangency meet one sheet only.
    BothSheetsNeeded,
    /// The sphere without its poles is a cylinder with two polar circles.
    Cylinder,
}

/// Draws a scheme. Equal arguments give equal bytes.
///
/// # Errors
/// A failure of the drawing library.
pub fn draw_scheme(scheme: Scheme) -> Result<Picture, PlotError> {
    match scheme {
        Scheme::Sheets => sheets::both_divisions(),
        Scheme::BothSheetsNeeded => sheets::near_tangency(),
        Scheme::Cylinder => cylinder::draw(),
    }
}

/// The direction at `degrees` from the x-axis, counterclockwise on the page.
fn direction(degrees: f64) -> Point {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [cos, -sin]
}

/// The point at `distance` from `center` in the direction of `degrees`.
fn polar(center: Point, distance: f64, degrees: f64) -> Point {
    let [x, y] = direction(degrees);
    [center[0] + distance * x, center[1] + distance * y]
}

/// An arc of a circle.
fn arc(center: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    const PARTS: u32 = 96;
    (0..=PARTS).map(|k| polar(center, radius, from + (to - from) * f64::from(k) / f64::from(PARTS))).collect()
}

/// An arrow head at `tip` that comes along `along`.
fn arrow_head(canvas: &Canvas<'_>, tip: Point, along: Point, ink: Ink) -> Result<(), PlotError> {
    const SIZE: f64 = 8.0;
    let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
    let [x, y] = along.map(|c| c / length * SIZE);
    let side = |s: f64| [tip[0] - x - s * 0.4 * y, tip[1] - y + s * 0.4 * x];
    canvas.polygon(&[tip, side(1.0), side(-1.0)], ink.color)
}
