//! The parameters of a body that can vary.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// One coordinate of (A, r).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Parameter {
    /// A1.
    A1,
    /// A2.
    A2,
    /// A3.
    A3,
    /// r1.
    R1,
    /// r2.
    R2,
    /// r3.
    R3,
}

/// A text that names no parameter.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{text}` is no parameter of a body; the parameters are A1, A2, A3, r1, r2, r3")]
pub struct ParseParameterError {
    /// What was written.
    pub text: String,
}

impl Parameter {
    /// All six.
    pub const ALL: [Self; 6] = [Self::A1, Self::A2, Self::A3, Self::R1, Self::R2, Self::R3];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["A1", "A2", "A3", "r1", "r2", "r3"][self.place()]
    }

    /// Its place in (A1, A2, A3, r1, r2, r3).
    #[must_use]
    pub fn place(self) -> usize {
        match self {
            Self::A1 => 0,
            Self::A2 => 1,
            Self::A3 => 2,
            Self::R1 => 3,
            Self::R2 => 4,
            Self::R3 => 5,
        }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Parameter {
    type Err = ParseParameterError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|parameter| parameter.name() == text.trim());
        found.ok_or_else(|| ParseParameterError { text: text.trim().to_owned() })
    }
}
