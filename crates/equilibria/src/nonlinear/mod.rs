//! Stability beyond the linearisation: Arnold's theorem at relative equilibria that are spectrally stable but no minimum,
//! and what damping leaves of it.
//!
//! At fixed l the flow has two degrees of freedom. Where its linearisation has two imaginary pairs without a resonance of
//! order up to four (ω₁ ≠ ω₂, 2ω₂, 3ω₂) and Arnold's determinant of the normal form does not vanish, invariant tori
//! enclose the equilibrium on every energy level near it: it is stable.

mod along;
mod complex;
mod determinant;
mod friction;
mod judge;
mod modes;
mod normal_form;
mod reduced_hamiltonian;
pub mod series;
mod sixth;
mod taylor;
mod verdict;
mod zeros;

pub use bifdiag_schema::{Failing, NonlinearVerdict, Reason};

pub use along::{VerdictChange, VerdictSpan, Verdicts};
pub use determinant::arnold_numerator;
pub use friction::Friction;
pub use judge::Question;
pub use normal_form::NormalForm;
pub use reduced_hamiltonian::reduced_hamiltonian;
pub use sixth::sixth;
pub use taylor::taylor;
pub use verdict::{Determinant, Nonlinear, Setting};
