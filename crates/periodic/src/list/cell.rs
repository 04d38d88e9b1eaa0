//! Cells of the section: small squares of a chart on which it is decided whether Rᵐ has a fixed point.
//!
//! What is decided rests on nine samples, of which the outer ones lie a little beyond the cell. With d = Rᵐ(y) − y:
//! - a cell is **empty** if the samples' images are far from it, compared with how far the images of neighbouring samples are
//!   from each other. Where a motion touches the section Rᵐ jumps, since a crossing is born: images are compared with all of
//!   the neighbour's, and one that was just born with the line of tangency;
//! - or if the affine map that fits d best vanishes nowhere in the cell, by a margin of several times what it leaves;
//! - it has **one** fixed point if that affine map has one zero, well within the samples; the index is the winding number of
//!   d along the eight outer samples.
//!
//! All else is open, and cut into four.

use nalgebra::{Matrix2, Vector2};

use crate::chart::{Chart, Surface};
use crate::flow::Phase as Point;
use crate::section_map::Image;

/// A square of a chart.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// Place of the chart.
    pub chart: usize,
    /// Coordinates of its middle.
    pub at: [f64; 2],
    /// Half a side.
    pub half: f64,
    /// Bit m − 1: whether Rᵐ has fixed points in it is open.
    pub open: u32,
}

/// How far the samples reach, in half sides.
pub const REACH: f64 = 1.25;
/// What an affine map leaves at the samples, times this, bounds what it leaves between them.
const MARGIN: f64 = 3.0;
/// Images of neighbours are at most this part of their distance from the cell apart.
const APART: f64 = 1.0 / 3.0;
/// A crossing was born about half way to the one with which it was born: with a margin.
const BORN: f64 = 0.75;

/// The nine places.
const GRID: [[f64; 2]; 9] =
    [[-1.0, -1.0], [0.0, -1.0], [1.0, -1.0], [-1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [1.0, 1.0]];
/// Those of the rim, in a circle.
const RIM: [usize; 8] = [0, 1, 2, 5, 8, 7, 6, 3];

/// The samples of a cell.
#[derive(Clone, Debug)]
pub struct Samples {
    /// The middle of the cell.
    pub middle: Point,
    /// Points of P⁻, at the nine places or, where these are in P⁺, on the line of tangency near them.
    pub points: [Option<Point>; 9],
    /// All of them are where they should be.
    pub whole: bool,
}

impl Cell {
    /// The four parts.
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

    /// Where to look; `None` if the chart fails.
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

    /// From a place in P⁺ to the line of tangency, a little beyond it, unless that is far away.
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

/// What is known of Rᵐ in a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// No fixed point.
    Empty,
    /// One, near these coordinates, and the winding number.
    One([f64; 2], i32),
    /// Nothing; the fixed points of the affine map that fits lie close to a line, if that is so.
    Open {
        /// That is so.
        line: bool,
    },
}

/// Looks at Rᵐ in a cell. `images` are those of the samples that are there.
#[must_use]
pub fn judge(cell: &Cell, chart: &Chart, samples: &Samples, images: &[&[Image]; 9], m: usize) -> Verdict {
    if samples.points.iter().all(Option::is_none) || is_far(cell, samples, images, m) {
        return Verdict::Empty;
    }
    if !samples.whole || images.iter().any(|images| images.len() < m) {
        return Verdict::Open { line: false };
    }
    let moved: [Point; 9] = std::array::from_fn(|k| match samples.points[k] {
        Some(y) => images[k][m - 1].point - y,
        None => Point::zeros(),
    });
    if vanishes_nowhere(&moved) {
        return Verdict::Empty;
    }
    in_the_chart(cell, chart, &moved)
}

/// The images are far from the cell.
fn is_far(cell: &Cell, samples: &Samples, images: &[&[Image]; 9], m: usize) -> bool {
    let size = 1.1 * std::f64::consts::SQRT_2 * cell.reach();
    (0..9).filter(|k| samples.points[*k].is_some()).all(|k| {
        // One that has no m-th return in the longest time has no orbit of interest.
        let Some(image) = images[k].get(m - 1) else { return true };
        let far = (image.point - samples.middle).norm() - size;
        let near = |j: usize| {
            let distances = images[j].iter().map(|other| (other.point - image.point).norm());
            samples.points[j].is_none() || distances.fold(f64::INFINITY, f64::min) <= APART * far
        };
        let beside = |j: usize| {
            let apart = [0, 1].map(|i| (GRID[j][i] - GRID[k][i]).abs());
            apart[0] + apart[1] == 1.0
        };
        far > 0.0 && (BORN * image.pair <= far || (0..9).filter(|j| beside(*j)).all(near))
    })
}

/// d = d₀ + d₁u + d₂v in half sides of the samples, and the largest distance from it.
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

/// The affine map has no zero over the samples, by a margin.
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

/// Counts zeros in the tangent plane.
fn in_the_chart(cell: &Cell, chart: &Chart, moved: &[Point; 9]) -> Verdict {
    let flat = moved.each_ref().map(|d| Vector2::new(chart.across[0].dot(d), chart.across[1].dot(d)));
    let ([d, du, dv], rest) = fit(&flat);
    let derivative = Matrix2::from_columns(&[du, dv]);
    let line = derivative.singular_values().max() > 4.0 * rest;
    let Some(inverse) = derivative.try_inverse() else { return Verdict::Open { line } };
    // In half sides of the samples: the affine map becomes x − zero, and what it leaves small where it is stretched.
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
    let sign = if derivative.determinant() > 0.0 { 1 } else { -1 };
    match winding(&straight, margin) {
        Some(turns) if turns != 0 => Verdict::One([0, 1].map(|i| cell.at[i] + cell.reach() * zero[i]), sign * turns),
        _ => Verdict::Open { line },
    }
}

/// The winding number along the rim; `None` where the straight piece between two neighbours comes too close to 0 to tell.
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
