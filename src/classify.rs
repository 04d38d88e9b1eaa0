//! The type of U_hl, E_hl and P_hl at one point (h, l).

use thiserror::Error;

use crate::atlas::{self, Atlas, AtlasError, Location, MomentumError, Place};
use crate::body::{Body, Number};
use crate::document::{Accuracy, ClassificationDocument, ComponentDocument, MarginDocument, SCHEMA_VERSION, Status};
use crate::equilibria::{CriticalSet, Point};
use crate::topology::merge::MergeError;
use crate::topology::{Component, Poles, signature};

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
pub fn classify(body: &Body, h: &Number, l: &Number) -> Result<ClassificationDocument, ClassifyError> {
    classify_with_effort(body, h, l).map(|(document, _)| document)
}

/// [`classify`], and what it cost.
///
/// # Errors
/// As [`classify`].
pub fn classify_with_effort(
    body: &Body,
    h: &Number,
    l: &Number,
) -> Result<(ClassificationDocument, Effort), ClassifyError> {
    if l.to_f64() == 0.0 {
        return Ok((at_rest(body, h, l), Effort::default()));
    }
    let set = CriticalSet::new(body.frame()).map_err(AtlasError::from)?;
    let x = atlas::abscissa(&set.frame, l.to_f64())?;
    let (found, curve_points) = at_one_momentum(&set, h, x);
    let mut effort = Effort { curve_points, built_atlas: false };
    if let Some((components, margin)) = found {
        return Ok((decided(body, h, l, &components, margin), effort));
    }
    effort.built_atlas = true;
    let document = match Atlas::new(body) {
        Ok(atlas) => atlas.classify(h, l)?,
        // Without an atlas the classes on both sides of the near curves are those at this l.
        Err(AtlasError::Unresolved { .. }) => open_at_one_momentum(body, &set, h, l, x)?,
        Err(error) => return Err(error.into()),
    };
    Ok((document, effort))
}

/// The candidates at a point too near to curves, from the critical points at x alone: one class for each cut among the
/// curves within their error bounds.
fn open_at_one_momentum(
    body: &Body,
    set: &CriticalSet,
    h: &Number,
    l: &Number,
    x: f64,
) -> Result<ClassificationDocument, ClassifyError> {
    let energy = h.to_f64() / set.frame.energy_unit;
    let mut points: Vec<(usize, Point)> =
        set.curves_over(x).0.iter().map(|&c| (c, set.curves[c].point(&set.frame, x))).collect();
    points.sort_by(|p, q| p.1.h().total_cmp(&q.1.h()));
    let error = |p: &Point| atlas::comparison_error(p, energy);
    let first = points.partition_point(|(_, p)| p.h() + error(p) < energy);
    let last = points.partition_point(|(_, p)| p.h() - error(p) <= energy);
    let mut candidates: Vec<Vec<ComponentDocument>> = Vec::new();
    for cut in first..=last {
        let below = points[..cut].iter().map(|(curve, point)| (*curve, point));
        let components = match cut {
            0 => Vec::new(),
            n if n == points.len() => vec![atlas::whole_sphere(!set.frame.is_euler())],
            _ => atlas::components_below(set, x, below)?,
        };
        let class: Vec<ComponentDocument> = components.iter().map(ComponentDocument::from).collect();
        if !candidates.contains(&class) {
            candidates.push(class);
        }
    }
    let distance = |p: &Point| (p.h() - energy).abs();
    let nearest = points.iter().min_by(|p, q| distance(&p.1).total_cmp(&distance(&q.1)));
    let unit = set.frame.energy_unit;
    let margin = MarginDocument {
        h: nearest.map_or(0.0, |(_, p)| distance(p) * unit),
        nearest: nearest.map_or_else(String::new, |(c, _)| atlas::curve_name(set, *c)),
        error_bound: nearest.map_or(0.0, |(_, p)| error(p) * unit),
    };
    let critical = atlas::on_straight_curve(body, h, l);
    let status = if critical { Status::Critical } else { Status::Undecided };
    Ok(open(body, h, l, status, candidates, margin))
}

/// The components of U_hl from the critical points at x alone, and the number of points computed; `None` when h is too
/// near to a curve, x to a cusp, or a join is not proved.
fn at_one_momentum(set: &CriticalSet, h: &Number, x: f64) -> (Option<(Vec<Component>, MarginDocument)>, usize) {
    let (over, near_end) = set.curves_over(x);
    let mut points: Vec<(usize, Point)> = over.iter().map(|&c| (c, set.curves[c].point(&set.frame, x))).collect();
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
    let unit = set.frame.energy_unit;
    let margin = MarginDocument {
        h: distance(&nearest) * unit,
        nearest: atlas::curve_name(set, curve),
        error_bound: error(&nearest) * unit,
    };
    (Some((components, margin)), count)
}

impl Atlas {
    /// Classifies a point of a prepared body. Where the atlas left something undecided, or does not know the components
    /// of a region, the critical points at this l are asked first.
    ///
    /// # Errors
    /// [`ClassifyError::Momentum`] when l is out of range, [`ClassifyError::Merge`] when the region's components are not
    /// known.
    pub fn classify(&self, h: &Number, l: &Number) -> Result<ClassificationDocument, ClassifyError> {
        let body = self.body();
        if l.to_f64() == 0.0 {
            return Ok(at_rest(body, h, l));
        }
        let unknown = |place: &Place| matches!(place, Place::Region(region) if self.components(*region).is_err());
        let Location { place, distance, nearest, error_bound, .. } = self.locate(h.to_f64(), l.to_f64())?;
        if !self.arrangement().undecided.is_empty() || unknown(&place) {
            let set = &self.arrangement().set;
            let x = atlas::abscissa(&set.frame, l.to_f64())?;
            if let (Some((components, margin)), _) = at_one_momentum(set, h, x) {
                return Ok(decided(body, h, l, &components, margin));
            }
        }
        let nearest = atlas::curve_name(&self.arrangement().set, nearest);
        let margin = MarginDocument { h: distance, nearest, error_bound };
        match place {
            Place::Forbidden => Ok(decided(body, h, l, &[], margin)),
            Place::Region(region) => Ok(decided(body, h, l, self.components(region)?, margin)),
            Place::Undecided(places) => {
                let mut candidates: Vec<Vec<ComponentDocument>> = Vec::new();
                for place in places {
                    let components = place.map_or(Ok([].as_slice()), |region| self.components(region))?;
                    let class: Vec<ComponentDocument> = components.iter().map(ComponentDocument::from).collect();
                    if !candidates.contains(&class) {
                        candidates.push(class);
                    }
                }
                let critical = atlas::on_straight_curve(body, h, l);
                let status = if critical { Status::Critical } else { Status::Undecided };
                Ok(open(body, h, l, status, candidates, margin))
            }
        }
    }
}

pub(crate) fn decided(
    body: &Body,
    h: &Number,
    l: &Number,
    components: &[Component],
    margin: MarginDocument,
) -> ClassificationDocument {
    let status = if components.is_empty() { Status::Forbidden } else { Status::Regular };
    ClassificationDocument {
        components: Some(components.iter().map(ComponentDocument::from).collect()),
        signature: if components.is_empty() { None } else { signature(components) },
        ..open(body, h, l, status, Vec::new(), margin)
    }
}

pub(crate) fn open(
    body: &Body,
    h: &Number,
    l: &Number,
    status: Status,
    candidates: Vec<Vec<ComponentDocument>>,
    margin: MarginDocument,
) -> ClassificationDocument {
    let note = body
        .flags()
        .euler
        .then(|| "r = 0: the poles ±r̂ do not exist and S vanishes identically, so P_hl is not defined".to_owned());
    ClassificationDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: body.moments().clone(),
        center: body.center().clone(),
        h: h.clone(),
        l: l.clone(),
        status,
        accuracy: Accuracy::Standard,
        margin,
        components: None,
        signature: None,
        candidates,
        note,
        inertia: None,
    }
}

/// l = 0: U = −⟨γ, r⟩ has its minimum −r at r̂ and its maximum r at −r̂; decided exactly.
pub(crate) fn at_rest(body: &Body, h: &Number, l: &Number) -> ClassificationDocument {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let frame = body.frame();
    let r = frame.r_norm * frame.energy_unit;
    let energy = h.to_f64();
    let euler = frame.is_euler();
    let disc = Component { boundary_circles: 1, poles: Some(Poles { plus: true, minus: false }) };
    let sphere = atlas::whole_sphere(!euler);
    let (nearest, distance) = match (euler, energy < 0.0) {
        (true, _) => ("l=0", energy.abs()),
        (false, true) => ("P+", (energy + r).abs()),
        (false, false) => ("P-", (energy - r).abs()),
    };
    let margin = MarginDocument { h: distance, nearest: nearest.to_owned(), error_bound: 4.0 * f64::EPSILON * r };
    let documents = |components: &[Component]| components.iter().map(ComponentDocument::from).collect::<Vec<_>>();
    match (atlas::compare_with_r(body, h), energy < 0.0) {
        (Greater, true) => decided(body, h, l, &[], margin),
        (Greater, false) => decided(body, h, l, &[sphere], margin),
        (Less, _) => decided(body, h, l, &[disc], margin),
        (Equal, _) if euler => open(body, h, l, Status::Critical, vec![Vec::new(), documents(&[sphere])], margin),
        (Equal, true) => open(body, h, l, Status::Critical, vec![Vec::new(), documents(&[disc])], margin),
        (Equal, false) => open(body, h, l, Status::Critical, vec![documents(&[disc]), documents(&[sphere])], margin),
    }
}
