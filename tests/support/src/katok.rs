//! Katok's plane: A = (1, A2, A3), r = (1, 0, 0), the bodies whose centre of mass lies on a principal axis.
//!
//! The class of the diagram changes where A_j = 1 (a pitchfork goes through infinity), where A_j = 3/4 (the cusp of a pair
//! reaches its pitchfork), and, for A_k < A_j < 3/4, where the pitchfork of the pair over the lesser moment passes through
//! the pair over the greater one: on the curve 4 (1/√(1 − A_j) − 1) = 1/(1 − A_k).

/// The values of A2, and of A3, on which the class changes.
pub const LINES: [f64; 2] = [0.75, 1.0];

/// The lesser moment A_k on the curve 4 (1/√(1 − A_j) − 1) = 1/(1 − A_k), over the greater one A_j; `None` beyond the ends
/// of the curve.
#[must_use]
pub fn lesser_moment(greater: f64) -> Option<f64> {
    if !(greater > 0.0 && greater < LINES[0]) {
        return None;
    }
    let lesser = 1.0 - 0.25 / (1.0 / (1.0 - greater).sqrt() - 1.0);
    (lesser > 0.0 && lesser < greater).then_some(lesser)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_begins_where_a_moment_vanishes_and_ends_on_the_line() {
        // 4 (1/√(1 − A_j) − 1) = 1 at A_j = 9/25, and A_k = A_j = 3/4 at the other end.
        assert!(lesser_moment(0.36).is_none_or(|lesser| lesser < 1e-15) && lesser_moment(0.3).is_none());
        // There it touches the diagonal.
        assert!((lesser_moment(0.7499).unwrap() - 0.7499).abs() < 1e-7 && lesser_moment(0.75).is_none());
    }
}
