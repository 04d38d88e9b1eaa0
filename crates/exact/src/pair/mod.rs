//! The order of two critical curves over all their common range of x: stretches on which the sign of h_a − h_b is proved,
//! and crossings, each alone in its box.
//!
//! On a stretch the slopes 1/J lie between their end values (J is monotone except at one known place). If they are
//! disjoint, the gap is monotone and its signs at the ends decide whether the curves cross, once. Otherwise the gap is
//! bounded from one end, by the identity of [`Evaluator::range_sign`](crate::evaluator::Evaluator::range_sign), by the
//! lemmas of `mirror`, or by what both points share over one x (`equal_momentum`); otherwise the stretch is halved. Where r lies on
//! an axis, families over moments are ordered all at once (`axis`). Both ends of the half-line are closed by limits: a
//! common cusp by the monotony of J through it, a common pitchfork by curvature, x → ∞ by the limits of slope and of
//! h − x/a.

mod crossing;
mod infinity;
mod moments;
mod node;
mod ordering;
mod side;
mod stretch;
#[cfg(test)]
mod tests;

pub(crate) use node::{Open, POINTS, PairProof, Proof, Stretch, StretchEnd};
