//! What is found of manifolds.

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
    /// Two at each point of the orbit in P⁻; of an equilibrium, all.
    pub curves: Vec<Curve>,
    /// They are points of two motions, which no curve joins: of an equilibrium with one real and one imaginary pair.
    pub are_motions: bool,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Manifolds {
    surface: Surface,
    /// By orbit, the unstable ones first.
    pub manifolds: Vec<Manifold>,
    /// Orbits that run from one unstable orbit to one, the same or another: each once.
    pub connections: Vec<Connection>,
    /// Pairs of orbits of which a curve of one meets a curve of the other at angles too small to be told from 0.
    pub contacts: Vec<Contact>,
    /// Crossings of the polylines that could not be refined.
    pub unresolved: usize,
    /// Orbits whose multiplier is too large, or too near to 1, for their manifolds to be followed.
    pub left_out: Vec<usize>,
}

/// A homoclinic orbit, or a heteroclinic one.
#[derive(Clone, Copy, Debug)]
pub struct Connection {
    /// The place in the list of the orbit that it leaves.
    pub from: usize,
    /// That of the orbit to which it comes.
    pub to: usize,
    /// Of its points that were found the one that is farthest from both orbits.
    pub state: State,
    /// The angle of the curves there, in (γ, l/L), in radians.
    pub angle: f64,
    /// How far the points of both curves are from each other.
    pub residual: f64,
    /// How many of its points were found.
    pub points: usize,
}

/// Curves that run along each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contact {
    /// The place in the list of the orbit whose unstable curve it is.
    pub from: usize,
    /// That of the orbit whose stable curve it is.
    pub to: usize,
    /// At how many crossings of the polylines, or along how many motions.
    pub places: usize,
}

impl Manifolds {
    /// None, over a section.
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

    /// Counts one more place where a curve, or motion, of one runs along one of another.
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
