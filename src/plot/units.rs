//! Lengths on the page: in pixels where they are computed, in canvas units where they are written.

/// Canvas units in a pixel.
pub(super) const UNITS: f64 = 10.0;

/// A position [x, y] in pixels, y downwards.
pub(super) type Point = [f64; 2];

/// Canvas units of a pixel coordinate.
pub(super) fn to_units(pixels: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "clamped; a NaN becomes 0")]
    let units = (pixels * UNITS).round().clamp(-1e6, 1e6) as i32;
    units
}

/// Canvas units of a length in pixels.
pub(super) fn length_units(pixels: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of i32")]
    let units = (pixels * UNITS).round().clamp(0.0, f64::from(i32::MAX)) as u32;
    units
}
