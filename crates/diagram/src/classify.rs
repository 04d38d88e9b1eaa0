//! The type of U_hl, E_hl and P_hl at one point (h, l).

use thiserror::Error;

use crate::atlas::{self, Atlas, AtlasError, Location, Place};
use crate::topology::merge::MergeError;
use crate::topology::{Component, Poles};
use bifdiag_body::{Body, Number};
use bifdiag_equilibria::curves::MomentumError;
use bifdiag_equilibria::curves::{CriticalSet, CurveId, CurveName, Point, Pole};

pub use crate::atlas::Margin;
pub use crate::topology::{Answer, Components};

/// The answer for one point.
#[derive(Clone, Debug, PartialEq)]
pub struct Classification {
    /// What is known.
    pub answer: Answer,
    /// Distance to the nearest curve.
    pub margin: Margin,
}

impl Classification {
    /// A point off the curves; without components it is forbidden.
    #[must_use]
    pub fn decided(components: Components, margin: Margin) -> Self {
        let answer = if components.is_empty() { Answer::Forbidden } else { Answer::Regular(components) };
        Self { answer, margin }
    }

    /// A point on a curve, or too near to one.
    #[must_use]
    pub fn open(critical: bool, candidates: Vec<Components>, margin: Margin) -> Self {
        let answer = if critical { Answer::Critical(candidates) } else { Answer::Undecided(candidates) };
        Self { answer, margin }
    }

    /// The components where they are known: none when forbidden; `None` when critical or undecided.
    #[must_use]
    pub fn components(&self) -> Option<&[Component]> {
        match &self.answer {
            Answer::Regular(components) => Some(components),
            Answer::Forbidden => Some(&[]),
            Answer::Critical(_) | Answer::Undecided(_) => None,
        }
    }

    /// The classes that may meet there; none for a point that is decided.
    #[must_use]
    pub fn candidates(&self) -> &[Components] {
        match &self.answer {
            Answer::Critical(candidates) | Answer::Undecided(candidates) => candidates,
            Answer::Regular(_) | Answer::Forbidden => &[],
        }
    }
}

/// Why a point has no answer.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ClassifyError {
    /// The body is beyond `f64`.
    #[error(transparent)]
    Atlas(#[from] AtlasError),
    /// l is beyond `f64`.
    #[error(transparent)]
    Momentum(#[from] MomentumError),
    /// The joins of the merge tree could not be proved.
    #[error("the connected components at this point could not be told in f64: {0}")]
    Merge(#[from] MergeError),
}

/// What an answer cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Points of curves that were computed.
    pub curve_points: usize,
    /// Events and regions of the whole plane were computed.
    pub built_atlas: bool,
}

/// Classifies one point of a body that is not prepared: finds the critical points at this l only. No curve is traced and
/// no event computed, unless the point is too near to a curve, when the atlas names the candidates.
///
/// # Errors
/// [`ClassifyError`] when the body or l leave the range of `f64`, or a join cannot be proved.
pub fn classify(body: &Body, h: &Number, l: &Number) -> Result<Classification, ClassifyError> {
    classify_with_effort(body, h, l).map(|(answer, _)| answer)
}

/// Classifies one point from the critical points at this l alone, where the error bounds of `f64` suffice, to name the
/// nearest curve too; `None` where they do not.
///
/// # Errors
/// [`ClassifyError`] when the body or l leave the range of `f64`.
pub fn classify_if_clear(body: &Body, h: &Number, l: &Number) -> Result<Option<Classification>, ClassifyError> {
    if l.to_f64() == 0.0 {
        return Ok(Some(at_rest(body, h)));
    }
    let set = CriticalSet::new(body.frame()).map_err(AtlasError::from)?;
    let x = bifdiag_equilibria::curves::abscissa(&set.frame, l.to_f64())?;
    let (found, _) = at_one_momentum(&set, h, x);
    Ok(found.filter(|found| found.named).map(|found| Classification::decided(found.components, found.margin)))
}

/// [`classify`], and what it cost.
///
/// # Errors
/// As [`classify`].
pub fn classify_with_effort(body: &Body, h: &Number, l: &Number) -> Result<(Classification, Effort), ClassifyError> {
    if l.to_f64() == 0.0 {
        return Ok((at_rest(body, h), Effort::default()));
    }
    let set = CriticalSet::new(body.frame()).map_err(AtlasError::from)?;
    let x = bifdiag_equilibria::curves::abscissa(&set.frame, l.to_f64())?;
    let (found, curve_points) = at_one_momentum(&set, h, x);
    let mut effort = Effort { curve_points, built_atlas: false };
    if let Some(AtMomentum { components, margin, .. }) = found {
        return Ok((Classification::decided(components, margin), effort));
    }
    effort.built_atlas = true;
    let answer = match Atlas::new(body) {
        Ok(atlas) => atlas.classify(h, l)?,
        // Without an atlas the classes on both sides of the near curves are those at this l.
        Err(AtlasError::Unresolved { .. }) => open_at_one_momentum(body, &set, h, l, x)?,
        Err(error) => return Err(error.into()),
    };
    Ok((answer, effort))
}

/// The candidates at a point too near to curves, from the critical points at x alone: one class for each cut among the
/// curves within their error bounds.
fn open_at_one_momentum(
    body: &Body,
    set: &CriticalSet,
    h: &Number,
    l: &Number,
    x: f64,
) -> Result<Classification, ClassifyError> {
    let energy = h.to_f64() / set.frame.energy_unit;
    let mut points: Vec<(CurveId, Point)> =
        set.curves_over(x).0.iter().map(|&c| (c, set.curves[c].point(&set.frame, x))).collect();
    points.sort_by(|p, q| p.1.h().total_cmp(&q.1.h()));
    let error = |p: &Point| atlas::comparison_error(p, energy);
    let first = points.partition_point(|(_, p)| p.h() + error(p) < energy);
    let last = points.partition_point(|(_, p)| p.h() - error(p) <= energy);
    let mut candidates: Vec<Components> = Vec::new();
    for cut in first..=last {
        let below = points[..cut].iter().map(|(curve, point)| (*curve, point));
        let components = match cut {
            0 => Vec::new(),
            n if n == points.len() => vec![atlas::whole_sphere(!set.frame.is_euler())],
            _ => atlas::components_below(set, x, below)?,
        };
        if !candidates.contains(&components) {
            candidates.push(components);
        }
    }
    let distance = |p: &Point| (p.h() - energy).abs();
    let nearest = points.iter().min_by(|p, q| distance(&p.1).total_cmp(&distance(&q.1)));
    let unit = set.frame.energy_unit;
    let margin = Margin {
        h: nearest.map_or(0.0, |(_, p)| distance(p) * unit),
        nearest: nearest.map(|(c, _)| CurveName::of(set, *c)),
        error_bound: nearest.map_or(0.0, |(_, p)| error(p) * unit),
    };
    Ok(Classification::open(atlas::on_straight_curve(body, h, l), candidates, margin))
}

/// What the critical points at one x tell.
struct AtMomentum {
    components: Components,
    margin: Margin,
    /// No other curve may be the nearest one.
    named: bool,
}

/// The components of U_hl from the critical points at x alone, and the number of points computed; `None` when h is too
/// near to a curve, x to a cusp, or a join is not proved.
fn at_one_momentum(set: &CriticalSet, h: &Number, x: f64) -> (Option<AtMomentum>, usize) {
    let (over, near_end) = set.curves_over(x);
    let mut points: Vec<(CurveId, Point)> = over.iter().map(|&c| (c, set.curves[c].point(&set.frame, x))).collect();
    points.sort_by(|p, q| p.1.h().total_cmp(&q.1.h()));
    let count = points.len();
    let energy = h.to_f64() / set.frame.energy_unit;
    let error = |p: &Point| atlas::comparison_error(p, energy);
    let distance = |p: &Point| (p.h() - energy).abs();
    let clear = points.iter().all(|(_, p)| distance(p) > error(p));
    let nearest = points.iter().min_by(|p, q| distance(&p.1).total_cmp(&distance(&q.1)));
    let Some(&(curve, nearest)) = nearest.filter(|_| clear && !near_end) else {
        return (None, count);
    };
    // The points are in the order of h.
    let below = &points[..points.partition_point(|(_, p)| p.h() < energy)];
    let components = if below.is_empty() {
        Vec::new()
    } else if below.len() == count {
        vec![atlas::whole_sphere(!set.frame.is_euler())]
    } else {
        match atlas::components_below(set, x, below.iter().map(|(curve, point)| (*curve, point))) {
            Ok(components) => components,
            Err(_open_join) => return (None, count),
        }
    };
    let farthest = distance(&nearest) + error(&nearest);
    let may_be_nearest = |(other, p): &&(CurveId, Point)| *other != curve && distance(p) - error(p) <= farthest;
    let unit = set.frame.energy_unit;
    let margin = Margin {
        h: distance(&nearest) * unit,
        nearest: Some(CurveName::of(set, curve)),
        error_bound: error(&nearest) * unit,
    };
    let named = !points.iter().any(|point| may_be_nearest(&point));
    (Some(AtMomentum { components, margin, named }), count)
}

impl Atlas {
    /// Classifies a point of a prepared body. Where the atlas left something undecided, or does not know the components
    /// of a region, the critical points at this l are asked first.
    ///
    /// # Errors
    /// [`ClassifyError::Momentum`] when l is out of range, [`ClassifyError::Merge`] when the region's components are not
    /// known.
    pub fn classify(&self, h: &Number, l: &Number) -> Result<Classification, ClassifyError> {
        self.classify_and_name(h, l).map(|(found, _)| found)
    }

    /// Classifies a point of a prepared body where the error bounds of `f64` suffice, to name the nearest curve too; `None`
    /// where they do not.
    ///
    /// # Errors
    /// As [`Atlas::classify`].
    pub fn classify_if_clear(&self, h: &Number, l: &Number) -> Result<Option<Classification>, ClassifyError> {
        let (found, named) = self.classify_and_name(h, l)?;
        Ok((named && found.components().is_some()).then_some(found))
    }

    /// The type, and whether the nearest curve is named for certain: within rounding of an event, or of the middle between two
    /// curves, it may be another one.
    fn classify_and_name(&self, h: &Number, l: &Number) -> Result<(Classification, bool), ClassifyError> {
        let body = self.body();
        if l.to_f64() == 0.0 {
            return Ok((at_rest(body, h), true));
        }
        let unknown = |place: &Place| matches!(place, Place::Region(region) if self.components(*region).is_err());
        let Location { place, distance, nearest, error_bound, named, .. } = self.locate(h.to_f64(), l.to_f64())?;
        let set = &self.arrangement().set;
        if !self.arrangement().undecided.is_empty() || unknown(&place) {
            let x = bifdiag_equilibria::curves::abscissa(&set.frame, l.to_f64())?;
            if let (Some(AtMomentum { components, margin, named }), _) = at_one_momentum(set, h, x) {
                return Ok((Classification::decided(components, margin), named));
            }
        }
        let margin = Margin { h: distance, nearest: Some(CurveName::of(set, nearest)), error_bound };
        let decided = |components| Ok((Classification::decided(components, margin), named));
        let places = match place {
            Place::Forbidden => return decided(Vec::new()),
            Place::Region(region) => return decided(self.components(region)?.to_vec()),
            Place::Undecided(places) => places,
        };
        let mut candidates: Vec<Components> = Vec::new();
        for place in places {
            let components = place.map_or(Ok([].as_slice()), |region| self.components(region))?;
            if !candidates.iter().any(|class| class == components) {
                candidates.push(components.to_vec());
            }
        }
        let on_curve = atlas::on_straight_curve(body, h, l);
        Ok((Classification::open(on_curve, candidates, margin), false))
    }
}

/// l = 0: U = −⟨γ, r⟩ has its minimum −r at r̂ and its maximum r at −r̂; decided exactly.
#[must_use]
pub fn at_rest(body: &Body, h: &Number) -> Classification {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let frame = body.frame();
    let r = frame.r_norm * frame.energy_unit;
    let energy = h.to_f64();
    let euler = frame.is_euler();
    let disc = || vec![Component { boundary_circles: 1, poles: Some(Poles { plus: true, minus: false }) }];
    let sphere = || vec![atlas::whole_sphere(!euler)];
    let (nearest, distance) = match (euler, energy < 0.0) {
        (true, _) => (CurveName::Rest, energy.abs()),
        (false, true) => (CurveName::Pole(Pole::Plus), (energy + r).abs()),
        (false, false) => (CurveName::Pole(Pole::Minus), (energy - r).abs()),
    };
    let margin = Margin { h: distance, nearest: Some(nearest), error_bound: 4.0 * f64::EPSILON * r };
    match (atlas::compare_with_r(body, h), energy < 0.0) {
        (Greater, true) => Classification::decided(Vec::new(), margin),
        (Greater, false) => Classification::decided(sphere(), margin),
        (Less, _) => Classification::decided(disc(), margin),
        (Equal, _) if euler => Classification::open(true, vec![Vec::new(), sphere()], margin),
        (Equal, true) => Classification::open(true, vec![Vec::new(), disc()], margin),
        (Equal, false) => Classification::open(true, vec![disc(), sphere()], margin),
    }
}
