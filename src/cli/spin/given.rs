//! Rates of rotation as they are given.

use bifdiag_body::Number;
use bifdiag_body::part::{Spin, SpinUnit};
use bifdiag_documents::Subject;

use crate::cli::terminal::significant;

/// Significant digits of a rate of rotation.
pub const SPIN_DIGITS: usize = 8;

/// What to add to a rate that is printed in rpm and in rad/s: how it was given, where that does not tell it.
pub fn as_given(spin: &Spin, [rpm, rad_per_s]: [&str; 2]) -> String {
    let (printed, given) = match spin.unit() {
        SpinUnit::RadPerSecond => (rad_per_s, spin.exact_rad_per_s()),
        SpinUnit::Rpm | SpinUnit::Hertz | SpinUnit::DegPerSecond => (rpm, spin.exact_rpm()),
    };
    if printed.parse().is_ok_and(|printed: Number| *printed.value() == given) {
        String::new()
    } else {
        format!(", given as {spin}")
    }
}

/// A rate per unit of time of a body in rad/s, or the nearest one that can be given.
pub fn that_can_be_given(subject: &Subject, omega: f64) -> String {
    significant((omega * subject.second()).clamp(Number::SMALLEST, Number::LARGEST), 6)
}
