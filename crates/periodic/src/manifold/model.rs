//! Manifolds and their connections, as they are found.

use bifdiag_dynamics::field::State;
use bifdiag_schema::ManifoldKind;

use super::curve::{Curve, Vertex};
use crate::chart::Surface;

/// The curves of one kind of one orbit.
#[derive(Clone, Debug)]
pub struct Manifold {
    /// The place of the orbit in the list, or of the equilibrium among those that were given.
    pub orbit: usize,
    /// Stable or unstable.
    pub kind: ManifoldKind,
    /// Of an orbit: the multiplier that is larger than 1, or below −1.
    pub multiplier: Option<f64>,
    /// Two at each point of the orbit in P⁻; for an equilibrium, all.
    pub curves: Vec<Curve>,
    /// The points belong to two motions, which no curve joins: for an equilibrium with one real and one imaginary pair.
    pub are_motions: bool,
}

/// The result.
#[derive(Clone, Debug)]
pub struct Manifolds {
    surface: Surface,
    /// By orbit, the unstable ones first.
    pub manifolds: Vec<Manifold>,
    /// Orbits that run from an unstable orbit to the same or another one, each listed once.
    pub connections: Vec<Connection>,
    /// Pairs of orbits whose curves meet at angles too small to distinguish from 0.
    pub contacts: Vec<Contact>,
    /// Crossings of the polylines that could not be refined.
    pub unresolved: usize,
    /// Orbits whose multiplier is too large or too close to 1 for their manifolds to be followed.
    pub left_out: Vec<usize>,
}

/// A homoclinic orbit, or a heteroclinic one.
#[derive(Clone, Copy, Debug)]
pub struct Connection {
    /// The number of the orbit that it leaves.
    pub from: usize,
    /// The number of the orbit that it approaches.
    pub to: usize,
    /// The point found that is farthest from the periodic orbits.
    pub state: State,
    /// The angle of the curves there, in (γ, l/L), in radians.
    pub angle: f64,
    /// The distance between the points of the two curves.
    pub residual: f64,
    /// How many of its points were found.
    pub points: usize,
}

/// Curves that run along each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contact {
    /// The number of the orbit with the unstable curve.
    pub from: usize,
    /// The number of the orbit with the stable curve.
    pub to: usize,
    /// The number of crossings of the polylines, or of motions, where this happens.
    pub places: usize,
}

impl Manifolds {
    /// An empty result over a section.
    pub(super) fn none(surface: Surface) -> Self {
        Self {
            surface,
            manifolds: Vec::new(),
            connections: Vec::new(),
            contacts: Vec::new(),
            unresolved: 0,
            left_out: Vec::new(),
        }
    }

    /// Counts one more place where a curve or motion of one orbit runs along one of another.
    pub(super) fn touch(&mut self, from: usize, to: usize) {
        match self.contacts.iter_mut().find(|known| [known.from, known.to] == [from, to]) {
            Some(known) => known.places += 1,
            None => self.contacts.push(Contact { from, to, places: 1 }),
        }
    }

    /// The state at a point of a curve.
    #[must_use]
    pub fn state(&self, vertex: &Vertex) -> State {
        self.surface.state(&vertex.point)
    }
}
