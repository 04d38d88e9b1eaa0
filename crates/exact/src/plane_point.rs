//! One point (h, l), decided exactly: signs against every height over l, and the topology between them.
//!
//! The regions at a point where `f64` does not separate them: from the curves on both sides of it, by name.
//!
//! A cell of the plane is identified by its x and the set of curves below it: within a slab that set grows with the cell. So the
//! exact signs of h against every height over x name the cell, and the atlas names its region.

use super::critical_values::{CriticalValue, CriticalValues};
use super::model::{Model, exact_unit};
use super::plane::{Gap, Open, Plane};
use super::vertex::{self, Vertex};
use crate::CertifiedAtlas;
use crate::id::TransitionId;
use bifdiag_body::{Body, Frame, Number};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::{Atlas, CellError, Sides};
use bifdiag_diagram::fast::at_rest;
use bifdiag_diagram::topology::{Classification, Margin};
use bifdiag_equilibria::curves::CurveName;
use bifdiag_numbers::Sign;
use dashu_ratio::RBig;
use thiserror::Error;

/// A point of the plane in the frame's units.
pub(crate) struct PlanePoint {
    /// l²/2.
    pub x: RBig,
    pub h: RBig,
}

impl PlanePoint {
    /// (h, l) in the body's units.
    pub fn scaled(frame: &Frame, h: &Number, l: &Number) -> Self {
        let momentum = l.value() / exact_unit(frame.momentum_unit);
        Self { x: &momentum * &momentum / RBig::from(2), h: h.value() / exact_unit(frame.energy_unit) }
    }
}

/// The type of one point, decided: regular, forbidden, or proved to lie on a curve.
///
/// # Errors
/// [`Open`]: what could not be decided within the largest precision.
pub fn classify_exactly(body: &Body, h: &Number, l: &Number) -> Result<Classification, Open> {
    if l.value().is_zero() {
        return Ok(at_rest(body, h));
    }
    let frame = body.frame();
    let model = Model::new(body, &frame);
    let PlanePoint { x, h: energy } = PlanePoint::scaled(&frame, h, l);
    let plane = Plane::new(&model, &frame);
    let mut heights = CriticalValues::new(&model, x.clone());
    let levels = heights.against(&energy).map_err(|none| plane.open(none, &x))?;
    let margin = margin(&plane, heights.nearest(&levels, &energy), &x);
    if levels.iter().any(|level| level.sign == Sign::Zero) {
        let vertex = Vertex { plane: &plane, heights: &heights, h: &energy, levels: &levels };
        return Ok(Classification::open(true, vertex::candidates(&vertex)?, margin));
    }
    Ok(Classification::decided(plane.class(&x, &Gap::around(&levels))?, margin))
}

/// The distance to the nearest curve.
fn margin(plane: &Plane<'_>, nearest: Option<CriticalValue>, x: &RBig) -> Margin {
    let unit = plane.frame.energy_unit;
    let Some(level) = nearest else { return Margin { h: 0.0, nearest: None, error_bound: 0.0 } };
    let [lo, hi] = level.distance.map(|distance| distance * unit);
    // A distance that is not 0 may be below all doubles.
    let rounding = if level.sign != Sign::Zero && lo < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { 0.0 };
    Margin { h: lo, nearest: Some(plane.name(&level.source, x)), error_bound: hi - lo + rounding }
}

/// Why the regions at a point are not known.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PlaceError {
    /// There is no atlas.
    #[error("no atlas of this body was made")]
    NoAtlas,
    /// With [`crate::Accuracy::Fast`] there is none.
    #[error("f64 does not tell apart the regions of this body")]
    NoFastAtlas,
    /// With [`crate::Accuracy::Fast`], and at l = 0, where no exact place is sought.
    #[error("f64 does not tell apart the regions of this type that are near the point")]
    Rounding,
    /// Where the point lies among the curves is not decided.
    #[error(transparent)]
    Open(#[from] Open),
    /// The atlas has no such place, or more than one.
    #[error(transparent)]
    Cells(#[from] CellError),
}

/// Where a cell with given curves on both sides over (x, l) is looked up.
type Lookup<'a> = dyn Fn(&RBig, &Sides) -> Result<Option<RegionId>, CellError> + 'a;

/// The regions at an exact point l ≠ 0, each once: one off the curves, those that meet there on a curve.
pub(crate) fn places(
    body: &Body,
    h: &Number,
    l: &Number,
    between: &Lookup<'_>,
) -> Result<Vec<Option<RegionId>>, PlaceError> {
    let frame = body.frame();
    let model = Model::new(body, &frame);
    let PlanePoint { x, h } = PlanePoint::scaled(&frame, h, l);
    let plane = Plane::new(&model, &frame);
    let mut heights = CriticalValues::new(&model, x.clone());
    let levels = heights.against(&h).map_err(|none| plane.open(none, &x))?;
    if levels.iter().all(|level| level.sign != Sign::Zero) {
        return Ok(vec![region(&plane, &heights, &h, &levels, between)?]);
    }
    let vertex = Vertex { plane: &plane, heights: &heights, h: &h, levels: &levels };
    let mut found = Vec::new();
    for cell in vertex::cells(&vertex)? {
        let place = region_of_cell(&plane, &cell, between)?;
        if !found.contains(&place) {
            found.push(place);
        }
    }
    Ok(found)
}

/// The region of a cell over an x.
fn region_of_cell(
    plane: &Plane<'_>,
    vertex::Cell { x, gap }: &vertex::Cell,
    between: &Lookup<'_>,
) -> Result<Option<RegionId>, PlaceError> {
    let h = match (&gap.low, &gap.high) {
        (None, _) => return Ok(None),
        (Some(low), None) => low + RBig::ONE,
        (Some(low), Some(high)) => (low + high) / RBig::from(2),
    };
    let mut heights = CriticalValues::new(plane.model, x.clone());
    let levels = heights.against(&h).map_err(|none| plane.open(none, x))?;
    region(plane, &heights, &h, &levels, between)
}

/// The region of a point off the curves. Over the x of an event the curves that meet there have no names of their own: then
/// that of a point beside it, so near that no curve comes between (as in Proposition 8.6).
fn region(
    plane: &Plane<'_>,
    heights: &CriticalValues<'_>,
    h: &RBig,
    levels: &[CriticalValue],
    between: &Lookup<'_>,
) -> Result<Option<RegionId>, PlaceError> {
    let x = &heights.x;
    if let Ok(found) = between(x, &sides(plane, levels, x)) {
        return Ok(found);
    }
    let room = vertex::room(plane, x, h, &Gap::around(levels));
    let beside = x + vertex::reach(plane, heights, &room)? / RBig::from(2);
    let levels =
        CriticalValues::new(plane.model, beside.clone()).against(h).map_err(|none| plane.open(none, &beside))?;
    Ok(between(&beside, &sides(plane, &levels, &beside))?)
}

/// The names of the curves on both sides of a point off them.
fn sides(plane: &Plane<'_>, levels: &[CriticalValue], x: &RBig) -> Sides {
    let names = |sign: Sign| -> Vec<CurveName> {
        levels.iter().filter(|level| level.sign == sign).map(|level| plane.name(&level.source, x)).collect()
    };
    Sides { below: names(Sign::Positive), above: names(Sign::Negative) }
}

impl CertifiedAtlas {
    /// The region of a cell over x with these curves on both sides; slabs in which x cannot lie are left out.
    pub(crate) fn region_between(&self, x: &RBig, sides: &Sides) -> Result<Option<RegionId>, CellError> {
        let proved = &self.arrangement;
        let ends = |transition: TransitionId, end: usize| {
            let group = proved.transitions.get(transition).into_iter().flatten();
            group.map(move |&event| &proved.events[event].x[end])
        };
        let may_be_at = |slab| {
            let begins = TransitionId::at_start(slab).is_none_or(|start| ends(start, 0).any(|from| from <= x));
            let goes_on = proved.transitions.get(TransitionId::at_end(slab)).is_none()
                || ends(TransitionId::at_end(slab), 1).any(|to| x <= to);
            begins && goes_on
        };
        let slabs = proved.slabs.pairs().zip(self.orders()).filter(|((slab, _), _)| may_be_at(*slab));
        sides.only(slabs.map(|((_, strip), order)| (order, strip.region_above.as_slice())))
    }

    /// The curves of each slab by rising h, by name.
    fn orders(&self) -> impl Iterator<Item = Vec<CurveName>> {
        self.arrangement.slabs.iter().map(|strip| strip.order.iter().map(|&curve| self.name(curve)).collect())
    }

    /// An atlas has the same slabs with the same regions, by the same names.
    pub(crate) fn agrees_with(&self, atlas: &Atlas) -> bool {
        let slabs = &atlas.arrangement().slabs;
        let regions = slabs.iter().map(|slab| &slab.region_above);
        slabs.len() == self.arrangement.slabs.len()
            && self.arrangement.slabs.iter().map(|strip| &strip.region_above).eq(regions)
            && self.orders().eq(atlas.orders())
    }
}
