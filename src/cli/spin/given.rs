//! A rate of rotation as it was given.

use bifdiag_body::Number;
use bifdiag_body::part::{Spin, SpinUnit};

use crate::cli::terminal::significant;

/// Significant digits of a rate of rotation.
pub const SPIN_DIGITS: usize = 8;

/// What to add to a rate that is printed in rpm and in rad/s: how it was given, where that does not tell it.
pub fn as_given(spin: &Spin, [rpm, rad_per_s]: [&str; 2]) -> String {
    let given = spin.number();
    let printed = match spin.unit() {
        SpinUnit::Rpm => rpm.to_owned(),
        SpinUnit::RadPerSecond => rad_per_s.to_owned(),
        SpinUnit::Hertz | SpinUnit::DegPerSecond => significant(given.to_f64(), SPIN_DIGITS),
    };
    if printed.parse().is_ok_and(|printed: Number| printed.value() == given.value()) {
        String::new()
    } else {
        format!(", given as {spin}")
    }
}
