//! Numbers of documents, read exactly.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use crate::Refused;

/// Digits of a number at most.
const DIGITS: usize = 1000;

/// Powers of ten of the first digit of a number of a body, and of a certificate in its units: beyond 10^±150 the square would
/// leave the range of `f64`.
const PLAIN: u64 = 150;

/// Likewise in the units of the body, which may be as large themselves.
const IN_UNITS: u64 = 500;

/// The number of a body as it was given: a decimal, a decimal with exponent, or a quotient of two.
pub(crate) fn given(text: &str) -> Result<RBig, Refused> {
    within(text, PLAIN).filter(is_plain).ok_or_else(|| refused(text))
}

/// The number that a text of a certificate denotes, or the refusal that names the text.
pub(crate) fn read(text: &str) -> Result<RBig, Refused> {
    exact(text).ok_or_else(|| refused(text))
}

/// The number that a text of a certificate denotes.
pub(crate) fn exact(text: &str) -> Option<RBig> {
    is_written(text).then(|| within(text, PLAIN).filter(is_plain))?
}

/// A number in the units of the body; divided by the unit it is within the limits of those in a certificate.
pub(crate) fn in_units(text: &str, unit: &RBig) -> Result<RBig, Refused> {
    let value = is_written(text).then(|| within(text, IN_UNITS)).flatten();
    value.filter(|value| is_plain(&(value / unit))).ok_or_else(|| refused(text))
}

/// A unit of a certificate: positive, no further than a power of four from a number that is read, such that doubles hold the
/// product of two, and in the one form in which it is written.
pub(crate) fn unit(text: &str) -> Result<RBig, Refused> {
    let is_unit = |value: &RBig| (1e-152..=1e152).contains(&value.to_f64().value());
    within(text, IN_UNITS).filter(is_unit).filter(|value| unit_text(value) == text).ok_or_else(|| refused(text))
}

fn is_plain(value: &RBig) -> bool {
    value.is_zero() || (1e-150..=1e150).contains(&value.to_f64().value().abs())
}

fn refused(text: &str) -> Refused {
    Refused::Number { text: text.to_owned() }
}

/// A text has the form of the numbers of a certificate: an integer, with a power of ten or without, or a fraction in lowest
/// terms.
fn is_written(text: &str) -> bool {
    if let Some((above, below)) = text.split_once('/') {
        return is_integer(above)
            && is_integer(below)
            && within(text, IN_UNITS).is_some_and(|value| value.to_string() == text);
    }
    match text.split_once('e') {
        Some((digits, power)) => [digits, power].iter().all(|part| is_integer(part) && *part != "0"),
        None => is_integer(text),
    }
}

/// Digits without a leading zero or plus.
fn is_integer(text: &str) -> bool {
    let digits = text.strip_prefix('-').unwrap_or(text);
    text == "0" || (!digits.is_empty() && !digits.starts_with('0') && digits.bytes().all(|c| c.is_ascii_digit()))
}

/// The exact decimal where the denominator is a power of two, else a fraction.
fn unit_text(value: &RBig) -> String {
    let denominator = value.denominator();
    let power = denominator.trailing_zeros().unwrap_or(0);
    if *denominator != UBig::ONE << power {
        return value.to_string();
    }
    let digits = value.numerator() * IBig::from(5).pow(power);
    if power == 0 { digits.to_string() } else { format!("{digits}e-{power}") }
}

fn within(text: &str, exponents: u64) -> Option<RBig> {
    match text.trim().split_once('/') {
        Some((above, below)) => {
            let below = decimal(below.trim(), exponents).filter(|below| !below.is_zero())?;
            Some(decimal(above.trim(), exponents)? / below)
        }
        None => decimal(text.trim(), exponents),
    }
}

fn decimal(text: &str, exponents: u64) -> Option<RBig> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (text, 0),
    };
    let negative = mantissa.starts_with('-');
    let magnitude = mantissa.strip_prefix(['+', '-']).unwrap_or(mantissa);
    let (whole, fraction) = magnitude.split_once('.').unwrap_or((magnitude, ""));
    let digits = [whole, fraction].concat();
    if digits.is_empty() || digits.len() > DIGITS || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let significant = digits.trim_start_matches('0');
    let Some(behind_first) = significant.len().checked_sub(1) else {
        return Some(RBig::ZERO);
    };
    let power = exponent.saturating_sub(i64::try_from(fraction.len()).ok()?);
    let leading = power.saturating_add(i64::try_from(behind_first).ok()?);
    if leading.unsigned_abs() > exponents {
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
            assert_eq!(given(text).as_ref(), Ok(&eleven_tenths), "{text}");
        }
        assert_eq!(given("-3."), Ok(RBig::from(-3)));
        assert_eq!(given("-0"), Ok(RBig::ZERO));
        assert_eq!(given("0e999"), Ok(RBig::ZERO));
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
            assert!(given(text).is_err() && exact(text).is_none(), "{text}");
        }
        assert_eq!(read("one"), Err(Refused::Number { text: "one".to_owned() }));
    }

    #[test]
    fn numbers_in_units_of_the_body_may_be_larger_than_the_body() {
        let ten = |power: usize| RBig::from(IBig::from(10).pow(power));
        let refused = |text: &str| Refused::Number { text: text.to_owned() };
        assert_eq!(in_units("3e151", &ten(150)), Ok(ten(151) * RBig::from(3)));
        assert_eq!(in_units("0", &ten(150)), Ok(RBig::ZERO));
        assert_eq!(in_units("3e151", &RBig::ONE), Err(refused("3e151")));
        assert_eq!(in_units("3e-1", &ten(150)), Err(refused("3e-1")));
        // Units are multiplied in doubles.
        assert_eq!(unit("5e-1"), Ok(RBig::from(1) / RBig::from(2)));
        for text in ["0", "-1", "1e0", "50e-2", "1/2", "1e153", "1e-153", "1e5000", "1e-5000"] {
            assert_eq!(unit(text), Err(refused(text)));
        }
    }

    #[test]
    fn numbers_of_a_certificate_have_one_form() {
        for text in ["0", "12", "-12e-3", "100e5", "1/3", "-2/7"] {
            assert!(exact(text).is_some(), "{text}");
        }
        for text in ["-0", "-0.0", "0.5", "1e0", "0e1", "+1", "01", "1e+2", "1e05", "1E2", " 1", "2/4", "3/1", "1/-3"] {
            assert_eq!(exact(text), None, "{text}");
        }
    }
}
