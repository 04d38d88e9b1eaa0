//! One point (h, l), decided exactly: signs against every height over l, and the topology between them.

use bifdiag_body::{Body, Frame, Number};
use bifdiag_diagram::classify::{Classification, Margin, at_rest};
use dashu_ratio::RBig;

use super::heights::{Heights, Level};
use super::model::{Model, exact};
use super::plane::{Gap, Open, Plane};
use super::vertex::{self, Vertex};
use bifdiag_numbers::Sign;

/// A point of the plane in the frame's units.
pub(crate) struct Point {
    /// l²/2.
    pub x: RBig,
    pub h: RBig,
}

impl Point {
    /// (h, l) in the body's units.
    pub fn scaled(frame: &Frame, h: &Number, l: &Number) -> Self {
        let momentum = l.value() / exact(frame.momentum_unit);
        Self { x: &momentum * &momentum / RBig::from(2), h: h.value() / exact(frame.energy_unit) }
    }
}

/// The type of one point, decided: regular, forbidden, or proved to lie on a curve.
///
/// # Errors
/// [`Open`]: what could not be decided within the largest precision.
pub fn classify_exactly(body: &Body, h: &Number, l: &Number) -> Result<Classification, Open> {
    if l.value().is_zero() {
        return Ok(at_rest(body, h));
    }
    let frame = body.frame();
    let model = Model::new(body, &frame);
    let Point { x, h: energy } = Point::scaled(&frame, h, l);
    let plane = Plane::new(&model, &frame);
    let mut heights = Heights::new(&model, x.clone());
    let levels = heights.against(&energy).map_err(|none| plane.open(none, &x))?;
    let margin = margin(&plane, heights.nearest(&levels, &energy), &x);
    if levels.iter().any(|level| level.sign == Sign::Zero) {
        let vertex = Vertex { plane: &plane, heights: &heights, h: &energy, levels: &levels };
        return Ok(Classification::open(true, vertex::candidates(&vertex)?, margin));
    }
    Ok(Classification::decided(plane.class(&x, &Gap::around(&levels))?, margin))
}

/// The distance to the nearest curve.
fn margin(plane: &Plane<'_>, nearest: Option<Level>, x: &RBig) -> Margin {
    let unit = plane.frame.energy_unit;
    let Some(level) = nearest else { return Margin { h: 0.0, nearest: None, error_bound: 0.0 } };
    let [lo, hi] = level.distance;
    Margin { h: lo * unit, nearest: Some(plane.name(&level.source, x)), error_bound: (hi - lo) * unit }
}
