//! The places of many points of one body: numbers of regions, or why there is none.

use std::sync::atomic::{AtomicBool, Ordering};

use bifdiag::diagram::atlas::{Place, Spot};
use bifdiag::equilibria::curves::CurveName;
use bifdiag::numbers::table::Id;
use bifdiag::{AnswerError, Number, Solver};
use rayon::prelude::*;

/// Below the lowest critical value.
const FORBIDDEN: i64 = -1;
/// On a curve.
const CRITICAL: i64 = -2;
/// Too near to a curve for this accuracy.
const UNDECIDED: i64 = -3;

/// The fewest points for a thread.
const CHUNK: usize = 1 << 16;
/// With so many points at one l, the heights of all curves there are worth computing.
const ROW: usize = 4;

fn code(spot: Spot) -> i64 {
    match spot {
        Spot::Region(region) => i64::try_from(region.index()).expect("regions are few"),
        Spot::Forbidden => FORBIDDEN,
        Spot::Critical => CRITICAL,
        Spot::Undecided => UNDECIDED,
    }
}

/// Places of points (h, l) of doubles, each meaning its shortest decimal; unfinished when `stop` is set. `None` without an
/// atlas.
pub fn of_points(prepared: &Solver, h: &[f64], l: &[f64], stop: &AtomicBool) -> Option<Result<Vec<i64>, AnswerError>> {
    prepared.atlas()?;
    let chunk = h.len().div_ceil(rayon::current_num_threads()).max(CHUNK);
    let mut places = vec![UNDECIDED; h.len()];
    let done = places
        .par_chunks_mut(chunk)
        .zip(h.par_chunks(chunk).zip(l.par_chunks(chunk)))
        .try_for_each(|(places, (h, l))| of_chunk(prepared, h, l, stop, places));
    Some(done.map(|()| places))
}

/// The points with one l, from whatever corner of the grid, are answered together.
fn of_chunk(prepared: &Solver, h: &[f64], l: &[f64], stop: &AtomicBool, places: &mut [i64]) -> Result<(), AnswerError> {
    let mut order: Vec<(u64, u32)> = (0..).zip(l).map(|(point, l)| (l.to_bits(), point)).collect();
    order.sort_unstable();
    let mut heights = Vec::new();
    for row in order.chunk_by(|p, q| p.0 == q.0).flat_map(|row| row.chunks(CHUNK)) {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        let points = || row.iter().map(|(_, point)| *point as usize);
        heights.clear();
        heights.extend(points().map(|point| h[point]));
        let l = f64::from_bits(row[0].0);
        if row.len() < ROW {
            for (point, h) in points().zip(&heights) {
                places[point] = of_doubles(prepared, *h, l)?;
            }
        } else {
            let spots = prepared.row(l, &heights).expect("the atlas was made")?;
            points().zip(spots).for_each(|(point, spot)| places[point] = code(spot));
        }
    }
    Ok(())
}

/// One point: a search among the curves, and exact arithmetic where that leaves it open.
fn of_doubles(prepared: &Solver, h: f64, l: f64) -> Result<i64, AnswerError> {
    let atlas = prepared.atlas().expect("the atlas was made");
    match if l == 0.0 { None } else { atlas.locate(h, l).ok() }.map(|location| location.place) {
        Some(Place::Region(region)) => Ok(code(Spot::Region(region))),
        Some(Place::Forbidden) => Ok(FORBIDDEN),
        _ => Ok(code(prepared.row(l, &[h]).expect("the atlas was made")?[0])),
    }
}

/// The place of one exact point.
pub fn of_point(prepared: &Solver, h: &Number, l: &Number) -> Result<i64, AnswerError> {
    let found = prepared.classify(h, l)?;
    Ok(code(prepared.spot(h, l, &found.answer)))
}

/// A point, and how far in h the nearest curve is.
pub struct Measured {
    pub place: i64,
    pub margin: f64,
    pub error: f64,
    /// That curve; `None` where none was computed.
    pub nearest: Option<CurveName>,
}

/// Places of points and their distances from curves, each as [`Solver::classify`] tells it; unfinished when `stop` is set.
pub fn measured(
    prepared: &Solver,
    count: usize,
    point: impl Fn(usize) -> [Number; 2] + Sync,
    stop: &AtomicBool,
) -> Result<Vec<Measured>, AnswerError> {
    let one = |k: usize| {
        if stop.load(Ordering::Relaxed) {
            return Ok(Measured { place: UNDECIDED, margin: f64::NAN, error: f64::NAN, nearest: None });
        }
        let [h, l] = point(k);
        let found = prepared.classify(&h, &l)?;
        let place = code(prepared.spot(&h, &l, &found.answer));
        Ok(Measured { place, margin: found.margin.h, error: found.margin.error_bound, nearest: found.margin.nearest })
    };
    (0..count).into_par_iter().with_min_len(64).map(one).collect()
}
