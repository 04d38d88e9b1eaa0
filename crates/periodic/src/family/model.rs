//! Families, and how far they are followed.

use bifdiag_body::Number;
use bifdiag_dynamics::field::{Dimension, HeavyTop};
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::critical::CriticalError;
use bifdiag_schema::{FamilyEnd, OrbitEventKind};
use thiserror::Error;

use crate::orbit::PeriodicOrbit;

/// The quantity that is fixed along a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// l, that of the equilibrium.
    Momentum,
    /// h.
    Energy,
}

/// How far families are followed.
#[derive(Clone, Copy, Debug)]
pub struct FamilyOptions<'a> {
    /// The quantity held fixed.
    pub held: Held,
    /// The most members of a family, and of each branch.
    pub members: usize,
    /// Also follow the families that begin at doublings and branches or pass at triplings.
    pub branches: bool,
    /// Counts the orbits found, and can stop the work.
    pub monitor: &'a Monitor,
}

/// How a family ends.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// The kind of end.
    pub kind: FamilyEnd,
    /// The curves of the equilibria that it approaches; equilibria on no named curve are left out.
    pub curves: Vec<String>,
}

/// A special orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct OrbitEvent {
    /// What happens there.
    pub kind: OrbitEventKind,
    /// The number of the member after which it lies.
    pub after: usize,
    /// The orbit.
    pub orbit: PeriodicOrbit,
    /// The last change of h, or of l where h is held, in its search.
    pub error: f64,
    /// Families that begin there.
    pub branches: Vec<Stretch>,
}

/// Consecutive orbits of a family, with the special ones between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// The orbits.
    pub members: Vec<PeriodicOrbit>,
    /// The special orbits.
    pub events: Vec<OrbitEvent>,
    /// How it ends.
    pub end: End,
}

/// The family of an imaginary pair of an equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// The frequency ω of small oscillations.
    pub frequency: f64,
    /// The orbits, starting at the equilibrium.
    pub stretch: Stretch,
}

/// Why no family can be followed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FamilyError {
    /// The equilibria of the body are not known.
    #[error(transparent)]
    Critical(#[from] CriticalError),
}

impl Stretch {
    pub(super) fn none(kind: FamilyEnd) -> Self {
        Self { members: Vec::new(), events: Vec::new(), end: End { kind, curves: Vec::new() } }
    }

    /// Converts from the units of the reduced top to those of the top as given.
    pub(super) fn restore(&mut self, top: &HeavyTop, held: Held) {
        let dimension = match held {
            Held::Momentum => Dimension::ENERGY,
            Held::Energy => Dimension::MOMENTUM,
        };
        self.members = std::mem::take(&mut self.members).into_iter().map(|orbit| orbit.restored(top)).collect();
        for event in &mut self.events {
            event.orbit = event.orbit.clone().restored(top);
            event.error = top.units().restore(event.error, dimension);
            event.branches.iter_mut().for_each(|branch| branch.restore(top, held));
        }
    }
}

/// A double as an exact number.
pub(super) fn number(x: f64) -> Option<Number> {
    format!("{x:?}").parse().ok()
}
