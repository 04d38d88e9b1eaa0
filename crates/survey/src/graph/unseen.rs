//! What a walk has not met yet.

/// Estimates from how often each class was met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unseen {
    /// Classes that were met once.
    pub once: u64,
    /// Classes that were met twice.
    pub twice: u64,
    /// The chance that the next meeting is with a class not met before: once / meetings (Good and Turing; I. J. Good,
    /// Biometrika 40, 1953).
    pub chance: f64,
    /// A lower bound on the number of classes not met, once (once − 1) / (2 (twice + 1)) (A. Chao, *Nonparametric
    /// estimation of the number of classes in a population*, Scand. J. Statist. 11, 1984; the form without bias).
    pub classes: f64,
}

impl Unseen {
    /// From the number of meetings with each class.
    #[must_use]
    pub fn of(meetings: impl Iterator<Item = u64>) -> Self {
        let (mut once, mut twice, mut all) = (0_u64, 0_u64, 0_u64);
        for count in meetings {
            all += count;
            once += u64::from(count == 1);
            twice += u64::from(count == 2);
        }
        let chance = if all == 0 { 1.0 } else { once as f64 / all as f64 };
        let classes = (once * once.saturating_sub(1)) as f64 / (2.0 * (twice + 1) as f64);
        Self { once, twice, chance, classes }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_met_once_tells_what_was_not_met() {
        let unseen = Unseen::of([1, 1, 1, 2, 5, 90].into_iter());
        assert_eq!((unseen.once, unseen.twice, unseen.chance, unseen.classes), (3, 1, 0.03, 1.5));
        assert_eq!(Unseen::of([4, 9].into_iter()).classes, 0.0);
    }
}
