//! Crossings as points: vectors, or images where there are many.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::style::RGBColor;

use super::colors::Coloring;
use super::layout::SheetPanel;
use super::scene::{SectionOptions, SectionScene};
use bifdiag_page::{Canvas, Ink, PAPER, Path, PlotError, Point, Rect, png, to_units};

/// Diameters of points in pixels.
const SMALLEST: f64 = 0.8;
const LARGEST: f64 = 2.2;
/// The part of a panel that points may cover before they are made smaller.
const COVERAGE: f64 = 0.06;

/// How points are drawn.
pub(super) struct Style {
    diameter: f64,
    as_image: bool,
}

impl Style {
    pub fn new(scenes: &[SectionScene<'_>], options: &SectionOptions) -> Self {
        let count = |scene: &SectionScene<'_>| scene.orbits.iter().map(|orbit| orbit.points.len()).sum::<usize>();
        let total: usize = scenes.iter().map(count).sum();
        let densest = scenes.iter().map(count).max().unwrap_or(0);
        // Both sheets together are some 200,000 square pixels.
        let room = COVERAGE * 2e5 / densest.max(1) as f64;
        let diameter = options.point_size.unwrap_or_else(|| room.sqrt().clamp(SMALLEST, LARGEST));
        Self { diameter, as_image: total > options.raster_above }
    }
}

/// Draws the crossings of one sheet.
pub(super) fn draw(
    canvas: &Canvas,
    scene: &SectionScene<'_>,
    panel: &SheetPanel,
    coloring: &Coloring,
    style: &Style,
) -> Result<(), PlotError> {
    let orbits = scene.orbits.iter().enumerate().map(|(index, orbit)| {
        let crossings = orbit.points.iter().map(|point| scene.portrait.crossing(panel.chart, point));
        let own = crossings.filter(|(_, sheet)| *sheet == panel.sheet).map(|(place, _)| panel.position(place));
        (coloring.of(scene, index), own)
    });
    let palette = coloring.palette();
    let shown: Vec<_> = palette.iter().map(|color| canvas.color(*color)).collect();
    if style.as_image {
        let mut raster = Raster::new(panel.rect);
        for (color, points) in orbits {
            points.for_each(|at| raster.dot(at, style.diameter, color));
        }
        canvas.element(&raster.element(&shown)?);
        return Ok(());
    }
    for (color, points) in orbits {
        let mut path = Path::default();
        points.for_each(|at| path.dot(at));
        let ink = Ink { color: palette[color], width: style.diameter };
        canvas.draw(&path, &format!("{} stroke-linecap=\"round\"", canvas.stroke(ink)));
    }
    Ok(())
}

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
        png(size, Some(colors.collect()), &self.pixels, None)
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
