//! The angle of a vector of the plane, all lanes at once.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use pulp::Simd;

use crate::integrator::taylor::magnitude;

/// (atan(q)/q − 1)/q² as a polynomial in q² on [0, tan²(π/8)], interpolated at Chebyshev's points: 1e-17 of atan.
const ARC_TANGENT: [f64; 13] = [
    -0.333_333_333_333_333_3,
    0.199_999_999_999_999_93,
    -0.142_857_142_857_114_9,
    0.111_111_111_107_514_82,
    -0.090_909_090_668_160_8,
    0.076_923_067_291_948_96,
    -0.066_666_418_691_311_83,
    0.058_819_230_561_140_225,
    -0.052_580_202_726_567_58,
    0.047_192_591_882_420_93,
    -0.041_038_875_468_627_87,
    0.030_622_995_553_735_516,
    -0.013_905_374_533_113_234,
];
/// What the doubles next to π/4, π/2 and π leave out.
const QUARTER_LOW: f64 = 3.061_616_997_868_383e-17;
const HALF_LOW: f64 = 6.123_233_995_736_766e-17;
const WHOLE_LOW: f64 = 1.224_646_799_147_353_2e-16;
/// tan(π/8).
const TURN: f64 = 0.414_213_562_373_095_03;

/// The angle of (x, y) in [−π, π], to 3e-16 of itself; 0 for the zero vector, π for y = ±0 and x < 0.
///
/// Without fused operations: in a single lane without hardware for them this is as fast as anything.
#[inline(always)]
pub(super) fn angle<S: Simd>(simd: S, y: S::f64s, x: S::f64s) -> S::f64s {
    let zero = simd.splat_f64s(0.0);
    let (rise, run) = (magnitude(simd, y), magnitude(simd, x));
    let (small, large) = (simd.min_f64s(rise, run), simd.max_f64s(rise, run));
    let large = simd.max_f64s(large, simd.splat_f64s(f64::MIN_POSITIVE));
    // Above π/8, from the difference to π/4.
    let turned = simd.less_than_f64s(simd.mul_f64s(simd.splat_f64s(TURN), large), small);
    let top = simd.select_f64s(turned, simd.sub_f64s(small, large), small);
    let bottom = simd.select_f64s(turned, simd.add_f64s(small, large), large);
    let q = simd.div_f64s(top, bottom);
    let square = simd.mul_f64s(q, q);
    let fourth = simd.mul_f64s(square, square);
    let (mut even, mut odd) = (simd.splat_f64s(ARC_TANGENT[12]), zero);
    for k in (0..6).rev() {
        odd = simd.add_f64s(simd.mul_f64s(odd, fourth), simd.splat_f64s(ARC_TANGENT[2 * k + 1]));
        even = simd.add_f64s(simd.mul_f64s(even, fourth), simd.splat_f64s(ARC_TANGENT[2 * k]));
    }
    let series = simd.add_f64s(simd.mul_f64s(odd, square), even);
    let angle = simd.add_f64s(simd.mul_f64s(simd.mul_f64s(q, square), series), q);

    let far = simd.add_f64s(simd.splat_f64s(FRAC_PI_4), simd.add_f64s(angle, simd.splat_f64s(QUARTER_LOW)));
    let angle = simd.select_f64s(turned, far, angle);
    let steep = simd.less_than_f64s(run, rise);
    let rest = simd.sub_f64s(simd.splat_f64s(FRAC_PI_2), simd.sub_f64s(angle, simd.splat_f64s(HALF_LOW)));
    let angle = simd.select_f64s(steep, rest, angle);
    let left = simd.less_than_f64s(x, zero);
    let rest = simd.sub_f64s(simd.splat_f64s(PI), simd.sub_f64s(angle, simd.splat_f64s(WHOLE_LOW)));
    let angle = simd.select_f64s(left, rest, angle);
    simd.select_f64s(simd.less_than_f64s(y, zero), simd.sub_f64s(zero, angle), angle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use pulp::Scalar;

    #[test]
    fn angles_are_those_of_the_mathematics_library() {
        for k in 0..20_000 {
            let direction = f64::from(k) * 0.618_033_988_7;
            let size = libm::exp(f64::from(k % 37) - 20.0);
            let (x, y) = (libm::cos(direction), size * libm::sin(direction));
            let expected = libm::atan2(y, x);
            // Its own rounding comes on top.
            assert!((angle(Scalar::new(), y, x) - expected).abs() <= 5e-16 * expected.abs(), "{x} {y}");
        }
    }

    #[test]
    fn axes_and_the_zero_vector() {
        let at = |y, x| angle(Scalar::new(), y, x);
        assert_eq!([at(0.0, 0.0), at(0.0, 1.0), at(0.0, -1.0), at(-0.0, -1.0)], [0.0, 0.0, PI, PI]);
        assert_eq!(
            [at(1.0, 0.0), at(-1.0, 0.0), at(2.0, 2.0), at(1.0, -1.0)],
            [FRAC_PI_2, -FRAC_PI_2, FRAC_PI_4, 3.0 * FRAC_PI_4]
        );
        assert_eq!([at(1e-320, 1.0), at(1e300, 1e-300)], [1e-320, FRAC_PI_2]);
    }
}
