//! Curves of fixed points: each belongs to a continuum of orbits of one period, as on a resonant torus of an integrable
//! body.

use bifdiag_dynamics::section::SectionError;
use bifdiag_numbers::table::Partition;

use super::newton::are_same;
use super::search::OnCurve;
use crate::flow::Phase as Point;
use crate::section_map::SectionMap;

/// Periods with a smaller relative difference count as equal.
const ONE_PERIOD: f64 = 1e-7;
/// A curve is followed over gaps of this many half sides of a cell.
const STRIDE: f64 = 6.0;

/// One point of each continuum, with its period.
///
/// # Errors
/// Those of [`SectionMap::images`].
pub fn families(map: &SectionMap<'_>, found: &[OnCurve]) -> Result<Vec<(Point, f64)>, SectionError> {
    let mut points: Vec<OnCurve> = found.to_vec();
    points.sort_by(|a, b| (a.fixed.turns.cmp(&b.fixed.turns)).then(a.fixed.period.total_cmp(&b.fixed.period)));
    let most = points.last().map_or(1, |point| point.fixed.turns);
    let starts: Vec<Point> = points.iter().map(|point| point.fixed.point).collect();
    let images = map.images(&starts, most)?;
    // Points of shorter orbits belong to their curves.
    let is_shorter = |k: usize| {
        let m = points[k].fixed.turns;
        let back = |d: usize| images[k].get(d - 1).is_some_and(|image| are_same(&image.point, &starts[k]));
        (1..m).any(|d| m.is_multiple_of(d) && back(d))
    };
    let own: Vec<usize> = (0..points.len()).filter(|k| !is_shorter(*k)).collect();
    let mut sets = Partition::new(own.len());
    for (i, &a) in own.iter().enumerate() {
        let first = &points[a];
        for (j, &b) in own.iter().enumerate().skip(i + 1) {
            let second = &points[b];
            let apart = second.fixed.period - first.fixed.period;
            if second.fixed.turns != first.fixed.turns || apart > ONE_PERIOD * first.fixed.period {
                break;
            }
            let near = STRIDE * first.half.max(second.half);
            let meets = |y: &Point| (y - second.fixed.point).norm() < near;
            // The curve or one of its images, which meet the same orbits.
            if meets(&first.fixed.point) || images[a].iter().any(|image| meets(&image.point)) {
                sets.unite(i, j);
            }
        }
    }
    let firsts: Vec<usize> = (0..own.len()).filter(|i| sets.find(*i) == *i).collect();
    Ok(firsts.into_iter().map(|i| (points[own[i]].fixed.point, points[own[i]].fixed.period)).collect())
}
