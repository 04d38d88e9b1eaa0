//! All relative equilibria of a body at one l, at many, or at one spin.

mod beyond;
mod continuation;
mod exact_spin;
mod families;
mod found;

use std::cell::LazyCell;
use std::cmp::Ordering;
use std::sync::{Arc, OnceLock};

use dashu_ratio::RBig;
use thiserror::Error;

use crate::curves::{Branch, CriticalSet, CurveId, CurveName, EquilibriaError, MomentumError, abscissa, branch_words};
use crate::nonlinear::{Friction, Nonlinear};
use crate::stability::exact::StabilityProfile;
use crate::stability::{Constants, Eigenvalues, LinearType};
use bifdiag_body::{Body, BodyAxis, Number};
use bifdiag_numbers::interval::Interval;
use bifdiag_numbers::table::Id;
use bifdiag_numbers::vector::{dot, norm};

pub use bifdiag_schema::Multiplicity;
pub use exact_spin::{ExactSpin, is_principal};
pub use families::{AxisCount, FamilyPoint, SteadyFamily, SteadyStretch, axis_counts};

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
    /// Negative eigenvalues of the Hessian of U_l, the Morse index: 0 minimum, 1 saddle, 2 maximum; across a circle.
    pub index: u8,
    /// The multiplicity of this entry.
    pub multiplicity: Multiplicity,
    /// Only at a given spin: steady axes meet here, which at slightly slower spins do not exist.
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
    /// At a spin l leaves the range of `f64`.
    #[error(
        "the spin {spin:e} is too {} for this body in f64; |spin| between {smallest:.1e} and {largest:.1e}, or 0, is possible",
        if *.spin < *.smallest { "slow" } else { "fast" }
    )]
    Spin {
        /// |Ω| as asked for, per unit of time.
        spin: f64,
        /// From here on no l is too small.
        smallest: f64,
        /// Up to here no l is too large.
        largest: f64,
    },
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
    /// Verdicts that need a normal form are left for later.
    defers: bool,
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
    Spin(&'a ExactSpin),
}

impl Fixed<'_> {
    /// The sign of l and Ω.
    fn sign(self) -> f64 {
        match self {
            Self::Momentum { l, .. } => l.to_f64().signum(),
            Self::Spin(spin) => f64::from(i8::from(spin.omega > RBig::ZERO) - i8::from(spin.omega < RBig::ZERO)),
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
        Ok(Self { body, constants, profile: OnceLock::new(), words, set, defers: false })
    }

    /// Without the verdicts that only a normal form decides, which takes several times as long as all the rest:
    /// [`Nonlinear::is_deferred`] says where one is missing.
    #[must_use]
    pub fn without_normal_forms(self) -> Self {
        Self { defers: true, ..self }
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

    /// The verdict on the equilibrium of one curve at l ≠ 0, as found by [`at`](Self::at) or for an exact root; `None`
    /// where the curve has no equilibrium.
    ///
    /// # Errors
    /// [`CriticalError::Momentum`] when l leaves the range of `f64`.
    pub fn verdict_on(&self, curve: CurveName, l: &Number) -> Result<Option<Nonlinear>, CriticalError> {
        let fixed = Fixed::Momentum { l, x: abscissa(&self.set.frame, l.to_f64())? };
        let mut found = Found::default();
        let is_here = |id: &CurveId| CurveName::of(&self.set, *id) == curve;
        for question in self.questions(fixed) {
            if question.ids().any(|id| is_here(&id)) {
                self.on_curves(&question, question.ids().filter(is_here), &mut found);
            }
        }
        Ok(found.list.iter().find(|found| found.curve == Some(curve)).map(|found| found.nonlinear))
    }

    /// All steady rotations with the angular velocity Ωγ: complete, from exact roots. Each has its own l.
    ///
    /// # Errors
    /// [`CriticalError::Spin`] when l of one of them leaves the range of `f64`.
    pub fn at_spin(&self, omega: &RBig) -> Result<Equilibria, CriticalError> {
        self.at_exact_spin(&ExactSpin::rational(omega.clone()))
    }

    /// The same for a spin that may be irrational.
    ///
    /// # Errors
    /// [`CriticalError::Spin`] when l of one of them leaves the range of `f64`.
    pub fn at_exact_spin(&self, spin: &ExactSpin) -> Result<Equilibria, CriticalError> {
        let omega = &spin.omega;
        if omega.is_zero() {
            return Ok(self.all_at_rest());
        }
        let mut found = self.everywhere(Fixed::Spin(spin));
        for equilibrium in &mut found.list {
            // No l of a spin is 0, though in doubles it may be.
            let least = f64::MIN_POSITIVE * self.set.frame.momentum_unit.max(1.0);
            abscissa(&self.set.frame, equilibrium.l.abs().max(least)).map_err(|error| self.beyond(omega, error))?;
            equilibrium.omega = omega.to_f64().value();
        }
        Ok(found)
    }

    /// The spins at which every l = JΩ is in range.
    fn beyond(&self, omega: &RBig, MomentumError { smallest, largest, .. }: MomentumError) -> CriticalError {
        let moments = self.body.moments_f64();
        let [least, most] = [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| moments.into_iter().reduce(of));
        CriticalError::Spin {
            spin: omega.to_f64().value().abs(),
            smallest: smallest / least.unwrap_or(f64::NAN),
            largest: largest / most.unwrap_or(f64::NAN),
        }
    }

    fn all_at_rest(&self) -> Equilibria {
        Equilibria {
            list: sorted(self.body, self.at_rest(), false),
            error_bound: self.body.center_norm().rounded().1,
            complete: true,
            by_continuation: false,
        }
    }

    /// The equilibria of all branches.
    fn everywhere(&self, fixed: Fixed<'_>) -> Equilibria {
        let mut found = Found { list: Vec::with_capacity(8), error_bound: 0.0 };
        let mut complete = true;
        for question in self.questions(fixed) {
            complete &= self.on_branch(&question, &mut found);
        }
        let list = sorted(self.body, found.list, matches!(fixed, Fixed::Spin(_)));
        Equilibria { list, error_bound: found.error_bound, complete, by_continuation: false }
    }

    /// Every branch with equilibria, whose curves have consecutive ids.
    fn questions<'b>(&'b self, fixed: Fixed<'b>) -> impl Iterator<Item = Question<'b>> {
        let mut next = 0;
        let alike = self.set.curves.as_slice().chunk_by(|one, other| one.branch == other.branch);
        alike.filter_map(move |curves| {
            let from = next;
            next += curves.len();
            let question = Question { branch: curves[0].branch, curves: CurveId::at(from)..CurveId::at(next), fixed };
            curves[0].is_critical().then_some(question)
        })
    }

    /// The equilibria of one branch.
    fn on_branch(&self, question: &Question<'_>, found: &mut Found) -> bool {
        self.on_curves(question, question.ids(), found)
    }

    /// Those of some curves of a branch at one l by f64 with bounds, and those of the whole branch exactly where these leave
    /// something open.
    fn on_curves(&self, question: &Question<'_>, mut ids: impl Iterator<Item = CurveId>, found: &mut Found) -> bool {
        let before = found.list.len();
        if let Fixed::Momentum { x, .. } = question.fixed
            && !self.set.ends_near(question.branch, question.curves.clone(), x)
            && ids.all(|id| self.quickly(id, x, question, found))
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

/// By h, then γ. Of fast rotations h itself would hide what the weight adds: its difference is taken term by term.
fn sorted(body: &Body, mut list: Vec<Equilibrium>, at_spin: bool) -> Vec<Equilibrium> {
    let (moments, center) = (body.moments_f64(), body.center_f64());
    let apart = |i: BodyAxis, k: BodyAxis| (body.moments()[i].value() - body.moments()[k].value()).to_f64().value();
    let apart = LazyCell::new(|| BodyAxis::ALL.map(|i| BodyAxis::ALL.map(|k| apart(i, k))));
    let largest = |gamma: &[f64; 3]| (0..3).max_by(|&i, &k| gamma[i].abs().total_cmp(&gamma[k].abs())).unwrap_or(0);
    // J less the moment of the nearest axis, small where γ is near it.
    let beyond = |gamma: &[f64; 3], axis: usize| (0..3).map(|k| apart[k][axis] * gamma[k] * gamma[k]).sum::<f64>();
    let inertia = |gamma: &[f64; 3]| (0..3).map(|k| moments[k] * gamma[k] * gamma[k]).sum::<f64>();
    let difference = |p: &Equilibrium, q: &Equilibrium| {
        let (i, k) = (largest(&p.gamma), largest(&q.gamma));
        let of_inertia = apart[i][k] + (beyond(&p.gamma, i) - beyond(&q.gamma, k));
        // h = Ω²J/2 − ⟨γ, r⟩ = l²/2J − ⟨γ, r⟩.
        let factor = if at_spin { p.omega * p.omega } else { -p.l * p.l / (inertia(&p.gamma) * inertia(&q.gamma)) };
        0.5 * factor * of_inertia - (dot(p.gamma, center) - dot(q.gamma, center))
    };
    let is_fast = |p: &Equilibrium| 0.5 * (p.omega * p.l).abs() > FAST * norm(center);
    list.sort_by(|p, q| {
        // For a symmetric pair the difference is 0 or -0, which must be equal here.
        let by_h = if is_fast(p) && is_fast(q) { difference(p, q) } else { p.h - q.h };
        let by_h = by_h.partial_cmp(&0.0).unwrap_or(Ordering::Equal);
        let by_gamma = (0..3).map(|k| p.gamma[k].total_cmp(&q.gamma[k]));
        by_gamma.fold(by_h, Ordering::then)
    });
    list
}

/// Kinetic energy over weight from which h keeps too few digits of the weight.
const FAST: f64 = 1e6;
