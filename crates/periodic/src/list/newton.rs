//! Newton's method for fixed points of Rᵐ, for many starts at once, in coordinates of a chart.

use bifdiag_dynamics::section::SectionError;
use nalgebra::{Matrix2, Vector2};

use crate::chart::Chart;
use crate::flow::Phase as Point;
use crate::section_map::SectionMap;

/// A guess: coordinates in a chart, and m.
#[derive(Clone, Debug)]
pub struct Guess<'a> {
    /// The chart.
    pub chart: &'a Chart,
    /// The coordinates.
    pub at: [f64; 2],
    /// m.
    pub turns: usize,
    /// How far the point may move.
    pub reach: f64,
}

/// A fixed point of Rᵐ.
#[derive(Clone, Copy, Debug)]
pub struct FixedPoint {
    /// The point.
    pub point: Point,
    /// Its coordinates.
    pub at: [f64; 2],
    /// m.
    pub turns: usize,
    /// The time of Rᵐ.
    pub period: f64,
    /// DRᵐ − 1 in coordinates of the chart.
    pub derivative: Matrix2<f64>,
    /// |Rᵐ(y) − y| there.
    pub residual: f64,
}

impl FixedPoint {
    /// The sign of det(DRᵐ − 1), the index of the fixed point where it is not 0.
    #[must_use]
    pub fn index(&self) -> i32 {
        if self.derivative.determinant() > 0.0 { 1 } else { -1 }
    }
}

/// Points closer than this are the same.
pub const SAME: f64 = 1e-7;

/// Whether two points coincide.
#[must_use]
pub fn are_same(a: &Point, b: &Point) -> bool {
    (a - b).norm() < SAME
}

/// The largest residual of a fixed point.
pub const CLOSED: f64 = 1e-11;
/// Iterations.
const ITERATIONS: usize = 12;
/// The step of the difference quotients.
const DISPLACEMENT: f64 = 1e-5;
/// Singular values below this part of the largest one count as 0 in the search for points of a curve.
const FLAT: f64 = 1e-3;

/// The fixed point found from each guess, if any. With `onto_curves`, steps avoid directions in which Rᵐ is nearly the
/// identity, so that a guess moves to the nearest point of a curve of fixed points.
///
/// # Errors
/// Those of [`SectionMap::images`].
pub fn newton(
    map: &SectionMap<'_>,
    guesses: &[Guess<'_>],
    onto_curves: bool,
) -> Result<Vec<Option<FixedPoint>>, SectionError> {
    let mut found: Vec<Option<FixedPoint>> = vec![None; guesses.len()];
    let mut at: Vec<[f64; 2]> = guesses.iter().map(|guess| guess.at).collect();
    let mut active: Vec<usize> = (0..guesses.len()).collect();
    for _ in 0..ITERATIONS {
        let evaluated = around(map, guesses, &active, &at)?;
        let mut left = Vec::new();
        for (&k, fixed) in active.iter().zip(evaluated) {
            let Some((fixed, offset)) = fixed else { continue };
            let best = found[k].map_or(f64::INFINITY, |old| old.residual);
            if fixed.residual < best {
                found[k] = Some(fixed);
            } else if best < CLOSED {
                continue;
            }
            let Some(step) = step(&fixed.derivative, offset, onto_curves) else { continue };
            at[k] = [fixed.at[0] - step[0], fixed.at[1] - step[1]];
            let gone = (at[k][0] - guesses[k].at[0]).abs().max((at[k][1] - guesses[k].at[1]).abs());
            if gone <= guesses[k].reach {
                left.push(k);
            }
        }
        active = left;
        if active.is_empty() {
            break;
        }
    }
    for slot in &mut found {
        slot.take_if(|fixed| fixed.residual > CLOSED);
    }
    Ok(found)
}

fn step(derivative: &Matrix2<f64>, offset: Vector2<f64>, onto_curves: bool) -> Option<Vector2<f64>> {
    if !onto_curves {
        return derivative.lu().solve(&offset);
    }
    let svd = derivative.svd(true, true);
    let largest = svd.singular_values.max();
    svd.solve(&offset, FLAT * largest).ok()
}

/// The map and its derivative at each active guess.
#[expect(clippy::type_complexity, reason = "a candidate fixed point, and Newton's step from it")]
fn around(
    map: &SectionMap<'_>,
    guesses: &[Guess<'_>],
    active: &[usize],
    at: &[[f64; 2]],
) -> Result<Vec<Option<(FixedPoint, Vector2<f64>)>>, SectionError> {
    const BESIDE: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
    let most = active.iter().map(|k| guesses[*k].turns).max().unwrap_or(0);
    let mut starts = Vec::with_capacity(5 * active.len());
    let mut places: Vec<Option<[usize; 5]>> = Vec::with_capacity(active.len());
    for &k in active {
        let points = BESIDE.map(|e| {
            let at = [at[k][0] + DISPLACEMENT * e[0], at[k][1] + DISPLACEMENT * e[1]];
            guesses[k].chart.place(map.surface(), at)
        });
        if points.iter().all(Option::is_some) {
            let first = starts.len();
            places.push(Some(std::array::from_fn(|j| first + j)));
            starts.extend(points.into_iter().flatten());
        } else {
            places.push(None);
        }
    }
    let ways = map.both_ways(&starts, most)?;
    let evaluated = active.iter().zip(places).map(|(&k, places)| {
        let (guess, places) = (&guesses[k], places?);
        let ends = |j: usize| ways[places[j]].ends(guess.turns);
        let [after, before] = ends(0)?;
        let plane = map.surface().tangent_plane(&before.point)?;
        let flat = |v: Point| Vector2::new(plane[0].dot(&v), plane[1].dot(&v));
        let (mut gaps, mut back) = ([Vector2::zeros(); 5], [Vector2::zeros(); 5]);
        for j in 0..5 {
            let [after, before] = ends(j)?;
            (gaps[j], back[j]) = (flat(after.point - before.point), flat(before.point));
        }
        let slopes = |v: &[Vector2<f64>; 5]| Matrix2::from_columns(&[v[1] - v[2], v[3] - v[4]]) / (2.0 * DISPLACEMENT);
        let home = slopes(&back).try_inverse()?;
        let derivative = home * slopes(&gaps);
        let fixed = FixedPoint {
            point: starts[places[0]],
            at: at[k],
            turns: guess.turns,
            period: after.time + before.time,
            derivative,
            residual: (after.point - before.point).norm(),
        };
        Some((fixed, home * gaps[0]))
    });
    Ok(evaluated.collect())
}
