//! Bodies up to units, and the order and the signs of their axes.

use bifdiag_body::{Body, BodyError};
use bifdiag_numbers::vector::norm;

/// The bodies among which a walk stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Domain {
    /// Bodies that exist: A_i + A_j > A_k, or equality and r_k = 0.
    Existing,
    /// All A > 0.
    All,
}

/// A body with A1 ≤ A2 ≤ A3, A1 + A2 + A3 = 2, r_i ≥ 0 and |r| = 1, or r = 0.
///
/// Where two moments are equal, r is turned in the plane of their axes until the component of the first of them is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// A1, A2, A3.
    pub a: [f64; 3],
    /// r1, r2, r3.
    pub r: [f64; 3],
}

impl Place {
    /// The place of A and r. Equal moments stay equal, and a component of r that is 0 stays 0.
    #[must_use]
    pub fn of([a, r]: [[f64; 3]; 2]) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| a[i].total_cmp(&a[j]));
        let (mut a, mut r) = (order.map(|k| a[k]), order.map(|k| r[k].abs()));
        let sum = a[0] + a[1] + a[2];
        a = a.map(|x| 2.0 * x / sum);
        for (i, j) in [(0, 1), (1, 2)] {
            if a[i] == a[j] {
                r[j] = libm::hypot(r[i], r[j]);
                r[i] = 0.0;
            }
        }
        let norm = norm(r);
        if norm > 0.0 {
            r = r.map(|x| x / norm);
        }
        Self { a, r }
    }

    /// The place of a body.
    #[must_use]
    pub fn of_body(body: &Body) -> Self {
        Self::of([body.moments_f64(), body.center_f64()])
    }

    /// A and r.
    #[must_use]
    pub fn values(&self) -> [[f64; 3]; 2] {
        [self.a, self.r]
    }

    /// The body of exactly these doubles, read as their shortest decimals.
    ///
    /// # Errors
    /// [`BodyError`] for a moment that is not positive.
    pub fn body(&self) -> Result<Body, BodyError> {
        Body::from_f64(self.a, self.r)
    }

    /// True when the body lies in a domain.
    #[must_use]
    pub fn is_in(&self, domain: Domain) -> bool {
        let excess = self.a[0] + self.a[1] - self.a[2];
        self.a[0] > 0.0 && (domain == Domain::All || excess > 0.0 || (excess == 0.0 && self.r[2] == 0.0))
    }
}

/// A change of A and of r.
pub(super) type Change = [[f64; 3]; 2];

/// The length of a change.
pub(super) fn length(change: &Change) -> f64 {
    libm::hypot(norm(change[0]), norm(change[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_order_and_signs_do_not_matter() {
        let place = Place::of([[4.0, 1.0, 3.0], [0.0, -2.0, 1.0]]);
        assert_eq!(place.a, [0.25, 0.75, 1.0]);
        assert_eq!(place, Place::of([[0.5, 1.5, 2.0], [4.0, 2.0, 0.0]]));
        assert!(place.is_in(Domain::Existing) && place.r[2] == 0.0);
        // A disc: equal moments, r turned.
        let top = Place::of([[1.0, 1.0, 2.0], [3.0, 4.0, 0.0]]);
        assert_eq!(top.values(), [[0.5, 0.5, 1.0], [0.0, 1.0, 0.0]]);
        assert!(!Place::of([[1.0, 1.0, 2.0], [3.0, 4.0, 1.0]]).is_in(Domain::Existing));
        assert!(!Place::of([[1.0, 1.0, 3.0], [1.0, 1.0, 1.0]]).is_in(Domain::Existing));
    }
}
