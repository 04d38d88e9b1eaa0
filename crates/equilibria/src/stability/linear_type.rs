//! Linear types of relative equilibria, and the words for them.

use std::fmt;

use bifdiag_numbers::Sign;
use bifdiag_schema::Stability;

/// The eigenvalues ±λ₁, ±λ₂ of the flow reduced by l at a relative equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LinearType {
    /// Two imaginary pairs; on a circle of equilibria one, across it.
    Elliptic,
    /// One real and one imaginary pair.
    SaddleCentre,
    /// Two real pairs; on a circle of equilibria one, across it.
    Saddle,
    /// A complex quadruple.
    Complex,
    /// A double imaginary pair.
    DoubleElliptic,
    /// A double real pair.
    DoubleReal,
    /// An eigenvalue zero (on a circle: across it too), and no real one.
    Zero,
    /// An eigenvalue zero and a real pair.
    ZeroReal,
}

impl LinearType {
    /// Some eigenvalue has a positive real part.
    #[must_use]
    pub fn is_unstable(self) -> bool {
        matches!(self, Self::SaddleCentre | Self::Saddle | Self::Complex | Self::DoubleReal | Self::ZeroReal)
    }

    /// The term in tables and documents, where a real pair beside a zero one has no word of its own.
    #[must_use]
    pub fn term(self) -> Stability {
        match self {
            Self::Elliptic => Stability::Elliptic,
            Self::SaddleCentre => Stability::SaddleCentre,
            Self::Saddle => Stability::Saddle,
            Self::Complex => Stability::Complex,
            Self::DoubleElliptic => Stability::DoubleElliptic,
            Self::DoubleReal => Stability::DoubleReal,
            Self::Zero | Self::ZeroReal => Stability::Zero,
        }
    }

    /// The word in tables and documents.
    #[must_use]
    pub fn word(self) -> &'static str {
        self.term().word()
    }
}

impl fmt::Display for LinearType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Signs of the coefficients of λ⁴ + bλ² + c and of its discriminant: they decide the linear type (Corollary 13.2 of
/// docs/mathematics.md).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs {
    /// Of b.
    pub b: Sign,
    /// Of c.
    pub c: Sign,
    /// Of b² − 4c.
    pub discriminant: Sign,
}

impl Signs {
    /// The type at a single equilibrium.
    #[must_use]
    pub fn linear_type(self) -> LinearType {
        match (self.c, self.discriminant, self.b) {
            (Sign::Zero, _, Sign::Negative) => LinearType::ZeroReal,
            (Sign::Zero, ..) => LinearType::Zero,
            (Sign::Negative, ..) => LinearType::SaddleCentre,
            (_, Sign::Negative, _) => LinearType::Complex,
            (_, Sign::Zero, Sign::Positive) => LinearType::DoubleElliptic,
            (_, Sign::Zero, _) => LinearType::DoubleReal,
            (_, _, Sign::Positive) => LinearType::Elliptic,
            (..) => LinearType::Saddle,
        }
    }

    /// The type across a circle, or a sphere, of equilibria, where c = 0 throughout.
    #[must_use]
    pub fn transverse_type(b: Sign) -> LinearType {
        match b {
            Sign::Zero => LinearType::Zero,
            Sign::Positive => LinearType::Elliptic,
            Sign::Negative => LinearType::Saddle,
        }
    }
}
