//! A state: its place in the (h, l) plane, and the steady rotation that it is or that is nearest to it.

use std::fmt;

use bifdiag_body::{Number, ParseNumberError};
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::Spot;
use bifdiag_diagram::topology::Margin;
use bifdiag_equilibria::permanent::MEANT;
use bifdiag_numbers::symmetric;
use bifdiag_numbers::vector::{cross, dot, norm};
use dashu_ratio::RBig;

use crate::solver::Solver;
use crate::steady::{SpinQuestion, Steady};

/// h and l of a state are computed with a smaller error, relative to the size of their terms.
const ROUNDING: f64 = 1e-14;

/// An angular velocity at a smaller angle to the vertical, in radians, is along it.
const UPRIGHT: f64 = 1e-9;

/// Where a state lies, and whether it is a steady rotation.
#[derive(Clone, Debug)]
pub struct State {
    /// The energy.
    pub h: f64,
    /// The vertical angular momentum, about the upward vertical.
    pub l: f64,
    /// The steady rotation that it is.
    pub steady: Option<Steady>,
    /// The region of (h, l), of a motion that is not steady.
    pub region: Option<RegionId>,
    /// The distance of (h, l) to the nearest curve, of a motion that is not steady.
    pub margin: Option<Margin>,
    /// The steady rotation at this spin whose axis is nearest to the vertical, of a motion that is not steady.
    pub nearest: Option<Steady>,
    /// What is not known.
    pub unknown: Option<UnknownOfState>,
}

/// What is not known of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnknownOfState {
    /// Whether it is a steady rotation.
    Steadiness,
    /// The regions of the body.
    Regions,
    /// That of the state.
    Region,
}

impl fmt::Display for UnknownOfState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Steadiness => "whether the motion is steady was not decided",
            Self::Regions => "the regions of this body were not found",
            Self::Region => "the region of its (h, l) is not known",
        })
    }
}

impl State {
    /// The state with an angular velocity, in principal axes and the body's units; `along` is a vector along
    /// it, or against it, exact and in the axes in which the body was given. The question's axis is the upward vertical,
    /// and its spin is |ω|.
    ///
    /// # Errors
    /// [`ParseNumberError`] where h or l leaves the range of doubles.
    pub fn new(
        solver: &Solver,
        omega: [f64; 3],
        along: &[RBig; 3],
        question: &SpinQuestion,
    ) -> Result<Self, ParseNumberError> {
        let (up, body) = (question.up, solver.body());
        let (a, r) = (body.moments_f64(), body.center_f64());
        let momentum: [f64; 3] = std::array::from_fn(|k| a[k] * omega[k]);
        // γ = −up: U = −⟨γ, r⟩ = ⟨up, r⟩; l = ⟨Aω, γ⟩, whose sign does not matter.
        let h = 0.5 * dot(omega, momentum) + dot(up, r);
        let is_level = symmetric::dot(&body.angular_momentum_as_given(along), &question.exact_up).is_zero();
        let l = if is_level { 0.0 } else { dot(momentum, up) };
        [h, l].into_iter().filter(|x| !x.is_finite()).try_for_each(|x| Number::from_f64(x).map(drop))?;
        let is_upright = norm(cross(omega, up)) <= UPRIGHT * norm(omega);
        let found = Steady::nearest(solver, question);
        let unknown = solver.atlas().is_none().then_some(UnknownOfState::Regions);
        let state = Self { h, l, steady: None, region: None, margin: None, nearest: None, unknown };
        match found {
            Some(steady) if steady.angle <= MEANT && is_upright => {
                Ok(Self { steady: Some(Steady { angle: 0.0, ..steady }), ..state })
            }
            None if is_upright => Ok(Self { unknown: Some(UnknownOfState::Steadiness), ..state }),
            nearest => {
                // A curve rises by l/J, which is at most l/min A, and h and l are rounded.
                let least = a.into_iter().fold(f64::INFINITY, f64::min);
                let size = 0.5 * dot(omega, momentum).abs() + norm(r) + l * l / least;
                Self { nearest, ..state }.placed(solver, ROUNDING * size)
            }
        }
    }

    /// With the region and the margin of its (h, l), which are known within `rounding` in h.
    fn placed(mut self, solver: &Solver, rounding: f64) -> Result<Self, ParseNumberError> {
        let [h, l] = [Number::from_f64(self.h)?, Number::from_f64(self.l)?];
        let Ok(found) = solver.classify(&h, &l) else {
            return Ok(Self { unknown: Some(UnknownOfState::Region), ..self });
        };
        if found.margin.h > rounding {
            match solver.spot(&h, &l, &found.answer) {
                Spot::Region(region) => self.region = Some(region),
                _ => self.unknown = Some(UnknownOfState::Region),
            }
        }
        Ok(Self { margin: Some(found.margin), ..self })
    }
}
