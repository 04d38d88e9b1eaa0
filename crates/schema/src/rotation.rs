//! Terms of rotation about an axis.

use super::Stability;
use super::term::term;

term! {
    /// Which end of an axis is up.
    pub enum AxisEnd {
        /// That to which the given direction points.
        Plus = "+axis",
        /// The other one.
        Minus = "-axis",
    }
}

term! {
    /// Linear type of a rotation over a range of spins, and whether it is a minimum of U_l there.
    pub enum SpinType {
        /// Two imaginary pairs, and U_l has a strict local minimum (across a circle of rotations: of the circle): stable.
        Minimum = "elliptic (local minimum)",
        /// The same where both pairs agree at every spin.
        DoubleMinimum = "double-elliptic (local minimum)",
        /// Two imaginary pairs only: linearly stable (a symmetric top is stable by a further integral).
        Elliptic = "elliptic",
        /// A double imaginary pair.
        DoubleElliptic = "double-elliptic",
        /// One real and one imaginary pair: unstable.
        SaddleCentre = "saddle-centre",
        /// Two real pairs: unstable.
        Saddle = "saddle",
        /// A double real pair: unstable.
        DoubleReal = "double-real",
        /// A complex quadruple: unstable.
        Complex = "complex",
        /// An eigenvalue zero.
        Zero = "zero",
    }
}

impl AxisEnd {
    /// The end of an axis of Staude's cone that is up at the spin Ω, by ±Ω².
    #[must_use]
    pub fn of_squared_spin(squared: f64) -> Self {
        if squared < 0.0 { Self::Minus } else { Self::Plus }
    }
}

impl SpinType {
    /// No eigenvalue has a positive real part, and none is zero.
    #[must_use]
    pub fn is_elliptic(self) -> bool {
        matches!(self, Self::Minimum | Self::DoubleMinimum | Self::Elliptic | Self::DoubleElliptic)
    }
}

impl From<Stability> for SpinType {
    fn from(found: Stability) -> Self {
        match found {
            Stability::Elliptic => Self::Elliptic,
            Stability::SaddleCentre => Self::SaddleCentre,
            Stability::Saddle => Self::Saddle,
            Stability::Complex => Self::Complex,
            Stability::DoubleElliptic => Self::DoubleElliptic,
            Stability::DoubleReal => Self::DoubleReal,
            Stability::Zero => Self::Zero,
        }
    }
}
