//! Names of classes.
//!
//! Why a diagram has no class.

use std::fmt;
use std::str::FromStr;

use crate::arrangement::RegionId;
use crate::topology::merge::MergeError;
use bifdiag_equilibria::curves::CurveId;
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

/// So many things, in words.
fn in_arrangement(count: usize) -> String {
    match count {
        1 => "one thing about the arrangement is".to_owned(),
        _ => format!("{count} things about the arrangement are"),
    }
}

/// Why an atlas has no class.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Unclassified {
    /// Something in the arrangement is undecided: the diagram is one of several.
    #[error("{} undecided at this accuracy, so its class is open", in_arrangement(*count))]
    Undecided {
        /// How many.
        count: usize,
    },
    /// The type of a region is not known.
    #[error("the type of region {region} is undecided at this accuracy: {source}")]
    Region {
        /// The region.
        region: RegionId,
        /// Why.
        source: MergeError,
    },
    /// The pieces of the arrangement do not make a planar map: a defect of this program.
    #[error(transparent)]
    Map(#[from] MapError),
}

/// The pieces do not fit together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum MapError {
    /// There are no slabs or no curves.
    #[error("the arrangement is empty")]
    Empty,
    /// Several events are proved to lie in one point or at one l, so that the orders between them are not known one by
    /// one.
    #[error("several events coincide, in one point or at one l, as on a border between classes")]
    Coincident,
    /// A curve begins or ends in the middle of the plane without an event.
    #[error("{curve:?} begins or ends where no event is")]
    LooseEnd {
        /// The curve.
        curve: CurveId,
    },
    /// Euler's formula fails or a face is not bounded by one cycle.
    #[error("{vertices} vertices, {edges} edges and {faces} faces with {cycles} boundaries are no map on the sphere")]
    NotPlanar {
        /// Vertices, those of the frame included.
        vertices: usize,
        /// Edges, those of the frame included.
        edges: usize,
        /// Faces, the outside included.
        faces: usize,
        /// Cycles of darts around faces.
        cycles: usize,
    },
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
