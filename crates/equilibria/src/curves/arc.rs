//! Arcs: pieces of curves on which x = l²/2 is a coordinate and the slope dh/dx = 1/J is monotone.

use super::curve_point::Point;
use super::families::{GenericState, Mu, SymmetricFamily};
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::root::{Bracket, newton_bracketed};

/// A stretch of the generic family on one side of a moment of inertia, by rising x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The moment from which δ is measured.
    pub base: Axis,
    /// Sign of δ.
    pub sign: f64,
    /// |δ| at the lower and upper end in x; 0 and ∞ are limits.
    pub distance: [f64; 2],
    /// x at both ends; 0 and ∞ are limits.
    pub x: [f64; 2],
}

/// The family of an arc.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Part of the generic family: at most two segments, by rising x.
    Generic(Vec<Segment>),
    /// Part of the family over μ = a_i, from t at the lower to t at the upper end in x.
    Symmetric {
        /// The family.
        family: SymmetricFamily,
        /// t = s − ŝ at both ends.
        t: [f64; 2],
    },
    /// A straight line in (x, h): γ is constant. Pole lines, rotations about principal axes.
    Straight {
        /// γ in the frame.
        gamma: [f64; 3],
        /// J(γ).
        j: f64,
    },
}

/// An arc, by rising x.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    /// Its family.
    pub shape: Shape,
    /// x at both ends; 0 and ∞ are limits.
    pub x: [f64; 2],
    /// 1/J at both ends; between them it is monotone.
    pub slope: [f64; 2],
}

/// |x̃/x − 1| up to which a root of x(μ) = x is accepted: the rounding of x(μ) itself.
const X_TOLERANCE: f64 = 16.0 * UNIT_ROUNDOFF;

impl Segment {
    /// μ at x. Precondition: x lies between the segment's ends. `seen` is called with every state on the way, the last
    /// one at μ; not at all at an end, where nothing has to be solved.
    fn solve(&self, frame: &Frame, x: f64, mut seen: impl FnMut(GenericState)) -> Mu {
        let mu = |distance: f64| Mu { base: self.base, delta: self.sign * distance };
        let [from, to] = self.distance;
        if x <= self.x[0] && from > 0.0 && from.is_finite() {
            return mu(from);
        }
        if x >= self.x[1] && to > 0.0 && to.is_finite() {
            return mu(to);
        }
        let root = newton_bracketed(Bracket { negative: from, positive: to }, self.guess(frame, x), X_TOLERANCE, |y| {
            let state = GenericState::at(frame, mu(y));
            seen(state);
            let ratio = x / state.x;
            (1.0 - ratio, ratio * state.log_slope() * self.sign)
        });
        mu(root)
    }

    /// |δ| at x to leading order at the ends: x ≈ a² r_base/(2|δ|) at a moment, x ≈ J_r² r/(2|δ|) at infinity, and
    /// x − x_c ∝ (δ − δ_c)² from a cusp.
    fn guess(&self, frame: &Frame, x: f64) -> f64 {
        let [from, to] = self.distance;
        if to == 0.0 || from == 0.0 {
            let a = frame.a[self.base];
            0.5 * a * a * frame.r[self.base] / x
        } else if from.is_infinite() {
            0.5 * frame.j_r * frame.j_r * frame.r_norm / x
        } else {
            let [low, high] = self.x;
            let fraction = ((x - low) / (high - low)).max(0.0);
            from + (to - from) * fraction.sqrt()
        }
    }
}

impl Arc {
    /// A straight arc between two abscissae.
    #[must_use]
    pub fn straight(gamma: [f64; 3], j: f64, x: [f64; 2]) -> Self {
        Self { shape: Shape::Straight { gamma, j }, x, slope: [1.0 / j; 2] }
    }

    /// The point at x. Precondition: x lies between the arc's ends, which themselves are allowed when finite and > 0.
    #[must_use]
    pub fn point(&self, frame: &Frame, x: f64) -> Point {
        self.point_and_mu(frame, x).0
    }

    /// The point at x and its multiplier μ (`None` for a straight arc off the families), from one solution for μ.
    #[must_use]
    pub fn point_and_mu(&self, frame: &Frame, x: f64) -> (Point, Option<Mu>) {
        match &self.shape {
            Shape::Straight { gamma, j } => (Point::over(frame, x, *gamma, *j), None),
            Shape::Generic(segments) => {
                let mut last = None;
                let mu = generic_mu(segments, frame, x, |state| last = Some(state));
                let state = last.unwrap_or_else(|| GenericState::at(frame, mu));
                (Point::over(frame, x, state.gamma, state.j), Some(mu))
            }
            Shape::Symmetric { family, t } => {
                let state = family.at(frame, solve_symmetric(family, frame, *t, x));
                (Point::over(frame, x, state.gamma, state.j), Some(Mu { base: family.axis, delta: 0.0 }))
            }
        }
    }

    /// The multiplier μ at x (`None` for a straight arc off the families).
    #[must_use]
    pub fn mu(&self, frame: &Frame, x: f64) -> Option<Mu> {
        match &self.shape {
            Shape::Straight { .. } => None,
            Shape::Generic(segments) => Some(generic_mu(segments, frame, x, |_| {})),
            Shape::Symmetric { family, .. } => Some(Mu { base: family.axis, delta: 0.0 }),
        }
    }

    /// The limit of the curve's last arc. (An arc with a finite end has none: then the answer is that of the axis next
    /// to which it ends.)
    #[must_use]
    pub fn asymptote(&self, frame: &Frame) -> Asymptote {
        match &self.shape {
            Shape::Straight { gamma, .. } => {
                // A component may round to 1 while the others are not zero.
                let axis =
                    Axis::ALL.into_iter().find(|&k| Axis::ALL.into_iter().all(|j| (gamma[j] != 0.0) == (j == k)));
                Asymptote { axis, rho: (0..3).map(|k| gamma[k] * frame.r[k]).sum() }
            }
            Shape::Generic(segments) => {
                let last = segments[segments.len() - 1];
                Asymptote { axis: Some(last.base), rho: last.sign * frame.r[last.base] }
            }
            Shape::Symmetric { family, .. } => Asymptote { axis: Some(family.axis), rho: 0.0 },
        }
    }
}

/// As x → ∞, h = x/J∞ − ρ∞ + O(1/x) (Proposition 6.2 of docs/mathematics.md).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asymptote {
    /// J∞ is the moment of this axis of the frame; `None`: J_r, of a pole line off the axes.
    pub axis: Option<Axis>,
    /// ρ∞ = lim ⟨γ, r⟩.
    pub rho: f64,
}

impl Asymptote {
    /// J∞ of `other` less J∞ of `self`, from exact differences rounded once.
    #[must_use]
    pub fn moment_gap(&self, frame: &Frame, other: &Self) -> f64 {
        match (self.axis, other.axis) {
            (Some(i), Some(j)) => frame.diff[j][i],
            (None, Some(j)) => frame.offset[j],
            (Some(i), None) => -frame.offset[i],
            (None, None) => 0.0,
        }
    }
}

fn generic_mu(segments: &[Segment], frame: &Frame, x: f64, seen: impl FnMut(GenericState)) -> Mu {
    let segment = segments.iter().find(|segment| x <= segment.x[1]).unwrap_or(&segments[segments.len() - 1]);
    segment.solve(frame, x, seen)
}

/// t with x(ŝ + t) = x.
fn solve_symmetric(family: &SymmetricFamily, frame: &Frame, t: [f64; 2], x: f64) -> f64 {
    let a = frame.a[family.axis];
    let guess = 2.0 * x / (a * a) - family.s_pitchfork;
    newton_bracketed(Bracket { negative: t[0], positive: t[1] }, guess, X_TOLERANCE, |t| {
        let state = family.at(frame, t);
        (state.x / x - 1.0, state.x_slope / x)
    })
}
