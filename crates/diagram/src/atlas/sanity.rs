//! What the theorems of `docs/mathematics.md` say of every atlas; called by unit, property and fuzz tests.

use thiserror::Error;

use super::{Atlas, whole_sphere};
use crate::arrangement::{InvariantError, RegionId, SlabId};
use crate::topology::{Component, accessible_regions};
use bifdiag_equilibria::curves::{CriticalSet, Curve, CurveId, Orbit, Pole};

/// A theorem that an atlas contradicts.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Contradiction {
    /// Euler's formula, an order of curves, or the sum of the indices.
    #[error(transparent)]
    Arrangement(#[from] InvariantError),
    /// No accessible region consists of these components (Theorem 11.1, Propositions 11.8 and 11.9).
    #[error("{region} shows {components:?}, which no body does")]
    Impossible {
        /// The region.
        region: RegionId,
        /// What it shows.
        components: Vec<Component>,
    },
    /// The components do not fit to the critical points below (Propositions 9.1, 9.2 and 9.5) or to the pole lines there.
    #[error("{region} shows {components:?}, but in {slab:?} the curves below and above it tell {expected:?}")]
    Curves {
        /// The region.
        region: RegionId,
        /// The slab of one of its cells.
        slab: SlabId,
        /// What it shows.
        components: Vec<Component>,
        /// What the curves tell.
        expected: Counts,
    },
}

/// What the curves below and above a cell say of U_hl.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// χ(U_hl): the sum of (−1)^index over the critical points below.
    pub euler_characteristic: i32,
    /// Minima below: U_hl has no more components.
    pub minima: u32,
    /// Maxima above: the complement of U_hl has no more components.
    pub maxima: u32,
    /// r̂ is in U_hl.
    pub plus: bool,
    /// −r̂ is in U_hl.
    pub minus: bool,
}

impl Atlas {
    /// Checks what must hold for every body: the invariants of the arrangement; in each region an accessible region that
    /// can occur; over each cell the Euler characteristic, the poles, and no more components of U_hl and of its complement
    /// than there are minima below and maxima above.
    ///
    /// # Errors
    /// The first [`Contradiction`] found.
    pub fn sanity_check(&self) -> Result<(), Contradiction> {
        self.arrangement.check_invariants()?;
        let euler = self.arrangement.set.frame.is_euler();
        let occurring = if euler { without_weight() } else { accessible_regions() };
        for (region, found) in self.regions.pairs() {
            let Ok(components) = &found.components else { continue };
            if !occurring.contains(components) {
                return Err(Contradiction::Impossible { region, components: components.clone() });
            }
        }
        self.arrangement.slabs.ids().try_for_each(|slab| self.check_cells(slab, !euler))
    }

    fn check_cells(&self, slab: SlabId, has_poles: bool) -> Result<(), Contradiction> {
        let (set, strip) = (&self.arrangement.set, &self.arrangement.slabs[slab]);
        for (position, &region) in strip.region_above.iter().enumerate() {
            let Ok(components) = &self.regions[region].components else { continue };
            let (below, above) = strip.order.split_at(position + 1);
            let expected = Counts::of(set, below, above);
            if !expected.fit(components, has_poles) {
                return Err(Contradiction::Curves { region, slab, components: components.clone(), expected });
            }
        }
        Ok(())
    }
}

impl Counts {
    fn of(set: &CriticalSet, below: &[CurveId], above: &[CurveId]) -> Self {
        let curves = |ids: &[CurveId]| ids.iter().map(|&c| &set.curves[c]).collect::<Vec<&Curve>>();
        let (below, above) = (curves(below), curves(above));
        let enters = |pole: Pole| below.iter().any(|curve| curve.entering_pole() == Some(pole));
        Self {
            euler_characteristic: below.iter().map(|curve| curve.euler_contribution()).sum(),
            minima: below.iter().map(|curve| extrema(curve, true)).sum(),
            maxima: above.iter().map(|curve| extrema(curve, false)).sum(),
            plus: enters(Pole::Plus),
            minus: enters(Pole::Minus),
        }
    }

    fn fit(self, components: &[Component], has_poles: bool) -> bool {
        let circles: u32 = components.iter().map(|component| component.boundary_circles).sum();
        let count = u32::try_from(components.len()).unwrap_or(u32::MAX);
        // The circles are the edges of a tree, the components on both sides of them its vertices (Proposition 9.5).
        let complement = (circles + 1).checked_sub(count);
        let has = |minus: bool| components.iter().filter_map(|c| c.poles).any(|p| if minus { p.minus } else { p.plus });
        let [plus, minus] = if has_poles { [self.plus, self.minus] } else { [false, false] };
        i64::from(self.euler_characteristic) == 2 * i64::from(count) - i64::from(circles)
            && count <= self.minima
            && complement.is_some_and(|circles| circles <= self.maxima && (circles == 0) == (self.maxima == 0))
            && (has(false), has(true)) == (plus, minus)
    }
}

/// Minima or maxima over each point of a curve; a circle of them counts once.
fn extrema(curve: &Curve, minima: bool) -> u32 {
    let index = match (curve.orbit, minima) {
        (Orbit::Pole(_), _) => return 0,
        (Orbit::Sphere, _) => return 1,
        (_, true) => 0,
        // The index across the circle.
        (Orbit::Circle(_), false) => 1,
        (_, false) => 2,
    };
    let points = if matches!(curve.orbit, Orbit::Pair(_)) { 2 } else { 1 };
    if curve.index == Some(index) { points } else { 0 }
}

/// For r = 0 U_hl is where a quadratic form is at least x/h: two caps, the sphere without two caps, or the sphere.
fn without_weight() -> Vec<Vec<Component>> {
    let component = |boundary_circles| Component { boundary_circles, poles: None };
    vec![vec![component(1); 2], vec![component(2)], vec![whole_sphere(false)]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrangement::Change;
    use crate::topology::Poles;
    use bifdiag_body::Preset;
    use bifdiag_numbers::table::Id;

    fn preset(name: &str) -> Atlas {
        Atlas::new(&Preset::find(name).unwrap().body()).unwrap()
    }

    #[test]
    fn every_preset_is_sane() {
        for preset in Preset::all() {
            Atlas::new(&preset.body()).unwrap().sanity_check().unwrap_or_else(|e| panic!("{}: {e}", preset.name()));
        }
    }

    #[test]
    fn a_sphere_without_three_discs_and_without_a_pole_is_impossible() {
        let mut atlas = preset("kovalevskaya");
        let three = Component { boundary_circles: 3, poles: Some(Poles { plus: true, minus: false }) };
        let region = atlas.regions.pairs().find(|(_, region)| region.components == Ok(vec![three])).unwrap().0;
        for poles in [Poles::default(), Poles { plus: false, minus: true }] {
            let components = vec![Component { poles: Some(poles), ..three }];
            atlas.regions[region].components = Ok(components.clone());
            assert_eq!(atlas.sanity_check(), Err(Contradiction::Impossible { region, components }));
        }
        let components = vec![Component { boundary_circles: 6, ..three }];
        atlas.regions[region].components = Ok(components.clone());
        assert_eq!(atlas.sanity_check(), Err(Contradiction::Impossible { region, components }));
    }

    #[test]
    fn any_region_with_the_components_of_another_contradicts_the_curves() {
        let atlas = preset("paper");
        for (region, own) in atlas.regions().pairs() {
            for other in atlas.regions().iter().filter(|other| other.components != own.components) {
                let mut changed = atlas.clone();
                changed.regions[region].components = other.components.clone();
                assert!(
                    matches!(changed.sanity_check(), Err(Contradiction::Curves { region: found, .. }) if found == region),
                    "{region}: {:?}",
                    other.components
                );
            }
        }
    }

    #[test]
    fn an_event_that_is_missing_breaks_eulers_formula() {
        let mut atlas = preset("paper");
        let events = atlas.arrangement.events.as_slice().to_vec();
        let crossing = events.iter().position(|event| matches!(event.change, Change::Swap(_))).unwrap();
        atlas.arrangement.events = events.iter().enumerate().filter(|(k, _)| *k != crossing).map(|(_, e)| *e).collect();
        assert!(matches!(atlas.sanity_check(), Err(Contradiction::Arrangement(InvariantError::Euler { .. }))));
    }

    #[test]
    fn curves_in_the_wrong_order_are_seen() {
        let mut atlas = preset("paper");
        let slab = SlabId::at(2);
        let order = &mut atlas.arrangement.slabs[slab].order;
        order.swap(0, 1);
        let [lower, upper] = [order[0], order[1]];
        let wrong = InvariantError::Order { slab, lower, upper };
        assert_eq!(atlas.sanity_check(), Err(Contradiction::Arrangement(wrong)));
    }
}
