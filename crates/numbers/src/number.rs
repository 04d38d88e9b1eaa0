//! Exact numbers as users write them.

use std::fmt;
use std::str::FromStr;

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use thiserror::Error;

/// Decimal exponents beyond this are refused: their square would leave the range of `f64`.
const MAX_DECIMAL_EXPONENT: u64 = 150;
/// More digits than this are refused.
const MAX_DIGITS: usize = 1000;

/// A rational number together with the text that denoted it.
///
/// `1.1` is eleven tenths, never the nearest double; `11/10` and `11e-1` are the same value.
/// Equality and order compare values, not texts.
#[derive(Clone, Debug)]
pub struct Number {
    text: String,
    value: RBig,
    nearest: f64,
}

/// Why a text is not a [`Number`].
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ParseNumberError {
    /// Nothing was written.
    #[error("the number is missing")]
    Empty,
    /// Not a decimal, a decimal with exponent, or a rational.
    #[error("`{text}` is not a number; write a decimal (1.1), a decimal with exponent (1e-3) or a rational (11/10)")]
    Malformed {
        /// What was written.
        text: String,
    },
    /// `inf`, `nan` and their like.
    #[error("`{text}` is not finite; a finite number is needed")]
    NotFinite {
        /// What was written.
        text: String,
    },
    /// A rational with denominator zero.
    #[error("`{text}` has denominator zero")]
    ZeroDenominator {
        /// What was written.
        text: String,
    },
    /// Beyond the supported range of magnitudes or of digits.
    #[error(
        "`{text}` is out of range; use units in which it lies between {smallest:e} and {largest:e} and has at most 1000 digits",
        smallest = Number::SMALLEST,
        largest = Number::LARGEST
    )]
    OutOfRange {
        /// What was written, shortened.
        text: String,
    },
}

impl Number {
    /// The smallest magnitude but 0.
    pub const SMALLEST: f64 = 1e-150;

    /// The largest magnitude.
    pub const LARGEST: f64 = 1e150;

    /// The exact value.
    #[must_use]
    pub fn value(&self) -> &RBig {
        &self.value
    }

    /// The nearest `f64`, correctly rounded.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.nearest
    }

    /// The text as it was written.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The number denoted by the shortest decimal that reads back as `value`.
    ///
    /// # Errors
    /// [`ParseNumberError::NotFinite`] for infinities and NaN, [`ParseNumberError::OutOfRange`] for
    /// magnitudes outside [`Number::SMALLEST`] … [`Number::LARGEST`].
    pub fn from_f64(value: f64) -> Result<Self, ParseNumberError> {
        if value.is_finite() {
            format!("{value:?}").parse()
        } else {
            Err(ParseNumberError::NotFinite { text: value.to_string() })
        }
    }

    /// from + (to − from)·part/parts, exactly; `parts` is not 0.
    #[must_use]
    pub fn between(from: &Self, to: &Self, part: u32, parts: u32) -> Self {
        let share = RBig::from(part) / RBig::from(parts);
        Self::from_rational(&from.value + (&to.value - &from.value) * share)
    }

    /// An exact value with its own text (`p/q`, or `p` for an integer).
    #[must_use]
    pub fn from_rational(value: RBig) -> Self {
        let text = value.to_string();
        let nearest = value.to_f64().value();
        Self { text, value, nearest }
    }
}

fn shortened(text: &str) -> String {
    const SHOWN: usize = 40;
    if text.chars().count() <= SHOWN {
        text.to_owned()
    } else {
        text.chars().take(SHOWN).chain("…".chars()).collect()
    }
}

/// The exact value of a decimal with optional sign, fraction and exponent.
fn parse_decimal(text: &str, whole: &str) -> Result<RBig, ParseNumberError> {
    let malformed = || ParseNumberError::Malformed { text: shortened(whole) };
    let out_of_range = || ParseNumberError::OutOfRange { text: shortened(whole) };
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(at) => {
            let digits = &text[at + 1..];
            let unsigned = digits.strip_prefix(['+', '-']).unwrap_or(digits);
            if unsigned.is_empty() || !unsigned.bytes().all(|b| b.is_ascii_digit()) {
                return Err(malformed());
            }
            let exponent = digits.parse::<i64>().map_err(|_overflow| out_of_range())?;
            (&text[..at], exponent)
        }
        None => (text, 0),
    };
    let (negative, magnitude) = match mantissa.as_bytes().first() {
        Some(b'-') => (true, &mantissa[1..]),
        Some(b'+') => (false, &mantissa[1..]),
        _ => (false, mantissa),
    };
    let (integer, fraction) = magnitude.split_once('.').unwrap_or((magnitude, ""));
    let digits = [integer, fraction].concat();
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(malformed());
    }
    if digits.len() > MAX_DIGITS {
        return Err(out_of_range());
    }
    let significant = digits.trim_start_matches('0');
    if significant.is_empty() {
        return Ok(RBig::ZERO);
    }
    let fraction_digits = i64::try_from(fraction.len()).map_err(|_overflow| out_of_range())?;
    let significant_digits = i64::try_from(significant.len()).map_err(|_overflow| out_of_range())?;
    let power = exponent.saturating_sub(fraction_digits);
    let leading = power.saturating_add(significant_digits - 1);
    if leading.unsigned_abs() > MAX_DECIMAL_EXPONENT {
        return Err(out_of_range());
    }
    let magnitude = UBig::from_str_radix(significant, 10).map_err(|_not_digits| malformed())?;
    let ten_power = UBig::from(10u8).pow(usize::try_from(power.unsigned_abs()).map_err(|_overflow| out_of_range())?);
    let signed = if negative { -IBig::from(magnitude) } else { IBig::from(magnitude) };
    Ok(if power >= 0 { RBig::from(signed * IBig::from(ten_power)) } else { RBig::from_parts(signed, ten_power) })
}

impl FromStr for Number {
    type Err = ParseNumberError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let trimmed = text.trim();
        if trimmed.is_empty() {
            return Err(ParseNumberError::Empty);
        }
        let bare = trimmed.trim_start_matches(['+', '-']);
        if ["inf", "infinity", "nan"].iter().any(|word| bare.eq_ignore_ascii_case(word)) {
            return Err(ParseNumberError::NotFinite { text: trimmed.to_owned() });
        }
        let value = match trimmed.split_once('/') {
            Some((numerator, denominator)) => {
                let numerator = parse_decimal(numerator.trim(), trimmed)?;
                let denominator = parse_decimal(denominator.trim(), trimmed)?;
                if denominator.is_zero() {
                    return Err(ParseNumberError::ZeroDenominator { text: shortened(trimmed) });
                }
                numerator / denominator
            }
            None => parse_decimal(trimmed, trimmed)?,
        };
        // For a decimal the standard library finds the nearest double, faster than by division.
        let nearest = trimmed.parse().unwrap_or_else(|_rational| value.to_f64().value());
        let in_range = (Self::SMALLEST..=Self::LARGEST).contains(&nearest.abs()) || value.is_zero();
        if in_range {
            Ok(Self { text: trimmed.to_owned(), value, nearest })
        } else {
            Err(ParseNumberError::OutOfRange { text: shortened(trimmed) })
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl PartialEq for Number {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl Eq for Number {}

impl PartialOrd for Number {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Number {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        // Rounding keeps the order, except where it makes numbers equal.
        match self.nearest.partial_cmp(&other.nearest) {
            Some(order) if order.is_ne() => order,
            _ => self.value.cmp(&other.value),
        }
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.text)
    }
}

impl<'de> Deserialize<'de> for Number {
    /// Reads a string, or a JSON number by its shortest decimal.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumberVisitor;
        impl Visitor<'_> for NumberVisitor {
            type Value = Number;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or a string such as \"1.1\", \"1e-3\" or \"11/10\"")
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<Number, E> {
                text.parse().map_err(E::custom)
            }
            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Number, E> {
                Number::from_f64(value).map_err(E::custom)
            }
            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Number, E> {
                value.to_string().parse().map_err(E::custom)
            }
            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Number, E> {
                value.to_string().parse().map_err(E::custom)
            }
        }
        deserializer.deserialize_any(NumberVisitor)
    }
}

impl schemars::JsonSchema for Number {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A number exactly as it was given: a decimal, a decimal with exponent, or a rational.",
            "type": ["string", "number"]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> RBig {
        text.parse::<Number>().unwrap().value().clone()
    }

    #[test]
    fn decimals_exponents_and_rationals_are_exact() {
        let eleven_tenths = RBig::from_parts(11.into(), 10u8.into());
        for text in ["1.1", "11/10", "11e-1", "+1.10", "0.11e1", ".11E+1", "2.2/2"] {
            assert_eq!(value(text), eleven_tenths, "{text}");
        }
        assert_eq!(value("-3."), RBig::from(-3));
        assert_eq!(value("-0"), RBig::ZERO);
    }

    #[test]
    fn the_text_is_kept_as_written() {
        let number: Number = " 1.10 ".parse().unwrap();
        assert_eq!(number.text(), "1.10");
        assert_eq!(serde_json::to_string(&number).unwrap(), "\"1.10\"");
    }

    #[test]
    fn wrong_texts_are_refused_with_their_reason() {
        let error = |text: &str| text.parse::<Number>().unwrap_err();
        assert_eq!(error("  "), ParseNumberError::Empty);
        assert!(matches!(error("nan"), ParseNumberError::NotFinite { .. }));
        assert!(matches!(error("-inf"), ParseNumberError::NotFinite { .. }));
        assert!(matches!(error("1/0"), ParseNumberError::ZeroDenominator { .. }));
        assert!(matches!(error("1e9999999999999999999"), ParseNumberError::OutOfRange { .. }));
        // Its exponent has no absolute value in 64 bits.
        assert!(matches!(error("1e-9223372036854775808"), ParseNumberError::OutOfRange { .. }));
        assert!(matches!(error("1e-151"), ParseNumberError::OutOfRange { .. }));
        assert!(matches!(error(&"9".repeat(2000)), ParseNumberError::OutOfRange { .. }));
        for text in ["abc", "1.2.3", "1e", "1e+", "--1", "1/2/3", ".", "0x10", "1_000", "1,0"] {
            assert!(matches!(error(text), ParseNumberError::Malformed { .. }), "{text}");
        }
    }

    #[test]
    fn json_numbers_are_read_as_their_shortest_decimal() {
        let number: Number = serde_json::from_str("1.1").unwrap();
        assert_eq!(*number.value(), RBig::from_parts(11.into(), 10u8.into()));
    }
}
