//! A spin, exact also where it is irrational.

use bifdiag_body::Body;
use bifdiag_numbers::symmetric::{Real, dot};
use dashu_ratio::RBig;

/// A spin Ω of which Ω⁴ is rational: with 1/Ω as the unit of time the condition Σ r_k²/(μ − A_k)² = Ω⁴ for the steady axes
/// (Theorem 3.2 of docs/mathematics.md) has rational coefficients.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactSpin {
    /// Ω, to 60 digits at least.
    pub omega: RBig,
    /// Ω², to as many, or exact.
    pub squared: RBig,
    /// Ω⁴, exact.
    pub fourth: RBig,
}

/// Digits to which an irrational number is known.
const DIGITS: usize = 60;

impl ExactSpin {
    /// A rational Ω.
    #[must_use]
    pub fn rational(omega: RBig) -> Self {
        let squared = &omega * &omega;
        Self { fourth: &squared * &squared, squared, omega }
    }

    /// Ω ≥ 0 with this square.
    #[must_use]
    pub fn of_square(squared: RBig) -> Self {
        Self { omega: Real::root_of(&squared, DIGITS).lo, fourth: &squared * &squared, squared }
    }

    /// The spin at which rotation with n = `up` pointing up is steady, n in the axes in which the body was given; `None`
    /// where there is no such spin, and for a principal axis.
    #[must_use]
    pub fn of_steady(body: &Body, up: &[RBig; 3]) -> Option<Self> {
        let balance = Balance::new(body, up);
        let [left, right] = balance.squares();
        if left.is_zero() || !balance.is_possible() {
            return None;
        }
        let fourth = right / left;
        let squared = Real::root_of(&fourth, DIGITS).lo;
        Some(Self { omega: Real::root_of(&squared, DIGITS).lo, squared, fourth })
    }

    /// Whether rotation with n = `up` pointing up, in the axes in which the body was given, is steady at this spin.
    #[must_use]
    pub fn is_steady(&self, body: &Body, up: &[RBig; 3]) -> bool {
        let balance = Balance::new(body, up);
        let [left, right] = balance.squares();
        balance.is_possible() && &self.fourth * left == right
    }
}

/// Whether an axis n of a body is principal, n × An = 0, n in the axes in which the body was given.
#[must_use]
pub fn is_principal(body: &Body, n: &[RBig; 3]) -> bool {
    Balance::new(body, n).left.iter().all(RBig::is_zero)
}

/// Ω²(n × An) = |n|(n × r): rotation with n pointing up is steady, for γ = −n/|n| and Ω²Aγ + r are parallel.
struct Balance<'a> {
    n: &'a [RBig; 3],
    /// n × An.
    left: [RBig; 3],
    /// n × r.
    right: [RBig; 3],
}

impl<'a> Balance<'a> {
    fn new(body: &Body, n: &'a [RBig; 3]) -> Self {
        let center = body.center_as_given();
        Self { n, left: cross(n, &body.angular_momentum_as_given(n)), right: cross(n, &center) }
    }

    /// Of some Ω² ≥ 0.
    fn is_possible(&self) -> bool {
        cross(&self.left, &self.right).iter().all(RBig::is_zero) && dot(&self.left, &self.right) >= RBig::ZERO
    }

    /// Of n × An and of |n|(n × r).
    fn squares(&self) -> [RBig; 2] {
        [dot(&self.left, &self.left), dot(self.n, self.n) * dot(&self.right, &self.right)]
    }
}

fn cross(v: &[RBig; 3], w: &[RBig; 3]) -> [RBig; 3] {
    [0, 1, 2].map(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        &v[i] * &w[j] - &v[j] * &w[i]
    })
}
