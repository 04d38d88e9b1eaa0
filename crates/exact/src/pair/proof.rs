//! What is proved of a pair of curves.

use dashu_ratio::RBig;

use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::Sign;

/// How many points of curves the order of two curves may cost in one precision: a count of work, so that the answer does
/// not depend on the machine.
pub(crate) const POINTS: u32 = 4000;

/// What ends a stretch.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Mark {
    /// The lower or upper end of the common range.
    End,
    /// This x.
    At(RBig),
}

/// A stretch with a proved sign of h_a − h_b, or with one crossing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stretch {
    pub x: [Mark; 2],
    /// Sign at the lower end.
    pub sign: Sign,
    pub proof: Proof,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Proof {
    /// One sign all along.
    Constant,
    /// The gap is monotone and vanishes once, between these two.
    Crossing([RBig; 2]),
}

/// Everything about one pair.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PairProof {
    pub curves: [CurveId; 2],
    pub stretches: Vec<Stretch>,
}

/// What was not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Open {
    pub x: [f64; 2],
}
