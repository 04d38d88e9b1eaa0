//! Where the regions beside a rotation change.

use dashu_ratio::RBig;

use crate::arrangement::Change;
use crate::atlas::Atlas;
use bifdiag_equilibria::curves::{CurveId, Pole};
use bifdiag_equilibria::permanent::AxisRotation;

/// The events of such a rotation's own curve, h = l²/(2C) − ρ, where its neighbouring regions change; none where r = 0.
#[must_use]
pub fn region_changes(atlas: &Atlas, rotation: &AxisRotation) -> Vec<RegionChange> {
    if rotation.weight.is_zero() {
        return Vec::new();
    }
    let pole = if rotation.weight > RBig::ZERO { Pole::Plus } else { Pole::Minus };
    let arrangement = atlas.arrangement();
    let is_own = |&curve: &CurveId| arrangement.set.curves[curve].pole == Some(pole);
    let mut changes: Vec<RegionChange> = Vec::new();
    for event in arrangement.events.iter().filter(|event| event.change.curves().iter().any(is_own)) {
        let omega = atlas.momentum(event.x) / rotation.moments[0].to_f64().value();
        let found = RegionChange {
            omega,
            // x = C² Ω² / 2, so that dΩ/Ω = dx / (2x).
            error_bound: omega * (0.5 * event.x_error / event.x + 4.0 * f64::EPSILON),
            event: match event.change {
                Change::Swap(_) => RegionEvent::Crossing,
                Change::Birth(_) | Change::Death(_) => RegionEvent::Cusp,
                Change::Open { .. } | Change::Close { .. } => RegionEvent::Fork,
            },
        };
        match changes.last_mut() {
            // Within rounding it is one spin, named after the event that changes most.
            Some(last) if (last.omega - omega).abs() <= last.error_bound + found.error_bound => {
                last.event = last.event.max(found.event);
            }
            _ => changes.push(found),
        }
    }
    changes
}

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

/// A spin at which the regions beside a rotation change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionChange {
    /// Ω in the body's units.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// What happens.
    pub event: RegionEvent,
}
