//! The cubic inequality whose solution is U_hl, in spherical coordinates about r̂, with enclosures.

use super::angle::Trig;
use super::interval::Interval;
use crate::body::Frame;

/// G(γ) = 2J(γ)(h + ⟨γ,r⟩) − l², whose sign for l ≠ 0 says whether γ is in U_hl = {G ≥ 0}.
///
/// With γ = cos ϑ r̂ + sin ϑ (cos ψ e1 + sin ψ e2), where e2 lies in the plane of r̂ and the frame axis k
/// on which r has its smallest component,
/// J − a_k = constant + axial cos 2ϑ + sin 2ϑ (p1 cos ψ + p2 sin ψ) + sin²ϑ (α cos 2ψ + β sin 2ψ).
/// All coefficients are closed formulas in the exact differences of moments: p and β vanish exactly for the bodies
/// for which they should, and nothing is lost when moments are nearly equal.
#[derive(Clone, Debug)]
pub(super) struct Level {
    /// 2 a_k h − l².
    base: Interval,
    twice_h: Interval,
    r: Interval,
    /// a_k.
    moment: Interval,
    /// [a_1 − a_k, a_3 − a_k], the range of J − a_k.
    range: Interval,
    constant: Interval,
    axial: Interval,
    p: [Interval; 2],
    alpha: Interval,
    beta: Interval,
    /// e1 and e2 in the frame, rounded.
    pub tangent: [[f64; 3]; 2],
    /// r̂ in the frame, rounded; the third axis when r = 0.
    pub pole: [f64; 3],
}

/// Enclosures over a box of (ϑ, ψ).
#[derive(Clone, Copy, Debug)]
pub(super) struct Slopes {
    /// ∂G/∂ϑ.
    pub meridional: Interval,
    /// H = ∂J/∂ψ / (2 sin ϑ), which is regular at the poles.
    pub turning: Interval,
    /// h + ⟨γ,r⟩.
    pub height: Interval,
}

impl Level {
    /// For finite h and l.
    pub fn new(frame: &Frame, h: f64, l: f64) -> Self {
        let r_hat = if frame.is_euler() {
            [Interval::ZERO, Interval::ZERO, Interval::ONE]
        } else {
            frame.r.map(|x| Interval::rounded(x) / Interval::rounded(frame.r_norm))
        };
        let k = if frame.is_euler() || (frame.r[0] <= frame.r[1] && frame.r[0] <= frame.r[2]) {
            0
        } else if frame.r[1] <= frame.r[2] {
            1
        } else {
            2
        };
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let above = |x: usize| Interval::rounded(frame.diff[x][k]);
        let [x, y, z] = [r_hat[i], r_hat[j], r_hat[k]];
        let (x2, y2) = (x.squared(), y.squared());
        let n2 = x2 + y2;
        let n = n2.sqrt();
        let axis = if frame.is_euler() { above(i) * x2 + above(j) * y2 } else { -Interval::rounded(frame.offset[k]) };
        let across = (y2 * above(i) + x2 * above(j)) / n2;
        let along = z.squared() * (x2 * above(i) + y2 * above(j)) / n2;
        let mean = (across + along).half();
        let (h, l, moment) = (Interval::rounded(h), Interval::rounded(l), Interval::rounded(frame.a[k]));
        let middle = |u: Interval| 0.5 * (u.lo + u.hi);
        let (mx, my, mz, mn) = (middle(x), middle(y), middle(z), middle(n));
        let mut tangent = [[0.0; 3]; 2];
        tangent[0][i] = -my / mn;
        tangent[0][j] = mx / mn;
        tangent[1][i] = -mx * mz / mn;
        tangent[1][j] = -my * mz / mn;
        tangent[1][k] = mn;
        Self {
            base: (moment * h).twice() - l.squared(),
            twice_h: h.twice(),
            r: Interval::rounded(frame.r_norm),
            moment,
            range: above(0).hull(above(2)),
            constant: (axis + mean).half(),
            axial: (axis - mean).half(),
            p: [x * y * Interval::rounded(frame.diff[j][i]) / n, -(z * (x2 * above(i) + y2 * above(j))) / n],
            alpha: (across - along).half(),
            beta: x * y * z * Interval::rounded(frame.diff[i][j]) / n2,
            tangent,
            pole: r_hat.map(middle),
        }
    }

    /// J − a_k.
    fn excess(&self, theta: &Trig, psi: &Trig) -> Interval {
        let excess = self.constant
            + self.axial * theta.cos_double
            + theta.sin_double * (self.p[0] * psi.cos + self.p[1] * psi.sin)
            + theta.sin.squared() * (self.alpha * psi.cos_double + self.beta * psi.sin_double);
        excess.intersect(self.range)
    }

    /// G over a box.
    pub fn value(&self, theta: &Trig, psi: &Trig) -> Interval {
        let twice_height = self.twice_h + (self.r * theta.cos).twice();
        self.base + self.excess(theta, psi) * twice_height + (self.moment * self.r * theta.cos).twice()
    }

    /// h + ⟨γ,r⟩ over a range of latitudes.
    pub fn height(&self, theta: &Trig) -> Interval {
        self.twice_h.half() + self.r * theta.cos
    }

    /// The derivatives over a box.
    pub fn slopes(&self, theta: &Trig, psi: &Trig) -> Slopes {
        let outward = self.p[0] * psi.cos + self.p[1] * psi.sin;
        let sideways = self.p[1] * psi.cos - self.p[0] * psi.sin;
        let quadrupole = self.alpha * psi.cos_double + self.beta * psi.sin_double;
        let quadrupole_slope = self.beta * psi.cos_double - self.alpha * psi.sin_double;
        let height = self.height(theta);
        let j = self.moment + self.excess(theta, psi);
        let j_slope = theta.sin_double * (quadrupole - self.axial.twice()) + (theta.cos_double * outward).twice();
        Slopes {
            meridional: (j_slope * height - j * self.r * theta.sin).twice(),
            turning: theta.cos * sideways + theta.sin * quadrupole_slope,
            height,
        }
    }

    /// G over the box by the mean value theorem: its value at a point of the box, and |∂G| times the largest
    /// distance from that point (`reach` in ϑ and in ψ).
    pub fn mean_value(&self, center: (&Trig, &Trig), slopes: &Slopes, theta: &Trig, reach: (f64, f64)) -> Interval {
        // ∂G/∂ψ = 2 (h + ⟨γ,r⟩) ∂J/∂ψ = 4 sin ϑ (h + ⟨γ,r⟩) H.
        let parallel = (theta.sin * slopes.height * slopes.turning).twice().twice();
        let spread = |slope: Interval, reach: f64| {
            let bound = (slope.magnitude() * reach).next_up();
            if bound == 0.0 { Interval::ZERO } else { Interval { lo: -bound, hi: bound } }
        };
        self.value(center.0, center.1) + spread(slopes.meridional, reach.0) + spread(parallel, reach.1)
    }
}
