//! What an answer is worth.

#[derive(Clone, Copy, PartialEq)]
pub enum Verdict {
    Right,
    Wrong,
    Undecided,
    /// No answer at all.
    Failed,
    /// Nothing that is known contradicts it, and no more is known.
    Unknown,
}

pub const ALL: [Verdict; 5] = [Verdict::Right, Verdict::Wrong, Verdict::Undecided, Verdict::Failed, Verdict::Unknown];

/// How often each of some verdicts was given, as cells of a table.
pub fn counts(given: &[Verdict], listed: &[Verdict]) -> String {
    let count = |verdict| given.iter().filter(|other| **other == verdict).count().to_string();
    listed.iter().copied().map(count).collect::<Vec<_>>().join(",")
}
