//! Where the regions beside a rotation change.

use super::rotation::AxisRotation;
use crate::atlas::Atlas;
use crate::diagram::Change;

/// The curves' meetings on the line h = l²/(2C) − ρ of such a rotation, where its neighbouring regions change.
#[must_use]
pub fn region_changes(atlas: &Atlas, rotation: &AxisRotation) -> Vec<RegionChange> {
    let mut changes: Vec<RegionChange> = Vec::new();
    for event in &atlas.arrangement().events {
        let l = atlas.momentum(event.x);
        let omega = l / rotation.moments[0].to_f64().value();
        let (h, line) = (atlas.energy(event.h), rotation.h(omega));
        let slack = 2.0 * atlas.energy(event.h_error) + 8.0 * f64::EPSILON * (h.abs() + line.abs());
        // x = C² Ω² / 2, so that dΩ/Ω = dx / (2x).
        let error_bound = omega * (0.5 * event.x_error / event.x + 4.0 * f64::EPSILON);
        if (h - line).abs() > slack {
            continue;
        }
        let event = match event.change {
            Change::Birth(_) | Change::Death(_) => "cusp",
            Change::Swap(_) => "crossing",
            Change::Open { .. } | Change::Close { .. } => "fork",
        };
        let same = |last: &RegionChange| (last.omega - omega).abs() <= last.error_bound + error_bound;
        if !changes.last().is_some_and(same) {
            changes.push(RegionChange { omega, error_bound, event });
        }
    }
    changes
}

/// A spin at which the regions beside a rotation change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionChange {
    /// Ω in the body's units.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// What happens: a fork, a crossing, a cusp.
    pub event: &'static str,
}
