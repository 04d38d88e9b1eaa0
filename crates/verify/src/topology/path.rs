//! Segments and arcs beside a point of the sphere, by a parameter from 0 to 1.

use crate::numbers::interval::Interval;
use crate::numbers::jet::Jet;

/// Points w beside an origin p; the point of the sphere is p + w, divided by its length.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Path {
    /// start + t·direction.
    Line { start: [Interval; 3], direction: [Interval; 3] },
    /// p + start, turned about an axis by the angle θ with tan(θ/2) = t·tangent.
    Arc { axis: usize, start: [Interval; 3], tangent: Interval },
}

impl Path {
    pub fn line(start: &[f64; 3], to: &[Interval; 3]) -> Self {
        let start = start.map(Interval::point);
        Self::Line { start, direction: std::array::from_fn(|i| to[i] - start[i]) }
    }

    /// w with its first two derivatives over a range of t.
    pub fn jets(&self, p: &[Interval; 3], t: Interval) -> [Jet; 3] {
        match *self {
            Self::Line { start, direction } => std::array::from_fn(|i| Jet::line(start[i], direction[i], t)),
            Self::Arc { axis, start, tangent } => {
                // cos θ − 1 = −2t²/(1+t²) and sin θ = 2t/(1+t²).
                let [j, k] = across(axis);
                let t = Jet::line(Interval::point(0.0), tangent, t);
                let twice = (Jet::constant(Interval::point(1.0)) + t.square()).recip().times(Interval::point(2.0)) * t;
                let bend = twice * t;
                let (first, second) = (p[j] + start[j], p[k] + start[k]);
                let mut w = start.map(Jet::constant);
                w[j] = w[j] - bend.times(first) - twice.times(second);
                w[k] = w[k] + twice.times(first) - bend.times(second);
                w
            }
        }
    }

    /// |p + w|² − 1 for |p| = 1; on an arc it is that of the start.
    pub fn excess(&self, p: &[Interval; 3], w: &[Jet; 3]) -> Jet {
        let w = match self {
            Self::Line { .. } => *w,
            Self::Arc { start, .. } => start.map(Jet::constant),
        };
        let term = |i: usize| w[i] * (Jet::constant(p[i] + p[i]) + w[i]);
        term(0) + term(1) + term(2)
    }

    /// The end, rounded.
    pub fn end(&self, p: &[Interval; 3]) -> [f64; 3] {
        self.jets(p, Interval::point(1.0)).map(|w| w.0[0].middle())
    }
}

/// The two axes across an axis.
pub(crate) fn across(axis: usize) -> [usize; 2] {
    [(axis + 1) % 3, (axis + 2) % 3]
}

/// tan(θ/2) of four turns that lead from one direction of the plane to another in a sense (1 or −1), rounded; each is a
/// quarter turn at most. `None` when a direction is not known, or when rounding leaves one that does not turn in this sense.
pub(crate) fn turns(from: [f64; 2], to: [f64; 2], sense: f64) -> Option<[f64; 4]> {
    let (from, to) = (unit(from)?, unit(to)?);
    let halfway = halfway(from, to, sense);
    let points = [from, self::halfway(from, halfway, sense), halfway, self::halfway(halfway, to, sense), to];
    let turn = |n: usize| {
        let ([a, b], [c, d]) = (points[n], points[n + 1]);
        (a * d - b * c) / (1.0 + a * c + b * d)
    };
    let turns = [turn(0), turn(1), turn(2), turn(3)];
    turns.iter().all(|turn| turn * sense > 0.0).then_some(turns)
}

/// The direction halfway between two in a sense: turned by φ with cos 2φ and the sign of sin 2φ known, 0 ≤ φ ≤ π.
fn halfway([a, b]: [f64; 2], [c, d]: [f64; 2], sense: f64) -> [f64; 2] {
    let whole = (a * c + b * d).clamp(-1.0, 1.0);
    let (cosine, sine) = ((0.5 * (1.0 + whole)).sqrt(), sense * (0.5 * (1.0 - whole)).sqrt());
    let cosine = if sense * (a * d - b * c) < 0.0 { -cosine } else { cosine };
    [a * cosine - b * sine, b * cosine + a * sine]
}

fn unit([a, b]: [f64; 2]) -> Option<[f64; 2]> {
    let size = a.abs().max(b.abs());
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let (a, b) = (a / size, b / size);
    let norm = (a * a + b * b).sqrt();
    Some([a / norm, b / norm])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four turns by the same quarter of the angle, in both senses.
    #[test]
    fn turns_lead_from_one_direction_to_another() {
        // tan of 11.25°, 33.75° and 22.5°, from turns by 90°, 270° and 180°.
        let (small, large, half) = (0.198_912_367_379_658, 0.668_178_637_919_298_9, 0.414_213_562_373_095_1);
        for (to, sense, expected) in [
            ([0.0, 3.0], 1.0, small),
            ([0.0, 3.0], -1.0, -large),
            ([0.0, -3.0], 1.0, large),
            ([-1.0, 0.0], 1.0, half),
            ([-1.0, 0.0], -1.0, -half),
        ] {
            for turn in turns([2.0, 0.0], to, sense).unwrap() {
                assert!((turn - expected).abs() < 1e-15, "{to:?} {sense} {turn}");
            }
        }
        assert_eq!(turns([0.0, 0.0], [1.0, 0.0], 1.0), None);
    }

    #[test]
    fn an_arc_turns_about_its_axis() {
        let p = [0.6, 0.8, 0.0].map(Interval::point);
        let arc = Path::Arc { axis: 2, start: [Interval::point(0.0); 3], tangent: Interval::point(1.0) };
        let end = arc.end(&p);
        assert!((end[0] + 1.4).abs() < 1e-15 && (end[1] + 0.2).abs() < 1e-15 && end[2] == 0.0, "{end:?}");
        // Half of the tangent: θ with tan(θ/2) = 1/2, and the slope is that of the turn.
        let [x, ..] = arc.jets(&p, Interval::point(0.5));
        assert!((x.0[0].middle() - (0.6 * (0.6 - 1.0) - 0.8 * 0.8)).abs() < 1e-15);
        let (angular, [sine, cosine]) = (2.0 / 1.25, [0.8, 0.6]);
        assert!((x.0[1].middle() - angular * (-0.6 * sine - 0.8 * cosine)).abs() < 1e-14);
    }
}
