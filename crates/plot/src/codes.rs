//! A grid of points as an image, a pixel for each.

use crate::diagram::tint;
use crate::page::{FAINT_INK, INK, PAPER, PlotError, png};

/// The image of a grid: rows of `width` codes from below, each the number of a region (whose sections are `kinds`), or
/// negative: forbidden (transparent), critical (black), undecided (grey). Equal arguments give equal bytes.
///
/// # Errors
/// [`PlotError`] when the image cannot be written.
pub fn draw_codes(width: usize, codes: &[i32], kinds: &[String]) -> Result<Vec<u8>, PlotError> {
    /// Colours that are no regions.
    const OTHERS: usize = 3;
    let regions = kinds.iter().take(usize::from(u8::MAX) + 1 - OTHERS).map(|kind| tint(kind));
    let colors: Vec<u8> =
        [PAPER, INK, FAINT_INK].into_iter().chain(regions).flat_map(|color| [color.0, color.1, color.2]).collect();
    let index = |code: i32| match code {
        -1 => 0,
        -2 => 1,
        // More regions than a palette holds share its last colour.
        code => usize::try_from(code).map_or(2_u8, |region| u8::try_from(OTHERS + region).unwrap_or(u8::MAX)),
    };
    let pixels: Vec<u8> = codes.chunks(width.max(1)).rev().flatten().map(|&code| index(code)).collect();
    let size = [width, codes.len() / width.max(1)].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    png(size, Some(colors), &pixels)
}
