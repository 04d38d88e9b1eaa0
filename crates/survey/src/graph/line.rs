//! Straight lines through the space of bodies.

use super::place::{Domain, Place, length};
use bifdiag_numbers::vector::norm;

/// A(s) = A + s a, r(s) = r + s d with d ⊥ r, so that r̂ runs on a great circle; |a|² + |d|² = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    from: Place,
    change: [[f64; 3]; 2],
    reach: [f64; 2],
}

impl Line {
    /// The line through a body in a direction; `None` where nothing changes.
    pub(super) fn new(from: Place, change: [[f64; 3]; 2], domain: Domain) -> Option<Self> {
        let length = length(&change);
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        let change = change.map(|part| part.map(|x| x / length));
        let mut line = Self { from, change, reach: [0.0; 2] };
        line.reach = [line.end(-1.0, domain), line.end(1.0, domain)];
        Some(line)
    }

    /// How far the line runs back and forth, up to where it leaves the bodies with A1 ≤ A2 ≤ A3 and r_i ≥ 0 or the domain.
    #[must_use]
    pub fn reach(&self) -> [f64; 2] {
        self.reach
    }

    fn end(&self, sign: f64, domain: Domain) -> f64 {
        let ([a, r], [da, dr]) = (self.from.values(), self.change);
        // Each of these stays ≥ 0; what is 0 and stays so is special about the whole line.
        let last = match domain {
            Domain::Existing => [a[0] + a[1] - a[2], da[0] + da[1] - da[2]],
            Domain::All => [a[0], da[0]],
        };
        let bounds = [
            last,
            [a[1] - a[0], da[1] - da[0]],
            [a[2] - a[1], da[2] - da[1]],
            [r[0], dr[0]],
            [r[1], dr[1]],
            [r[2], dr[2]],
        ];
        let ends = bounds.into_iter().map(|[value, slope]| {
            let slope = sign * slope;
            // The special ones are special in every bit.
            if slope < 0.0 && (value > 0.0 || slope < -1e-12) { value.max(0.0) / -slope } else { f64::INFINITY }
        });
        ends.fold(f64::INFINITY, f64::min)
    }

    /// A and r at s; |r| is not 1.
    #[must_use]
    pub fn at(&self, s: f64) -> [[f64; 3]; 2] {
        let from = self.from.values();
        std::array::from_fn(|part| std::array::from_fn(|k| from[part][k] + s * self.change[part][k]))
    }

    /// How far the body at s is from that at 0: √(|ΔA|² + ∠²), with the angle ∠ between the two r.
    #[must_use]
    pub fn distance(&self, s: f64) -> f64 {
        let [da, dr] = self.change;
        libm::hypot(s * norm(da), libm::atan(s * norm(dr)))
    }

    /// Values of s on one side of 0, growing in size, as dense at both ends as in logarithms: those of the logistic
    /// function at even steps, which `shift` in [0, 1) moves.
    #[must_use]
    pub fn nodes(&self, forth: bool, shift: f64) -> Vec<f64> {
        const COUNT: usize = 30;
        /// e^−13 = 2e-6 of the side is left out at both ends.
        const END: f64 = 13.0;
        let side = if forth { self.reach[1] } else { -self.reach[0] };
        if side == 0.0 || !side.is_finite() {
            return Vec::new();
        }
        let step = 2.0 * END / COUNT as f64;
        (0..COUNT).map(|k| side / (1.0 + libm::exp(END - step * (k as f64 + shift)))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::chart::Chart;
    use super::*;

    #[test]
    fn a_line_ends_where_a_body_ceases_to_exist_or_is_special() {
        let place = Place::of([[0.5, 0.6, 0.9], [0.6, 0.0, 0.8]]);
        let line = |change, domain| Line::new(place, change, domain).unwrap();
        let flatter = [[-0.5, -0.5, 1.0], [0.0; 3]];
        let unit = 1.5_f64.sqrt();
        // A3 − A2 shrinks to 0 on the one side; A1 + A2 − A3 = 0.2 (or A1 = 0.5) on the other.
        let close = |found: [f64; 2], wanted: [f64; 2]| (0..2).all(|k| (found[k] - wanted[k]).abs() < 1e-12);
        assert!(close(line(flatter, Domain::Existing).reach(), [0.2 * unit, 0.1 * unit]));
        assert!(close(line(flatter, Domain::All).reach(), [0.2 * unit, unit]));
        // r turns by a quarter at most.
        let turned = line([[0.0; 3], [-0.8, 0.0, 0.6]], Domain::All);
        assert!((turned.distance(turned.reach()[1]) - libm::atan(0.75)).abs() < 1e-12);
        assert!((turned.reach()[0] - 4.0 / 3.0).abs() < 1e-12);
        assert!(turned.nodes(true, 0.5).iter().all(|s| *s > 0.0 && *s < turned.reach()[1]));
        let chart = Chart::new(place);
        let whole = chart.line(&[0.1, 0.2, 0.3], Domain::Existing).unwrap();
        assert!(whole.at(0.5 * whole.reach()[0]).iter().flatten().all(|x| *x >= 0.0));
        assert_eq!(whole.at(0.01)[1][1], 0.0);
    }
}
