//! The stable and unstable manifolds of unstable periodic orbits and of equilibria in the section, and where they
//! cross.
//!
//! The unstable manifold of an orbit is a curve through each of its points of P⁻, the maxima of ⟨γ,r⟩, and R maps these
//! curves to each other. The reversal (γ,l) ↦ (γ,−l) takes motions at l to motions at −l run backwards, and P⁻ to P⁻:
//! stable manifolds are the images of the unstable ones at −l.

mod crossing;
mod curve;
mod equilibrium;
mod grow;
mod model;
mod refine;
mod ring;
mod series;
mod strand;
mod world;

use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, SectionError};
use thiserror::Error;

pub use crossing::Crossing;
pub use curve::{Curve, Vertex};
pub use equilibrium::{manifolds_of_equilibria, rest};
pub use model::{Connection, Contact, Manifold, Manifolds};

use crate::chart::Surface;
use crate::flow::Phase;
use crate::list::OrbitList;
use crate::orbit::{OrbitError, unstable_direction};
use crate::section_map::SectionMap;
use bifdiag_schema::Stability;
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
    /// The unstable direction of an orbit could not be found.
    #[error("the directions of an orbit cannot be found")]
    Orbit(#[from] OrbitError),
    /// The equilibrium is stable or degenerate.
    #[error(
        "the equilibrium is of type {}: manifolds are followed only for the types saddle-centre, saddle and complex, where the \
         eigenvalues alone determine which motions leave it",
        .0.word()
    )]
    Type(Stability),
    /// It is one of a circle or sphere of equilibria, or lies where a curve ends.
    #[error(
        "the equilibrium is not isolated, or two of them meet there: manifolds are followed only for isolated equilibria"
    )]
    NotIsolated,
    /// The series has no coefficients, or they grow too fast.
    #[error(
        "the motions that leave the equilibrium cannot be expanded in a series about it: an eigenvalue is nearly a multiple of \
         another, or eigenvectors are nearly parallel"
    )]
    Series,
    /// The closed curve on which motions begin touches P⁻.
    #[error("the motions that leave the equilibrium cannot be separated where their crossings of the section begin")]
    Ring,
}

/// Manifolds are followed for multipliers between these: the first piece of a curve reaches from 10⁻⁴ over the
/// multiplier to 10⁻⁴ from the orbit.
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
    let surface = Surface::new(top, setting.h(), setting.l());
    let surfaces = [surface, surface.reversed()];
    let world = |is_reversed: bool| World {
        map: SectionMap::new(&surfaces[usize::from(is_reversed)], setting.torus(), list.longest, monitor),
        is_reversed,
        rests: Vec::new(),
        long: f64::INFINITY,
    };
    let worlds = [world(false), world(true)];
    let mut found = Manifolds::none(surface);
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
        // With a negative multiplier a curve returns to itself after two periods.
        let size = if orbit.multipliers[0][0] < 0.0 { size * size } else { size };
        if !(MULTIPLIERS[0]..MULTIPLIERS[1]).contains(&size) {
            found.left_out.push(place);
            continue;
        }
        for world in &worlds {
            let point = world.mirrored(&start);
            let (multiplier, across) = unstable_direction(top, &world.surface().state(&point), orbit.period)?;
            let made = Branch::pair(world, place, turns, point, multiplier, &across);
            if made.is_empty() && !found.left_out.contains(&place) {
                found.left_out.push(place);
            }
            branches.extend(made);
        }
    }
    grow::grow_all(&worlds, &branches, &targets, options.length, &mut found)?;
    crossing::connect(&worlds, &branches, &targets, &mut found)?;
    Ok(found)
}
