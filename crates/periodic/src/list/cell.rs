//! Cells of the section: small squares of a chart on which it is decided whether Rᵐ has a fixed point.
//!
//! A motion is followed to its m-th crossing of P forward, F, and backward, B: a fixed point of Rᵐ is a zero of
//! d = F − B, and each half of the way stretches less than the whole. The verdict rests on nine samples, the outer ones
//! a little beyond the cell:
//! - a cell is **empty** if at all samples F is far from B, compared with how far F and B move between neighbouring
//!   samples. Where a motion touches the section, crossings are born in pairs and the later ones are renumbered. Where
//!   neighbours disagree for this reason, all crossings that may continue to an m-th one are compared, forward and
//!   backward, of all samples. Each may move as far as to neighbours' crossings at nearly the same time or, if it was
//!   just born, to the line of tangency;
//! - it is empty, too, if at all samples F and B are less than half the shortest possible period apart in time;
//! - or if the affine map that best fits d vanishes nowhere in the cell, by several times its residual;
//! - it has **one** fixed point if that affine map has one zero, well within the samples; the index is the winding
//!   number of d along the eight outer samples, times the sign of det DB: DRᵐ − 1 = DB⁻¹ Dd.
//!
//! All other cells are open, and are cut into four.

use nalgebra::{Matrix2, Vector2};

use crate::chart::{Chart, Surface};
use crate::flow::Phase as Point;
use crate::section_map::{BothWays, Image};

/// A square of a chart.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// The number of its chart.
    pub chart: usize,
    /// Coordinates of its middle.
    pub at: [f64; 2],
    /// Half a side.
    pub half: f64,
    /// Bit m − 1: whether Rᵐ has fixed points in it is open.
    pub open: u32,
}

/// How far the samples reach, in units of half the side.
pub const REACH: f64 = 1.25;
/// The residual of an affine map at the samples, times this, is taken to bound its residual between them.
const MARGIN: f64 = 3.0;
/// A cell is empty if images move between neighbours by at most this share of the distance between F and B.
const APART: f64 = 1.0 / 3.0;
/// A crossing was born about half way to its twin: with a margin.
const BORN: f64 = 0.75;

/// The nine places.
const GRID: [[f64; 2]; 9] =
    [[-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0]];
/// The places on the rim, in order round it.
const RIM: [usize; 8] = [0, 1, 2, 5, 8, 7, 6, 3];

/// The samples of a cell.
#[derive(Clone, Debug)]
pub struct Samples {
    /// The middle of the cell.
    pub middle: Point,
    /// Points of P⁻: at the nine places or, where these are in P⁺, on the line of tangency near them.
    pub points: [Option<Point>; 9],
    /// All of them are at their places.
    pub whole: bool,
}

impl Cell {
    /// The four quarters.
    #[must_use]
    pub fn parts(&self, open: u32) -> [Self; 4] {
        let half = 0.5 * self.half;
        [[-half, -half], [half, -half], [-half, half], [half, half]].map(|[x, y]| Self {
            chart: self.chart,
            at: [self.at[0] + x, self.at[1] + y],
            half,
            open,
        })
    }

    /// How far the samples reach.
    #[must_use]
    pub fn reach(&self) -> f64 {
        REACH * self.half
    }

    fn place(&self, k: usize) -> [f64; 2] {
        [0, 1].map(|i| self.at[i] + self.reach() * GRID[k][i])
    }

    /// The samples; `None` if the chart fails.
    #[must_use]
    pub fn samples(&self, surface: &Surface, chart: &Chart) -> Option<Samples> {
        let mut grid = [Point::zeros(); 9];
        for (k, y) in grid.iter_mut().enumerate() {
            *y = chart.place(surface, self.place(k))?;
        }
        let slopes = grid.each_ref().map(|y| surface.slope(y));
        let mut samples = Samples { middle: grid[4], points: [None; 9], whole: slopes.iter().all(|s| *s < 0.0) };
        let gradient = [0, 1].map(|i| (0..9).map(|k| GRID[k][i] * slopes[k]).sum::<f64>() / (6.0 * self.reach()));
        for k in 0..9 {
            samples.points[k] =
                if slopes[k] < 0.0 { Some(grid[k]) } else { self.onto_line(surface, chart, k, gradient) };
        }
        Some(samples)
    }

    /// The point just beyond the line of tangency nearest to a place in P⁺, unless that is far away.
    fn onto_line(&self, surface: &Surface, chart: &Chart, k: usize, gradient: [f64; 2]) -> Option<Point> {
        let steep = gradient[0] * gradient[0] + gradient[1] * gradient[1];
        let target = -0.02 * steep.sqrt() * self.half;
        let mut at = self.place(k);
        for _ in 0..8 {
            let y = chart.place(surface, at)?;
            let slope = surface.slope(&y);
            if slope < 0.0 && slope > 3.0 * target {
                return Some(y);
            }
            let step = (slope - target) / steep;
            at = [at[0] - step * gradient[0], at[1] - step * gradient[1]];
            let gone = (at[0] - self.at[0]).abs().max((at[1] - self.at[1]).abs());
            if gone.is_nan() || gone > 2.0 * self.reach() {
                return None;
            }
        }
        None
    }
}

/// What is known about Rᵐ in a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// No fixed point.
    Empty,
    /// One fixed point, near these coordinates, and its index.
    One([f64; 2], i32),
    /// Nothing.
    Open {
        /// The fixed points of the affine map that fits lie close to a line.
        line: bool,
    },
}

/// Judges Rᵐ in a cell from the motions through its samples.
#[must_use]
pub fn judge(cell: &Cell, surface: &Surface, samples: &Samples, ways: &[&BothWays; 9], m: usize) -> Verdict {
    if is_brief(surface, samples, ways, m) || is_apart(samples, ways, m) {
        return Verdict::Empty;
    }
    if !samples.whole || ways.iter().any(|ways| ways.ends(m).is_none()) {
        return Verdict::Open { line: false };
    }
    let ends = ways.map(|ways| [&ways.after[m - 1], &ways.before[m - 1]]);
    let gaps = ends.map(|[after, before]| after.point - before.point);
    if vanishes_nowhere(&gaps) {
        return Verdict::Empty;
    }
    let middle = ends[4][1].point;
    let Some(plane) = surface.tangent_plane(&middle) else { return Verdict::Open { line: false } };
    let flat = |v: Point| Vector2::new(plane[0].dot(&v), plane[1].dot(&v));
    in_the_plane(cell, &gaps.map(flat), &ends.map(|[_, before]| flat(before.point - middle)))
}

/// Whether the motions from B to F take less than half the shortest possible period, as near a triple crossing of P.
fn is_brief(surface: &Surface, samples: &Samples, ways: &[&BothWays; 9], m: usize) -> bool {
    let shortest = surface.shortest_period();
    let mut ends = (0..9).filter(|k| samples.points[*k].is_some()).map(|k| ways[k].ends(m));
    ends.all(|ends| ends.is_some_and(|[after, before]| after.time + before.time < 0.5 * shortest))
}

/// The neighbours of a sample that exist.
fn neighbours(samples: &Samples, k: usize) -> impl Iterator<Item = usize> {
    (0..9).filter(move |j| {
        let apart = [0, 1].map(|i| (GRID[*j][i] - GRID[k][i]).abs());
        apart[0] + apart[1] == 1.0 && samples.points[*j].is_some()
    })
}

/// Whether F and B are far apart, compared with how far they move between neighbouring samples.
fn is_apart(samples: &Samples, ways: &[&BothWays; 9], m: usize) -> bool {
    let there: Vec<usize> = (0..9).filter(|k| samples.points[*k].is_some()).collect();
    let is_steady = |k: &usize| {
        // A motion without an m-th crossing in the longest time belongs to no orbit that is looked for.
        let Some([after, before]) = ways[*k].ends(m) else { return true };
        let most = APART * (after.point - before.point).norm();
        neighbours(samples, *k).all(|j| {
            ways[j].ends(m).is_some_and(|ends| {
                (ends[0].point - after.point).norm() + (ends[1].point - before.point).norm() <= most
            })
        })
    };
    there.iter().all(is_steady) || {
        // Crossings are born within the cell.
        let after = branches(samples, ways, &there, m, |ways| &ways.after);
        let before = branches(samples, ways, &there, m, |ways| &ways.before);
        after.iter().all(|(end, drift)| {
            before.iter().all(|(other, more)| drift + more <= APART * (end.point - other.point).norm())
        })
    }
}

/// The crossings of all samples that may continue to an m-th crossing somewhere in the cell, and how far each may move.
fn branches<'a>(
    samples: &Samples,
    ways: &[&'a BothWays; 9],
    there: &[usize],
    m: usize,
    way: impl Fn(&'a BothWays) -> &'a [Image],
) -> Vec<(&'a Image, f64)> {
    let mut found = Vec::new();
    for &k in there {
        let Some([after, before]) = ways[k].ends(m) else { continue };
        let late = APART * (after.time + before.time) / m as f64;
        let images = way(ways[k]);
        let shifted = [m.checked_sub(2), Some(m), Some(m + 2)].into_iter().flatten().filter(|a| *a > 0);
        for end in shifted.filter_map(|a| images.get(a - 1)) {
            let drift = neighbours(samples, k).map(|j| moved(end, way(ways[j]), late)).fold(0.0, f64::max);
            found.push((end, drift));
        }
    }
    found
}

/// How far a crossing moves to a neighbouring sample: to one of the same kind at nearly the same time, whatever its
/// number, or, if it was just born, to the place of its birth.
fn moved(end: &Image, neighbours: &[Image], late: f64) -> f64 {
    let same = |other: &&Image| other.is_maximum == end.is_maximum && (other.time - end.time).abs() <= late;
    let distances = neighbours.iter().filter(same).map(|other| (other.point - end.point).norm());
    distances.fold(BORN * end.pair, f64::min)
}

/// The least-squares fit d₀ + d₁u + d₂v, with u, v ∈ [−1, 1] over the samples, and its largest residual.
fn fit<const N: usize>(values: &[nalgebra::SVector<f64, N>; 9]) -> ([nalgebra::SVector<f64, N>; 3], f64) {
    let mut fitted = [nalgebra::SVector::<f64, N>::zeros(); 3];
    for (value, [u, v]) in values.iter().zip(GRID) {
        fitted[0] += value / 9.0;
        fitted[1] += value * (u / 6.0);
        fitted[2] += value * (v / 6.0);
    }
    let rest = |(value, [u, v]): (&nalgebra::SVector<f64, N>, [f64; 2])| {
        (value - fitted[0] - fitted[1] * u - fitted[2] * v).norm()
    };
    let largest = values.iter().zip(GRID).map(rest).fold(0.0, f64::max);
    (fitted, largest)
}

/// Whether the affine map has no zero over the samples, by a margin.
fn vanishes_nowhere(moved: &[Point; 9]) -> bool {
    let ([d, du, dv], rest) = fit(moved);
    let at = |u: f64, v: f64| (d + du * u + dv * v).norm();
    let clipped = |x: f64| if x.is_nan() { 0.0 } else { x.clamp(-1.0, 1.0) };
    let (uu, uv, vv) = (du.dot(&du), du.dot(&dv), dv.dot(&dv));
    let (bu, bv) = (d.dot(&du), d.dot(&dv));
    let determinant = uu * vv - uv * uv;
    let [u, v] = [(uv * bv - vv * bu) / determinant, (uv * bu - uu * bv) / determinant];
    let mut least = f64::INFINITY;
    if u.abs() <= 1.0 && v.abs() <= 1.0 {
        least = at(u, v);
    }
    for end in [-1.0, 1.0] {
        least = least.min(at(end, clipped(-(bv + end * uv) / vv))).min(at(clipped(-(bu + end * uv) / uu), end));
    }
    least > MARGIN * rest
}

/// Counts the zeros of the gaps F − B, projected to the tangent plane at B.
fn in_the_plane(cell: &Cell, flat: &[Vector2<f64>; 9], before: &[Vector2<f64>; 9]) -> Verdict {
    let ([d, du, dv], rest) = fit(flat);
    let ([_, eu, ev], _) = fit(before);
    let back = Matrix2::from_columns(&[eu, ev]).determinant();
    let derivative = Matrix2::from_columns(&[du, dv]);
    let line = derivative.singular_values().max() > 4.0 * rest;
    let Some(inverse) = derivative.try_inverse() else { return Verdict::Open { line } };
    // In units of the samples' reach the affine map becomes x − zero, and residuals shrink where it stretches.
    let zero = -(inverse * d);
    let straight = flat.each_ref().map(|d| inverse * d);
    let margin =
        MARGIN * straight.iter().zip(GRID).map(|(d, x)| (d - Vector2::from(x) + zero).amax()).fold(0.0, f64::max);
    let far = zero.amax();
    // The cell's half side is 1/REACH.
    if far > 1.0 / REACH + margin {
        return Verdict::Empty;
    }
    if far > 1.0 - margin || margin.is_nan() {
        return Verdict::Open { line };
    }
    let sign = if derivative.determinant() * back > 0.0 { 1 } else { -1 };
    match winding(&straight, margin) {
        Some(turns) if turns != 0 => Verdict::One([0, 1].map(|i| cell.at[i] + cell.reach() * zero[i]), sign * turns),
        _ => Verdict::Open { line },
    }
}

/// The winding number along the rim; `None` where the segment between two neighbours comes too close to 0.
fn winding(values: &[Vector2<f64>; 9], margin: f64) -> Option<i32> {
    let mut turned = 0.0;
    for k in 0..8 {
        let (a, b) = (values[RIM[k]], values[RIM[(k + 1) % 8]]);
        let along = b - a;
        let nearest = (-a.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        let distance = (a + along * nearest).norm();
        if distance.is_nan() || distance <= margin {
            return None;
        }
        turned += libm::atan2(a.x * b.y - a.y * b.x, a.dot(&b));
    }
    #[expect(
        clippy::cast_possible_truncation,
        reason = "eight angles below π, whose sum is a multiple of 2π within rounding"
    )]
    let winding = (turned / std::f64::consts::TAU).round() as i32;
    Some(winding)
}
