//! Numbers of events, slabs and regions.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use bifdiag_numbers::table::{Id, ids};

ids! {
    /// An event, by rising x.
    EventId;
    /// A slab, by rising x.
    SlabId;
    /// A region of the half-plane l > 0, by its first appearance as l, then h rise; written `R1`, `R2`, …
    RegionId;
}

impl SlabId {
    /// The slab that ends at an event, where each event has two slabs of its own.
    #[must_use]
    pub fn ending_at(event: EventId) -> Self {
        Self(event.0)
    }

    /// The slab that begins at an event, where each event has two slabs of its own.
    #[must_use]
    pub fn starting_at(event: EventId) -> Self {
        Self(event.0 + 1)
    }

    /// The slab before it.
    #[must_use]
    pub fn before(self) -> Option<Self> {
        self.0.checked_sub(1).map(Self)
    }

    /// The slab after it.
    #[must_use]
    pub fn after(self) -> Self {
        Self(self.0 + 1)
    }
}

/// A cell: the part of a region in one slab, above the curve at this position of the slab's order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Cell {
    /// The slab.
    pub slab: SlabId,
    /// Position, from below, of the curve below the cell.
    pub position: usize,
}

impl fmt::Display for RegionId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "R{}", self.0 + 1)
    }
}

/// A text that is no region's name.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` does not name a region; names are R1, R2, …")]
pub struct ParseRegionIdError(String);

impl FromStr for RegionId {
    type Err = ParseRegionIdError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let number = text.strip_prefix('R').filter(|digits| digits.starts_with(|c: char| ('1'..='9').contains(&c)));
        let index = number.and_then(|digits| digits.parse::<usize>().ok());
        index.map(|number| Self::at(number - 1)).ok_or_else(|| ParseRegionIdError(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_regions_are_read_back() {
        assert_eq!("R5".parse::<RegionId>().unwrap(), RegionId::at(4));
        assert_eq!(RegionId::at(4).to_string(), "R5");
        for text in ["", "R", "R0", "5", "r5", "R+5", "R05", "R5 ", "R99999999999999999999999"] {
            assert_eq!(text.parse::<RegionId>(), Err(ParseRegionIdError(text.to_owned())));
        }
    }
}
