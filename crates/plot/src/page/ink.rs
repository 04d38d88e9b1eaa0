//! Colours that every picture shares, and lines in them.

use plotters::style::RGBColor;

/// Text, frames and axes.
pub const INK: RGBColor = rgb(0x22_22_22);
/// Less important text.
pub const FAINT_INK: RGBColor = rgb(0x59_59_59);
/// The ground of the page and of labels.
pub(crate) const PAPER: RGBColor = rgb(0xff_ff_ff);
/// The two pole lines.
pub const POLE: RGBColor = rgb(0xdc_72_26);

/// Colour and width of a line, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Ink {
    /// On light paper; the theme turns it.
    pub color: RGBColor,
    /// In pixels.
    pub width: f64,
}

/// The colour 0xRRGGBB.
#[must_use]
pub const fn rgb(color: u32) -> RGBColor {
    let [_, red, green, blue] = color.to_be_bytes();
    RGBColor(red, green, blue)
}

/// Colours 0xRRGGBB.
#[must_use]
pub const fn rgbs<const N: usize>(colors: [u32; N]) -> [RGBColor; N] {
    let mut all = [PAPER; N];
    let mut index = 0;
    while index < N {
        all[index] = rgb(colors[index]);
        index += 1;
    }
    all
}
