//! Numbers of documents, read exactly.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::Refused;

/// What is read at most: powers of ten of the first digit, and digits.
struct Limits {
    exponent: u64,
    digits: usize,
}

/// Of a body, and of a certificate in its units: beyond 10^±150 the square would leave the range of `f64`.
const PLAIN: Limits = Limits { exponent: 150, digits: 1000 };

/// Of what is told in the units of the body, which may be as large themselves.
const IN_UNITS: Limits = Limits { exponent: 500, digits: 1000 };

/// The number that a text denotes, or the refusal that names the text.
pub(super) fn read(text: &str) -> Result<RBig, Refused> {
    exact(text).ok_or_else(|| refused(text))
}

/// The number that a text denotes: a decimal, a decimal with exponent, or a quotient of two.
pub(super) fn exact(text: &str) -> Option<RBig> {
    within(text, &PLAIN).filter(is_plain)
}

/// A number in the units of the body; divided by the unit it is within the limits of those in a certificate.
pub(super) fn in_units(text: &str, unit: &RBig) -> Result<RBig, Refused> {
    within(text, &IN_UNITS).filter(|value| is_plain(&(value / unit))).ok_or_else(|| refused(text))
}

/// A unit of a certificate: positive, no further than a power of four from a number that is read, and such that doubles hold the
/// product of two.
pub(super) fn unit(text: &str) -> Result<RBig, Refused> {
    let is_unit = |value: &RBig| (1e-152..=1e152).contains(&value.to_f64().value());
    within(text, &IN_UNITS).filter(is_unit).ok_or_else(|| refused(text))
}

fn is_plain(value: &RBig) -> bool {
    value.is_zero() || (1e-150..=1e150).contains(&value.to_f64().value().abs())
}

fn refused(text: &str) -> Refused {
    Refused::Number { text: text.to_owned() }
}

fn within(text: &str, limits: &Limits) -> Option<RBig> {
    match text.trim().split_once('/') {
        Some((above, below)) => {
            let below = decimal(below.trim(), limits).filter(|below| !below.is_zero())?;
            Some(decimal(above.trim(), limits)? / below)
        }
        None => decimal(text.trim(), limits),
    }
}

fn decimal(text: &str, limits: &Limits) -> Option<RBig> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (text, 0),
    };
    let negative = mantissa.starts_with('-');
    let magnitude = mantissa.strip_prefix(['+', '-']).unwrap_or(mantissa);
    let (whole, fraction) = magnitude.split_once('.').unwrap_or((magnitude, ""));
    let digits = [whole, fraction].concat();
    if digits.is_empty() || digits.len() > limits.digits || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let significant = digits.trim_start_matches('0');
    let Some(behind_first) = significant.len().checked_sub(1) else { return Some(RBig::ZERO) };
    let power = exponent.saturating_sub(i64::try_from(fraction.len()).ok()?);
    let leading = power.saturating_add(i64::try_from(behind_first).ok()?);
    if leading.unsigned_abs() > limits.exponent {
        return None;
    }
    let integer = IBig::from(UBig::from_str_radix(significant, 10).ok()?);
    let integer = if negative { -integer } else { integer };
    let scale = UBig::from(10u8).pow(usize::try_from(power.unsigned_abs()).ok()?);
    Some(if power < 0 { RBig::from_parts(integer, scale) } else { RBig::from(integer * IBig::from(scale)) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_exponents_and_quotients_are_exact() {
        let eleven_tenths = RBig::from_parts(11.into(), 10u8.into());
        for text in ["1.1", "11/10", "11e-1", "+1.10", "0.11e1", ".11E+1", "2.2/2", " 22 / 20 "] {
            assert_eq!(exact(text).as_ref(), Some(&eleven_tenths), "{text}");
        }
        assert_eq!(exact("-3."), Some(RBig::from(-3)));
        assert_eq!(exact("-0"), Some(RBig::ZERO));
        assert_eq!(exact("0e999"), Some(RBig::ZERO));
    }

    #[test]
    fn other_texts_are_refused() {
        let long = "9".repeat(2000);
        for text in [
            "",
            "  ",
            "nan",
            "-inf",
            "abc",
            "1.2.3",
            "1e",
            "1e+",
            "1e+-2",
            "--1",
            "+-1",
            "1/2/3",
            "1/0",
            ".",
            "0x10",
            "1_000",
            "1,0",
            "1e151",
            "1e-151",
            "1e200/1e10",
            "1e9999999999999999999",
            "1e-9223372036854775808",
            &long,
        ] {
            assert_eq!(exact(text), None, "{text}");
        }
        assert_eq!(read("one"), Err(Refused::Number { text: "one".to_owned() }));
    }

    #[test]
    fn what_is_told_in_units_of_the_body_may_be_larger_than_the_body() {
        let ten = |power: usize| RBig::from(IBig::from(10).pow(power));
        let refused = |text: &str| Refused::Number { text: text.to_owned() };
        assert_eq!(in_units("3e151", &ten(150)), Ok(ten(151) * RBig::from(3)));
        assert_eq!(in_units("0", &ten(150)), Ok(RBig::ZERO));
        assert_eq!(in_units("3e151", &RBig::ONE), Err(refused("3e151")));
        assert_eq!(in_units("3e-1", &ten(150)), Err(refused("3e-1")));
        // Units are multiplied in doubles.
        assert_eq!(unit("4e-151"), Ok(RBig::from(4) / ten(151)));
        for text in ["0", "-1", "1e153", "1e-153", "1e5000", "1e-5000"] {
            assert_eq!(unit(text), Err(refused(text)));
        }
    }
}
