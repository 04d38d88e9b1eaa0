//! What is told of a relative equilibrium.

use std::sync::Arc;

use crate::curves::CurveName;
use crate::stability::{Eigenvalues, LinearType, Verdict};

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
    pub verdict: Verdict,
    /// The eigenvalues of the flow reduced by l, per unit of time.
    pub eigenvalues: Eigenvalues,
    /// The curve on which it lies; `None` when no curve carries it.
    pub curve: Option<CurveName>,
    /// Its branch in words.
    pub branch_name: Arc<str>,
}
