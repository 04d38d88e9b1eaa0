//! How colours look: Oklab (B. Ottosson, A perceptual color space for image processing, 2020), in which equal distances
//! look about equally large, and what colour-blind readers see of them.

use plotters::style::RGBColor;

/// A colour in Oklab: lightness from 0 (black) to 1 (white), `a` from green to red, `b` from blue to yellow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lab {
    pub lightness: f64,
    pub a: f64,
    pub b: f64,
}

/// Linear light of the three channels, 0 to 1.
fn linear(RGBColor(red, green, blue): RGBColor) -> [f64; 3] {
    [red, green, blue].map(|byte| {
        let value = f64::from(byte) / 255.0;
        if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
    })
}

/// The nearest colour that three bytes can hold.
fn of_linear(channels: [f64; 3]) -> RGBColor {
    let [red, green, blue] = channels.map(|value| {
        let value = value.clamp(0.0, 1.0);
        let encoded = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * libm::pow(value, 1.0 / 2.4) - 0.055 };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let byte = (255.0 * encoded).round() as u8;
        byte
    });
    RGBColor(red, green, blue)
}

fn times(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

/// A colour in Oklab.
pub(crate) fn lab(color: RGBColor) -> Lab {
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
pub(crate) fn rgb_of(Lab { lightness, a, b }: Lab) -> RGBColor {
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
#[cfg(test)]
pub(crate) fn contrast(one: RGBColor, other: RGBColor) -> f64 {
    let luminance = |color| times([[0.2126, 0.7152, 0.0722]; 3], linear(color))[0];
    let (p, q) = (luminance(one), luminance(other));
    (p.max(q) + 0.05) / (p.min(q) + 0.05)
}

#[cfg(test)]
pub(crate) mod sight {
    //! Simulated sight, for tests of palettes.

    use super::{RGBColor, lab, linear, of_linear, times};

    /// How a reader sees.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(crate) enum Sight {
        Full,
        Deuteranopia,
        Protanopia,
        Tritanopia,
    }

    pub(crate) const SIGHTS: [Sight; 4] = [Sight::Full, Sight::Deuteranopia, Sight::Protanopia, Sight::Tritanopia];

    /// What is seen of a colour: Machado, Oliveira, Fernandes, A physiologically-based model for simulation of color
    /// vision deficiency, 2009, severity 1.
    fn seen(sight: Sight, color: RGBColor) -> RGBColor {
        let matrix = match sight {
            Sight::Full => return color,
            Sight::Protanopia => [
                [0.152_286, 1.052_583, -0.204_868],
                [0.114_503, 0.786_281, 0.099_216],
                [-0.003_882, -0.048_116, 1.051_998],
            ],
            Sight::Deuteranopia => [
                [0.367_322, 0.860_646, -0.227_968],
                [0.280_085, 0.672_501, 0.047_413],
                [-0.011_820, 0.042_940, 0.968_881],
            ],
            Sight::Tritanopia => [
                [1.255_528, -0.076_749, -0.178_779],
                [-0.078_411, 0.930_809, 0.147_602],
                [0.004_733, 0.691_367, 0.303_900],
            ],
        };
        of_linear(times(matrix, linear(color)))
    }

    /// CIE L*a*b* for the white of sRGB.
    fn cie(color: RGBColor) -> [f64; 3] {
        let xyz = times(
            [
                [0.412_390_8, 0.357_584_3, 0.180_480_8],
                [0.212_639_0, 0.715_168_7, 0.072_192_3],
                [0.019_330_8, 0.119_194_8, 0.950_532_2],
            ],
            linear(color),
        );
        let [x, y, z] = [xyz[0] / 0.950_456, xyz[1], xyz[2] / 1.089_058]
            .map(|t| if t > 216.0 / 24_389.0 { libm::cbrt(t) } else { (24_389.0 / 27.0 * t + 16.0) / 116.0 });
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// The distance of two colours in CIE L*a*b* (ΔE of 1976) as a reader sees them.
    pub(crate) fn apart(sight: Sight, one: RGBColor, other: RGBColor) -> f64 {
        let (p, q) = (cie(seen(sight, one)), cie(seen(sight, other)));
        (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum::<f64>().sqrt()
    }

    /// The least distance of the colours for any reader.
    pub(crate) fn assert_apart(colors: &[RGBColor], least: f64) {
        for sight in SIGHTS {
            for (place, one) in colors.iter().enumerate() {
                for other in &colors[..place] {
                    let distance = apart(sight, *one, *other);
                    assert!(distance >= least, "{one:?} and {other:?} are {distance:.1} apart with {sight:?}");
                }
            }
        }
    }

    #[test]
    fn known_colours_have_known_places() {
        let white = cie(RGBColor(255, 255, 255));
        assert!((white[0] - 100.0).abs() < 0.01 && white[1].abs() < 0.01 && white[2].abs() < 0.01, "{white:?}");
        let red = cie(RGBColor(255, 0, 0));
        assert!((red[0] - 53.24).abs() < 0.05 && (red[1] - 80.09).abs() < 0.1 && (red[2] - 67.2).abs() < 0.1);
        // Red and green of equal lightness are one olive to a deuteranope.
        let (red, green) = (RGBColor(190, 80, 40), RGBColor(90, 128, 40));
        assert!(apart(Sight::Full, red, green) > 3.0 * apart(Sight::Deuteranopia, red, green));
        assert!(apart(Sight::Tritanopia, RGBColor(0, 0, 255), RGBColor(0, 255, 0)) > 20.0);
    }

    #[test]
    fn oklab_goes_there_and_back() {
        for color in [RGBColor(0, 0, 0), RGBColor(255, 255, 255), RGBColor(200, 30, 90), RGBColor(3, 140, 77)] {
            assert_eq!(super::rgb_of(lab(color)), color);
        }
    }
}
