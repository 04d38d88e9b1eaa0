//! The equations of relative equilibria along one branch, their linearisation and tangent.

use crate::stability::RelativeEquilibrium;
use bifdiag_body::{Axis, Frame};

/// What stays the same along a branch.
pub(super) struct Branch<'a> {
    pub frame: &'a Frame,
    /// r_i = 0 and B_i = 0 for this axis i, γ_i is free; `None`: γ_j = 0 wherever r_j = 0.
    pub pair: Option<Axis>,
    /// Signs of γ on the axes with r_j ≠ 0, where B_jγ_j = r_j; 0 on the others.
    pub sign: [f64; 3],
}

/// A point of the branch: five unknowns.
#[derive(Clone, Copy)]
pub(super) struct Point {
    pub gamma: [f64; 3],
    pub omega: f64,
    /// The axis i whose gap is held; the others follow as B_j = B_i + s(A_i − A_j).
    pub anchor: Axis,
    pub gap: f64,
}

/// The equations at a point to first order, with the γ_j eliminated:
/// δγ_j = k_j + u_j x + v_j w, δB_j/B_j = e_j x + f_j w, and n_0 + n_1 x + n_2 w = 0 from |γ|² = 1.
/// w = δΩ/`scale`; x = δB_i/B_i of the anchor, or δγ_i for a pair.
#[derive(Default)]
pub(super) struct Linear {
    pub k: [f64; 3],
    pub u: [f64; 3],
    pub v: [f64; 3],
    pub e: [f64; 3],
    pub f: [f64; 3],
    pub n: [f64; 3],
}

/// A unit tangent.
#[derive(Clone, Copy)]
pub(super) struct Tangent {
    pub gamma: [f64; 3],
    /// dB_j/B_j where r_j ≠ 0.
    pub gap: [f64; 3],
    /// dΩ/`scale`.
    pub omega: f64,
    pub x: f64,
    pub scale: f64,
    /// dl.
    pub l: f64,
}

impl Tangent {
    pub fn dot(&self, other: &Self) -> f64 {
        (0..3).map(|j| self.gamma[j] * other.gamma[j] + self.gap[j] * other.gap[j]).sum::<f64>()
            + self.omega * other.omega
    }

    pub fn reversed(self) -> Self {
        let Self { gamma, gap, omega, x, scale, l } = self;
        Self { gamma: gamma.map(|x| -x), gap: gap.map(|x| -x), omega: -omega, x: -x, scale, l: -l }
    }
}

impl Branch<'_> {
    /// The point with these γ and Ω.
    pub fn point(&self, gamma: [f64; 3], omega: f64) -> Point {
        if let Some(anchor) = self.pair {
            return Point { gamma, omega, anchor, gap: 0.0 };
        }
        let gap = RelativeEquilibrium::new(self.frame, gamma, omega).gap;
        let active = Axis::ALL.into_iter().filter(|&j| self.sign[j] != 0.0);
        let anchor = active.min_by(|&i, &j| gap[i].abs().total_cmp(&gap[j].abs())).unwrap_or(Axis::ALL[0]);
        Point { gamma, omega, anchor, gap: gap[anchor] }
    }

    pub fn gaps(&self, point: &Point) -> [f64; 3] {
        let s = point.omega * point.omega;
        self.frame.diff[point.anchor].map(|difference| point.gap + s * difference)
    }

    /// The same point, held by its smallest gap.
    pub fn reanchored(&self, point: Point) -> Point {
        let gaps = self.gaps(&point);
        let smaller = |j: &Axis| self.sign[*j] != 0.0 && gaps[*j].abs() < 0.5 * point.gap.abs();
        let smallest = Axis::ALL.into_iter().filter(smaller).min_by(|&i, &j| gaps[i].abs().total_cmp(&gaps[j].abs()));
        smallest.map_or(point, |anchor| Point { anchor, gap: gaps[anchor], ..point })
    }

    pub fn moment(&self, gamma: &[f64; 3]) -> f64 {
        (0..3).map(|j| self.frame.a[j] * gamma[j] * gamma[j]).sum()
    }

    pub fn l(&self, point: &Point) -> f64 {
        point.omega * self.moment(&point.gamma)
    }

    pub fn linear(&self, point: &Point, scale: f64) -> Linear {
        let Point { gamma, omega, anchor, gap } = *point;
        let mut linear = Linear::default();
        for j in (0..3).filter(|&j| self.sign[j] != 0.0) {
            let difference = self.frame.diff[anchor][j];
            let inverse = 1.0 / (gap + omega * omega * difference);
            linear.e[j] = gap * inverse;
            linear.f[j] = 2.0 * omega * scale * difference * inverse;
            linear.k[j] = self.frame.r[j] * inverse - gamma[j];
            linear.u[j] = -gamma[j] * linear.e[j];
            linear.v[j] = -gamma[j] * linear.f[j];
        }
        if let Some(axis) = self.pair {
            linear.u[axis] = 1.0;
        }
        linear.n[0] = -0.5;
        for j in 0..3 {
            linear.n[0] += gamma[j] * (0.5 * gamma[j] + linear.k[j]);
            linear.n[1] += gamma[j] * linear.u[j];
            linear.n[2] += gamma[j] * linear.v[j];
        }
        linear
    }

    /// A unit tangent at a point of the branch.
    pub fn tangent(&self, point: &Point) -> Tangent {
        // √(r/a₃) is the angular velocity below which changes of Ω are measured absolutely.
        let floor = if self.frame.is_euler() { 1.0 } else { (self.frame.r_norm / self.frame.a[2]).sqrt() };
        let scale = point.omega.max(floor);
        let linear = self.linear(point, scale);
        let along = |x: f64, w: f64| -> [[f64; 3]; 2] {
            [
                std::array::from_fn(|j| linear.u[j] * x + linear.v[j] * w),
                std::array::from_fn(|j| linear.e[j] * x + linear.f[j] * w),
            ]
        };
        let (x, w) = (-linear.n[2], linear.n[1]);
        let square = w * w + along(x, w).as_flattened().iter().map(|x| x * x).sum::<f64>();
        let (x, omega) = (x / square.sqrt(), w / square.sqrt());
        let [gamma, gap] = along(x, omega);
        // dl = J dΩ + 2Ω⟨Aγ, dγ⟩; as ⟨γ, dγ⟩ = 0, A may be replaced by A − A_i.
        let turning: f64 = (0..3).map(|j| self.frame.diff[j][point.anchor] * point.gamma[j] * gamma[j]).sum();
        let l = self.moment(&point.gamma) * omega * scale + 2.0 * point.omega * turning;
        Tangent { gamma, gap, omega, x, scale, l }
    }
}
