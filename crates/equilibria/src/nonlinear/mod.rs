//! Stability beyond the linearisation: Arnold's theorem at relative equilibria that are spectrally stable but no minimum.
//!
//! At fixed l the flow has two degrees of freedom. Where its linearisation has two imaginary pairs without a resonance of
//! order up to four (ω₁ ≠ ω₂, 2ω₂, 3ω₂) and Arnold's determinant of the normal form does not vanish, invariant tori
//! enclose the equilibrium on every energy level near it: it is stable.

mod complex;
mod normal_form;
mod reduced_hamiltonian;
pub mod series;

pub use normal_form::NormalForm;
use reduced_hamiltonian::farthest;
pub use reduced_hamiltonian::reduced_hamiltonian;

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;

use crate::stability::{Constants, Reduced, State};

/// The normal form of the flow reduced by l at a relative equilibrium, in units in which Ω = 1: its determinant is D₄/s.
/// `None` where the enclosures do not tell that there are two distinct imaginary pairs.
#[must_use]
pub fn normal_form<E: Enclosure>(c: &Constants<E>, state: &State<E>, reduced: &Reduced<E>) -> Option<NormalForm<E>> {
    let series = reduced_hamiltonian(c, state, farthest(state));
    let [b, c0] = reduced.coefficients();
    NormalForm::new(&series, b, c0, c.precision)
}

impl<E: Enclosure> NormalForm<E> {
    /// The conditions of Arnold's theorem hold for certain: no resonance ω₁ = ω₂, 2ω₂ or 3ω₂, and a determinant other than 0.
    #[must_use]
    pub fn is_stable(&self, precision: E::Precision) -> bool {
        let [large, small] = &self.omega;
        let apart = |n| (large.clone() - E::small(n, precision) * small.clone()).strict_sign().is_some();
        (1..=3).all(apart) && matches!(self.arnold.sign(), Some(Sign::Positive | Sign::Negative))
    }
}
