//! Rationals and powers of two.

use dashu_base::BitTest;
use dashu_int::IBig;
use dashu_ratio::RBig;

/// k with 2ᵏ⁻¹ < |x| < 2ᵏ⁺¹, x ≠ 0.
#[must_use]
pub fn exponent(x: &RBig) -> i64 {
    let length = |bits: usize| i64::try_from(bits).unwrap_or(i64::MAX);
    length(x.numerator().bit_len()) - length(x.denominator().bit_len())
}

/// 2ᵏx, exact.
#[must_use]
pub fn times_power_of_two(x: RBig, k: i64) -> RBig {
    let power = RBig::from(IBig::ONE << usize::try_from(k.unsigned_abs()).unwrap_or(0));
    if k < 0 { x / power } else { x * power }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_two_brings_a_number_near_one() {
        for text in ["3", "-3", "1/3", "-7/1000000007", "123456789012345678901234567890", "1"] {
            let x: RBig = text.parse().unwrap();
            let size = times_power_of_two(x.clone(), -exponent(&x));
            let size = if size < RBig::ZERO { -size } else { size };
            assert!(RBig::from(1) < RBig::from(2) * &size && size < RBig::from(2), "{text}");
            assert_eq!(times_power_of_two(times_power_of_two(x.clone(), 70), -70), x);
        }
    }
}
