//! Staude's curve γ = ± adj(μ − A) r/√p, cut by the level U = h.

use super::latitude::Latitude;
use super::strand::{Piece, runs};

/// The curve's ridges and valleys, with what is inside U_hl. Its two signs are images of each other under γ → −γ.
#[derive(Debug)]
pub(super) struct Cut<L> {
    /// ω of the positive sign where U = h on either sign of the curve, by rising μ, without the fold.
    pub roots: Vec<L>,
    /// So many roots lie below the fold.
    pub valley_roots: usize,
    /// ω of the positive sign where ridge and valley meet.
    pub fold: L,
    /// For each sign, whether the gaps between roots and fold lie in U_hl.
    pub inside: [Vec<bool>; 2],
}

impl<L: Latitude> Cut<L> {
    /// Pieces of the ridge, μ above the fold, in terms of ω, which rises with μ: the lower end is the fold, the upper the
    /// pole.
    pub fn ridges(&self, sign: usize) -> Vec<Piece<L>> {
        Self::pieces(&self.roots[self.valley_roots..], &self.inside[sign][self.valley_roots + 1..])
    }

    /// Pieces of the valley, by rising μ: the upper end is the fold.
    pub fn valleys(&self, sign: usize) -> Vec<Piece<L>> {
        Self::pieces(&self.roots[..self.valley_roots], &self.inside[sign][..=self.valley_roots])
    }

    fn pieces(roots: &[L], gaps: &[bool]) -> Vec<Piece<L>> {
        let end = |root: Option<usize>| root.map(|root| roots[root].clone());
        runs(gaps).into_iter().map(|ends| Piece { ends: ends.map(end) }).collect()
    }
}
