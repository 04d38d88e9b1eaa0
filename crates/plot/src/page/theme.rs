//! Colours for light and dark screens and for print.

use plotters::style::RGBColor;

use super::perception::{Lab, lab, rgb_of};

/// For what a picture is coloured. A theme maps every colour of the light one, so that no picture knows of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Dark on white.
    #[default]
    Light,
    /// Light on a dark ground.
    Dark,
    /// Dark on white with pale grounds and darker lines, for paper and photocopies.
    Print,
}

impl Theme {
    /// A colour of the light theme as this theme shows it.
    pub(crate) fn color(self, color: RGBColor) -> RGBColor {
        /// Lightness of the dark theme's ground, and of what is black in the light one.
        const GROUND: f64 = 0.18;
        const BLACK: f64 = 1.02;
        /// Lines in light colours, such as yellow, stay as light as this at least in the dark theme.
        const LINE: f64 = 0.5;
        /// Grounds are lighter than this, lines and texts darker.
        const PALE: f64 = 0.8;
        let Lab { lightness, a, b } = lab(color);
        match self {
            Self::Light => color,
            Self::Dark => {
                let darkest = if lightness > PALE { GROUND } else { LINE };
                rgb_of(Lab { lightness: BLACK - (BLACK - darkest) * lightness, a, b })
            }
            Self::Print if lightness > PALE => {
                rgb_of(Lab { lightness: 1.0 - 0.6 * (1.0 - lightness), a: 0.6 * a, b: 0.6 * b })
            }
            Self::Print => rgb_of(Lab { lightness: 0.85 * lightness, a, b }),
        }
    }
}
