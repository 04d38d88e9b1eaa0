//! The stable and unstable manifolds of unstable periodic orbits in the section, and where they cross.
//!
//! The unstable manifold of an orbit is a curve through each of its points of P⁻, the maxima of ⟨γ,r⟩, and R takes these curves to
//! each other. The reversal (γ,l) ↦ (γ,−l) takes motions at l to motions at −l run backwards, and P⁻ to P⁻: stable manifolds are
//! the images of the unstable ones at −l.

mod crossing;
mod curve;
mod grow;
mod model;
mod refine;
mod world;

use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, SectionError};
use bifdiag_schema::ManifoldKind;
use thiserror::Error;

pub use crossing::Crossing;
pub use curve::{Curve, Vertex};
pub use model::{Connection, Contact, Manifold, Manifolds};

use crate::chart::Surface;
use crate::flow::Phase;
use crate::list::OrbitList;
use crate::orbit::{OrbitError, unstable_direction};
use crate::section_map::SectionMap;
use curve::Branch;
use world::World;

/// How far manifolds are followed.
#[derive(Clone, Copy, Debug)]
pub struct ManifoldOptions {
    /// The length of each curve, in (γ, l/L), L = √(2A_max(|h| + |r|)).
    pub length: f64,
}

impl Default for ManifoldOptions {
    fn default() -> Self {
        Self { length: 10.0 }
    }
}

/// Why there are no manifolds.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ManifoldError {
    /// A motion could not be followed, or the work was stopped.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// The directions of an orbit could not be found.
    #[error("the directions of an orbit cannot be found")]
    Orbit(#[from] OrbitError),
}

/// Multipliers between which manifolds are followed: the curve begins 10⁻⁴ from the orbit, and its first piece ends at that
/// distance over the multiplier.
const MULTIPLIERS: [f64; 2] = [1.01, 1e6];

/// The manifolds of the unstable orbits of a list, and where they cross.
///
/// # Errors
/// [`ManifoldError`].
pub fn manifolds(
    setting: &SectionSetting,
    list: &OrbitList,
    options: &ManifoldOptions,
    monitor: &Monitor,
) -> Result<Manifolds, ManifoldError> {
    let top = setting.torus().top();
    let surfaces = [setting.l(), -setting.l()].map(|l| Surface::new(top, setting.h(), l));
    let world = |is_reversed: bool| World {
        map: SectionMap::new(&surfaces[usize::from(is_reversed)], setting.torus(), list.longest, monitor),
        is_reversed,
    };
    let worlds = [world(false), world(true)];
    let mut found = Manifolds::default();
    let mut targets: Vec<Phase> = Vec::new();
    let mut branches: Vec<Branch> = Vec::new();
    for (place, listed) in list.orbits.iter().enumerate() {
        let orbit = &listed.orbit;
        if !orbit.stability.is_unstable() {
            continue;
        }
        let turns = (orbit.crossings / 2) as usize;
        let start = surfaces[0].point(&orbit.start);
        let images = worlds[0].map.images(&[start], turns)?;
        targets.extend(images[0].iter().map(|image| image.point));
        let size = orbit.multipliers[0][0].abs();
        // Where −1 is the sign, a curve comes back to itself after two periods.
        let size = if orbit.multipliers[0][0] < 0.0 { size * size } else { size };
        if !(MULTIPLIERS[0]..MULTIPLIERS[1]).contains(&size) {
            found.left_out.push(place);
            continue;
        }
        for world in &worlds {
            let point = world.seen(&start);
            let (multiplier, across) = unstable_direction(top, &world.surface().state(&point), orbit.period)?;
            let made = Branch::pair(world, place, turns, point, multiplier, &across);
            if made.is_empty() && !found.left_out.contains(&place) {
                found.left_out.push(place);
            }
            branches.extend(made);
        }
    }
    for (place, branch) in branches.iter().enumerate() {
        let world = &worlds[usize::from(branch.is_stable)];
        let curves = grow::grow(world, (place, branch), &targets, options.length)?;
        let kind = if branch.is_stable { ManifoldKind::Stable } else { ManifoldKind::Unstable };
        match found.manifolds.last_mut().filter(|last| last.orbit == branch.orbit && last.kind == kind) {
            Some(last) => last.curves.extend(curves),
            None => found.manifolds.push(Manifold { orbit: branch.orbit, kind, multiplier: branch.multiplier, curves }),
        }
    }
    crossing::connect(&worlds, &branches, &targets, &mut found)?;
    Ok(found)
}
