//! Curves: maximal pieces of critical curves and pole lines between cusps and pitchforks.

use super::arc::Arc;
use super::curve_point::Point;
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::table::ids;

ids! {
    /// A curve of a [`CriticalSet`](super::CriticalSet).
    CurveId;
    /// A cusp.
    CuspId;
    /// A pitchfork.
    PitchforkId;
    /// A cluster of cusps that f64 cannot count.
    ClusterId;
    /// An interval of μ between moments with r_k ≠ 0, numbered from μ = −∞: a branch of the generic family.
    IntervalId;
}

/// One of the poles ±r̂ of the Poisson sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Pole {
    /// γ = +r̂.
    Plus,
    /// γ = −r̂.
    Minus,
}

/// To which family of critical points a curve belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Branch {
    /// The generic family over one interval between moments with r_k ≠ 0.
    Generic(IntervalId),
    /// Rotation about the only axis that carries r, with γ at this pole; straight.
    Axis(Pole),
    /// The pair, or circle, over the eigenspace of this axis of the frame.
    Symmetric(Axis),
    /// A pole line off the critical curves.
    Pole(Pole),
}

/// How many critical points lie over one point of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Orbit {
    /// One.
    Point,
    /// A symmetric pair ±γ_i, i the axis of the frame.
    Pair(Axis),
    /// A circle in the plane of the axis i and the next of the frame.
    Circle(Axis),
    /// All of S².
    Sphere,
    /// None: a pole line off the critical curves.
    Pole(Pole),
}

/// Where a curve ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// l → 0.
    Origin,
    /// l → ∞ at ± this axis of the frame, or along a pole line.
    Infinity,
    /// The cusp with this number.
    Cusp(CuspId),
    /// The pitchfork with this number.
    Pitchfork(PitchforkId),
}

/// A curve of critical values, or a pole line, by rising x.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its family.
    pub branch: Branch,
    /// Number of the piece on its branch, from 1, in the order of the branch's own parameter.
    pub piece: usize,
    /// Critical points over each point of the curve.
    pub orbit: Orbit,
    /// Morse index of U_l (of its restriction to the normal direction for a circle); `None` for a pole line.
    pub index: Option<u8>,
    /// The pole line that runs on this curve, when r lies on a principal axis.
    pub pole: Option<Pole>,
    /// Arcs by rising x, end to end.
    pub arcs: Vec<Arc>,
    /// Lower and upper end.
    pub ends: [End; 2],
}

impl Curve {
    /// Range of x; 0 and ∞ are limits.
    #[must_use]
    pub fn x(&self) -> [f64; 2] {
        [self.arcs[0].x[0], self.arcs[self.arcs.len() - 1].x[1]]
    }

    /// The arc over x.
    #[must_use]
    pub fn arc(&self, x: f64) -> &Arc {
        self.arcs.iter().find(|arc| x <= arc.x[1]).unwrap_or(&self.arcs[self.arcs.len() - 1])
    }

    /// The point at x. Precondition: x in the curve's range.
    #[must_use]
    pub fn point(&self, frame: &Frame, x: f64) -> Point {
        self.arc(x).point(frame, x)
    }

    /// True for curves of critical points, false for a pole line off them.
    #[must_use]
    pub fn is_critical(&self) -> bool {
        !matches!(self.orbit, Orbit::Pole(_))
    }

    /// The pole that enters U_hl across this curve, whether or not it is critical too.
    #[must_use]
    pub fn entering_pole(&self) -> Option<Pole> {
        match self.orbit {
            Orbit::Pole(pole) => Some(pole),
            _ => self.pole,
        }
    }

    /// (−1)^index times the number of critical points; a circle counts 0, S² counts 2, a pole line 0.
    #[must_use]
    pub fn euler_contribution(&self) -> i32 {
        let sign = if self.index == Some(1) { -1 } else { 1 };
        match self.orbit {
            Orbit::Point => sign,
            Orbit::Pair(_) => 2 * sign,
            Orbit::Sphere => 2,
            Orbit::Circle(_) | Orbit::Pole(_) => 0,
        }
    }
}
