//! The momenta at which relative equilibria are wanted.

use bifdiag_body::Number;
use thiserror::Error;

use crate::cli::input::values;

/// Momenta as the option says them.
#[derive(Clone, Debug, PartialEq)]
pub enum Momenta {
    /// One.
    One(Number),
    /// Equally spaced, both ends included, exact.
    Range { from: Number, to: Number, count: u32 },
}

/// The most momenta of a range.
const MOST: u32 = 10_000_000;

/// Why momenta are refused.
#[derive(Debug, PartialEq, Error)]
pub enum MomentaError {
    #[error("a range of momenta is written a:b:n, such as 0:4:401 for 401 momenta from 0 to 4")]
    Shape,
    #[error("{name}: {source}")]
    End { name: &'static str, source: values::ValueError },
    #[error("{0}")]
    One(values::ValueError),
    #[error("n = `{value}` is not a whole number from 1 to {MOST}")]
    Count { value: String },
    #[error("a = {from} is above b = {to}; write the smaller momentum first")]
    Falling { from: String, to: String },
}

impl Momenta {
    /// Of the text of the option.
    pub fn parse(text: &str) -> Result<Self, MomentaError> {
        if !text.contains(':') {
            return values::number(text).map(Self::One).map_err(MomentaError::One);
        }
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, count] = parts[..] else { return Err(MomentaError::Shape) };
        let end = |name, text| values::number(text).map_err(|source| MomentaError::End { name, source });
        let (from, to) = (end("a", from)?, end("b", to)?);
        if from > to {
            return Err(MomentaError::Falling { from: from.to_string(), to: to.to_string() });
        }
        match count.parse() {
            Ok(count) if (1..=MOST).contains(&count) => Ok(Self::Range { from, to, count }),
            _ => Err(MomentaError::Count { value: count.to_owned() }),
        }
    }

    /// Momentum `k` of a range.
    pub fn at([from, to]: [&Number; 2], count: u32, k: u32) -> Number {
        Number::between(from, to, k, count.max(2) - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_exact() {
        let Ok(Momenta::Range { from, to, count }) = Momenta::parse("0.1:0.4:4") else { panic!("a range") };
        let momenta: Vec<String> = (0..count).map(|k| Momenta::at([&from, &to], count, k).to_string()).collect();
        assert_eq!(momenta, ["1/10", "1/5", "3/10", "2/5"]);
        assert_eq!(Momenta::at([&from, &to], 1, 0).to_string(), "1/10");
    }

    #[test]
    fn wrong_ranges_say_what_is_right() {
        assert_eq!(Momenta::parse("1:2"), Err(MomentaError::Shape));
        assert!(matches!(Momenta::parse("2:1:5"), Err(MomentaError::Falling { .. })));
        assert!(matches!(Momenta::parse("1:2:0"), Err(MomentaError::Count { .. })));
        assert!(matches!(Momenta::parse("1:x:3"), Err(MomentaError::End { name: "b", .. })));
        assert!(matches!(Momenta::parse("x"), Err(MomentaError::One(_))));
    }
}
