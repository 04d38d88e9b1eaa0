//! Colours that every picture shares, lines in them, and the themes that show them.

use plotters::style::RGBColor;

use super::perception::{Lab, lab, rgb_of};

/// Text, frames and axes.
pub const INK: RGBColor = rgb(0x22_22_22);
/// Less important text.
pub const FAINT_INK: RGBColor = rgb(0x59_59_59);
/// The ground of the page and of labels.
pub const PAPER: RGBColor = rgb(0xff_ff_ff);
/// The pole +r̂.
pub const POLE: RGBColor = rgb(0xdc_72_26);
/// The pole −r̂.
pub const POLE_MINUS: RGBColor = RGBColor(0x78, 0x32, 0x64);

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

/// Areas are lighter than this in the light theme, text in them is darker.
const PALE: f64 = 0.65;
/// … and lines are darker than this.
const LINES: f64 = 0.8;
/// Lightness of the dark theme's ground, and how much lighter areas may be: the more, the darker they are in the light theme,
/// and the less so the darker, so that pale tints keep apart and light text can be read on all.
const DARKEST: f64 = 0.18;
const RISE: f64 = 0.38;
const PACE: f64 = 0.2;

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
    /// The colour of an area in the light theme as this theme shows it.
    #[must_use]
    pub fn ground(self, color: RGBColor) -> RGBColor {
        self.shown(color, PALE)
    }

    /// The colour of a line, of a text or of paper in the light theme as this theme shows it.
    #[must_use]
    pub fn color(self, color: RGBColor) -> RGBColor {
        self.shown(color, LINES)
    }

    /// What is lighter than `pale` as an area, all else as a line.
    fn shown(self, color: RGBColor, pale: f64) -> RGBColor {
        let Lab { lightness, a, b } = lab(color);
        match self {
            Self::Light => color,
            Self::Dark if lightness > pale => {
                let rise = 1.0 - libm::exp((lightness - 1.0) / PACE);
                rgb_of(Lab { lightness: DARKEST + RISE * rise, a, b })
            }
            // Yellow stays light.
            Self::Dark => rgb_of(Lab { lightness: 1.02 - 0.52 * lightness, a, b }),
            Self::Print if lightness > pale => {
                rgb_of(Lab { lightness: 1.0 - 0.6 * (1.0 - lightness), a: 0.6 * a, b: 0.6 * b })
            }
            Self::Print => rgb_of(Lab { lightness: 0.85 * lightness, a, b }),
        }
    }
}
