//! Newton's method on the equations of the branch with one more condition.

use super::branch::{Branch, Kind, Linear, Point, Tangent};
use super::report::Effort;
use crate::body::Axis;

/// Newton updates below this size leave an error of the order of its square: below rounding.
const CONVERGED: f64 = 2e-9;
const MAX_ITERATIONS: usize = 8;

/// The equation that picks one point of the branch.
#[derive(Clone, Copy, Debug)]
pub(super) enum Condition<'a> {
    /// The plane through the predicted point, orthogonal to the tangent of the last one (pseudo-arclength).
    Plane(&'a Tangent),
    /// l has this value.
    Momentum(f64),
    /// Ω = 0.
    Rest,
    /// γ_i = 0 on a pair.
    Symmetric(Axis),
}

impl Branch<'_> {
    /// Steps by `step` along `tangent` and corrects back to the branch; `None` if Newton's method does not contract
    /// at once or the signs that belong to the branch would change.
    pub fn advance(&self, base: &Point, tangent: &Tangent, step: f64, effort: &mut Effort) -> Option<Point> {
        let predicted = self.predict(base, tangent, step)?;
        self.correct(predicted, Condition::Plane(tangent), tangent.omega_scale, 0.5 * step.abs(), effort)
    }

    pub fn predict(&self, base: &Point, tangent: &Tangent, step: f64) -> Option<Point> {
        let mut point = *base;
        for j in 0..3 {
            point.gamma[j] += step * tangent.gamma[j];
        }
        point.omega += step * tangent.omega * tangent.omega_scale;
        if self.kind == Kind::Generic {
            // The sign is kept, and the error is of third order in the logarithm.
            let half = 0.5 * step * tangent.x;
            point.gap *= (1.0 + half) / (1.0 - half);
        }
        self.has_signs(&point, false).then_some(point)
    }

    /// The condition's linear equation c0 + c1 x + c2 w = 0.
    fn row(&self, point: &Point, condition: Condition, linear: &Linear, omega_scale: f64) -> [f64; 3] {
        match condition {
            Condition::Plane(tangent) => {
                let mut c = [0.0, 0.0, tangent.omega];
                for j in 0..3 {
                    c[0] += tangent.gamma[j] * linear.k[j];
                    c[1] += tangent.gamma[j] * linear.u[j] + tangent.gap[j] * linear.e[j];
                    c[2] += tangent.gamma[j] * linear.v[j] + tangent.gap[j] * linear.f[j];
                }
                c
            }
            Condition::Momentum(l) => {
                let moment = self.moment(&point.gamma);
                let mut c = [point.omega * moment - l, 0.0, moment * omega_scale];
                for j in 0..3 {
                    let weight = 2.0 * point.omega * self.frame.a[j] * point.gamma[j];
                    c[0] += weight * linear.k[j];
                    c[1] += weight * linear.u[j];
                    c[2] += weight * linear.v[j];
                }
                c
            }
            Condition::Rest => [point.omega / omega_scale, 0.0, 1.0],
            Condition::Symmetric(axis) => [point.gamma[axis], 1.0, 0.0],
        }
    }

    /// Newton's method from `point`; the first update may not exceed `reach`.
    pub fn correct(
        &self,
        mut point: Point,
        condition: Condition,
        omega_scale: f64,
        reach: f64,
        effort: &mut Effort,
    ) -> Option<Point> {
        effort.corrections += 1;
        let mut last = f64::INFINITY;
        for iteration in 0..MAX_ITERATIONS {
            effort.newton_iterations += 1;
            let linear = self.linear(&point, omega_scale);
            let c = self.row(&point, condition, &linear, omega_scale);
            let n = &linear.n;
            let determinant = n[1] * c[2] - n[2] * c[1];
            if determinant == 0.0 {
                return None;
            }
            let x = (n[2] * c[0] - n[0] * c[2]) / determinant;
            let w = (n[0] * c[1] - n[1] * c[0]) / determinant;
            let mut size = w.abs();
            for j in 0..3 {
                let change = linear.k[j] + linear.u[j] * x + linear.v[j] * w;
                point.gamma[j] += change;
                size = size.max(change.abs()).max((linear.e[j] * x + linear.f[j] * w).abs());
            }
            point.omega += w * omega_scale;
            if self.kind == Kind::Generic {
                if x.abs() >= 1.0 {
                    return None;
                }
                point.gap *= (1.0 + 0.5 * x) / (1.0 - 0.5 * x);
            }
            // Written so that NaN is refused.
            let contracts = if iteration == 0 { size <= reach.max(CONVERGED) } else { size <= 0.5 * last };
            if size <= CONVERGED {
                if matches!(condition, Condition::Rest) {
                    point.omega = 0.0;
                }
                if let Condition::Symmetric(axis) = condition {
                    point.gamma[axis] = 0.0;
                }
                return self.has_signs(&point, true).then_some(point);
            }
            if !contracts {
                return None;
            }
            last = size;
        }
        None
    }

    /// Whether the gaps (and γ, for a corrected point) have the signs that belong to this branch.
    fn has_signs(&self, point: &Point, corrected: bool) -> bool {
        let gaps = self.gaps(point);
        (0..3).all(|j| {
            !self.active[j] || (gaps[j] * self.sign[j] > 0.0 && (!corrected || point.gamma[j] * self.sign[j] > 0.0))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::Body;
    use crate::continuation::Start;
    use crate::stability::RelativeEquilibrium;

    /// γ = r_j/(s(μ − A_j)) of the frame at a μ below all moments.
    fn start(frame: &crate::body::Frame, below: f64) -> Start {
        let w: [f64; 3] = std::array::from_fn(|j| frame.r[j] / (-below + frame.diff[0][j]));
        let s = (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]).sqrt();
        Start::on(frame, RelativeEquilibrium::new(frame, w.map(|x| x / s), s.sqrt()))
    }

    #[test]
    fn the_tangent_is_the_derivative_along_the_branch() {
        let frame = Body::parse(&["2", "1.1", "1"], &["0.9", "0.3", "0.6"]).unwrap().frame();
        let mut effort = Effort::default();
        for below in [0.01, 0.1, 0.5, 3.0] {
            let start = start(&frame, below);
            let branch = Branch::new(&frame, &start);
            let base = branch.reanchored(branch.point(&start));
            let tangent = branch.tangent(&base);
            let step = 1e-4;
            let [back, ahead] = [-step, step].map(|step| branch.advance(&base, &tangent, step, &mut effort).unwrap());
            let slope = |from: f64, to: f64| (to - from) / (2.0 * step);
            // Central differences: an error of the order of the squared step.
            let close = |x: f64, y: f64| (x - y).abs() < 1e-6 * (1.0 + y.abs());
            assert!(close(slope(branch.l(&back), branch.l(&ahead)), tangent.l));
            assert!(close(slope(branch.h(&back), branch.h(&ahead)), base.omega * tangent.l));
            assert!(close(slope(back.omega, ahead.omega), tangent.omega * tangent.omega_scale));
            let [gaps_back, gaps_ahead] = [branch.gaps(&back), branch.gaps(&ahead)];
            for j in 0..3 {
                assert!(close(slope(back.gamma[j], ahead.gamma[j]), tangent.gamma[j]));
                assert!(close(slope(gaps_back[j], gaps_ahead[j]) / branch.gaps(&base)[j], tangent.gap[j]));
            }
        }
    }

    #[test]
    fn newtons_method_contracts_quadratically() {
        let frame = Body::parse(&["2", "1.1", "1"], &["0.9", "0.3", "0.6"]).unwrap().frame();
        let start = start(&frame, 0.4);
        let branch = Branch::new(&frame, &start);
        let base = branch.point(&start);
        let tangent = branch.tangent(&base);
        let mut effort = Effort::default();
        branch.advance(&base, &tangent, 0.1, &mut effort).unwrap();
        // 1e-2, 1e-4, 1e-8, and one more to see that it has converged.
        assert!(effort.newton_iterations <= 4, "{effort:?}");
    }
}
