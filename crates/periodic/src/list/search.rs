//! The search: the squares of a cover are cut into cells until each is decided.

use bifdiag_dynamics::section::SectionError;
use nalgebra::Vector2;

use super::cell::{Cell, REACH, Samples, Verdict, judge};
use super::newton::{FixedPoint, Guess, newton};
use super::stage::Stage;
use crate::chart::{BEYOND, Chart, Cover};
use crate::flow::Phase as Point;
use crate::section_map::{BothWays, SectionMap};

/// How many returns are considered, and how much work may be done.
#[derive(Clone, Copy, Debug)]
pub struct SearchOptions {
    /// The largest m.
    pub turns: usize,
    /// How often a cell is cut into four.
    pub levels: u32,
    /// The most cells to examine.
    pub cells: usize,
}

/// A cell that could not be decided.
#[derive(Clone, Copy, Debug)]
pub struct OpenCell {
    /// Its middle.
    pub middle: Point,
    /// Half a side.
    pub half: f64,
    /// Bit m − 1: whether Rᵐ has fixed points in it is open.
    pub turns: u32,
    /// It meets the line of tangency.
    pub at_tangency: bool,
}

/// A point of a curve of fixed points.
#[derive(Clone, Copy, Debug)]
pub struct OnCurve {
    /// The point.
    pub fixed: FixedPoint,
    /// Half a side of its cell.
    pub half: f64,
}

/// What the search found.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// Fixed points of each Rᵐ, each once for every cell whose samples surround it.
    pub points: Vec<FixedPoint>,
    /// Points of curves of fixed points.
    pub on_curves: Vec<OnCurve>,
    /// Cells that are still open.
    pub open: Vec<OpenCell>,
    /// They are open because no more cells may be examined.
    pub spent: bool,
    /// Cells examined.
    pub cells: usize,
    /// Motions followed.
    pub motions: usize,
    /// Motions that did not return in time.
    pub slow: usize,
}

/// Cells along each side of a square at the start.
const FIRST: u32 = 2;
/// Their samples lie where the charts were tested.
const _: () = assert!(1.0 + (REACH - 1.0) / FIRST as f64 <= BEYOND);
/// Cuts after which curves of fixed points are considered.
const CURVES: u32 = 2;
/// After this many cuts one more line of births is allowed for, and another after as many again.
const CROSSED: u32 = 6;
/// More cuts, as long as only a few cells are left.
const FURTHER: u32 = 6;
/// At most this many are few.
const FEW: usize = 1024;
/// Cells examined together.
const BATCH: usize = 4096;
/// |det(DRᵐ − 1)| below this share of the squared norm: 1 is a double multiplier.
const PARABOLIC: f64 = 3e-5;

/// Searches a cover; `watch` is called as the work goes on.
///
/// # Errors
/// Those of [`SectionMap::images`].
pub fn search(
    map: &SectionMap<'_>,
    cover: &Cover,
    options: &SearchOptions,
    watch: &mut dyn FnMut(Stage),
) -> Result<Found, SectionError> {
    let all = (1 << options.turns) - 1;
    let mut found = Found::default();
    let mut level: Vec<Cell> = Vec::new();
    for (chart, Chart { radius, .. }) in cover.charts.iter().enumerate() {
        let half = radius / f64::from(FIRST);
        for k in 0..FIRST * FIRST {
            let at = [k % FIRST, k / FIRST].map(|i| half * (2.0 * f64::from(i) + 1.0) - radius);
            level.push(Cell { chart, at, half, open: all });
        }
    }
    let whole = area(&level);
    let mut undecided_area = whole;
    for depth in 0..=options.levels + FURTHER {
        let mut left = Vec::new();
        let mut to_examine = level.len();
        for batch in level.chunks(BATCH) {
            let undecided = examine(map, cover, options, batch, depth, &mut found)?;
            undecided_area += area(undecided.iter().map(|(cell, ..)| cell)) - area(batch);
            left.extend(
                undecided.into_iter().map(|(cell, open, samples)| (cell, open_cell(cover, &cell, open, samples))),
            );
            to_examine -= batch.len();
            let decided = 1.0 - (undecided_area / whole).clamp(0.0, 1.0);
            watch(Stage::Cells { examined: found.cells, open: to_examine + left.len(), decided });
        }
        let is_deep = depth >= options.levels && (left.len() > FEW || depth == options.levels + FURTHER);
        found.spent = !is_deep && found.cells + 4 * left.len() > options.cells;
        if is_deep || found.spent {
            found.open = left.into_iter().map(|(_, open)| open).collect();
            break;
        }
        level = left.iter().flat_map(|(cell, open)| cell.parts(open.turns)).collect();
    }
    Ok(found)
}

/// The area of cells, in the tangent planes.
fn area<'a>(cells: impl IntoIterator<Item = &'a Cell>) -> f64 {
    cells.into_iter().map(|cell| 4.0 * cell.half * cell.half).sum()
}

fn open_cell(cover: &Cover, cell: &Cell, turns: u32, samples: Option<Samples>) -> OpenCell {
    let (middle, at_tangency) =
        samples.map_or_else(|| (cover.charts[cell.chart].center, true), |samples| (samples.middle, !samples.whole));
    OpenCell { middle, half: cell.half, turns, at_tangency }
}

type Undecided = (Cell, u32, Option<Samples>);

/// Examines some cells; returns those that stay open, and for which m.
fn examine(
    map: &SectionMap<'_>,
    cover: &Cover,
    options: &SearchOptions,
    cells: &[Cell],
    depth: u32,
    found: &mut Found,
) -> Result<Vec<Undecided>, SectionError> {
    let samples: Vec<Option<Samples>> =
        cells.iter().map(|cell| cell.samples(map.surface(), &cover.charts[cell.chart])).collect();
    let starts: Vec<Point> = samples.iter().flatten().flat_map(|s| s.points.iter().copied().flatten()).collect();
    // Where a pair of crossings is born, the later ones are renumbered. Most cells contain one line of births; in
    // smaller ones two may cross, and in still smaller ones three.
    let born = 1 + depth / CROSSED;
    let ways = map.both_ways(&starts, options.turns + 2 * born as usize)?;
    found.cells += cells.len();
    found.motions += starts.len();
    found.slow += ways.iter().filter(|ways| ways.ends(options.turns).is_none()).count();
    let (mut rest, none) = (&ways[..], BothWays::default());
    let mut open: Vec<Undecided> = Vec::new();
    let (mut ones, mut lines) = (Vec::new(), Vec::new());
    for (cell, samples) in cells.iter().zip(samples) {
        let Some(samples) = samples else {
            open.push((*cell, cell.open, None));
            continue;
        };
        let mut own = [&none; 9];
        for (own, _) in own.iter_mut().zip(&samples.points).filter(|(_, point)| point.is_some()) {
            let (first, others) = rest.split_at(1);
            (*own, rest) = (&first[0], others);
        }
        let chart = &cover.charts[cell.chart];
        let mut undecided = 0;
        let place = open.len();
        for m in (1..=options.turns).filter(|m| cell.open >> (m - 1) & 1 == 1) {
            let guess = |at| Guess { chart, at, turns: m, reach: 2.0 * cell.reach() };
            match judge(cell, map.surface(), &samples, &own, m) {
                Verdict::Empty => continue,
                Verdict::One(at, index) => ones.push((place, guess(at), index, *cell)),
                Verdict::Open { line } if line && depth >= CURVES => lines.push((place, guess(cell.at), *cell)),
                Verdict::Open { .. } => {}
            }
            undecided |= 1 << (m - 1);
        }
        if undecided != 0 {
            open.push((*cell, undecided, Some(samples)));
        }
    }
    let guesses: Vec<Guess<'_>> = ones.iter().map(|(_, guess, ..)| guess.clone()).collect();
    for ((place, guess, index, cell), fixed) in ones.iter().zip(newton(map, &guesses, false)?) {
        if let Some(fixed) = fixed.filter(|fixed| is_in(cell, fixed) && fixed.index() == *index) {
            found.points.push(fixed);
            open[*place].1 &= !(1 << (guess.turns - 1));
        }
    }
    let guesses: Vec<Guess<'_>> = lines.iter().map(|(_, guess, _)| guess.clone()).collect();
    let first = newton(map, &guesses, true)?;
    let curves = on_curves(map, &lines, &first)?;
    for ((place, guess, cell), fixed) in lines.iter().zip(curves) {
        if let Some(fixed) = fixed {
            found.on_curves.push(OnCurve { fixed, half: cell.half });
            open[*place].1 &= !(1 << (guess.turns - 1));
        }
    }
    open.retain(|(_, turns, _)| *turns != 0);
    Ok(open)
}

fn is_in(cell: &Cell, fixed: &FixedPoint) -> bool {
    (fixed.at[0] - cell.at[0]).abs().max((fixed.at[1] - cell.at[1]).abs()) <= cell.reach()
}

/// Whether 1 is a double multiplier.
fn is_parabolic(fixed: &FixedPoint) -> bool {
    fixed.derivative.determinant().abs() <= PARABOLIC * fixed.derivative.norm_squared()
}

/// Fixed points with others on both sides, in the direction in which Rᵐ is nearly the identity: points of a curve.
fn on_curves(
    map: &SectionMap<'_>,
    lines: &[(usize, Guess<'_>, Cell)],
    first: &[Option<FixedPoint>],
) -> Result<Vec<Option<FixedPoint>>, SectionError> {
    let mut beside = Vec::new();
    for (k, ((_, guess, cell), fixed)) in lines.iter().zip(first).enumerate() {
        let Some(fixed) = fixed.filter(|fixed| is_in(cell, fixed) && is_parabolic(fixed)) else { continue };
        let svd = fixed.derivative.svd(false, true);
        let Some(rows) = svd.v_t else { continue };
        let kernel = rows.row(svd.singular_values.imin()).transpose();
        for side in [0.5, -0.5] {
            let at = Vector2::from(fixed.at) + kernel * (side * cell.half);
            beside.push((k, Guess { at: at.into(), reach: 0.25 * cell.half, ..guess.clone() }));
        }
    }
    let guesses: Vec<Guess<'_>> = beside.iter().map(|(_, guess)| guess.clone()).collect();
    let second = newton(map, &guesses, true)?;
    let mut curves = vec![None; lines.len()];
    for (pair, found) in beside.chunks(2).zip(second.chunks(2)) {
        if found.iter().all(|fixed| fixed.is_some_and(|fixed| is_parabolic(&fixed))) {
            curves[pair[0].0] = first[pair[0].0];
        }
    }
    Ok(curves)
}
