//! One number, or a range of them.

use bifdiag_body::Number;

use super::values;
use crate::cli::failure::Failure;

/// Numbers or energies as the option says them.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    /// One.
    One(Number),
    /// Equally spaced, both ends included, exact.
    Range { from: Number, to: Number, count: u32 },
}

/// The most numbers of a range.
const MOST: u32 = 10_000_000;

impl Numbers {
    /// Parses the option.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        if !text.contains(':') {
            return values::number(text).map(Self::One);
        }
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, count] = parts[..] else {
            return Err(Failure::input("a range is written a:b:n, such as 0:4:401 for 401 numbers from 0 to 4"));
        };
        let end = |name, text| values::number(text).map_err(|error| Failure::input(format!("{name}: {error}")));
        let (from, to) = (end("a", from)?, end("b", to)?);
        if from > to {
            return Err(Failure::input(format!("a = {from} is above b = {to}; write the smaller number first")));
        }
        match count.trim().parse() {
            Ok(count) if (1..=MOST).contains(&count) => Ok(Self::Range { from, to, count }),
            _ => Err(Failure::input(format!("n = `{count}` is not a whole number from 1 to {MOST}"))),
        }
    }

    /// All of them.
    pub fn list(&self) -> Vec<Number> {
        match self {
            Self::One(number) => vec![number.clone()],
            Self::Range { from, to, count } => (0..*count).map(|k| Self::at([from, to], *count, k)).collect(),
        }
    }

    /// Number `k` of a range.
    pub fn at([from, to]: [&Number; 2], count: u32, k: u32) -> Number {
        Number::between(from, to, k, count.max(2) - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_exact() {
        let Ok(Numbers::Range { from, to, count }) = Numbers::parse("0.1:0.4:4") else { panic!("a range") };
        let numbers: Vec<String> = (0..count).map(|k| Numbers::at([&from, &to], count, k).to_string()).collect();
        assert_eq!(numbers, ["1/10", "1/5", "3/10", "2/5"]);
        assert_eq!(Numbers::at([&from, &to], 1, 0).to_string(), "1/10");
    }

    #[test]
    fn wrong_ranges_say_what_is_right() {
        let wrong = |text| Numbers::parse(text).unwrap_err().to_string();
        assert!(wrong("1:2").starts_with("a range is written a:b:n"));
        assert!(wrong("2:1:5").starts_with("a = 2 is above b = 1"));
        assert!(wrong("1:2:0").starts_with("n = `0` is not a whole number"));
        assert!(wrong("1:x:3").starts_with("b: `x` is not a number"));
        assert!(wrong("x").starts_with("`x` is not a number"));
    }
}
