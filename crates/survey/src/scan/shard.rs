//! One of n parts of a scan.

use std::str::FromStr;

use thiserror::Error;

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
        let (number, count) = (whole(number)?, whole(count)?);
        if (1..=count).contains(&number) { Ok(Self { number, count }) } else { Err(ParseShardError) }
    }
}

impl Shard {
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
