//! A periodic orbit and its description.

use bifdiag_dynamics::field::{Dimension, HeavyTop, State, dot};
use bifdiag_dynamics::integrator::StepError;
use bifdiag_numbers::vector::norm;
use bifdiag_schema::OrbitStability;
use thiserror::Error;

use crate::flow::{Level, Phase, Space};
use crate::reversor::{Reversor, all_are_symmetric, reversors};
use crate::shooting::{Keep, Ring, ShootingError, Shot};
use crate::walk::walk;

/// A periodic orbit of γ and l.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicOrbit {
    /// One of its points: a maximum of ⟨γ,r⟩, which lies on P, if it has one.
    pub start: State,
    /// Energy.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
    /// Period.
    pub period: f64,
    /// Its crossings of P in a period: zeros of S = ⟨ω, r×γ⟩, inward and outward.
    pub crossings: u32,
    /// The multipliers other than those that h, l and the flow make 1, each [re, im].
    pub multipliers: [[f64; 2]; 2],
    /// The linear stability that follows from them.
    pub stability: OrbitStability,
    /// Their sum.
    pub trace: f64,
    /// ∮⟨l, ω⟩ dt, twice the integral of the kinetic energy.
    pub action: f64,
    /// A reversor maps it to itself.
    pub symmetric: bool,
    /// The largest closing defect between neighbouring nodes, where |γ| and the largest |l| at its energy are 1.
    pub residual: f64,
}

/// Why an orbit could not be found or described.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum OrbitError {
    /// It could not be closed.
    #[error(transparent)]
    Shooting(#[from] ShootingError),
    /// The motion leaves the range of `f64`.
    #[error(transparent)]
    Step(#[from] StepError),
}

/// What remains fixed while a guess is corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fixed {
    /// Its l, and the position of its first point along the family.
    Momentum,
    /// Its h, likewise.
    Energy,
    /// Its h and l.
    Both,
}

/// A smaller l, relative to the length of the angular momentum, is 0.
const LEVEL: f64 = 1e-13;

/// Half traces closer than this to 1 or −1 count as parabolic.
const PARABOLIC: f64 = 1e-9;

/// The linear stability of an orbit with this trace.
#[must_use]
pub fn stability(trace: f64) -> OrbitStability {
    let half = 0.5 * trace;
    if (half.abs() - 1.0).abs() <= PARABOLIC {
        OrbitStability::Parabolic
    } else if half > 1.0 {
        OrbitStability::Hyperbolic
    } else if half < -1.0 {
        OrbitStability::InverseHyperbolic
    } else {
        OrbitStability::Elliptic
    }
}

impl PeriodicOrbit {
    /// Describes an orbit that closes up to rounding. It is not corrected; its residual says how well it closes.
    ///
    /// # Errors
    /// [`OrbitError`] at an equilibrium, and where the motion leaves the range of `f64`.
    pub fn new(top: &HeavyTop, start: &State, period: f64) -> Result<Self, OrbitError> {
        let units = top.units();
        let (space, x, time) = reduced(top, start, period);
        let shot = around(&space, &x, time)?;
        let momentum = start.reduced(units).l;
        let l = dot(start.gamma, momentum);
        // At l = 0 time may be reversed by turning the momentum around alone; rounding leaves some of l.
        let l = if l.abs() <= LEVEL * norm(momentum) { 0.0 } else { l };
        let about = About { space: &space, reversors: &reversors(&space.top, l) };
        Ok(about.describe(&shot).restored(top))
    }

    /// The orbit of the reduced top in the units of the top as given.
    #[must_use]
    pub fn restored(mut self, top: &HeavyTop) -> Self {
        let units = top.units();
        self.start = self.start.restored(units);
        self.h = units.restore(self.h, Dimension::ENERGY);
        self.l = units.restore(self.l, Dimension::MOMENTUM);
        self.period = units.restore(self.period, Dimension::TIME);
        self.action = units.restore(self.action, Dimension::MOMENTUM);
        self
    }

    /// The product of the multipliers, as computed: 1 up to rounding.
    #[must_use]
    pub fn product(&self) -> f64 {
        let [[a, b], [c, d]] = self.multipliers;
        a * c - b * d
    }
}

/// The larger multiplier of an unstable orbit, and its eigendirection across the orbit at the start.
///
/// # Errors
/// [`OrbitError`] at an equilibrium, and where the motion leaves the range of `f64`.
pub fn unstable_direction(top: &HeavyTop, start: &State, period: f64) -> Result<(f64, Phase), OrbitError> {
    let (space, x, time) = reduced(top, start, period);
    let shot = around(&space, &x, time)?;
    let reduced = shot.reduced();
    let (matrix, multiplier) = (reduced.matrix, reduced.multipliers()[0][0]);
    // (M − λ)v = 0, from the longer row.
    let rows = [0, 1].map(|i| {
        [matrix[(i, 0)] - if i == 0 { multiplier } else { 0.0 }, matrix[(i, 1)] - if i == 1 { multiplier } else { 0.0 }]
    });
    let [a, b] = if dot2(rows[0]) >= dot2(rows[1]) { rows[0] } else { rows[1] };
    let across = shot.frames[0].across;
    Ok((multiplier, (across[0] * b - across[1] * a).normalize()))
}

fn dot2([a, b]: [f64; 2]) -> f64 {
    a * a + b * b
}

/// Corrects a guess to a closed orbit; returns its start and its period.
///
/// # Errors
/// [`OrbitError`] where no orbit is near, or a continuum of them.
pub fn correct(top: &HeavyTop, start: &State, period: f64, fixed: Fixed) -> Result<(State, f64), OrbitError> {
    let units = top.units();
    let (space, x, time) = reduced(top, start, period);
    let (h, l) = (space.top.energy(&space.state(&x)), x.fixed_rows::<3>(0).dot(&x.fixed_rows::<3>(3)));
    let [_, of_l, of_h] = space.gradients(&x);
    let place = |gradient: Phase| Keep::Place(gradient.normalize().push(0.0));
    let (level, keep) = match fixed {
        Fixed::Both => (Level::Momentum(l), Keep::Energy(h)),
        Fixed::Momentum => (Level::Momentum(l), place(of_h)),
        Fixed::Energy => (Level::Energy(h), place(of_l)),
    };
    let shot = around(&space, &x, time)?.ring.close(&space, level, keep, None)?;
    let state = space.state(&shot.ring.nodes[0]).restored(units);
    Ok((state, units.restore(shot.ring.period, Dimension::TIME)))
}

fn reduced(top: &HeavyTop, start: &State, period: f64) -> (Space, Phase, f64) {
    let units = top.units();
    let start = start.reduced(units);
    let space = Space::new(top, top.reduced().energy(&start));
    let point = space.point(&start);
    (space, point, units.reduce(period, Dimension::TIME))
}

/// The number of nodes of a ring is a multiple of this, the number of motions that the widest registers follow at once.
pub const NODES: usize = 8;
/// More stretching than this from node to node costs digits.
const STRETCH: f64 = 100.0;
const MOST_NODES: usize = 64;

/// The motion from a point during a period, as an orbit.
fn around(space: &Space, start: &Phase, period: f64) -> Result<Shot, ShootingError> {
    let mut nodes = vec![*start];
    for k in 1..NODES {
        nodes.extend(space.ends(&nodes[k - 1..], period / NODES as f64)?);
    }
    // (Any level will do: the derivative across an orbit does not depend on it.)
    spread(space, Ring { nodes, period }.shoot(space, Level::Momentum(0.0), None)?)
}

/// The same orbit with as many nodes as its stretching needs.
///
/// # Errors
/// [`ShootingError::Step`].
pub fn spread(space: &Space, mut shot: Shot) -> Result<Shot, ShootingError> {
    while shot.chain().stretch() > STRETCH && shot.ring.nodes.len() < MOST_NODES {
        let ring = &shot.ring;
        let middles = space.ends(&ring.nodes, 0.5 * ring.period / ring.nodes.len() as f64)?;
        let nodes = ring.nodes.iter().zip(&middles).flat_map(|(node, middle)| [*node, *middle]).collect();
        shot = Ring { nodes, period: ring.period }.shoot(space, shot.level, None)?;
    }
    Ok(shot)
}

/// What the description of an orbit depends on.
#[derive(Clone, Copy)]
pub struct About<'a> {
    /// The space of its points.
    pub space: &'a Space,
    /// The reversors at its l.
    pub reversors: &'a [Reversor],
}

impl About<'_> {
    /// Describes a closed orbit, in the units of the reduced top.
    #[must_use]
    pub fn describe(&self, shot: &Shot) -> PeriodicOrbit {
        let Self { space, reversors } = *self;
        let seen = walk(space, shot, reversors);
        let reduced = shot.reduced();
        let state = space.state(&shot.ring.nodes[0]);
        PeriodicOrbit {
            start: seen.maximum.unwrap_or(state),
            h: space.top.energy(&state),
            l: dot(state.gamma, state.l),
            period: shot.ring.period,
            crossings: seen.crossings,
            multipliers: reduced.multipliers(),
            stability: stability(reduced.trace()),
            trace: reduced.trace(),
            action: seen.action,
            symmetric: seen.symmetric || all_are_symmetric(&space.top),
            residual: shot.residual,
        }
    }
}
