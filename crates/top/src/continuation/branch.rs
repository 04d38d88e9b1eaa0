//! The equations of relative equilibria along one branch, their linearisation and tangent.

use super::options::Start;
use crate::body::{Axis, Frame};
use crate::stability::RelativeEquilibrium;

/// Which equations hold along the branch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// γ_j = r_j/B_j for every axis with r_j ≠ 0, γ_j = 0 for the others.
    Generic,
    /// r_i = 0 and B_i = 0 for this axis i, γ_i is free.
    Pair {
        /// i.
        axis: Axis,
    },
}

/// A point of the branch: five unknowns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// The vertical γ.
    pub gamma: [f64; 3],
    /// Ω.
    pub omega: f64,
    /// The axis i whose gap is held; the others follow as B_j = B_i + s(A_i − A_j).
    pub anchor: Axis,
    /// B_i.
    pub gap: f64,
}

/// What stays the same along a branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch<'a> {
    pub frame: &'a Frame,
    pub kind: Kind,
    /// Axes with r_j ≠ 0: there B_jγ_j = r_j, and neither factor can change its sign.
    pub active: [bool; 3],
    /// Axes with r_j = γ_j = 0 along the branch; a pitchfork where their gap vanishes.
    pub frozen: [bool; 3],
    /// Signs of γ on the active axes.
    pub sign: [f64; 3],
    /// √(r/a₃): the angular velocity below which changes of Ω are measured absolutely.
    pub omega_floor: f64,
}

/// The equations at a point to first order, with the γ_j eliminated:
/// δγ_j = k_j + u_j x + v_j w, δB_j/B_j = e_j x + f_j w, and n0 + n1 x + n2 w = 0 from |γ|² = 1.
/// w = δΩ/`omega_scale`; x = δB_i/B_i of the anchor, or δγ_i for a pair.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linear {
    pub k: [f64; 3],
    pub u: [f64; 3],
    pub v: [f64; 3],
    pub e: [f64; 3],
    pub f: [f64; 3],
    pub n: [f64; 3],
}

/// The unit tangent, oriented the same way all along the branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tangent {
    pub gamma: [f64; 3],
    /// dB_j/B_j on active axes.
    pub gap: [f64; 3],
    /// dΩ/`omega_scale`.
    pub omega: f64,
    /// Change of the parameter x.
    pub x: f64,
    pub omega_scale: f64,
    /// dl along the unit tangent.
    pub l: f64,
}

impl Tangent {
    pub fn dot(&self, other: &Self) -> f64 {
        let mut sum = self.omega * other.omega;
        for j in 0..3 {
            sum += self.gamma[j] * other.gamma[j] + self.gap[j] * other.gap[j];
        }
        sum
    }
}

impl<'a> Branch<'a> {
    pub fn new(frame: &'a Frame, start: &Start) -> Self {
        let gamma = &start.equilibrium.gamma;
        let active = frame.r.map(|r| r != 0.0);
        let kind = start.pair_axis.map_or(Kind::Generic, |axis| Kind::Pair { axis });
        let omega_floor = if frame.is_euler() { 1.0 } else { (frame.r_norm / frame.a[2]).sqrt() };
        Self {
            frame,
            kind,
            active,
            frozen: Axis::ALL.map(|j| !active[j] && start.pair_axis != Some(j)),
            sign: gamma.map(|x| if x < 0.0 { -1.0 } else { 1.0 }),
            omega_floor,
        }
    }

    /// The start as a point of this branch, not yet corrected.
    pub fn point(&self, start: &Start) -> Point {
        let RelativeEquilibrium { mut gamma, omega, gap } = start.equilibrium;
        for j in (0..3).filter(|&j| self.frozen[j]) {
            gamma[j] = 0.0;
        }
        match self.kind {
            Kind::Pair { axis } => {
                gamma[axis] = gamma[axis].abs();
                Point { gamma, omega, anchor: axis, gap: 0.0 }
            }
            Kind::Generic => {
                let anchor = self.smallest_gap(&gap);
                Point { gamma, omega, anchor, gap: gap[anchor] }
            }
        }
    }

    fn smallest_gap(&self, gaps: &[f64; 3]) -> Axis {
        let active = Axis::ALL.into_iter().filter(|&j| self.active[j]);
        active.min_by(|&i, &j| gaps[i].abs().total_cmp(&gaps[j].abs())).unwrap_or(Axis::ALL[0])
    }

    pub fn gaps(&self, point: &Point) -> [f64; 3] {
        let s = point.omega * point.omega;
        self.frame.diff[point.anchor].map(|difference| point.gap + s * difference)
    }

    /// The same point, held by its smallest gap.
    pub fn reanchored(&self, mut point: Point) -> Point {
        if self.kind == Kind::Generic {
            let gaps = self.gaps(&point);
            let anchor = self.smallest_gap(&gaps);
            if gaps[anchor].abs() < 0.5 * gaps[point.anchor].abs() {
                point.gap = gaps[anchor];
                point.anchor = anchor;
            }
        }
        point
    }

    pub fn equilibrium(&self, point: &Point) -> RelativeEquilibrium {
        RelativeEquilibrium { gamma: point.gamma, omega: point.omega, gap: self.gaps(point) }
    }

    pub fn moment(&self, gamma: &[f64; 3]) -> f64 {
        let a = &self.frame.a;
        a[0] * gamma[0] * gamma[0] + a[1] * gamma[1] * gamma[1] + a[2] * gamma[2] * gamma[2]
    }

    pub fn l(&self, point: &Point) -> f64 {
        point.omega * self.moment(&point.gamma)
    }

    pub fn h(&self, point: &Point) -> f64 {
        let (gamma, r) = (&point.gamma, &self.frame.r);
        let potential = gamma[0] * r[0] + gamma[1] * r[1] + gamma[2] * r[2];
        0.5 * point.omega * point.omega * self.moment(gamma) - potential
    }

    pub fn omega_scale(&self, point: &Point) -> f64 {
        point.omega.abs().max(self.omega_floor)
    }

    pub fn linear(&self, point: &Point, omega_scale: f64) -> Linear {
        let Point { gamma, omega, anchor, gap } = *point;
        let mut linear = Linear { k: [0.0; 3], u: [0.0; 3], v: [0.0; 3], e: [0.0; 3], f: [0.0; 3], n: [0.0; 3] };
        let mut norm = -1.0;
        for j in 0..3 {
            norm += gamma[j] * gamma[j];
            if self.active[j] {
                let difference = self.frame.diff[anchor][j];
                let inverse = 1.0 / (gap + omega * omega * difference);
                linear.e[j] = gap * inverse;
                linear.f[j] = 2.0 * omega * omega_scale * difference * inverse;
                linear.k[j] = self.frame.r[j] * inverse - gamma[j];
                linear.u[j] = -gamma[j] * linear.e[j];
                linear.v[j] = -gamma[j] * linear.f[j];
            }
        }
        if let Kind::Pair { axis } = self.kind {
            linear.u[axis] = 1.0;
        }
        linear.n[0] = 0.5 * norm;
        for j in 0..3 {
            linear.n[0] += gamma[j] * linear.k[j];
            linear.n[1] += gamma[j] * linear.u[j];
            linear.n[2] += gamma[j] * linear.v[j];
        }
        linear
    }

    /// The unit tangent at a point of the branch.
    pub fn tangent(&self, point: &Point) -> Tangent {
        let omega_scale = self.omega_scale(point);
        let linear = self.linear(point, omega_scale);
        let orientation = self.orientation(point);
        let mut x = -linear.n[2] * orientation;
        let mut omega = linear.n[1] * orientation;
        let mut square = omega * omega;
        for j in 0..3 {
            let gamma = linear.u[j] * x + linear.v[j] * omega;
            let gap = linear.e[j] * x + linear.f[j] * omega;
            square += gamma * gamma + gap * gap;
        }
        let inverse = 1.0 / square.sqrt();
        x *= inverse;
        omega *= inverse;
        let gamma = std::array::from_fn(|j| linear.u[j] * x + linear.v[j] * omega);
        let gap = std::array::from_fn(|j| linear.e[j] * x + linear.f[j] * omega);
        Tangent { gamma, gap, omega, x, omega_scale, l: self.l_along(point, &gamma, omega * omega_scale) }
    }

    /// The sign that makes (−n2, n1) point the same way all along a branch, whatever the anchor.
    fn orientation(&self, point: &Point) -> f64 {
        match self.kind {
            Kind::Pair { .. } => 1.0,
            // n1 = −B_i Σ γ_j²/B_j, and the sign of B_i is that of γ_i.
            Kind::Generic => -self.sign[point.anchor],
        }
    }

    /// dl = J dΩ + 2Ω⟨Aγ, dγ⟩; as ⟨γ, dγ⟩ = 0, A may be replaced by A − A_i.
    fn l_along(&self, point: &Point, gamma: &[f64; 3], omega: f64) -> f64 {
        let mut turning = 0.0;
        for j in 0..3 {
            turning += self.frame.diff[j][point.anchor] * point.gamma[j] * gamma[j];
        }
        self.moment(&point.gamma) * omega + 2.0 * point.omega * turning
    }

    /// A smooth function along the branch that changes its sign exactly at cusps.
    pub fn turning(&self, point: &Point, tangent: &Tangent) -> f64 {
        match self.kind {
            Kind::Generic => tangent.l / tangent.omega_scale,
            // On a pair dl vanishes at the pitchfork too, by symmetry; the other factor is 4A_i − 3J.
            Kind::Pair { axis } => {
                let mut difference = 0.0;
                for j in 0..3 {
                    difference += self.frame.diff[axis][j] * point.gamma[j] * point.gamma[j];
                }
                self.frame.a[axis] + 3.0 * difference
            }
        }
    }
}
