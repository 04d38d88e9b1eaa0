//! Exact answers about the (h, l) half-plane of a body: [`atlas`], [`classify`] and [`critical`], one function for each
//! question, and [`Solver`] for many questions about one body; [`State`], [`AxisSpins`] and [`AllSpins`] for states and
//! spins. Each tries `f64` with error bounds first
//! ([`bifdiag_diagram::fast`]) and continues with exact arithmetic where these do not suffice.
//!
//! [`CertifiedAtlas`] proves the whole plane from rationals:
//!
//! - **Cusps** are the roots of an integer polynomial of degree at most ten, isolated by Descartes' rule
//!   (`curves`); **meetings with pole lines** those of one of degree at most sixteen (`polar`). None can be missed.
//! - **Crossings** of two critical curves are alone in their boxes, and on every other stretch of x the order of the two
//!   is proved (`pair`), up to x = l²/2 → 0 and ∞, in interval arithmetic of growing precision.
//! - A critical point with μ ≥ the largest moment is the global minimum. For critical γ and any γ' on the sphere
//!   U(γ') − U(γ) = (s/2)[⟨γ'−γ, (μ−A)(γ'−γ)⟩ + (J'−J)²/J'] (Proposition 3.9 of docs/mathematics.md), which
//!   then is not negative. So the lowest curve needs no comparison.
//! - **Events** are ordered by disjoint enclosures of x, or proved to coincide by gcd; **faces** follow from the
//!   vertical orders at one exact x between events, each proved (`arrange`).
//! - **Topology** comes from the ridges of J over the latitudes (`ridges`), at a point proved to lie in the face (`region`).
//!
//! What cannot be proved is an error that says where, never an answer. Nothing is shared with the `f64` arrangement but
//! vocabulary ([`bifdiag_equilibria::curves::Branch`] and its like).

mod answers;
mod arrange;
mod certificate;
mod conversion;
mod critical_values;
mod curves;
mod equal_momentum;
mod estimate;
mod evaluator;
mod family;
mod id;
mod mirror;
mod model;
mod pair;
mod plane;
mod plane_point;
mod polar;
mod region;
mod ridges;
mod solver;
mod spins;
mod state;
pub mod statistics;
mod steady;
mod vertex;

use std::fmt;

use thiserror::Error;

pub use answers::{Accuracy, AnswerError, atlas, classify};
pub use bifdiag_equilibria::critical::critical;
pub use plane::Open;
pub use plane_point::{PlaceError, classify_exactly};
pub use solver::Solver;
pub use spins::{AllSpins, AxisSpins, EndUp};
pub use state::{State, UnknownOfState};
pub use steady::{SpinQuestion, Steady};

use arrange::{Arrangement, Undecided};
use bifdiag_body::{Body, Frame};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::topology::Component;
use bifdiag_equilibria::curves::{CurveId, CurveName, EquilibriaError};
use bifdiag_numbers::table::Table;
use curves::{Curves, IsolationError};
use model::Model;
use region::Region;

/// A proved atlas.
#[derive(Clone, Debug)]
pub struct CertifiedAtlas {
    body: Body,
    frame: Frame,
    arrangement: Arrangement,
    regions: Table<RegionId, Region>,
}

/// Why the arrangement of a body is not proved. Ranges are in the body's units.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Obstacle {
    /// Roots that neither isolation nor gcd separates.
    #[error("two roots of the polynomial of {of} cannot be told apart")]
    Roots {
        /// What its roots are.
        of: Special,
    },
    /// A degenerate critical point that is no ordinary cusp or pitchfork.
    #[error("the body has a degenerate relative equilibrium that is no ordinary cusp or pitchfork")]
    Degenerate,
    /// Whether two curves cross.
    #[error("the order of the curves {} and {} between l = {} and l = {}", curves[0], curves[1], l[0], l[1])]
    Order {
        /// Names of the curves.
        curves: [CurveName; 2],
        /// Range of l.
        l: [f64; 2],
    },
    /// Two events on a common curve.
    #[error("the order of two events of the curves {} between l = {} and l = {}", list(curves), l[0], l[1])]
    Events {
        /// Names of the curves.
        curves: Vec<CurveName>,
        /// Range of l.
        l: [f64; 2],
    },
    /// The vertical order of the curves over one l.
    #[error("the vertical order of the curves near l = {l}")]
    Heights {
        /// Near this l.
        l: f64,
    },
}

fn list(names: &[CurveName]) -> String {
    names.iter().map(CurveName::to_string).collect::<Vec<_>>().join(", ")
}

/// What the roots of a polynomial are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Special {
    /// The cusps of the generic family, 4(q'D − 2qD')p − 3(p'D − 2pD')q.
    Cusps,
    /// The meetings of pole lines with critical curves, N² − r²p³D².
    Meetings,
}

impl fmt::Display for Special {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Cusps => "cusps, 4(q'D - 2qD')p - 3(p'D - 2pD')q",
            Self::Meetings => "meetings with pole lines, N^2 - r^2 p^3 D^2",
        })
    }
}

/// Why there is no certified atlas.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("not proved with {} bits and {} points of each pair of curves: {}", arrange::STAGES[arrange::STAGES.len() - 1], pair::POINTS, obstacles.iter().map(Obstacle::to_string).collect::<Vec<_>>().join("; "))]
pub struct ProofError {
    /// Each of them.
    pub obstacles: Vec<Obstacle>,
}

/// Why a proved atlas cannot be written as a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ConversionError {
    /// The curves cannot be drawn.
    #[error(transparent)]
    Equilibria(EquilibriaError),
    /// In `f64` other curves are found than those that are proved.
    #[error("the curves as drawn in f64 are not those that are proved: their cusps cannot be told apart in f64")]
    Curves,
}

impl CertifiedAtlas {
    /// Proves the arrangement of a body and the topology of its regions.
    ///
    /// # Errors
    /// [`ProofError`] when the order of curves or events is not proved with the largest precision. A region whose topology
    /// alone is not proved is no error: see [`Self::components`].
    pub fn new(body: &Body) -> Result<Self, ProofError> {
        Self::with_points(body, pair::POINTS)
    }

    /// The same with no more points of each pair of curves.
    pub(crate) fn with_points(body: &Body, points: u32) -> Result<Self, ProofError> {
        let frame = body.frame();
        let model = Model::new(body, &frame);
        let curves = Curves::of(&model)
            .map_err(|IsolationError| ProofError { obstacles: vec![Obstacle::Roots { of: Special::Cusps }] })?;
        let arrangement = arrange::arrange(model, &curves, points).map_err(|undecided| ProofError {
            obstacles: undecided.iter().map(|u| obstacle(&frame, &curves, u)).collect(),
        })?;
        let regions = region::regions(&arrangement, &frame);
        Ok(Self { body: body.clone(), frame, arrangement, regions })
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// How many regions there are: proved.
    #[must_use]
    pub fn region_count(&self) -> usize {
        self.regions.len()
    }

    /// The regions, in order.
    #[must_use]
    pub fn region_ids(&self) -> impl ExactSizeIterator<Item = RegionId> + use<> {
        self.regions.ids()
    }

    /// How many points there are at which curves meet.
    #[must_use]
    pub fn event_count(&self) -> usize {
        self.arrangement.events.len()
    }

    /// The components of U_hl in a region; `None` when they are not proved.
    #[must_use]
    pub fn components(&self, region: RegionId) -> Option<&[Component]> {
        self.regions[region].components.as_deref().ok()
    }

    /// The bits that were needed at most; 53 when `f64` sufficed everywhere.
    #[must_use]
    pub fn bits(&self) -> usize {
        self.arrangement.bits.max(53)
    }
}

fn obstacle(frame: &Frame, list: &Curves, undecided: &Undecided) -> Obstacle {
    let momentum = |x: f64| (2.0 * x).sqrt() * frame.momentum_unit;
    let name = |curve: CurveId| list.list[curve].name(frame);
    match undecided {
        Undecided::Roots => Obstacle::Roots { of: Special::Meetings },
        Undecided::Degenerate => Obstacle::Degenerate,
        Undecided::Pair { curves, x } => Obstacle::Order { curves: curves.map(name), l: x.map(momentum) },
        Undecided::Events { curves, x } => {
            Obstacle::Events { curves: curves.iter().map(|&c| name(c)).collect(), l: x.map(momentum) }
        }
        Undecided::Order { x } | Undecided::Gluing { x } => Obstacle::Heights { l: momentum(*x) },
    }
}
