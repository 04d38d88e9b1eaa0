//! The straight path between two bodies, and the borders that it crosses.

use bifdiag_body::{Body, Number};
use dashu_ratio::RBig;

use crate::border::{BodySegment, Border, BorderOptions, all};

/// A body in axes with A1 ≤ A2 ≤ A3 and r_i ≥ 0, and in units with A1 + A2 + A3 = 2 and the largest r_i = 1, exactly; r may be 0.
/// Its diagram is the same up to scale. Axes of equal moments are ordered by rising r_i.
#[must_use]
pub fn in_standard_axes(body: &Body) -> Body {
    oriented(body, None).body
}

/// A body in standard axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Oriented {
    /// The body.
    pub body: Body,
    /// Axes of equal moments have changed their order: r was turned or reflected, which changes no diagram.
    pub is_turned: bool,
}

/// Two bodies in [standard axes](in_standard_axes), but axes of equal moments in the order in which r is nearest to that of
/// the other body.
#[must_use]
pub fn in_near_axes(first: &Body, second: &Body) -> [Oriented; 2] {
    let first = oriented(first, Some(&in_standard_axes(second)));
    let second = oriented(second, Some(&first.body));
    [first, second]
}

/// In standard axes; axes of equal moments are ordered like the components of r of the other body by size, or by rising
/// r_i. For a ball, r has the direction of the other body's.
fn oriented(body: &Body, other: Option<&Body>) -> Oriented {
    let values = |numbers: &[Number; 3]| numbers.each_ref().map(|x| x.value().clone());
    let (a, r) = (values(body.moments()), values(body.center()).map(|x| x.clone().max(-x)));
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[i].cmp(&a[j]).then_with(|| r[i].cmp(&r[j])));
    if let Some(other) = other {
        // Of all orders, the one in which both sequences rise together has the least distance.
        let sizes = values(other.center());
        let mut first = 0;
        for group in order.chunk_by_mut(|&i, &j| a[i] == a[j]) {
            let mut places: Vec<usize> = (first..first + group.len()).collect();
            places.sort_by(|&p, &q| sizes[p].cmp(&sizes[q]));
            for (place, k) in places.into_iter().zip(group.to_vec()) {
                group[place - first] = k;
            }
            first += group.len();
        }
    }
    let is_ball = a.iter().all(|moment| *moment == a[0]);
    let turned = other.filter(|other| is_ball && !body.is_euler() && !other.is_euler());
    let is_turned = order.windows(2).any(|pair| {
        let [i, j] = [pair[0], pair[1]];
        a[i] == a[j] && r[i] != r[j] && i > j
    });
    let half = (&a[0] + &a[1] + &a[2]) / RBig::from(2);
    let largest = r.iter().fold(RBig::ZERO, |most, x| most.max(x.clone()));
    let unit = if largest.is_zero() { RBig::ONE } else { largest };
    let [moments, own] = [order.map(|k| &a[k] / &half), order.map(|k| &r[k] / &unit)];
    let center = turned.map_or_else(|| own.clone(), |other| values(other.center()));
    let is_turned = is_turned || center != own;
    // Scaled by positive numbers, moments stay positive.
    let body = Body::new(moments.map(Number::from_rational), center.map(Number::from_rational))
        .unwrap_or_else(|_| body.clone());
    Oriented { body, is_turned }
}

/// The borders on the straight path between two bodies in [standard axes](in_standard_axes), in their order.
#[must_use]
pub fn borders_between(from: &Body, to: &Body, options: &BorderOptions) -> Vec<Border> {
    all(&BodySegment::new(from.clone(), to.clone()), options)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// About an axis of symmetry r may be turned: the way from one body to another is not to be that turn.
    #[test]
    fn equal_moments_stand_in_the_order_of_the_other_body() {
        let body = |a: [&str; 3], r: [&str; 3]| Body::parse(&a, &r).unwrap();
        let centers = |first: &Body, second: &Body| in_near_axes(first, second).map(|end| end.body.center_f64());
        let symmetric = body(["1", "1", "2"], ["4", "3", "5"]);
        let near = body(["1", "1.1", "2"], ["4", "1", "5"]);
        assert_eq!(centers(&symmetric, &near), [[0.8, 0.6, 1.0], [0.8, 0.2, 1.0]]);
        assert_eq!(centers(&near, &symmetric), [[0.8, 0.2, 1.0], [0.8, 0.6, 1.0]]);
        assert_eq!(in_near_axes(&symmetric, &near).map(|end| end.is_turned), [false, false]);
        let other = body(["1", "1.1", "2"], ["1", "4", "5"]);
        assert_eq!(centers(&symmetric, &other), [[0.6, 0.8, 1.0], [0.2, 0.8, 1.0]]);
        assert_eq!(in_near_axes(&symmetric, &other).map(|end| end.is_turned), [true, false]);
        assert_eq!(centers(&symmetric, &symmetric), [[0.6, 0.8, 1.0]; 2]);
        let ball = body(["1", "1", "1"], ["3", "2", "1"]);
        assert_eq!(centers(&ball, &other), [[0.2, 0.8, 1.0]; 2]);
        assert_eq!(centers(&ball, &near), [[0.8, 0.2, 1.0]; 2]);
        assert_eq!(in_near_axes(&near, &ball).map(|end| end.is_turned), [false, true]);
        assert_eq!(centers(&ball, &body(["1", "2", "3"], ["0"; 3]))[0], [1.0 / 3.0, 2.0 / 3.0, 1.0]);
    }

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
