//! Numbers that can be written down.

/// Significant digits of the numbers of a body and of a point.
pub(crate) const DIGITS: usize = 6;

/// The nearest number with a few significant digits.
pub(crate) fn rounded(x: f64, digits: usize) -> f64 {
    format!("{x:.*e}", digits.saturating_sub(1)).parse().unwrap_or(x)
}
