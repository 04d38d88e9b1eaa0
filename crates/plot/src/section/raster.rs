//! Points as an image with a palette, embedded into the SVG.

use crate::page::{PAPER, PlotError, Point, Rect, png, to_units};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::style::RGBColor;

/// Image pixels in a pixel of the page.
const SCALE: f64 = 3.0;

/// An image over a rectangle of the page: 0 is transparent, k the colour k − 1 of a palette.
pub(super) struct Raster {
    rect: Rect,
    size: [usize; 2],
    pixels: Vec<u8>,
}

impl Raster {
    pub fn new(rect: Rect) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a panel has a few hundred pixels")]
        let size = [rect.width, rect.height].map(|side| (side * SCALE).ceil() as usize);
        Self { rect, size, pixels: vec![0; size[0] * size[1]] }
    }

    /// A disc in a colour of the palette.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the image")]
    pub fn dot(&mut self, at: Point, diameter: f64, color: usize) {
        let center = [(at[0] - self.rect.x) * SCALE, (at[1] - self.rect.y) * SCALE];
        let radius = 0.5 * diameter * SCALE;
        let range = |axis: usize| {
            let last = self.size[axis] as f64 - 1.0;
            let from = (center[axis] - radius).floor().clamp(0.0, last) as usize;
            let to = (center[axis] + radius).ceil().clamp(0.0, last) as usize;
            from..=to
        };
        let index = u8::try_from(color + 1).unwrap_or(u8::MAX);
        for y in range(1) {
            for x in range(0) {
                let [dx, dy] = [x as f64 + 0.5 - center[0], y as f64 + 0.5 - center[1]];
                // The pixel nearest to the centre is always set.
                if dx * dx + dy * dy <= (radius * radius).max(0.5) {
                    self.pixels[y * self.size[0] + x] = index;
                }
            }
        }
    }

    /// The image as an SVG element.
    pub fn element(&self, palette: &[RGBColor]) -> Result<String, PlotError> {
        let [x, y, width, height] = [self.rect.x, self.rect.y, self.rect.width, self.rect.height].map(to_units);
        Ok(format!(
            "<image xmlns:xlink=\"http://www.w3.org/1999/xlink\" x=\"{x}\" y=\"{y}\" width=\"{width}\" \
             height=\"{height}\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,{}\"/>",
            STANDARD.encode(self.png(palette)?)
        ))
    }

    fn png(&self, palette: &[RGBColor]) -> Result<Vec<u8>, PlotError> {
        let size = self.size.map(|pixels| u32::try_from(pixels).unwrap_or(u32::MAX));
        let colors = [PAPER].iter().chain(palette).flat_map(|color| [color.0, color.1, color.2]);
        png(size, Some(colors.collect()), &self.pixels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_at_the_rim_stay_inside() {
        let mut raster = Raster::new(Rect { x: 10.0, y: 20.0, width: 4.0, height: 2.0 });
        raster.dot([10.0, 20.0], 1.0, 0);
        raster.dot([14.0, 22.0], 1.0, 6);
        assert_eq!((raster.pixels.first(), raster.pixels.last()), (Some(&1), Some(&7)));
        let png = raster.png(&[RGBColor(1, 2, 3); 7]).unwrap();
        assert!(png.starts_with(b"\x89PNG"));
    }
}
