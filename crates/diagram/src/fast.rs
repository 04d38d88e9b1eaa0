//! Answers of `f64`, with error bounds: undecided where these do not suffice, but for points at l = 0 or exactly on a straight
//! curve. The public answers of `bifdiag_exact` begin here.

use dashu_ratio::RBig;
use thiserror::Error;

use crate::arrangement::{Arrangement, Undecided};
use crate::atlas::{self, Atlas, Location, Place, StraightCurve};
use crate::topology::merge::MergeError;
use crate::topology::{Classification, Component, Components, Margin, Poles, whole_sphere};
use bifdiag_body::{Body, Number};
use bifdiag_equilibria::curves::{
    Branch, CriticalSet, CurveId, CurveName, EquilibriaError, MomentumError, Point, Pole, abscissa,
};
use bifdiag_numbers::symmetric::Real;

/// Why `f64` has no answer.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FastError {
    /// The critical points cannot be computed.
    #[error(transparent)]
    Equilibria(#[from] EquilibriaError),
    /// l is beyond `f64`.
    #[error(transparent)]
    Momentum(#[from] MomentumError),
    /// The regions could not be put together: events of this body are closer than `f64` resolves.
    #[error(
        "the regions of this body cannot be told apart in f64: the order of the curves near l = {l:e} is not decided"
    )]
    Unresolved {
        /// Near this l, in the body's units.
        l: f64,
    },
    /// The joins of the merge tree could not be proved.
    #[error("the connected components at this point could not be decided in f64: {0}")]
    Merge(#[from] MergeError),
}

/// Computes curves, events, regions and their topology; no polylines, no stability.
///
/// # Errors
/// [`FastError::Equilibria`] when the body's data leave the range of `f64`; [`FastError::Unresolved`] when the order of the
/// curves contradicts itself, which happens only when events coincide to within rounding.
pub fn atlas(body: &Body) -> Result<Atlas, FastError> {
    let arrangement = Arrangement::new(CriticalSet::new(body.frame())?);
    if arrangement.slabs.is_empty() {
        let at = arrangement.undecided.iter().find_map(|undecided| match undecided {
            Undecided::Order { event } => Some(arrangement.events[*event].x),
            _ => None,
        });
        let x = at.unwrap_or(0.0);
        return Err(FastError::Unresolved { l: (2.0 * x).sqrt() * arrangement.set.frame.momentum_unit });
    }
    let regions = atlas::regions(&arrangement);
    Ok(Atlas::of_parts(body.clone(), arrangement, regions))
}

/// Classifies one point from the critical points at this l, or, too near to a curve, names the candidates by the atlas.
///
/// # Errors
/// [`FastError`] when the body or l leave the range of `f64`, or a join cannot be proved.
pub fn classify(body: &Body, h: &Number, l: &Number) -> Result<Classification, FastError> {
    if let Some((found, _)) = classify_at_momentum(body, h, l)? {
        return Ok(found);
    }
    match atlas(body) {
        Ok(atlas) => classify_in(&atlas, h, l).map(|(found, _)| found),
        // Without an atlas the classes on both sides of a near curve are those at this l, if no other curve is as near.
        Err(error @ FastError::Unresolved { .. }) => {
            let set = CriticalSet::new(body.frame())?;
            let x = abscissa(&set.frame, l.to_f64())?;
            AtMomentum::new(&set, h, x).open(body, h, l)?.ok_or(error)
        }
        Err(error) => Err(error),
    }
}

/// Classifies one point from the critical points at this l alone: no curve is traced and no event computed. The answer, and
/// whether the nearest curve is named for certain; `None` where the error bounds do not suffice.
///
/// # Errors
/// [`FastError`] when the body or l leave the range of `f64`.
pub fn classify_at_momentum(body: &Body, h: &Number, l: &Number) -> Result<Option<(Classification, bool)>, FastError> {
    if l.to_f64() == 0.0 {
        return Ok(Some((at_rest(body, h), true)));
    }
    let set = CriticalSet::new(body.frame())?;
    let x = abscissa(&set.frame, l.to_f64())?;
    Ok(AtMomentum::new(&set, h, x).decided())
}

/// Classifies a point by an atlas. Where that left something undecided, or does not know the components of a region, the
/// critical points at this l are asked first. The answer, and whether the nearest curve is named for certain: within
/// rounding of an event, or of the middle between two curves, it may be another one.
///
/// # Errors
/// [`FastError::Momentum`] when l is out of range, [`FastError::Merge`] when the region's components are not known.
pub fn classify_in(atlas: &Atlas, h: &Number, l: &Number) -> Result<(Classification, bool), FastError> {
    let body = atlas.body();
    if l.to_f64() == 0.0 {
        return Ok((at_rest(body, h), true));
    }
    let unknown = |place: &Place| matches!(place, Place::Region(region) if atlas.components(*region).is_err());
    let Location { place, distance, nearest, error_bound, named, .. } = atlas.locate(h.to_f64(), l.to_f64())?;
    let set = &atlas.arrangement().set;
    let x = abscissa(&set.frame, l.to_f64())?;
    if (!atlas.arrangement().undecided.is_empty() || unknown(&place))
        && let Some(found) = AtMomentum::new(set, h, x).decided()
    {
        return Ok(found);
    }
    let margin = Margin { h: distance, nearest: Some(CurveName::of(set, nearest)), error_bound };
    let decided = |components| Ok((Classification::decided(components, margin), named));
    let places = match place {
        Place::Forbidden => return decided(Vec::new()),
        Place::Region(region) => return decided(atlas.components(region)?.to_vec()),
        Place::Undecided(places) => places,
    };
    let mut candidates: Vec<Components> = Vec::new();
    for place in places {
        let components = place.map_or(Ok([].as_slice()), |region| atlas.components(region))?;
        if !candidates.iter().any(|class| class == components) {
            candidates.push(components.to_vec());
        }
    }
    let on_it = atlas::straight_curve_at(body, h, l);
    Ok((beside_curve((set, x), on_it, candidates, margin), false))
}

/// What is known of a point too near to a curve: whether it lies on a straight one is decided exactly.
fn beside_curve(
    (set, x): (&CriticalSet, f64),
    on_it: Option<StraightCurve>,
    candidates: Vec<Components>,
    margin: Margin,
) -> Classification {
    let margin = match on_it {
        Some(StraightCurve::PoleLine(pole)) => {
            let is_line =
                |id: &CurveId| set.curves[*id].branch == Branch::Pole(pole) || set.curves[*id].pole == Some(pole);
            let line = set.curves_over(x).0.into_iter().find(is_line).map(|id| CurveName::of(set, id));
            Margin { h: 0.0, nearest: line.or(margin.nearest), error_bound: 0.0 }
        }
        Some(StraightCurve::AxisLine) => Margin { h: 0.0, ..margin },
        None => margin,
    };
    Classification::open(on_it.is_some(), candidates, margin)
}

/// The points of all curves over one x, by rising h, beside an energy.
struct AtMomentum<'a> {
    set: &'a CriticalSet,
    x: f64,
    energy: f64,
    points: Vec<(CurveId, Point)>,
    /// x lies within rounding of the end of a curve.
    near_end: bool,
}

impl<'a> AtMomentum<'a> {
    fn new(set: &'a CriticalSet, h: &Number, x: f64) -> Self {
        let (over, near_end) = set.curves_over(x);
        let mut points: Vec<(CurveId, Point)> = over.iter().map(|&c| (c, set.curves[c].point(&set.frame, x))).collect();
        points.sort_by(|p, q| p.1.h().total_cmp(&q.1.h()));
        Self { set, x, energy: h.to_f64() / set.frame.energy_unit, points, near_end }
    }

    fn distance(&self, point: &Point) -> f64 {
        (point.h() - self.energy).abs()
    }

    fn error(&self, point: &Point) -> f64 {
        atlas::comparison_error(point, self.energy)
    }

    fn nearest(&self) -> Option<&(CurveId, Point)> {
        self.points.iter().min_by(|p, q| self.distance(&p.1).total_cmp(&self.distance(&q.1)))
    }

    fn margin(&self, nearest: Option<&(CurveId, Point)>) -> Margin {
        let unit = self.set.frame.energy_unit;
        Margin {
            h: nearest.map_or(0.0, |(_, point)| self.distance(point) * unit),
            nearest: nearest.map(|(curve, _)| CurveName::of(self.set, *curve)),
            error_bound: nearest.map_or(0.0, |(_, point)| self.error(point) * unit),
        }
    }

    /// The components of U_hl above the lowest `count` curves.
    fn components_above(&self, count: usize) -> Result<Components, MergeError> {
        match count {
            0 => Ok(Vec::new()),
            all if all == self.points.len() => Ok(vec![whole_sphere(!self.set.frame.is_euler())]),
            _ => {
                let below = self.points[..count].iter().map(|(curve, point)| (*curve, point));
                atlas::components_below(self.set, self.x, below)
            }
        }
    }

    /// The answer, and whether no other curve may be the nearest one; `None` when h is too near to a curve, x to the end of
    /// one, or a join is not proved.
    fn decided(&self) -> Option<(Classification, bool)> {
        let is_clear = !self.near_end && self.points.iter().all(|(_, p)| self.distance(p) > self.error(p));
        let nearest = self.nearest().filter(|_| is_clear)?;
        let below = self.points.partition_point(|(_, p)| p.h() < self.energy);
        let components = self.components_above(below).ok()?;
        let farthest = self.distance(&nearest.1) + self.error(&nearest.1);
        let is_rival =
            |(other, p): &(CurveId, Point)| *other != nearest.0 && self.distance(p) - self.error(p) <= farthest;
        let named = !self.points.iter().any(is_rival);
        Some((Classification::decided(components, self.margin(Some(nearest))), named))
    }

    /// The candidates too near to a curve: the classes on both sides of it. `None` where several curves are too near, since
    /// rounding may change their order, and where a curve ends.
    fn open(&self, body: &Body, h: &Number, l: &Number) -> Result<Option<Classification>, MergeError> {
        let first = self.points.partition_point(|(_, p)| p.h() + self.error(p) < self.energy);
        let last = self.points.partition_point(|(_, p)| p.h() - self.error(p) <= self.energy);
        if self.near_end || last > first + 1 {
            return Ok(None);
        }
        let mut candidates: Vec<Components> = Vec::new();
        for cut in first..=last {
            let components = self.components_above(cut)?;
            if !candidates.contains(&components) {
                candidates.push(components);
            }
        }
        let margin = self.margin(self.nearest());
        let on_it = atlas::straight_curve_at(body, h, l);
        Ok(Some(beside_curve((self.set, self.x), on_it, candidates, margin)))
    }
}

/// l = 0: U = −⟨γ, r⟩ has its minimum −r at r̂ and its maximum r at −r̂; decided exactly.
#[must_use]
pub fn at_rest(body: &Body, h: &Number) -> Classification {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let frame = body.frame();
    let stands = h.value() >= &RBig::ZERO;
    let euler = frame.is_euler();
    let with_poles = |plus, minus| vec![Component { boundary_circles: 1, poles: Some(Poles { plus, minus }) }];
    let disc = || with_poles(true, false);
    let sphere = || vec![whole_sphere(!euler)];
    let place = atlas::compare_with_r(body, h);
    // The curve of relative equilibria that begins there; the pole line does, too.
    let of_pole = || {
        let set = CriticalSet::new(frame).ok()?;
        Some(CurveName::of(&set, set.at_rest(!stands)?))
    };
    let nearest = match (euler, stands) {
        (true, _) => CurveName::Rest,
        (false, true) => of_pole().unwrap_or(CurveName::Pole(Pole::Minus)),
        (false, false) => of_pole().unwrap_or(CurveName::Pole(Pole::Plus)),
    };
    // | |h| − |r| |
    let (r, size) = (body.center_norm(), if stands { h.value().clone() } else { -h.value() });
    let (lo, hi) = if place.is_lt() { (r.lo - &size, r.hi - size) } else { (&size - r.hi, size - r.lo) };
    let (distance, error_bound) = Real { lo, hi }.rounded();
    let margin = Margin { h: distance, nearest: Some(nearest), error_bound };
    match (place, stands) {
        (Greater, false) => Classification::decided(Vec::new(), margin),
        (Greater, true) => Classification::decided(sphere(), margin),
        (Less, _) => Classification::decided(disc(), margin),
        (Equal, _) if euler => Classification::open(true, beginning_without_weight(body), margin),
        // Off a permanent axis the extremum of U_l and the pole part at l > 0.
        (Equal, false) if body.flags().axis => Classification::open(true, vec![Vec::new(), disc()], margin),
        (Equal, true) if body.flags().axis => Classification::open(true, vec![disc(), sphere()], margin),
        (Equal, false) => Classification::open(true, vec![Vec::new(), with_poles(false, false), disc()], margin),
        (Equal, true) => Classification::open(true, vec![disc(), with_poles(true, true), sphere()], margin),
    }
}

/// The classes that meet at h = l = 0 where r = 0: U_l = l²/(2⟨γ, Aγ⟩) has its minima over the largest moment, saddles over the
/// middle one and maxima over the smallest.
fn beginning_without_weight(body: &Body) -> Vec<Components> {
    let component = |boundary_circles| Component { boundary_circles, poles: None };
    let mut moments = body.moments().each_ref().map(|moment| moment.value().clone());
    moments.sort();
    let [smallest, middle, largest] = &moments;
    let mut classes = vec![Vec::new()];
    if middle < largest {
        classes.push(vec![component(1); 2]);
    }
    if smallest < middle {
        classes.push(vec![component(2)]);
    }
    classes.push(vec![whole_sphere(false)]);
    classes
}
