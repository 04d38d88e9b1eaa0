//! Over which part of a map bodies exist: no moment of inertia exceeds the sum of the others.

use bifdiag_body::Body;
use bifdiag_schema::BodyParameter;

use super::shown::{Seen, shared};

/// A polygon over two parameters.
pub type Polygon = Vec<[f64; 2]>;

/// By how much one moment exceeds the sum of the others, for each of them, as c + aˣx + aʸy.
pub struct Existence(Vec<[f64; 3]>);

/// Whether some mass has these moments and this centre.
pub fn exists(body: &Seen) -> bool {
    Body::from_f64(body.values[0], body.values[1]).is_ok_and(|body| !body.flags().unphysical)
}

impl Existence {
    /// Over these axes; nowhere is a body known to be impossible where the moments do not depend on them alone, and where no
    /// body exists at all, so that nothing would be left to be drawn.
    pub fn over(bodies: &[Seen], axes: [BodyParameter; 2]) -> Self {
        let moments: Option<Vec<[f64; 3]>> = BodyParameter::ALL[..3]
            .iter()
            .map(|parameter| match axes.iter().position(|axis| axis == parameter) {
                Some(0) => Some([0.0, 1.0, 0.0]),
                Some(_) => Some([0.0, 0.0, 1.0]),
                None => shared(bodies, *parameter).map(|value| [value, 0.0, 0.0]),
            })
            .collect();
        let Some(moments) = moments.filter(|_| bodies.iter().any(exists)) else { return Self(Vec::new()) };
        let excess = |k: usize| {
            let sum = |part: usize| moments.iter().map(|moment| moment[part]).sum::<f64>();
            [0, 1, 2].map(|part| 2.0 * moments[k][part] - sum(part))
        };
        Self((0..3).map(excess).collect())
    }

    /// The parts of a rectangle in which no body exists.
    pub fn impossible(&self, [x, y]: [[f64; 2]; 2]) -> Vec<Polygon> {
        let corners = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
        let parts = self.0.iter().map(|plane| clipped(&corners, |at| excess(plane, at)));
        parts.filter(|part| part.len() > 2).collect()
    }

    /// The part of a polygon in which bodies exist.
    pub fn possible(&self, polygon: &[[f64; 2]]) -> Polygon {
        self.0.iter().fold(polygon.to_vec(), |left, plane| clipped(&left, |at| -excess(plane, at)))
    }

    /// Whether a body exists here.
    pub fn holds(&self, at: [f64; 2]) -> bool {
        self.0.iter().all(|plane| excess(plane, at) <= 0.0)
    }
}

fn excess([c, x, y]: &[f64; 3], at: [f64; 2]) -> f64 {
    c + x * at[0] + y * at[1]
}

/// The part of a polygon where a linear function is not negative.
fn clipped(polygon: &[[f64; 2]], value: impl Fn([f64; 2]) -> f64) -> Polygon {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (place, &to) in polygon.iter().enumerate() {
        let from = polygon[(place + polygon.len() - 1) % polygon.len()];
        let (before, after) = (value(from), value(to));
        if (before < 0.0) != (after < 0.0) {
            let share = before / (before - after);
            left.push([0, 1].map(|k| from[k] + share * (to[k] - from[k])));
        }
        if after >= 0.0 {
            left.push(to);
        }
    }
    // A corner on the line is one corner.
    left.dedup();
    if left.len() > 1 && left.first() == left.last() {
        left.remove(0);
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(moments: [f64; 3]) -> Seen {
        Seen { at: [moments[1], moments[2]], values: [moments, [1.0, 0.0, 0.0]], shows: None }
    }

    #[test]
    fn bodies_exist_between_the_lines_of_the_katok_plane() {
        let bodies = [[1.0, 0.5, 0.6], [1.0, 0.3, 0.4]].map(seen);
        assert_eq!(bodies.each_ref().map(exists), [true, false]);
        let existence = Existence::over(&bodies, [BodyParameter::A2, BodyParameter::A3]);
        assert!(existence.holds([0.5, 0.6]) && existence.holds([1.2, 0.3]));
        assert!(![[0.3, 0.4], [1.5, 0.4], [0.4, 1.5]].into_iter().any(|at| existence.holds(at)));
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        assert_eq!(existence.possible(&square), [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(existence.impossible([[0.25, 0.75]; 2]), [[[0.25, 0.25], [0.75, 0.25], [0.25, 0.75]]]);
    }

    #[test]
    fn where_no_body_exists_at_all_nothing_is_hatched() {
        let existence = Existence::over(&[seen([1.0, 0.3, 0.4])], [BodyParameter::R2, BodyParameter::R3]);
        assert!(existence.impossible([[0.0, 1.0]; 2]).is_empty());
    }
}
