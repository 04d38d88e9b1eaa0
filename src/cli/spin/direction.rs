//! Directions in the frame of the question: the part's, or principal axes.

use numbers::vector::dot;
use schema::PartDocument;

use crate::cli::input::values::{self, ValueError};

/// x, y, z or three coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisArgument(pub [f64; 3]);

/// Reads a direction; its length does not matter.
pub fn axis(text: &str) -> Result<AxisArgument, ValueError> {
    let (sign, name) =
        text.strip_prefix('-').map_or((1.0, text.strip_prefix('+').unwrap_or(text)), |rest| (-1.0, rest));
    let named = match name {
        "x" => Some([sign, 0.0, 0.0]),
        "y" => Some([0.0, sign, 0.0]),
        "z" => Some([0.0, 0.0, sign]),
        _ => None,
    };
    match named {
        Some(direction) => Ok(AxisArgument(direction)),
        None => values::direction(text).map(|direction| AxisArgument(direction.0)),
    }
}

/// A vector of the question's frame in principal axes.
pub fn to_principal(part: Option<&PartDocument>, v: [f64; 3]) -> [f64; 3] {
    match part {
        Some(part) => part.principal.axes.map(|axis| dot(axis, v)),
        None => v,
    }
}

/// A vector in principal axes in the question's frame.
pub fn from_principal(part: Option<&PartDocument>, v: [f64; 3]) -> [f64; 3] {
    match part {
        Some(part) => std::array::from_fn(|i| (0..3).map(|k| part.principal.axes[k][i] * v[k]).sum()),
        None => v,
    }
}

/// One second in the body's unit of time.
pub fn second(part: Option<&PartDocument>) -> f64 {
    let units = part.and_then(|part| part.units.parse::<::part::Units>().ok());
    units.map_or(1.0, |units| 1.0 / units.time().to_f64().value())
}
