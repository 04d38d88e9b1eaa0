//! Many bodies: what a scan records of each, and what all of them have in common.
//!
//! A [`Design`](crate::Design) numbers its bodies; body n depends on n alone, so that a scan can be cut into shards,
//! interrupted and resumed. [`ScanRow::of`] classifies one body, a [`Summary`] counts. Nothing here reads files or
//! starts threads.

mod row;
mod summary;

pub use row::{DiagramCounts, RegionMargin, ScanRow};
use std::collections::BTreeMap;
use std::str::FromStr;
pub use summary::{ClassRecord, Summary, class_text};

use thiserror::Error;

use bifdiag_body::Preset;
use bifdiag_diagram::class::{Class, ClassName};
use bifdiag_exact::Accuracy;

/// The classes of the named bodies; of several bodies of one class the first.
#[must_use]
pub fn known_classes() -> BTreeMap<ClassName, &'static Preset> {
    let mut known = BTreeMap::new();
    for preset in Preset::all() {
        let class = bifdiag_exact::atlas(&preset.body(), Accuracy::Fast).ok().and_then(|atlas| Class::of(&atlas).ok());
        if let Some(class) = class {
            known.entry(class.name().clone()).or_insert(preset);
        }
    }
    known
}

/// Part `number` (from 1) of `count`: consecutive bodies, as many as in any other part, give or take one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    number: u64,
    count: u64,
}

/// A text that is no shard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("a shard is written i/n with 1 ≤ i ≤ n, such as 3/16")]
pub struct ParseShardError;

impl FromStr for Shard {
    type Err = ParseShardError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (number, count) = text.split_once('/').ok_or(ParseShardError)?;
        let whole = |text: &str| text.trim().parse::<u64>().map_err(|_not_whole| ParseShardError);
        Self::new(whole(number)?, whole(count)?).ok_or(ParseShardError)
    }
}

impl Shard {
    /// `None` where there is no such part.
    #[must_use]
    pub fn new(number: u64, count: u64) -> Option<Self> {
        (1..=count).contains(&number).then_some(Self { number, count })
    }

    /// The bodies of this part of a scan of `bodies`: from, and up to but without.
    #[must_use]
    pub fn range(self, bodies: u64) -> [u64; 2] {
        let cut = |part: u64| {
            let exact = u128::from(bodies) * u128::from(part) / u128::from(self.count);
            u64::try_from(exact).unwrap_or(bodies)
        };
        [cut(self.number - 1), cut(self.number)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_cover_everything_once() {
        for bodies in [0, 1, 5, 10, 1_000_003] {
            for count in [1, 2, 3, 7, 16] {
                let mut next = 0;
                for number in 1..=count {
                    let [from, to] = Shard { number, count }.range(bodies);
                    assert_eq!(from, next);
                    assert!(to - from <= bodies.div_ceil(count));
                    next = to;
                }
                assert_eq!(next, bodies);
            }
        }
        for wrong in ["0/3", "4/3", "1-3", "1/", "1/2/3", "-1/3"] {
            assert_eq!(wrong.parse::<Shard>(), Err(ParseShardError), "{wrong}");
        }
    }
}
