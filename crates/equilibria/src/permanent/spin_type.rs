//! The spectral types that a rotation has between the spins at which it changes, and those spins.

use std::cmp::Ordering;

use bifdiag_numbers::polynomial::Root;
use dashu_ratio::RBig;

/// The spectral type of such a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SpinType {
    /// Two imaginary pairs, and U_l has a strict local minimum (across a circle of rotations: of the circle): stable.
    Minimum,
    /// Two imaginary pairs only: linearly stable (and for a symmetric top stable by a further integral).
    Elliptic,
    /// One real and one imaginary pair: unstable.
    SaddleCentre,
    /// Two real pairs: unstable.
    Saddle,
    /// A double real pair: unstable.
    DoubleReal,
    /// A complex quadruple: unstable.
    Complex,
    /// An eigenvalue zero, and no real one: open.
    Zero,
    /// An eigenvalue zero and a real pair: unstable.
    ZeroReal,
}

impl SpinType {
    /// No eigenvalue has a positive real part.
    #[must_use]
    pub fn is_stable(self) -> bool {
        matches!(self, Self::Minimum | Self::Elliptic | Self::Zero)
    }

    /// As it is printed.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Minimum => "elliptic (local minimum)",
            Self::Elliptic => "elliptic",
            Self::SaddleCentre => "saddle-centre",
            Self::Saddle => "saddle",
            Self::DoubleReal => "double-real",
            Self::Complex => "complex",
            Self::Zero | Self::ZeroReal => "zero",
        }
    }
}

/// A spin at which the type changes.
#[derive(Clone, Debug)]
pub struct SpinChange {
    /// Ω in the body's units.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// Below.
    pub from: SpinType,
    /// Above.
    pub to: SpinType,
    /// Ω².
    pub(super) squared: Root,
}

impl SpinChange {
    /// Where a spin Ω ≥ 0 stands to the change, exactly.
    #[must_use]
    pub fn place_of(&self, omega: &RBig) -> Ordering {
        self.squared.place_of(&(omega * omega))
    }
}
