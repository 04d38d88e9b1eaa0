//! The straight path between two bodies, and the borders that it crosses.

use bifdiag_body::{Body, Number};
use dashu_ratio::RBig;

use crate::border::{BodySegment, Border, BorderOptions, all};

/// A body in axes with A1 ≤ A2 ≤ A3 and r_i ≥ 0, and in units with A1 + A2 + A3 = 2 and the largest r_i = 1, exactly. Its
/// diagram is the same up to its scale. Axes of equal moments stand by rising r_i.
#[must_use]
pub fn in_standard_axes(body: &Body) -> Body {
    let values = |numbers: &[Number; 3]| numbers.each_ref().map(|x| x.value().clone());
    let (a, r) = (values(body.moments()), values(body.center()).map(|x| x.clone().max(-x)));
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[i].cmp(&a[j]).then_with(|| r[i].cmp(&r[j])));
    let half = (&a[0] + &a[1] + &a[2]) / RBig::from(2);
    let largest = r.iter().fold(RBig::ZERO, |most, x| most.max(x.clone()));
    let unit = if largest.is_zero() { RBig::ONE } else { largest };
    let [moments, center] = [order.map(|k| &a[k] / &half), order.map(|k| &r[k] / &unit)];
    // Scaled by positive numbers, moments stay positive.
    Body::new(moments.map(Number::from_rational), center.map(Number::from_rational)).unwrap_or_else(|_| body.clone())
}

/// The borders on the straight path between two bodies in [standard axes](in_standard_axes), in their order.
#[must_use]
pub fn borders_between(from: &Body, to: &Body, options: &BorderOptions) -> Vec<Border> {
    all(&BodySegment::new(from.clone(), to.clone()), options)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_and_units_do_not_matter() {
        let body = |a: [&str; 3], r: [&str; 3]| in_standard_axes(&Body::parse(&a, &r).unwrap());
        let first = body(["2", "1.1", "1"], ["0.9", "-0.3", "0.6"]);
        let second = body(["1/2", "1", "0.55"], ["6", "9", "3"]);
        assert_eq!((first.moments_f64(), first.center_f64()), (second.moments_f64(), second.center_f64()));
        let sum = first.moments().iter().fold(RBig::ZERO, |sum, a| sum + a.value());
        assert_eq!(sum, RBig::from(2));
        assert_eq!(body(["2", "2", "1"], ["1", "0", "0"]).center_f64(), [0.0, 0.0, 1.0]);
        assert_eq!(body(["2", "1.5", "1"], ["0"; 3]).center_f64(), [0.0; 3]);
    }
}
