//! Directions in the frame of the question: the part's, or principal axes.

use bifdiag_numbers::vector::dot;
use bifdiag_schema::PartDocument;
use dashu_ratio::RBig;

use crate::cli::input::values::{self, Triple, ValueError};

/// x, y, z or three coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisArgument {
    /// Of length 1.
    pub direction: [f64; 3],
    /// As it was given.
    pub given: Triple,
}

/// Reads a direction; its length does not matter.
pub fn axis(text: &str) -> Result<AxisArgument, ValueError> {
    let given = values::triple(match text.strip_prefix('+').unwrap_or(text) {
        "x" => "1,0,0",
        "y" => "0,1,0",
        "z" => "0,0,1",
        "-x" => "-1,0,0",
        "-y" => "0,-1,0",
        "-z" => "0,0,-1",
        _ => text,
    })?;
    Ok(AxisArgument { direction: given.rounded().direction()?.0, given })
}

/// A vector of the question's frame in principal axes.
pub fn to_principal(part: Option<&PartDocument>, v: [f64; 3]) -> [f64; 3] {
    match part {
        Some(part) => part.principal.axes.map(|axis| dot(axis, v)),
        None => v,
    }
}

/// The same of exact numbers, which stay exact without a part.
pub fn to_principal_exactly(part: Option<&PartDocument>, v: &Triple) -> [RBig; 3] {
    if part.is_none() {
        return v.values();
    }
    to_principal(part, v.rounded().0).map(|x| RBig::try_from(x).unwrap_or_default())
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
    1.0 / unit_of_time(part).to_f64().value()
}

/// The body's unit of time in seconds, exactly.
pub fn unit_of_time(part: Option<&PartDocument>) -> RBig {
    let units = part.and_then(|part| part.units.parse::<bifdiag_body::part::Units>().ok());
    units.map_or(RBig::ONE, |units| units.time().clone())
}
