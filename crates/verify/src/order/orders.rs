//! What is known when two curves are compared.

use bifdiag_schema::PlaceDocument;

use super::stand::{Stand, stand};
use crate::Refused;
use crate::equilibria::pieces::{Branch, Pieces};
use crate::equilibria::point::Point;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;

/// What is known when curves are compared.
pub(crate) struct Orders<'a> {
    pub spaces: &'a Spaces,
    pub pieces: &'a Pieces,
    /// The branch of the generic family on which dJ/dμ = 0 once, and the equilibrium there.
    pub inflection: Option<(usize, Point)>,
    /// (curve, side, other): the other passes exactly through this end.
    pub meetings: Vec<(usize, usize, usize)>,
}

impl Orders<'_> {
    /// The equilibrium of a curve over x.
    pub fn stand(&self, curve: usize, place: Option<&PlaceDocument>, x: &Fixed) -> Result<Stand, Refused> {
        stand(self.spaces, self.pieces, curve, place, x)
    }

    /// The inflection, if it lies on the branch of a curve.
    pub fn turn(&self, curve: usize) -> Option<&Point> {
        let (branch, bend) = self.inflection.as_ref()?;
        (self.pieces.list[curve].branch == Branch::Generic(*branch)).then_some(bend)
    }

    /// The refusal of a pair near x.
    pub fn refused(&self, curves: [usize; 2], x: f64, why: &'static str) -> Refused {
        Refused::Pair { curves: curves.map(|c| self.pieces.list[c].id.clone()), x, why }
    }
}
