//! Names of classes.

use std::fmt;
use std::str::FromStr;

use sha2::{Digest, Sha256};
use thiserror::Error;

/// Hexadecimal digits of a name.
const DIGITS: usize = 12;

/// The name of a class: the first 12 hexadecimal digits of the SHA-256 of its canonical form.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ClassName(String);

/// A text that is not the name of a class.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is not the name of a class; a name is 12 hexadecimal digits such as 4b99dc25201f")]
pub struct ParseClassNameError(String);

impl ClassName {
    /// Of a canonical form.
    pub(super) fn of_text(text: &str) -> Self {
        let mut name = base16ct::lower::encode_string(&Sha256::digest(text.as_bytes()));
        name.truncate(DIGITS);
        Self(name)
    }

    /// The digits.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for ClassName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl FromStr for ClassName {
    type Err = ParseClassNameError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let is_digit = |byte: u8| matches!(byte, b'0'..=b'9' | b'a'..=b'f');
        if text.len() == DIGITS && text.bytes().all(is_digit) {
            Ok(Self(text.to_owned()))
        } else {
            Err(ParseClassNameError(text.to_owned()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_beginning_of_the_sha_256_of_the_text() {
        // FIPS 180-4, the message "abc".
        assert_eq!(ClassName::of_text("abc").as_str(), "ba7816bf8f01");
    }

    #[test]
    fn only_twelve_lower_case_digits_are_a_name() {
        assert_eq!("4b99dc25201f".parse::<ClassName>().unwrap().to_string(), "4b99dc25201f");
        for wrong in ["", "4b99dc25201", "4b99dc25201f0", "4B99DC25201F", "4b99dc25201g"] {
            assert_eq!(wrong.parse::<ClassName>(), Err(ParseClassNameError(wrong.to_owned())));
        }
    }
}
