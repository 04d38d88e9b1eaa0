//! What an answer is worth.

#[derive(Clone, Copy, PartialEq)]
pub enum Verdict {
    Right,
    Wrong,
    Undecided,
    /// No answer at all.
    Failed,
    /// More is not known than that nothing known speaks against it.
    Untold,
}

pub const ALL: [Verdict; 5] = [Verdict::Right, Verdict::Wrong, Verdict::Undecided, Verdict::Failed, Verdict::Untold];

/// How often each of some verdicts was given, as cells of a table.
pub fn counts(given: &[Verdict], told: &[Verdict]) -> String {
    let count = |verdict| given.iter().filter(|other| **other == verdict).count().to_string();
    told.iter().copied().map(count).collect::<Vec<_>>().join(",")
}
