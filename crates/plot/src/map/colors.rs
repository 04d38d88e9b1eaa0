//! Colours for many entries, distinct in print and for colour-blind readers where possible.

use super::model::Map;
use bifdiag_page::{INK, rgb, rgbs};
use plotters::style::RGBColor;

/// What has no colour of its own.
const REST: RGBColor = rgb(0xe9_e9_e9);
/// Where nothing is known.
const UNKNOWN: RGBColor = rgb(0x9a_9a_9a);

/// The first ones: light enough for black text, and apart for every reader in the light theme and the dark one.
const CHOSEN: [RGBColor; 14] = rgbs([
    0xb5_be_fa, 0xeb_c7_6b, 0xb5_d3_a0, 0xf1_99_a1, 0xdb_ca_d9, 0xf7_f4_c7, 0x90_c6_b1, 0xf3_d7_c5, 0xff_bf_f2,
    0xda_f4_71, 0x5a_a3_e2, 0xd4_81_3a, 0x5b_b7_5f, 0xc5_7f_a5,
]);

/// Ends and middle of the scale of an ordered quantity, the lowest first; numbers can be read on all.
const SCALE: [RGBColor; 3] = rgbs([0xf7_f4_c4, 0x9a_d0_b4, 0x6d_9b_d6]);

/// Colours of lines: the text's, then for kinds of events.
const LINES: [RGBColor; 5] = [INK, rgb(0xa3_0d_18), rgb(0x0f_3a_8a), rgb(0x00_80_5c), rgb(0x8a_24_c0)];

/// The colour of a line.
pub(super) fn line(hue: usize) -> RGBColor {
    LINES[hue % LINES.len()]
}

/// The colour of a body that shows an entry of a map, or nothing that is known.
pub(super) fn fill(map: &Map, entry: Option<usize>) -> RGBColor {
    match entry {
        None => UNKNOWN,
        Some(entry) if map.ordered => level(entry, map.entries.len()),
        Some(entry) => map.entries.get(entry).map_or(Some(entry), |entry| entry.color).map_or(REST, color),
    }
}

/// The colour of a place in an order.
fn level(entry: usize, count: usize) -> RGBColor {
    let place = 2.0 * entry as f64 / (count.max(2) - 1) as f64;
    let [from, to] = if place < 1.0 { [SCALE[0], SCALE[1]] } else { [SCALE[1], SCALE[2]] };
    let share = if place < 1.0 { place } else { place - 1.0 };
    let mix = |a: u8, b: u8| {
        let value = f64::from(a) + share * (f64::from(b) - f64::from(a));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two bytes")]
        let byte = value.round() as u8;
        byte
    };
    RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

/// One of the colours. Beyond the chosen ones hues follow the golden section.
fn color(number: usize) -> RGBColor {
    if let Some(color) = CHOSEN.get(number) {
        return *color;
    }
    let step = number - CHOSEN.len();
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

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_page::sight::assert_apart;
    use bifdiag_page::{Theme, contrast};

    #[test]
    fn the_first_colours_are_told_apart_by_every_reader() {
        for theme in [Theme::Light, Theme::Dark] {
            let shown = CHOSEN.map(|color| theme.ground(color));
            // Three times what is just seen, and more.
            assert_apart(&shown, 9.0);
            for color in shown {
                let text = contrast(theme.color(INK), color);
                assert!(text > 4.5, "{text} of a number on {color:?} in {theme:?}");
            }
        }
    }

    #[test]
    fn colours_of_a_quantity_grow_darker() {
        let luminance =
            |color: RGBColor| 0.2126 * f64::from(color.0) + 0.7152 * f64::from(color.1) + 0.0722 * f64::from(color.2);
        for count in [2, 5, 17] {
            for entry in 1..count {
                assert!(luminance(level(entry, count)) < luminance(level(entry - 1, count)), "{entry} of {count}");
                for theme in [Theme::Light, Theme::Dark] {
                    let text = contrast(theme.color(INK), theme.ground(level(entry, count)));
                    assert!(text > 4.5, "{text} of a number on {entry} of {count} in {theme:?}");
                }
            }
        }
    }
}
