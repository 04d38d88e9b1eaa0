//! All relative equilibria of a body at one l, at many, or at one spin.

mod beyond;
mod continuation;
mod families;
mod found;

use std::sync::{Arc, OnceLock};

use dashu_ratio::RBig;
use thiserror::Error;

use crate::curves::{Branch, CriticalSet, CurveId, CurveName, EquilibriaError, MomentumError, abscissa, branch_words};
use crate::nonlinear::{Friction, Nonlinear};
use crate::stability::exact::StabilityProfile;
use crate::stability::{Constants, Eigenvalues, LinearType};
use bifdiag_body::{Body, Number};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::table::Id;

pub use families::{Place, SteadyFamily, SteadyStretch};

/// How many critical points an entry stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Multiplicity {
    /// One critical point; 2 is a degenerate root (at a cusp or pitchfork).
    Points(u32),
    /// A circle of critical points (Lagrange's top); `gamma` is one of them.
    Circle,
    /// All of S² is critical (r = 0).
    Sphere,
}

/// A relative equilibrium: the body turns about the vertical γ with constant angular velocity ω γ.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium {
    /// Vertical angular momentum.
    pub l: f64,
    /// Energy h = U_l(γ).
    pub h: f64,
    /// The vertical in body coordinates.
    pub gamma: [f64; 3],
    /// Angular velocity l / J(γ), with the sign of l.
    pub omega: f64,
    /// Morse index of U_l: 0 minimum, 1 saddle, 2 maximum; across a circle.
    pub index: u8,
    /// How many critical points this entry stands for.
    pub multiplicity: Multiplicity,
    /// Of those at one spin: two steady axes meet here, of which slower or faster spins have none.
    pub is_fold: bool,
    /// The type of the flow reduced by l, linearised.
    pub stability: LinearType,
    /// What is known of its stability; of a circle or sphere as a whole.
    pub nonlinear: Nonlinear,
    /// What damping leaves of it.
    pub friction: Friction,
    /// The eigenvalues of the flow reduced by l, per unit of time.
    pub eigenvalues: Eigenvalues,
    /// The curve on which it lies; `None` when no curve carries it.
    pub curve: Option<CurveName>,
    /// Its branch in words.
    pub branch_name: Arc<str>,
}

/// All relative equilibria at one l.
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibria {
    /// By rising h, then γ lexicographically.
    pub list: Vec<Equilibrium>,
    /// Bound on the error of every `h`.
    pub error_bound: f64,
    /// False when it could not be decided whether further ones exist: roots closer than 2^-4000.
    pub complete: bool,
    /// γ, h, Ω and the index were found by Newton continuation, not from the closed form.
    pub by_continuation: bool,
}

/// Why the equilibria cannot be computed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CriticalError {
    /// The body is beyond `f64`.
    #[error(transparent)]
    Equilibria(#[from] EquilibriaError),
    /// l is beyond `f64`.
    #[error(transparent)]
    Momentum(#[from] MomentumError),
    /// Newton continuation did not reach l along a curve.
    #[error(
        "Newton continuation {} does not reach this l; the closed form, which is the default, has the answer",
        .curve.map_or_else(|| "along a branch".to_owned(), |curve| format!("along {curve}"))
    )]
    Lost {
        /// The curve, if it has a name.
        curve: Option<CurveName>,
    },
}

/// All critical points of U_l with energy, angular velocity, Morse index, eigenvalues and stability.
///
/// # Errors
/// [`CriticalError`] when the body or l leave the range of `f64`.
pub fn critical(body: &Body, l: &Number) -> Result<Equilibria, CriticalError> {
    RelativeEquilibria::new(body)?.at(l)
}

/// The curves of a body, computed once for queries at many l.
#[derive(Debug)]
pub struct RelativeEquilibria<'a> {
    body: &'a Body,
    set: CriticalSet,
    constants: Constants<Interval>,
    /// Made when intervals leave something open.
    profile: OnceLock<Option<StabilityProfile>>,
    /// Each branch in words.
    words: Vec<(Branch, Arc<str>)>,
}

/// A branch at one l or spin.
struct Question<'a> {
    branch: Branch,
    /// Its curves, which have consecutive ids.
    curves: std::ops::Range<CurveId>,
    fixed: Fixed<'a>,
}

/// What the equilibria have in common.
#[derive(Clone, Copy)]
enum Fixed<'a> {
    /// l, and x = l²/2, rounded, in the frame's units.
    Momentum { l: &'a Number, x: f64 },
    /// Ω ≠ 0.
    Spin(&'a RBig),
}

impl Fixed<'_> {
    /// The sign of l and Ω.
    fn sign(self) -> f64 {
        match self {
            Self::Momentum { l, .. } => l.to_f64().signum(),
            Self::Spin(omega) => f64::from(i8::from(*omega > RBig::ZERO) - i8::from(*omega < RBig::ZERO)),
        }
    }
}

impl Question<'_> {
    fn ids(&self) -> impl Iterator<Item = CurveId> {
        (self.curves.start.index()..self.curves.end.index()).map(CurveId::at)
    }
}

/// What has been found at one l or spin so far.
#[derive(Default)]
struct Found {
    list: Vec<Equilibrium>,
    error_bound: f64,
}

impl<'a> RelativeEquilibria<'a> {
    /// Finds all curves of the body.
    ///
    /// # Errors
    /// [`CriticalError::Equilibria`].
    pub fn new(body: &'a Body) -> Result<Self, CriticalError> {
        let set = CriticalSet::new(body.frame())?;
        let constants = Constants::rounded(&set.frame);
        let mut words: Vec<(Branch, Arc<str>)> = Vec::with_capacity(6);
        for curve in set.curves.iter().filter(|curve| curve.piece == 1 && curve.is_critical()) {
            words.push((curve.branch, branch_words(&set, curve.branch).into()));
        }
        Ok(Self { body, constants, profile: OnceLock::new(), words, set })
    }

    fn words(&self, branch: Branch) -> Arc<str> {
        let known = self.words.iter().find(|(known, _)| *known == branch);
        known.map_or_else(|| branch_words(&self.set, branch).into(), |(_, words)| Arc::clone(words))
    }

    /// The equilibria at l: complete, however near to a cusp or pitchfork l lies.
    ///
    /// # Errors
    /// [`CriticalError::Momentum`] when l leaves the range of `f64`.
    pub fn at(&self, l: &Number) -> Result<Equilibria, CriticalError> {
        let frame = &self.set.frame;
        if l.to_f64() == 0.0 {
            return Ok(self.all_at_rest());
        }
        let x = abscissa(frame, l.to_f64())?;
        Ok(self.everywhere(Fixed::Momentum { l, x }))
    }

    /// All steady rotations with the angular velocity Ωγ: complete, from exact roots. Each has its own l.
    ///
    /// # Errors
    /// [`CriticalError::Momentum`] when l of one of them leaves the range of `f64`.
    pub fn at_spin(&self, omega: &RBig) -> Result<Equilibria, CriticalError> {
        if omega.is_zero() {
            return Ok(self.all_at_rest());
        }
        let mut found = self.everywhere(Fixed::Spin(omega));
        for equilibrium in &mut found.list {
            let least = f64::MIN_POSITIVE * self.set.frame.momentum_unit;
            abscissa(&self.set.frame, equilibrium.l.abs().max(least))?;
            equilibrium.omega = omega.to_f64().value();
        }
        Ok(found)
    }

    fn all_at_rest(&self) -> Equilibria {
        let error_bound = 8.0 * UNIT_ROUNDOFF * self.set.frame.r_norm * self.set.frame.energy_unit;
        Equilibria { list: sorted(self.at_rest()), error_bound, complete: true, by_continuation: false }
    }

    /// The equilibria of all branches.
    fn everywhere(&self, fixed: Fixed<'_>) -> Equilibria {
        let mut found = Found { list: Vec::with_capacity(8), error_bound: 0.0 };
        let mut complete = true;
        let mut next = 0;
        let curves = self.set.curves.as_slice();
        // Curves of one branch have consecutive ids.
        while next < curves.len() {
            let branch = curves[next].branch;
            let end = next + curves[next..].iter().take_while(|curve| curve.branch == branch).count();
            if curves[next].is_critical() {
                let question = Question { branch, curves: CurveId::at(next)..CurveId::at(end), fixed };
                complete &= self.on_branch(&question, &mut found);
            }
            next = end;
        }
        let list = sorted(found.list);
        Equilibria { list, error_bound: found.error_bound, complete, by_continuation: false }
    }

    /// The equilibria of one branch: at one l by f64 with bounds, and exactly where these leave something open.
    fn on_branch(&self, question: &Question<'_>, found: &mut Found) -> bool {
        let before = found.list.len();
        if let Fixed::Momentum { x, .. } = question.fixed
            && !self.set.ends_near(question.branch, question.curves.clone(), x)
            && question.ids().all(|id| self.quickly(id, x, question, found))
        {
            return true;
        }
        found.list.truncate(before);
        self.exactly(question, found).is_some()
    }

    fn profile(&self) -> Option<&StabilityProfile> {
        self.profile.get_or_init(|| StabilityProfile::new(self.body, &self.set)).as_ref()
    }
}

fn sorted(mut list: Vec<Equilibrium>) -> Vec<Equilibrium> {
    list.sort_by(|p, q| {
        let by_gamma = (0..3).map(|k| p.gamma[k].total_cmp(&q.gamma[k]));
        by_gamma.fold(p.h.total_cmp(&q.h), std::cmp::Ordering::then)
    });
    list
}
