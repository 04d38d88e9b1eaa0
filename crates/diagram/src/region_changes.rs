//! What changes with the spin of a rotation about a permanent axis: its stability and the regions beside it.

use std::cmp::Ordering;

use dashu_ratio::RBig;

use crate::arrangement::Change;
use crate::atlas::Atlas;
use bifdiag_equilibria::curves::{CurveId, Pole};
use bifdiag_equilibria::permanent::{AxisRotation, SpinChange, SpinType};

/// What happens to the curve of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum RegionEvent {
    /// Another curve crosses it.
    Crossing,
    /// It ends with another one.
    Cusp,
    /// A pair begins or ends on it.
    Fork,
}

impl RegionEvent {
    /// As it is printed.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Cusp => "cusp",
            Self::Fork => "fork",
        }
    }
}

/// A spin at which the stability of a rotation changes, or the regions beside it, or both.
#[derive(Clone, Debug)]
pub struct RotationChange {
    /// Ω in the body's units.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// l there.
    pub l: f64,
    /// h there.
    pub h: f64,
    /// The type below and above.
    pub types: [SpinType; 2],
    /// The change of the type.
    pub stability: Option<SpinChange>,
    /// What the curves do.
    pub region: Option<RegionEvent>,
}

impl RotationChange {
    /// How a spin compares with it, by its square: exactly if the type changes, otherwise equal within rounding.
    #[must_use]
    pub fn place_of(&self, squared: &RBig) -> Ordering {
        if let Some(change) = &self.stability {
            return change.place_of(squared);
        }
        let apart = squared.to_f64().value().sqrt() - self.omega;
        if apart.abs() <= self.error_bound { Ordering::Equal } else { apart.total_cmp(&0.0) }
    }
}

/// Everything that changes with the spin of a rotation, by rising spin; without an atlas only the stability is known.
#[must_use]
pub fn rotation_changes(rotation: &AxisRotation, atlas: Option<&Atlas>) -> Vec<RotationChange> {
    let stability = |change: SpinChange| RotationChange {
        omega: change.omega,
        error_bound: change.error_bound,
        l: rotation.l(change.omega),
        h: rotation.h_at(&change),
        types: [change.from, change.to].map(|kind| rotation.own(kind)),
        stability: Some(change),
        region: None,
    };
    let mut changes: Vec<RotationChange> = rotation.changes().into_iter().map(stability).collect();
    for region in atlas.map(|atlas| region_changes(atlas, rotation)).unwrap_or_default() {
        let is_same = |change: &&mut RotationChange| {
            change.stability.is_some()
                && change.region.is_none()
                && (change.omega - region.omega).abs() <= change.error_bound + region.error_bound
        };
        match changes.iter_mut().find(is_same) {
            Some(same) => same.region = region.region,
            None => changes.push(region),
        }
    }
    changes.sort_by(|p, q| p.omega.total_cmp(&q.omega));
    changes
}

/// The events of a rotation's own curve, h = l²/(2C) − ρ, where its neighbouring regions change; none where r = 0.
fn region_changes(atlas: &Atlas, rotation: &AxisRotation) -> Vec<RotationChange> {
    if rotation.weight.is_zero() {
        return Vec::new();
    }
    let pole = if rotation.weight > RBig::ZERO { Pole::Plus } else { Pole::Minus };
    let arrangement = atlas.arrangement();
    let is_own = |&curve: &CurveId| arrangement.set.curves[curve].pole == Some(pole);
    let mut changes: Vec<RotationChange> = Vec::new();
    for event in arrangement.events.iter().filter(|event| event.change.curves().iter().any(is_own)) {
        let omega = atlas.momentum(event.x) / rotation.moments[0].to_f64().value();
        // x = C² Ω² / 2, so that dΩ/Ω = dx / (2x).
        let error_bound = omega * (0.5 * event.x_error / event.x + 4.0 * f64::EPSILON);
        let region = Some(match event.change {
            Change::Swap(_) => RegionEvent::Crossing,
            Change::Birth(_) | Change::Death(_) => RegionEvent::Cusp,
            Change::Open { .. } | Change::Close { .. } => RegionEvent::Fork,
        });
        match changes.last_mut() {
            // Events of two kinds within rounding are one change, named after the one that changes most; two of one kind are two.
            Some(last) if last.region != region && (last.omega - omega).abs() <= last.error_bound + error_bound => {
                last.region = last.region.max(region);
            }
            _ => {
                let at = RBig::try_from(omega).ok().and_then(|omega| rotation.type_at_spin(&omega));
                let Some(kind) = at.map(|kind| rotation.own(kind)) else { continue };
                let (l, h) = (rotation.l(omega), rotation.h(omega));
                changes.push(RotationChange { omega, error_bound, l, h, types: [kind; 2], stability: None, region });
            }
        }
    }
    changes
}
