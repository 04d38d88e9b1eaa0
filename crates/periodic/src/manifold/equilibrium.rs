//! The manifolds of unstable equilibria, at their energy.
//!
//! Along steady rotations S and all its derivatives vanish: an equilibrium lies in P, on the line of tangency, and at
//! its own energy E and P are singular there. So no curve can start in a chart of P. Motions start on the manifold
//! itself, which is a power series near the equilibrium, and are followed to P⁻.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{Dimension, HeavyTop, State};
use bifdiag_dynamics::section::{Monitor, PpTorus};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity};
use bifdiag_equilibria::stability::LinearType;

use super::curve::Branch;
use super::model::Manifolds;
use super::ring::Ring;
use super::series::{Rates, Series};
use super::world::{REST, World};
use super::{ManifoldError, ManifoldOptions, crossing, grow, strand};
use crate::chart::Surface;
use crate::flow::Phase;
use crate::list::longest;
use crate::section_map::SectionMap;

/// A motion that comes within [`REST`] of an equilibrium needs more than this many growth times to pass it.
const LONG: f64 = 10.0;

/// The manifolds of the equilibria on one curve at one l, which share their energy, and where they cross. Numbers of
/// orbits in the result are numbers of equilibria in the list given.
///
/// # Errors
/// [`ManifoldError`], also for stable equilibria.
pub fn manifolds_of_equilibria(
    body: &Body,
    equilibria: &[Equilibrium],
    options: &ManifoldOptions,
    monitor: &Monitor,
) -> Result<Manifolds, ManifoldError> {
    let top = HeavyTop::new(body);
    let torus = PpTorus::new(&top)?;
    let Some(first) = equilibria.first() else { return Err(ManifoldError::NotIsolated) };
    let surface = Surface::new(&top, first.h, first.l);
    let surfaces = [surface, surface.reversed()];
    let point = |found: &Equilibrium| surface.point(&rest(found, &top));
    let targets: Vec<Phase> = equilibria.iter().map(point).collect();
    let growths = equilibria.iter().flat_map(|found| found.eigenvalues.pairs).map(|[re, _]| re).filter(|re| *re > 0.0);
    let [least, most] = growths.fold([f64::INFINITY, 0.0], |[a, b]: [f64; 2], re| [a.min(re), b.max(re)]);
    let waiting = longest(&top) - 2.0 * libm::log(REST) / least;
    let world = |is_reversed: bool| World {
        map: SectionMap::new(&surfaces[usize::from(is_reversed)], &torus, waiting, monitor),
        is_reversed,
        rests: Vec::new(),
        long: LONG / most,
    };
    let mut worlds = [world(false), world(true)];
    for world in &mut worlds {
        world.rests = targets.iter().map(|target| world.mirrored(target)).collect();
    }
    let mut found = Manifolds::none(surface);
    let mut branches: Vec<Branch> = Vec::new();
    for (place, equilibrium) in equilibria.iter().enumerate() {
        let rates = rates(equilibrium, &top)?;
        for world in &worlds {
            let surface = world.surface();
            let series = Series::new(surface.space(), world.rests[place], rates).ok_or(ManifoldError::Series)?;
            if let Rates::One(_) = rates {
                found.manifolds.push(strand::manifold(world, place, &series)?);
            } else {
                let ring = Ring::new(surface, series).ok_or(ManifoldError::Ring)?;
                branches.push(Branch::of_rest(world, place, ring));
            }
        }
    }
    grow::grow_all(&worlds, &branches, &targets, options.length, &mut found)?;
    strand::connect(&mut found);
    if !branches.is_empty() {
        crossing::connect(&worlds, &branches, &targets, &mut found)?;
    }
    Ok(found)
}

/// (γ, l) of an equilibrium, l = A(Ωγ), rounded as where its manifolds begin.
#[must_use]
pub fn rest(equilibrium: &Equilibrium, top: &HeavyTop) -> State {
    let gamma = equilibrium.gamma;
    State { gamma, l: top.inertia(gamma.map(|x| equilibrium.omega * x)) }
}

/// The growth rates, in the units of the reduced top.
fn rates(equilibrium: &Equilibrium, top: &HeavyTop) -> Result<Rates, ManifoldError> {
    if equilibrium.multiplicity != Multiplicity::Points(1) {
        return Err(ManifoldError::NotIsolated);
    }
    let reduced = |x: f64| top.units().reduce(x, Dimension::FREQUENCY);
    let [first, second] = equilibrium.eigenvalues.pairs.map(|pair| pair.map(reduced));
    match equilibrium.stability {
        LinearType::SaddleCentre => Ok(Rates::One(first[0].max(second[0]))),
        LinearType::Saddle | LinearType::DoubleReal => {
            Ok(Rates::Two([first[0].min(second[0]), first[0].max(second[0])]))
        }
        LinearType::Complex => Ok(Rates::Pair(first)),
        kind => Err(ManifoldError::Type(kind.term())),
    }
}
