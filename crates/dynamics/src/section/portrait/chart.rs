//! Angles of γ about two axes, and figures in the plane of these angles.

use std::f64::consts::{PI, TAU};

use super::super::torus::PpTorus;
use crate::field::dot;

/// Places on the edge of a chart at which its kind is looked up.
const EDGE_PLACES: usize = 720;

/// Which angles (x, y) = (ψ, ϑ) of γ are drawn, x in [0, 2π) and y in [0, π].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SectionChart {
    /// The PP-torus: (ψ', ϑ') with r̂ as polar axis; y = 0 and y = π are the polar circles.
    #[default]
    Torus,
    /// The Poisson sphere: (ψ, ϑ) with γ = (sinψ sinϑ, cosψ sinϑ, cosϑ).
    Sphere,
}

/// A chart's axes: γ = sin y (sin x e₁ + cos x e₂) + cos y e₃.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axes([[f64; 3]; 3]);

impl Axes {
    pub fn new(chart: SectionChart, torus: &PpTorus) -> Self {
        Self(match chart {
            SectionChart::Torus => torus.axes(),
            SectionChart::Sphere => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        })
    }

    pub fn gamma(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let ((sin_x, cos_x), (sin_y, cos_y)) = (libm::sincos(x), libm::sincos(y));
        let [u, v, w] = self.0;
        std::array::from_fn(|i| sin_y * (sin_x * u[i] + cos_x * v[i]) + cos_y * w[i])
    }

    pub fn angles(&self, gamma: [f64; 3]) -> [f64; 2] {
        let [p, q, s] = self.0.map(|axis| dot(gamma, axis));
        let x = libm::atan2(p, q);
        let x = if x < 0.0 { x + TAU } else { x };
        [if x < TAU { x } else { 0.0 }, libm::atan2((p * p + q * q).sqrt(), s)]
    }

    /// The sine of y.
    pub fn sine(&self, gamma: [f64; 3]) -> f64 {
        let cos = dot(gamma, self.0[2]);
        (1.0 - cos * cos).max(0.0).sqrt()
    }

    /// A polyline on the sphere as polylines in the chart, cut where it runs over the seam x = 0.
    pub fn cut(&self, line: &[[f64; 3]], closed: bool) -> Vec<Vec<[f64; 2]>> {
        let mut angles: Vec<[f64; 2]> = line.iter().map(|gamma| self.angles(*gamma)).collect();
        if closed {
            angles.extend(angles.first().copied());
        }
        let mut pieces = Vec::new();
        let mut piece: Vec<[f64; 2]> = Vec::new();
        for point in angles {
            if let Some(&last) = piece.last() {
                let across = point[0] - last[0];
                if across.abs() > PI {
                    let (edge, other) = if across > 0.0 { (0.0, TAU) } else { (TAU, 0.0) };
                    let way = across.abs() - TAU;
                    let share = (edge - last[0]).abs() / way.abs();
                    let y = if way == 0.0 { last[1] } else { last[1] + share * (point[1] - last[1]) };
                    piece.push([edge, y]);
                    pieces.push(std::mem::replace(&mut piece, vec![[other, y]]));
                }
            }
            piece.push(point);
        }
        if piece.len() > 1 {
            pieces.push(piece);
        }
        pieces
    }
}

/// An area of a chart: the points that an odd number of its loops encloses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChartArea {
    /// Closed polygons, (x, y) in radians.
    pub loops: Vec<Vec<[f64; 2]>>,
}

impl ChartArea {
    /// The area that is bounded by `lines` and contains the part `bottom` of the edge y = π.
    ///
    /// Each line is closed by straight walls up to y = 0, unless it ends where it begins: a point lies over an odd number
    /// of lines exactly if it is not of the same kind as the edge y = π under it.
    pub(super) fn new(lines: Vec<Vec<[f64; 2]>>, bottom: &[[f64; 2]]) -> Self {
        let walled = lines.into_iter().filter_map(|mut line| {
            let (first, last) = (*line.first()?, *line.last()?);
            if first != last {
                line.extend([[last[0], 0.0], [first[0], 0.0]]);
            }
            Some(line)
        });
        let columns = bottom.iter().map(|&[from, to]| vec![[from, 0.0], [to, 0.0], [to, PI], [from, PI]]);
        Self { loops: walled.chain(columns).collect() }
    }

    /// True for a point inside.
    #[must_use]
    pub fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let mut inside = false;
        for polygon in &self.loops {
            for (k, a) in polygon.iter().enumerate() {
                let b = polygon[(k + 1) % polygon.len()];
                if (a[0] > x) != (b[0] > x) && a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) > y {
                    inside = !inside;
                }
            }
        }
        inside
    }
}

/// The parts of an edge y = const of a chart where something holds of x.
pub(super) fn edge_parts(holds: &dyn Fn(f64) -> bool) -> Vec<[f64; 2]> {
    let place = |k: usize| (k as f64 + 0.5) * TAU / EDGE_PLACES as f64;
    let mut parts = Vec::new();
    let mut open = holds(place(0)).then_some(0.0);
    for k in 1..EDGE_PLACES {
        let here = holds(place(k));
        if here == open.is_some() {
            continue;
        }
        let (mut low, mut high) = (place(k - 1), place(k));
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if holds(middle) == here { high = middle } else { low = middle }
        }
        match open.take() {
            Some(from) => parts.push([from, high]),
            None => open = Some(high),
        }
    }
    parts.extend(open.map(|from| [from, TAU]));
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::HeavyTop;

    fn axes() -> Axes {
        let torus = PpTorus::new(&HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623])).unwrap();
        Axes::new(SectionChart::Torus, &torus)
    }

    #[test]
    fn angles_and_gamma_are_inverse() {
        for k in 0..50 {
            let point = [0.12 * f64::from(k), 0.05 + 0.06 * f64::from(k)];
            let back = axes().angles(axes().gamma(point));
            assert!((back[0] - point[0]).abs() < 1e-13 && (back[1] - point[1]).abs() < 1e-13);
        }
    }

    #[test]
    fn a_circle_over_the_seam_bounds_its_disc() {
        let circle: Vec<[f64; 3]> = (0..400)
            .map(|k| {
                let (sin, cos) = libm::sincos(f64::from(k) / 400.0 * TAU);
                axes().gamma([(0.5 * cos + TAU) % TAU, 1.0 + 0.5 * sin])
            })
            .collect();
        let pieces = axes().cut(&circle, true);
        assert_eq!(pieces.len(), 3, "the line begins inside, leaves, comes back and leaves again");
        let disc = ChartArea::new(pieces.clone(), &[]);
        let rest = ChartArea::new(pieces, &[[0.0, TAU]]);
        for ([x, y], inside) in
            [([0.1, 1.0], true), ([6.2, 1.2], true), ([3.0, 1.0], false), ([0.1, 2.0], false), ([0.3, 0.4], false)]
        {
            assert_eq!(disc.contains([x, y]), inside, "({x}, {y})");
            assert_ne!(rest.contains([x, y]), inside, "({x}, {y})");
        }
    }

    #[test]
    fn a_closed_line_needs_no_walls() {
        let circle: Vec<[f64; 2]> = (0..=100)
            .map(|k| {
                let (sin, cos) = libm::sincos(f64::from(k % 100) / 100.0 * TAU);
                [2.0 + 0.5 * cos, 1.0 + 0.5 * sin]
            })
            .collect();
        let disc = ChartArea::new(vec![circle.clone()], &[]);
        assert_eq!(disc.loops, [circle]);
        assert!(disc.contains([2.0, 1.0]) && !disc.contains([2.0, 0.2]) && !disc.contains([2.0, 1.6]));
    }

    #[test]
    fn a_circle_round_the_axis_bounds_its_cap() {
        let circle: Vec<[f64; 3]> = (0..100).map(|k| axes().gamma([f64::from(k) / 100.0 * TAU, 1.0])).collect();
        let cap = ChartArea::new(axes().cut(&circle, true), &[]);
        assert!(cap.contains([0.01, 0.5]) && cap.contains([6.27, 0.5]) && !cap.contains([3.0, 1.5]));
    }
}
