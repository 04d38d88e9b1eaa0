//! Angles without an angle: half-angle tangents, exact in binary, with their trigonometric enclosures.

use std::cmp::Ordering;

use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::interval::Interval;

/// tan(π/8) = √2 − 1, rounded down and up: where sin 2x is largest.
const OCTANT: Interval = Interval { lo: 0.414_213_562_373_095, hi: 0.414_213_562_373_096 };
/// tan(3π/8) = √2 + 1, rounded down and up: where sin 2x is smallest.
const THREE_OCTANTS: Interval = Interval { lo: 2.414_213_562_373_095, hi: 2.414_213_562_373_096 };

/// A bound of the angle between 2 arctan t and 2 arctan t', t' being t0 or t1.
pub(super) fn half_angle_reach(t0: f64, t: f64, t1: f64) -> f64 {
    (2.0 * (t - t0).max(t1 - t)).next_up().next_up()
}

/// All cosines.
const UNIT: Interval = Interval { lo: -1.0, hi: 1.0 };

/// The part of an enclosure inside a range that is known to hold the value. If there is none, the two contradict each
/// other: a defect of this program, and no conclusion is drawn.
pub(super) fn within(x: Interval, range: Interval) -> Interval {
    x.meet(&range).unwrap_or(Interval::LINE)
}

/// Enclosures of cos x, sin x, cos 2x and sin 2x for an angle or a range of angles x.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trig {
    pub cos: Interval,
    pub sin: Interval,
    pub cos_double: Interval,
    pub sin_double: Interval,
}

impl Trig {
    /// x = 2 arctan t for one t ≥ 0.
    pub fn at(t: f64) -> Self {
        if t == 0.0 {
            let (zero, one) = (Interval::ZERO, Interval::ONE);
            return Self { cos: one, sin: zero, cos_double: one, sin_double: zero };
        }
        let t = Interval::point(t);
        let denominator = Interval::ONE + t.square();
        Self::of((Interval::ONE - t) * (Interval::ONE + t) / denominator, t.twice() / denominator)
    }

    /// An angle in [0, π] given by its cosine.
    pub fn of_cosine(cos: f64) -> Self {
        let cos = Interval::point(cos);
        Self::of(cos, ((Interval::ONE - cos) * (Interval::ONE + cos)).sqrt())
    }

    fn of(cos: Interval, sin: Interval) -> Self {
        let (cos, sin) = (within(cos, UNIT), within(sin, Interval { lo: 0.0, ..UNIT }));
        Self {
            cos,
            sin,
            cos_double: within((cos - sin) * (cos + sin), UNIT),
            sin_double: within((cos * sin).twice(), UNIT),
        }
    }

    /// All x = 2 arctan t with t0 ≤ t ≤ t1, from the values at both ends.
    pub fn over(t0: f64, t1: f64) -> Self {
        let (first, last) = (Self::at(t0), Self::at(t1));
        let reaches = |turn: Interval| t0 <= turn.hi && turn.lo <= t1;
        let mut sin = first.sin.hull(&last.sin);
        let mut cos_double = first.cos_double.hull(&last.cos_double);
        let mut sin_double = first.sin_double.hull(&last.sin_double);
        if reaches(Interval::ONE) {
            sin.hi = 1.0;
            cos_double.lo = -1.0;
        }
        if reaches(OCTANT) {
            sin_double.hi = 1.0;
        }
        if reaches(THREE_OCTANTS) {
            sin_double.lo = -1.0;
        }
        Self { cos: first.cos.hull(&last.cos), sin, cos_double, sin_double }
    }

    /// x → π − x.
    pub fn mirrored(self) -> Self {
        Self { cos: -self.cos, sin_double: -self.sin_double, ..self }
    }

    /// x → x + quarter turns.
    fn turned(self, quadrant: u8) -> Self {
        let (cos, sin) = match quadrant {
            0 => (self.cos, self.sin),
            1 => (-self.sin, self.cos),
            2 => (-self.cos, -self.sin),
            _ => (self.sin, -self.cos),
        };
        if quadrant.is_multiple_of(2) {
            Self { cos, sin, ..self }
        } else {
            Self { cos, sin, cos_double: -self.cos_double, sin_double: -self.sin_double }
        }
    }
}

/// A longitude ψ = quadrant · π/2 + 2 arctan t, 0 ≤ t < 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Longitude {
    pub quadrant: u8,
    pub t: f64,
}

impl Longitude {
    pub const START: Self = Self { quadrant: 0, t: 0.0 };

    /// t = 1 is the start of the next quadrant.
    pub fn new(quadrant: u8, t: f64) -> Self {
        if t == 1.0 { Self { quadrant: (quadrant + 1) % 4, t: 0.0 } } else { Self { quadrant, t } }
    }

    pub fn trig(self) -> Trig {
        Trig::at(self.t).turned(self.quadrant)
    }

    pub fn order(&self, other: &Self) -> Ordering {
        self.quadrant.cmp(&other.quadrant).then(self.t.total_cmp(&other.t))
    }
}

/// A range of longitudes inside one quadrant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LongitudeRange {
    pub quadrant: u8,
    pub t0: f64,
    pub t1: f64,
}

impl LongitudeRange {
    pub fn quadrants() -> impl DoubleEndedIterator<Item = Self> {
        (0..4).map(|quadrant| Self { quadrant, t0: 0.0, t1: 1.0 })
    }

    pub fn trig(self) -> Trig {
        Trig::over(self.t0, self.t1).turned(self.quadrant)
    }

    pub fn start(self) -> Longitude {
        Longitude::new(self.quadrant, self.t0)
    }

    pub fn end(self) -> Longitude {
        Longitude::new(self.quadrant, self.t1)
    }

    /// The two parts on both sides of t; `None` when t is not strictly inside.
    pub fn split(self, t: f64) -> Option<(Self, Self)> {
        (self.t0 < t && t < self.t1).then_some((Self { t1: t, ..self }, Self { t0: t, ..self }))
    }

    /// True when ψ lies strictly inside.
    pub fn contains(self, psi: Longitude) -> bool {
        psi.quadrant == self.quadrant && self.t0 < psi.t && psi.t < self.t1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_contain_their_points() {
        let bounds = [0.0, 0.1, 0.4, 0.42, 0.9, 1.0, 1.3, 2.0, 2.5, 4.0];
        for (i, &t0) in bounds.iter().enumerate() {
            for &t1 in &bounds[i..] {
                let range = Trig::over(t0, t1);
                for step in 0..=20 {
                    let point = Trig::at(t0 + (t1 - t0) * f64::from(step) / 20.0);
                    for (outer, inner) in [
                        (range.cos, point.cos),
                        (range.sin, point.sin),
                        (range.cos_double, point.cos_double),
                        (range.sin_double, point.sin_double),
                    ] {
                        assert!(outer.lo <= inner.hi && inner.lo <= outer.hi, "[{t0}, {t1}] {outer:?} {inner:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_stretch_is_open() {
        for stretch in LongitudeRange::quadrants() {
            let (left, right) = stretch.split(0.25).unwrap();
            let holds = |psi| [left.contains(psi), right.contains(psi)];
            assert_eq!(holds(right.start()), [false; 2]);
            assert_eq!(holds(stretch.start()), [false; 2]);
            assert_eq!(holds(Longitude::new(stretch.quadrant, 0.125)), [true, false]);
            assert_eq!(holds(Longitude::new(stretch.quadrant, 0.75)), [false, true]);
            assert_eq!(holds(Longitude::new((stretch.quadrant + 1) % 4, 0.75)), [false; 2]);
            assert!(stretch.split(0.0).is_none() && stretch.split(1.0).is_none());
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        for quadrant in 0..4 {
            let trig = Longitude::new(quadrant, 0.0).trig();
            let (cos, sin) = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)][usize::from(quadrant)];
            assert_eq!((trig.cos, trig.sin), (Interval::point(cos), Interval::point(sin)));
            assert_eq!(trig.cos_double, Interval::point(cos * cos - sin * sin));
        }
        assert_eq!(Longitude::new(3, 1.0), Longitude::START);
    }
}
