//! Bodies on the two sides of a border.

use std::fmt;

use thiserror::Error;

use super::segment::Segment;
use proof::{Accuracy, NoAtlas, atlas_of};
use top::atlas::Atlas;
use top::class::{Class, Unclassified};

/// An end of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// t = 0.
    Lower,
    /// t = 1.
    Upper,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Lower { "lower" } else { "upper" })
    }
}

/// Why a body has no class.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum NoClass {
    /// It has no atlas.
    #[error(transparent)]
    Atlas(#[from] NoAtlas),
    /// Its diagram is open.
    #[error(transparent)]
    Diagram(#[from] Unclassified),
}

/// A body of a segment with its atlas and class.
pub(super) struct Side {
    pub t: f64,
    pub atlas: Atlas,
    pub class: Class,
}

impl Side {
    pub(super) fn of(segment: &Segment, t: f64, accuracy: Accuracy) -> Result<Self, NoClass> {
        let atlas = atlas_of(&segment.body(t), accuracy)?;
        let class = Class::of(&atlas)?;
        Ok(Self { t, atlas, class })
    }
}
