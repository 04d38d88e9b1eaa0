//! What damping leaves of stability (Proposition 13.12 of docs/mathematics.md).
//!
//! The torque −δA(ω − Ωγ), Ω = l/J, conserves l = ⟨γ, Aω⟩ and dissipates twice δ times the kinetic energy of the motion
//! relative to the steady rotation: Mξ̈ + Γξ̇ + δMξ̇ + Kξ = 0, whose characteristic polynomial is that of κ = λ² + δλ with
//! the gyroscopic term Gλ² in place of Gκ.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use super::verdict::Setting;
use crate::stability::{LinearType, Reduced};
use bifdiag_schema::{NonlinearVerdict, Reason};

/// Stability under damping that conserves l.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Asymptotically stable, modulo rotation about the vertical (a circle or sphere: as a whole); `None` where the
    /// Hessian is degenerate and it is not known whether U_l has a strict minimum.
    pub survives: Option<bool>,
    /// How many eigenvalues have a positive real part: the Morse index.
    pub growing: u8,
    /// d Re λ/dδ at δ = 0 for both pairs, in the order of their eigenvalues; `None` for a pair of zeros or a double pair.
    pub rates: [Option<f64>; 2],
}

impl Friction {
    /// At a relative equilibrium whose type is known.
    #[must_use]
    pub fn new<E: Enclosure>(reduced: &Reduced<E>, kind: LinearType, setting: Setting, is_set: bool) -> Self {
        let is_degenerate = matches!(kind, LinearType::Zero | LinearType::ZeroReal) || setting.minimum == Some(false);
        let survives = match setting.index {
            0 if is_degenerate => match setting.verdict(kind) {
                Some((NonlinearVerdict::Stable, Reason::Energy)) => Some(true),
                _ => setting.minimum,
            },
            index => Some(index == 0),
        };
        Self { survives, growing: setting.index, rates: rates(reduced, kind, is_set) }
    }
}

/// −½ ± G/(2√(β² − 4χ)) at κ = (−β ± √(β² − 4χ))/2; beside a zero −(β + G)/(2β).
fn rates<E: Enclosure>(reduced: &Reduced<E>, kind: LinearType, is_set: bool) -> [Option<f64>; 2] {
    let middle = |x: E| {
        let [lo, hi] = x.bounds();
        Some(0.5 * (lo + hi)).filter(|rate| rate.is_finite())
    };
    let gyroscopic = reduced.gyroscopic().clone();
    let beside_zero = || {
        let beta = reduced.coefficients()[0].clone();
        let is_simple = matches!(beta.sign(), Some(Sign::Positive | Sign::Negative));
        let rate = -((beta.clone() + gyroscopic.clone()) / (beta.clone() + beta));
        [if is_simple { middle(rate) } else { None }, None]
    };
    if is_set {
        return beside_zero();
    }
    let root = reduced.discriminant().sqrt();
    let share = |sign: Sign| {
        let part = if sign == Sign::Positive { gyroscopic.clone() } else { -gyroscopic.clone() };
        middle((part - root.clone()) / (root.clone() + root.clone()))
    };
    let (larger, smaller) = (share(Sign::Positive), share(Sign::Negative));
    match kind {
        LinearType::Elliptic => [smaller, larger],
        LinearType::SaddleCentre | LinearType::Saddle => [larger, smaller],
        LinearType::Complex => [Some(-0.5); 2],
        LinearType::DoubleElliptic | LinearType::DoubleReal => [None; 2],
        LinearType::Zero | LinearType::ZeroReal => beside_zero(),
    }
}
