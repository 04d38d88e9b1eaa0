//! Striped grounds.

use plotters::style::RGBColor;

use super::geometry::UNITS;

/// Width of a stripe in pixels.
const WIDTH: f64 = 5.0;

/// Stripes of some colours in turn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stripes {
    pub colors: Vec<RGBColor>,
}

impl Stripes {
    /// The pattern as an SVG element, with colours as `hex` writes them.
    pub fn definition(&self, number: usize, hex: impl Fn(RGBColor) -> String) -> String {
        let width = WIDTH * UNITS;
        let period = width * self.colors.len() as f64;
        let stripe = |(place, color): (usize, &RGBColor)| {
            let (x, color) = (width * place as f64, hex(*color));
            // A little over the edge, so that no seam shows.
            format!("<rect x=\"{x}\" width=\"{}\" height=\"{period}\" fill=\"{color}\"/>", width + 2.0)
        };
        let ground = format!("<rect width=\"{period}\" height=\"{period}\" fill=\"{}\"/>", hex(self.colors[0]));
        let stripes: String = self.colors.iter().enumerate().map(stripe).collect();
        format!(
            "<defs><pattern id=\"stripes-{number}\" width=\"{period}\" height=\"{period}\" \
             patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(-45)\">{ground}{stripes}</pattern></defs>\n"
        )
    }

    /// The attributes of an area.
    pub fn fill(number: usize) -> String {
        format!("fill=\"url(#stripes-{number})\"")
    }
}
