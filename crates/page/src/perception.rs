//! How colours look: Oklab (B. Ottosson, A perceptual color space for image processing, 2020), in which equal distances
//! look about equally large, and what colour-blind readers see of them.

use plotters::style::RGBColor;

/// A colour in Oklab: lightness from 0 (black) to 1 (white), `a` from green to red, `b` from blue to yellow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lab {
    pub lightness: f64,
    pub a: f64,
    pub b: f64,
}

/// Linear light of the three channels, 0 to 1.
pub fn linear(RGBColor(red, green, blue): RGBColor) -> [f64; 3] {
    [red, green, blue].map(|byte| {
        let value = f64::from(byte) / 255.0;
        if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
    })
}

/// The nearest colour that three bytes can hold.
pub fn of_linear(channels: [f64; 3]) -> RGBColor {
    let [red, green, blue] = channels.map(|value| {
        let value = value.clamp(0.0, 1.0);
        let encoded = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * libm::pow(value, 1.0 / 2.4) - 0.055 };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let byte = (255.0 * encoded).round() as u8;
        byte
    });
    RGBColor(red, green, blue)
}

pub fn times(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

/// A colour in Oklab.
pub fn lab(color: RGBColor) -> Lab {
    let cones = times(
        [
            [0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9],
            [0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6],
            [0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5],
        ],
        linear(color),
    );
    let [lightness, a, b] = times(
        [
            [0.210_454_255_3, 0.793_617_785, -0.004_072_046_8],
            [1.977_998_495_1, -2.428_592_205, 0.450_593_709_9],
            [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766],
        ],
        cones.map(libm::cbrt),
    );
    Lab { lightness, a, b }
}

/// The nearest colour that can be shown.
pub fn rgb_of(Lab { lightness, a, b }: Lab) -> RGBColor {
    let roots = times(
        [
            [1.0, 0.396_337_777_4, 0.215_803_757_3],
            [1.0, -0.105_561_345_8, -0.063_854_172_8],
            [1.0, -0.089_484_177_5, -1.291_485_548],
        ],
        [lightness, a, b],
    );
    of_linear(times(
        [
            [4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2],
            [-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5],
            [-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701],
        ],
        roots.map(|root| root * root * root),
    ))
}

/// The contrast of two colours, from 1 to 21 (WCAG 2).
#[must_use]
pub fn contrast(one: RGBColor, other: RGBColor) -> f64 {
    let luminance = |color| times([[0.2126, 0.7152, 0.0722]; 3], linear(color))[0];
    let (p, q) = (luminance(one), luminance(other));
    (p.max(q) + 0.05) / (p.min(q) + 0.05)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn oklab_goes_there_and_back() {
        for color in [RGBColor(0, 0, 0), RGBColor(255, 255, 255), RGBColor(200, 30, 90), RGBColor(3, 140, 77)] {
            assert_eq!(rgb_of(lab(color)), color);
        }
    }
}
