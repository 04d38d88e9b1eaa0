//! Tints and lines, for the picture and its legend.

use plotters::style::RGBColor;

use crate::page::{INK, Ink, rgb, rgbs};

/// Ground where U > h.
pub(super) const FORBIDDEN: RGBColor = rgb(0xd9_d9_d9);
/// Tints of components: apart in lightness, too.
const TINTS: [RGBColor; 5] = rgbs([0xbf_dc_f2, 0xfb_ee_b8, 0xa9_cf_b4, 0xf3_c6_b4, 0xd3_c5_e6]);
/// ∂U.
pub(super) const BOUNDARY: Ink = Ink { color: INK, width: 1.8 };
/// Other levels.
pub(super) const LEVEL: Ink = Ink { color: rgb(0x8c_8c_8c), width: 0.6 };
/// The tint of the component at a place of the canonical order.
pub(super) fn tint(place: usize) -> RGBColor {
    TINTS[place % TINTS.len()]
}
