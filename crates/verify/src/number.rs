//! Numbers of documents, read exactly.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::Refused;

/// Beyond 10^±150 a number is refused: its square would leave the range of `f64`.
const MAX_DECIMAL_EXPONENT: u64 = 150;
/// More digits than this are refused.
const MAX_DIGITS: usize = 1000;

/// The number that a text denotes, or the refusal that names the text.
pub(super) fn read(text: &str) -> Result<RBig, Refused> {
    exact(text).ok_or_else(|| Refused::Number { text: text.to_owned() })
}

/// The number that a text denotes: a decimal, a decimal with exponent, or a quotient of two.
pub(super) fn exact(text: &str) -> Option<RBig> {
    let value = match text.trim().split_once('/') {
        Some((above, below)) => {
            let below = decimal(below.trim()).filter(|below| !below.is_zero())?;
            decimal(above.trim())? / below
        }
        None => decimal(text.trim())?,
    };
    let in_range = (1e-150..=1e150).contains(&value.to_f64().value().abs());
    (in_range || value.is_zero()).then_some(value)
}

fn decimal(text: &str) -> Option<RBig> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (text, 0),
    };
    let negative = mantissa.starts_with('-');
    let magnitude = mantissa.strip_prefix(['+', '-']).unwrap_or(mantissa);
    let (whole, fraction) = magnitude.split_once('.').unwrap_or((magnitude, ""));
    let digits = [whole, fraction].concat();
    if digits.is_empty() || digits.len() > MAX_DIGITS || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let significant = digits.trim_start_matches('0');
    let Some(behind_first) = significant.len().checked_sub(1) else { return Some(RBig::ZERO) };
    let power = exponent.saturating_sub(i64::try_from(fraction.len()).ok()?);
    let leading = power.saturating_add(i64::try_from(behind_first).ok()?);
    if leading.unsigned_abs() > MAX_DECIMAL_EXPONENT {
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
}
