//! Colours as colour-blind readers see them, to test palettes with.

use plotters::style::RGBColor;

use super::perception::{linear, of_linear, times};

/// How a reader sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sight {
    /// All three kinds of cones.
    Full,
    /// Without those for middle wavelengths.
    Deuteranopia,
    /// Without those for long ones.
    Protanopia,
    /// Without those for short ones.
    Tritanopia,
}

/// All of them.
pub const SIGHTS: [Sight; 4] = [Sight::Full, Sight::Deuteranopia, Sight::Protanopia, Sight::Tritanopia];

/// What is seen of a colour: Machado, Oliveira, Fernandes, A physiologically-based model for simulation of color
/// vision deficiency, 2009, severity 1.
fn seen(sight: Sight, color: RGBColor) -> RGBColor {
    let matrix = match sight {
        Sight::Full => return color,
        Sight::Protanopia => {
            [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]]
        }
        Sight::Deuteranopia => {
            [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]]
        }
        Sight::Tritanopia => {
            [[1.255_528, -0.076_749, -0.178_779], [-0.078_411, 0.930_809, 0.147_602], [0.004_733, 0.691_367, 0.303_900]]
        }
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
#[must_use]
pub fn apart(sight: Sight, one: RGBColor, other: RGBColor) -> f64 {
    let (p, q) = (cie(seen(sight, one)), cie(seen(sight, other)));
    (0..3).map(|k| (p[k] - q[k]) * (p[k] - q[k])).sum::<f64>().sqrt()
}

/// The colours are at least this far apart for every reader.
///
/// # Panics
/// If two of them are nearer for one reader.
pub fn assert_apart(colors: &[RGBColor], least: f64) {
    for sight in SIGHTS {
        for (place, one) in colors.iter().enumerate() {
            for other in &colors[..place] {
                let distance = apart(sight, *one, *other);
                assert!(distance >= least, "{one:?} and {other:?} are {distance:.1} apart with {sight:?}");
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
