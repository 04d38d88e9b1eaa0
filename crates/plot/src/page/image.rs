//! PNG files.

use super::error::PlotError;

/// An image of `samples`, row by row: three bytes a pixel, or with `palette` (its colours, three bytes each, of which
/// the first is transparent) one.
pub(crate) fn png([width, height]: [u32; 2], palette: Option<Vec<u8>>, samples: &[u8]) -> Result<Vec<u8>, PlotError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    if let Some(palette) = palette {
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_filter(png::Filter::NoFilter);
        encoder.set_palette(palette);
        encoder.set_trns(vec![0]);
    } else {
        encoder.set_color(png::ColorType::Rgb);
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(samples)?;
    writer.finish()?;
    Ok(bytes)
}
