//! Tints and lines, for the picture and its legend.

use plotters::style::RGBColor;

use crate::page::{INK, Ink, rgb, rgbs};

/// Ground where U > h.
pub(super) const FORBIDDEN: RGBColor = rgb(0xd9_d9_d9);
/// Tints of components, apart from each other and from that for every reader.
const TINTS: [RGBColor; 5] = rgbs([0xc7_e5_ff, 0xff_e8_85, 0x9e_ba_9e, 0xee_b7_87, 0xd8_b2_f7]);
/// ∂U.
pub(super) const BOUNDARY: Ink = Ink { color: INK, width: 1.8 };
/// Other levels.
pub(super) const LEVEL: Ink = Ink { color: rgb(0x8c_8c_8c), width: 0.6 };
/// The tint of the component at a place of the canonical order.
pub(super) fn tint(place: usize) -> RGBColor {
    TINTS[place % TINTS.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Theme;
    use crate::page::sight::assert_apart;

    #[test]
    fn components_are_told_apart_by_every_reader() {
        for theme in [Theme::Light, Theme::Dark] {
            let shown: Vec<RGBColor> = TINTS.into_iter().chain([FORBIDDEN]).map(|color| theme.ground(color)).collect();
            // A clear difference of patches.
            assert_apart(&shown, 10.0);
        }
    }
}
