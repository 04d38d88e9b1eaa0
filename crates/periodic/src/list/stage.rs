//! How far the search for the orbits at a point has come.

/// A stage of the search, as it is shown to whoever waits for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stage {
    /// P is being covered with squares.
    Cover {
        /// Squares so far.
        squares: usize,
        /// Those whose rim has been checked to lie within others.
        checked: usize,
    },
    /// The squares are being searched, cell by cell.
    Cells {
        /// Cells examined so far.
        examined: usize,
        /// Cells still to be examined, as far as they are known: each may have to be cut into four.
        open: usize,
        /// The share of the squares' area that has been decided.
        decided: f64,
    },
    /// The orbits that were found are being proved.
    Proofs {
        /// Orbits already tried.
        tried: usize,
        /// All orbits found.
        found: usize,
    },
}
