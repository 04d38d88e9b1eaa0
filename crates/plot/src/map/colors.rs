//! Colours for many entries, apart in print and for colour-blind readers as far as that is possible.

use plotters::style::RGBColor;

/// Where nothing is known.
pub(super) const UNKNOWN: RGBColor = RGBColor(0x9a, 0x9a, 0x9a);

/// The first ones, chosen by hand: light enough for black text, neighbours apart in lightness too.
const CHOSEN: [RGBColor; 14] = [
    RGBColor(0xa6, 0xc8, 0xea),
    RGBColor(0xf7, 0xc5, 0x8b),
    RGBColor(0xb5, 0xdd, 0xa4),
    RGBColor(0xf2, 0xa7, 0xa0),
    RGBColor(0xcf, 0xbc, 0xe6),
    RGBColor(0xfb, 0xec, 0xa0),
    RGBColor(0x8f, 0xd2, 0xcb),
    RGBColor(0xe3, 0xc9, 0xb0),
    RGBColor(0xf3, 0xbf, 0xdd),
    RGBColor(0xd9, 0xe6, 0x7f),
    RGBColor(0x7f, 0xa8, 0xd1),
    RGBColor(0xd9, 0x93, 0x5a),
    RGBColor(0x7d, 0xb3, 0x6b),
    RGBColor(0xc9, 0x7f, 0x91),
];

/// The colour of an entry. Beyond the chosen ones hues follow the golden section.
pub(super) fn color(entry: usize) -> RGBColor {
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
