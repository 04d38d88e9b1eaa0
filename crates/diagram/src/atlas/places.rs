//! Which regions of an atlas a classified point lies in, or meets.
//!
//! Many points at one l: the heights of the curves are computed once.
//!
//! Exact decisions: points that lie on a straight curve, by rational arithmetic.

use super::locate::{Place, comparison_error, each};
use super::{Atlas, Component};
use crate::arrangement::{RegionId, SlabId};
use crate::topology::Answer;
use bifdiag_body::{Body, Number};
use bifdiag_equilibria::curves::{CurveName, MomentumError, Pole, abscissa};
use bifdiag_numbers::table::Id;
use dashu_ratio::RBig;
use thiserror::Error;

/// Where curves start: below this x = l²/2 every curve from l = 0 is at its limit to the last bit.
const AT_REST: f64 = 1e-60;

/// The curves over one x by name, on both sides of an energy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sides {
    /// Those below it.
    pub below: Vec<CurveName>,
    /// Those above it.
    pub above: Vec<CurveName>,
}

/// Why no region is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("no region of the atlas near the point alone has the curves on both sides that the point has")]
pub struct CellError;

impl Sides {
    /// The region of the cell that has these curves below and above it, in a slab with these curves by rising h; `None` for
    /// the forbidden one.
    ///
    /// # Errors
    /// [`CellError`] where the slab has other curves, or no such cell.
    pub fn cell(&self, order: &[CurveName], region_above: &[RegionId]) -> Result<Option<RegionId>, CellError> {
        let (below, above) = order.split_at_checked(self.below.len()).ok_or(CellError)?;
        let same = |there: &[CurveName], names: &[CurveName]| {
            there.len() == names.len() && there.iter().all(|name| names.contains(name))
        };
        let fits = same(below, &self.below) && same(above, &self.above);
        if fits { Ok(below.len().checked_sub(1).map(|highest| region_above[highest])) } else { Err(CellError) }
    }

    /// The one region of all the cells in some slabs that have these curves on both sides.
    ///
    /// # Errors
    /// [`CellError`] where there is none, or more than one.
    pub fn only<'a>(
        &self,
        slabs: impl Iterator<Item = (Vec<CurveName>, &'a [RegionId])>,
    ) -> Result<Option<RegionId>, CellError> {
        let mut cells = slabs.filter_map(|(order, region_above)| self.cell(&order, region_above).ok());
        let first = cells.next().ok_or(CellError)?;
        if cells.all(|cell| cell == first) { Ok(first) } else { Err(CellError) }
    }
}

impl Atlas {
    /// The regions at a point of known type, each once; `None` in the list is the forbidden region. A regular or forbidden
    /// point has one; a point on a curve each that meets there, and those within rounding that are of the same types. `None`
    /// where `f64` does not decide: what this atlas knows of the regions near the point does not fit the answer, or fits it twice.
    #[must_use]
    pub fn places(&self, h: &Number, l: &Number, answer: &Answer) -> Option<Vec<Option<RegionId>>> {
        let frame = &self.arrangement.set.frame;
        let at_rest = l.value().is_zero();
        let x = abscissa(frame, l.to_f64()).ok()?.max(AT_REST);
        let near = match self.locate_scaled(h.to_f64() / frame.energy_unit, x).place {
            _ if at_rest && matches!(answer, Answer::Regular(_)) => vec![Some(self.region_at_rest(h)?)],
            // Without weight every curve begins at h = l = 0.
            _ if at_rest && frame.is_euler() && matches!(answer, Answer::Critical(_)) => {
                let above = &self.arrangement.slabs[SlabId::at(0)].region_above;
                std::iter::once(None).chain(above.iter().copied().map(Some)).collect()
            }
            Place::Region(region) => vec![Some(region)],
            Place::Forbidden => vec![None],
            Place::Undecided(places) => places,
        };
        let fits = |&place: &Option<RegionId>| self.class(place).is_some_and(|class| answer.allows(class));
        let there: Vec<_> = near.into_iter().filter(fits).collect();
        match answer {
            Answer::Regular(_) | Answer::Forbidden => (there.len() == 1).then_some(there),
            Answer::Critical(classes) | Answer::Undecided(classes) => {
                let found = |class: &Vec<Component>| there.iter().any(|&place| self.class(place) == Some(class));
                classes.iter().all(found).then_some(there)
            }
        }
    }

    /// The regions just below and just above a curve at l, of which `None` is the forbidden one. No answer where the curve is not
    /// there, or where `f64` does not decide on which side of an event l lies at which they change.
    #[must_use]
    pub fn beside(&self, curve: CurveName, l: f64) -> Option<[Option<RegionId>; 2]> {
        let set = &self.arrangement.set;
        let x = abscissa(&set.frame, l).ok()?;
        let in_slab = |slab| {
            let strip = &self.arrangement.slabs[slab];
            let place = strip.order.iter().position(|&other| CurveName::of(set, other) == curve)?;
            Some([place.checked_sub(1).map(|below| strip.region_above[below]), Some(strip.region_above[place])])
        };
        let mut found = each(self.slabs_near(self.slab_at(x), x, true)).map(in_slab);
        let first = found.next().flatten()?;
        found.all(|other| other == Some(first)).then_some(first)
    }

    /// The components of U_hl in a region, none in the forbidden one; `None` where they are not known.
    #[must_use]
    pub fn class(&self, place: Option<RegionId>) -> Option<&[Component]> {
        place.map_or(Some(&[]), |region| self.components(region).ok())
    }

    /// The region above h > −r at l = 0, h no critical value: every curve from l = 0 begins at −r or at r.
    fn region_at_rest(&self, h: &Number) -> Option<RegionId> {
        let first = SlabId::at(0);
        let points = self.points_in(first, AT_REST);
        let below = if compare_with_r(&self.body, h).is_lt() {
            points.iter().filter(|point| point.h() < 0.0).count()
        } else {
            points.len()
        };
        self.arrangement.slabs[first].region_above.get(below.checked_sub(1)?).copied()
    }

    /// The curves of each slab by rising h, by name.
    #[must_use]
    pub fn orders(&self) -> impl ExactSizeIterator<Item = Vec<CurveName>> {
        self.arrangement.slabs.ids().map(|slab| self.order_of(slab))
    }

    fn order_of(&self, slab: SlabId) -> Vec<CurveName> {
        let name = |&curve: &_| CurveName::of(&self.arrangement.set, curve);
        self.arrangement.slabs[slab].order.iter().map(name).collect()
    }

    /// The region at a point off the curves over x = l²/2 in the frame's units, with these curves on both sides of it; `None`
    /// for the forbidden region.
    ///
    /// # Errors
    /// [`CellError`] where no slab within rounding of x has such a cell, or such cells are in several regions.
    pub fn region_between(&self, x: f64, sides: &Sides) -> Result<Option<RegionId>, CellError> {
        let near = each(self.slabs_near(self.slab_at(x), x, true));
        sides.only(near.map(|slab| (self.order_of(slab), self.arrangement.slabs[slab].region_above.as_slice())))
    }
}

/// Where a point of a row lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// Inside this region.
    Region(RegionId),
    /// Below the lowest critical value.
    Forbidden,
    /// Exactly on a curve.
    Critical,
    /// Not known.
    Undecided,
}

impl Atlas {
    /// Where each (h, l) of a row lies. The curves decide where they are farther than their error bounds; nearer points, and
    /// rows at l = 0 or within rounding of an event, are passed to `decide`: each double denotes its shortest decimal.
    ///
    /// # Errors
    /// [`MomentumError`] when l is out of range.
    pub fn row(
        &self,
        l: f64,
        h: &[f64],
        mut decide: impl FnMut(&Number, &Number) -> Spot,
    ) -> Result<Vec<Spot>, MomentumError> {
        let frame = &self.arrangement.set.frame;
        let x = abscissa(frame, l)?;
        let slab = self.slab_at(x);
        let near = self.slabs_near(slab, x, true);
        let clear = x > 0.0 && near.start() == near.end() && self.order_is_certain(slab, x);
        let points = if clear { self.points_in(slab, x) } else { Vec::new() };
        let region_above = &self.arrangement.slabs[slab].region_above;
        let mut ask = |h: f64| {
            let (Ok(h), Ok(l)) = (Number::from_f64(h), Number::from_f64(l)) else { return Spot::Undecided };
            decide(&h, &l)
        };
        let spots = h.iter().map(|&given| {
            let h = given / frame.energy_unit;
            let below = points.partition_point(|point| point.h() <= h);
            let far = |point: &_| (h - bifdiag_equilibria::curves::Point::h(point)).abs() > comparison_error(point, h);
            let sides = below.checked_sub(1).and_then(|k| points.get(k)).into_iter().chain(points.get(below));
            if !clear || !sides.into_iter().all(far) {
                return ask(given);
            }
            below.checked_sub(1).map_or(Spot::Forbidden, |k| Spot::Region(region_above[k]))
        });
        Ok(spots.collect())
    }
}

/// A straight curve of the diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StraightCurve {
    /// h = l²/(2 J_r) ∓ r, the pole line of ±r̂.
    PoleLine(Pole),
    /// h = l²/(2 A_i) of a body with r = 0.
    AxisLine,
}

/// The straight curve on which a point lies exactly.
#[must_use]
pub fn straight_curve_at(body: &Body, h: &Number, l: &Number) -> Option<StraightCurve> {
    let x = l.value() * l.value() / RBig::from(2);
    let norm_squared = body.center_squared();
    if norm_squared.is_zero() {
        return on_axis_line(body, h.value(), &x).then_some(StraightCurve::AxisLine);
    }
    // J_r = Σ r_i² A_i / r².
    let offset = h.value() - x * &norm_squared / body.weighted_moment();
    let pole = if offset < RBig::ZERO { Pole::Plus } else { Pole::Minus };
    (&offset * &offset == norm_squared).then_some(StraightCurve::PoleLine(pole))
}

/// h = x / A_i for a body with r = 0: x/h is a moment.
fn on_axis_line(body: &Body, h: &RBig, x: &RBig) -> bool {
    if h.is_zero() {
        return false;
    }
    let at = x / h;
    match body.tensor() {
        Some(tensor) => {
            let powers = tensor.matrix().characteristic();
            powers.iter().rev().fold(RBig::ZERO, |sum, c| sum * &at + c).is_zero()
        }
        None => body.moments().iter().any(|a| *a.value() == at),
    }
}

/// Compares |h| with r, exactly: for l = 0 the critical values are ∓r.
#[must_use]
pub fn compare_with_r(body: &Body, h: &Number) -> std::cmp::Ordering {
    (h.value() * h.value()).cmp(&body.center_squared())
}
