//! The topology of U_hl from the ridges and valleys of J over the circles of latitude about r̂ (Theorem 9.7 of
//! docs/algorithms.md): exact, without a critical point, a path or a box.

mod axial;
mod curve;
mod enclosed;
mod exact_cut;
mod latitude;
mod strand;
mod whole;

use std::cell::OnceCell;

use bifdiag_diagram::topology::Component;
use dashu_ratio::RBig;

use super::model::Model;

/// The ridges of a body.
pub(super) struct Ridges<'a> {
    model: &'a Model,
    whole: OnceCell<Option<whole::Whole>>,
}

impl<'a> Ridges<'a> {
    pub fn of(model: &'a Model) -> Self {
        Self { model, whole: OnceCell::new() }
    }

    /// The components of U_hl for x = l²/2 > 0 and an h that is no critical value and not U(±r̂).
    ///
    /// `None`: two latitudes cannot be separated, which depends on h and not on the answer; another h in the same region
    /// may decide.
    pub fn components(&self, x: &RBig, h: &RBig) -> Option<Vec<Component>> {
        match self.model.active.len() {
            0 => Some(euler(self.model, x, h)),
            1 => axial::components(self.model, x, h),
            _ => curve::components(self.model, &self.whole, x, h),
        }
    }
}

/// r = 0: U ≤ h where J ≥ x/h.
fn euler(model: &Model, x: &RBig, h: &RBig) -> Vec<Component> {
    let inside = |a: &RBig| *h > RBig::ZERO && a * h >= *x;
    let dimension: usize = model.groups.iter().filter(|group| inside(&group.a)).map(|group| group.size).sum();
    let one = |boundary_circles| Component { boundary_circles, poles: None };
    match dimension {
        0 => Vec::new(),
        // Two caps, about the ends of one axis.
        1 => vec![one(1), one(1)],
        2 => vec![one(2)],
        _ => vec![one(0)],
    }
}

#[cfg(test)]
mod tests;
