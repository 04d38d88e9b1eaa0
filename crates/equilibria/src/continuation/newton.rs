//! Newton's method on the equations of the branch with one more condition.

use super::branch::{Branch, Linear, Point, Tangent};

/// Newton updates below this size leave an error of the order of its square: below rounding.
const CONVERGED: f64 = 2e-9;
const MAX_ITERATIONS: usize = 8;

/// The equation that picks one point of the branch.
#[derive(Clone, Copy)]
pub(super) enum Condition<'a> {
    /// The plane through the predicted point, orthogonal to the tangent of the last one (pseudo-arclength).
    Plane(&'a Tangent),
    /// l has this value.
    Momentum(f64),
}

impl Branch<'_> {
    /// The point a step ahead along the tangent; `None` where the signs that belong to the branch would change.
    pub fn predict(&self, base: &Point, tangent: &Tangent, step: f64) -> Option<Point> {
        let mut point = *base;
        for j in 0..3 {
            point.gamma[j] += step * tangent.gamma[j];
        }
        point.omega += step * tangent.omega * tangent.scale;
        self.stretch(&mut point, step * tangent.x);
        self.has_signs(&point).then_some(point)
    }

    /// Changes the gap's logarithm by x: its sign is kept, and the error is of third order.
    fn stretch(&self, point: &mut Point, x: f64) {
        if self.pair.is_none() {
            point.gap *= (1.0 + 0.5 * x) / (1.0 - 0.5 * x);
        }
    }

    fn has_signs(&self, point: &Point) -> bool {
        let gaps = self.gaps(point);
        (0..3).all(|j| self.sign[j] == 0.0 || gaps[j] * self.sign[j] > 0.0)
    }

    /// The condition's linear equation c_0 + c_1 x + c_2 w = 0.
    fn row(&self, point: &Point, condition: Condition, linear: &Linear, scale: f64) -> [f64; 3] {
        let (mut c, weight): ([f64; 3], [f64; 3]) = match condition {
            Condition::Plane(tangent) => ([0.0, 0.0, tangent.omega], tangent.gamma),
            Condition::Momentum(l) => {
                let moment = self.moment(&point.gamma);
                let weight = |j: usize| 2.0 * point.omega * self.frame.a[j] * point.gamma[j];
                ([point.omega * moment - l, 0.0, moment * scale], std::array::from_fn(weight))
            }
        };
        for j in 0..3 {
            c[0] += weight[j] * linear.k[j];
            c[1] += weight[j] * linear.u[j];
            c[2] += weight[j] * linear.v[j];
            if let Condition::Plane(tangent) = condition {
                c[1] += tangent.gap[j] * linear.e[j];
                c[2] += tangent.gap[j] * linear.f[j];
            }
        }
        c
    }

    /// Newton's method from `point`, whose first update may not exceed `reach`; `None` if it does not contract at once.
    pub fn correct(&self, mut point: Point, condition: Condition, scale: f64, reach: f64) -> Option<Point> {
        let mut allowed = reach.max(CONVERGED);
        for _ in 0..MAX_ITERATIONS {
            let linear = self.linear(&point, scale);
            let c = self.row(&point, condition, &linear, scale);
            let n = &linear.n;
            let determinant = n[1] * c[2] - n[2] * c[1];
            let x = (n[2] * c[0] - n[0] * c[2]) / determinant;
            let w = (n[0] * c[1] - n[1] * c[0]) / determinant;
            let mut size = w.abs().max(x.abs());
            for j in 0..3 {
                let change = linear.k[j] + linear.u[j] * x + linear.v[j] * w;
                point.gamma[j] += change;
                size = size.max(change.abs()).max((linear.e[j] * x + linear.f[j] * w).abs());
            }
            point.omega += w * scale;
            self.stretch(&mut point, x);
            if size <= CONVERGED {
                let keeps = |j: usize| self.sign[j] == 0.0 || point.gamma[j] * self.sign[j] > 0.0;
                return (self.has_signs(&point) && (0..3).all(keeps)).then_some(point);
            }
            // Written so that NaN is refused: a sum of non-numbers is no smaller than anything.
            if !(size <= allowed && x.is_finite() && w.is_finite()) {
                return None;
            }
            allowed = 0.5 * size;
        }
        None
    }
}
