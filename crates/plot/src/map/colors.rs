//! Colours for many entries, apart in print and for colour-blind readers as far as that is possible.

use crate::page::{rgb, rgbs};
use plotters::style::RGBColor;

/// Where nothing is known.
const UNKNOWN: RGBColor = rgb(0x9a_9a_9a);

/// The first ones, chosen by hand: light enough for black text, neighbours apart in lightness too.
const CHOSEN: [RGBColor; 14] = rgbs([
    0xa6_c8_ea, 0xf7_c5_8b, 0xb5_dd_a4, 0xf2_a7_a0, 0xcf_bc_e6, 0xfb_ec_a0, 0x8f_d2_cb, 0xe3_c9_b0, 0xf3_bf_dd,
    0xd9_e6_7f, 0x7f_a8_d1, 0xd9_93_5a, 0x7d_b3_6b, 0xc9_7f_91,
]);

/// The colour of a body that shows an entry, or nothing that is known.
pub(super) fn fill(entry: Option<usize>) -> RGBColor {
    entry.map_or(UNKNOWN, color)
}

/// The colour of an entry. Beyond the chosen ones hues follow the golden section.
fn color(entry: usize) -> RGBColor {
    if let Some(color) = CHOSEN.get(entry) {
        return *color;
    }
    let step = entry - CHOSEN.len();
    let hue = (0.11 + 0.618_033_988_75 * step as f64).fract();
    let (low, high) = [(150.0, 240.0), (120.0, 205.0), (175.0, 250.0)][step % 3];
    let channel = |shift: f64| {
        let place = (hue + shift).fract() * 6.0;
        let share = (place - 3.0).abs() - 1.0;
        let value = low + (high - low) * share.clamp(0.0, 1.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let value = value as u8;
        value
    };
    RGBColor(channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0))
}
