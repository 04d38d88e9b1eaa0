//! Linear types of relative equilibria, verdicts on their stability, and the words for both.

use std::fmt;

use bifdiag_numbers::Sign;

use crate::curves::{CriticalSet, Curve};

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
    /// All types, in the order of their declaration.
    pub const ALL: [Self; 8] = [
        Self::Elliptic,
        Self::SaddleCentre,
        Self::Saddle,
        Self::Complex,
        Self::DoubleElliptic,
        Self::DoubleReal,
        Self::Zero,
        Self::ZeroReal,
    ];

    /// Some eigenvalue has a positive real part.
    #[must_use]
    pub fn is_unstable(self) -> bool {
        matches!(self, Self::SaddleCentre | Self::Saddle | Self::Complex | Self::DoubleReal | Self::ZeroReal)
    }

    /// The word in tables and documents.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Elliptic => "elliptic",
            Self::SaddleCentre => "saddle-centre",
            Self::Saddle => "saddle",
            Self::Complex => "complex",
            Self::DoubleElliptic => "double-elliptic",
            Self::DoubleReal => "double-real",
            Self::Zero | Self::ZeroReal => "zero",
        }
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

/// What is known of the stability of a relative equilibrium (of a circle or sphere of them: as a whole).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Stable: a strict minimum of U_l.
    Energy,
    /// Stable by a further integral.
    Integral,
    /// All eigenvalues are imaginary; nothing more is claimed.
    Spectrum,
    /// Unstable.
    Unstable,
    /// Not decided by the linearization.
    Open,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Energy => "stable (energy)",
            Self::Integral => "stable (integral)",
            Self::Spectrum => "spectrally",
            Self::Unstable => "unstable",
            Self::Open => "open",
        })
    }
}

/// What a verdict needs besides the linear type (Proposition 13.6 of docs/mathematics.md).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// Morse index of U_l; across a circle its transverse index.
    pub index: u8,
    /// The multiplier is at least the largest moment: a strict global minimum of U_l, even where it is degenerate.
    pub global_minimum: bool,
    /// A further integral confines the motion as soon as no eigenvalue says otherwise: γ = ±r̂ on the axis of symmetry
    /// (Lagrange), circles of regular precessions, and every rotation without weight (Euler).
    pub integral: bool,
}

impl Setting {
    /// That of the rotations of a curve between its ends; `None` for a pole line.
    #[must_use]
    pub fn along(set: &CriticalSet, curve: &Curve) -> Option<Self> {
        Some(Self { index: curve.index?, global_minimum: false, integral: set.has_integral(curve) })
    }

    /// The verdict.
    #[must_use]
    pub fn verdict(self, kind: LinearType) -> Verdict {
        match kind {
            _ if kind.is_unstable() => Verdict::Unstable,
            LinearType::Zero if self.global_minimum => Verdict::Energy,
            LinearType::Zero if self.integral => Verdict::Integral,
            LinearType::Zero => Verdict::Open,
            _ if self.index == 0 => Verdict::Energy,
            _ if self.integral => Verdict::Integral,
            _ => Verdict::Spectrum,
        }
    }
}
