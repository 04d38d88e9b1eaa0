//! Places on families of relative equilibria, as certificates write them.

use dashu_ratio::RBig;

use super::spaces::Spaces;
use crate::numbers::fixed::Fixed;
use crate::numbers::number;
use bifdiag_schema::PlaceDocument;

/// A half of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// μ = a + y.
    Plus,
    /// μ = a − y.
    Minus,
    /// v = P̂ + y over a space without r.
    Over,
}

/// A range of places, as exact numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    pub base: usize,
    pub side: Side,
    pub lo: RBig,
    pub hi: RBig,
}

impl Place {
    /// A place whose base is a space and whose ends are numbers in order.
    pub fn read(document: &PlaceDocument, spaces: &Spaces) -> Option<Self> {
        let side = match document.side.as_str() {
            "+" => Side::Plus,
            "-" => Side::Minus,
            "over" => Side::Over,
            _ => return None,
        };
        let [lo, hi] = document.y.each_ref().map(|text| number::exact(text));
        let (lo, hi) = (lo?, hi?);
        (lo <= hi && document.base < spaces.list.len()).then_some(Self { base: document.base, side, lo, hi })
    }

    pub fn y(&self, spaces: &Spaces) -> Fixed {
        spaces.set(&self.lo).hull(&spaces.set(&self.hi))
    }

    /// The range of μ (of y over a space without r).
    pub fn range(&self, spaces: &Spaces) -> [RBig; 2] {
        let a = &spaces.list[self.base].a;
        match self.side {
            Side::Plus => [a + &self.lo, a + &self.hi],
            Side::Minus => [a - &self.hi, a - &self.lo],
            Side::Over => [self.lo.clone(), self.hi.clone()],
        }
    }
}
