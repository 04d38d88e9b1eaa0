//! What vertices, edges and faces of the map are called.

use std::fmt;

use crate::topology::Component;
use bifdiag_equilibria::curves::{Curve, Orbit, Pole};

/// The meaning of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum VertexKind {
    /// The end of a curve on the frame, at l → 0 or l → ∞.
    End,
    /// Two curves of critical points meet and vanish.
    Cusp,
    /// A pair or circle leaves a curve.
    Pitchfork,
    /// Two curves cross.
    Crossing,
}

/// The meaning of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EdgeKind {
    /// A side of the frame.
    Frame(Side),
    /// Part of a curve.
    Curve {
        /// Morse index; `None` for a pole line off the critical curves.
        index: Option<u8>,
        /// Points, pairs, circles, spheres over a point of the curve.
        critical: CriticalKind,
        /// The pole that enters U_hl across the curve.
        pole: Option<Pole2>,
    },
}

/// A side of the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// l → 0.
    Rest,
    /// l → ∞.
    Fast,
    /// Below everything.
    Bottom,
    /// Above everything.
    Top,
}

/// How many critical points lie over a point of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum CriticalKind {
    /// None: a pole line.
    Nothing,
    /// One.
    Point,
    /// Two.
    Pair,
    /// A circle.
    Circle,
    /// All of S².
    Sphere,
}

/// A pole, ordered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pole2 {
    /// +r̂.
    Plus,
    /// −r̂.
    Minus,
}

/// The type of a region.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum FaceKind {
    /// Beyond the frame.
    Outside,
    /// Below the lowest critical value.
    Forbidden,
    /// The components of U_hl in canonical order.
    Region(Vec<Component>),
}

impl EdgeKind {
    pub(super) fn of(curve: &Curve) -> Self {
        let critical = match curve.orbit {
            Orbit::Point => CriticalKind::Point,
            Orbit::Pair(_) => CriticalKind::Pair,
            Orbit::Circle(_) => CriticalKind::Circle,
            Orbit::Sphere => CriticalKind::Sphere,
            Orbit::Pole(_) => CriticalKind::Nothing,
        };
        let pole = curve.entering_pole().map(|pole| match pole {
            Pole::Plus => Pole2::Plus,
            Pole::Minus => Pole2::Minus,
        });
        Self::Curve { index: curve.index, critical, pole }
    }
}

impl fmt::Display for EdgeKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::Curve { index, critical, pole } = self else {
            return f.write_str(match self {
                Self::Frame(Side::Rest) => "l=0",
                Self::Frame(Side::Fast) => "l=oo",
                Self::Frame(Side::Bottom) => "h=-oo",
                _ => "h=oo",
            });
        };
        let name = match (critical, index) {
            (CriticalKind::Nothing, _) | (_, None) => "",
            (CriticalKind::Sphere, _) => "sphere",
            (_, Some(0)) => "minimum",
            // A circle has one normal direction only: index 1 is a maximum across it.
            (CriticalKind::Circle, _) | (_, Some(2)) => "maximum",
            (_, Some(_)) => "saddle",
        };
        f.write_str(name)?;
        match critical {
            CriticalKind::Pair => f.write_str("-pair")?,
            CriticalKind::Circle => f.write_str("-circle")?,
            _ => {}
        }
        match pole {
            Some(pole) => {
                let sign = if *pole == Pole2::Plus { "P+" } else { "P-" };
                if name.is_empty() { f.write_str(sign) } else { write!(f, "={sign}") }
            }
            None => Ok(()),
        }
    }
}

impl VertexKind {
    /// The mark in a class's text.
    pub(super) fn mark(self) -> char {
        match self {
            Self::End => '.',
            Self::Cusp => '<',
            Self::Pitchfork => 'Y',
            Self::Crossing => 'x',
        }
    }
}

impl fmt::Display for FaceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outside => f.write_str("outside"),
            Self::Forbidden => f.write_str("-"),
            Self::Region(components) => {
                for (place, component) in components.iter().enumerate() {
                    if place > 0 {
                        f.write_str(" & ")?;
                    }
                    f.write_str(&component.accessible_region())?;
                    let poles = component.poles.unwrap_or_default();
                    let signs = [(poles.plus, "+"), (poles.minus, "-")];
                    for (_, sign) in signs.iter().filter(|(inside, _)| *inside) {
                        f.write_str(sign)?;
                    }
                }
                Ok(())
            }
        }
    }
}
