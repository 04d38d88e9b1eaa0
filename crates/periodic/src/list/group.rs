//! From fixed points of the powers of R to orbits, each once.

use std::cmp::Ordering;

use bifdiag_dynamics::field::dot;
use bifdiag_dynamics::section::SectionError;

use super::newton::{FixedPoint, SAME, are_same};
use crate::flow::Phase as Point;
use crate::section_map::SectionMap;

/// A cycle of R.
#[derive(Clone, Copy, Debug)]
pub struct Cycle {
    /// Its point with the largest ⟨γ,r⟩.
    pub start: Point,
    /// The number of its points.
    pub turns: usize,
    /// Its period in time.
    pub period: f64,
    /// The index of its points.
    pub index: i32,
}

/// The cycles.
#[derive(Clone, Debug, Default)]
pub struct Grouped {
    /// By length, then by period.
    pub cycles: Vec<Cycle>,
    /// The sums of the indices of the fixed points of R, R², …
    pub index_sums: Vec<i32>,
    /// Cycles with points that the search did not find.
    pub incomplete: usize,
}

/// Collects fixed points into cycles.
///
/// # Errors
/// Those of [`SectionMap::images`].
pub fn orbits(map: &SectionMap<'_>, found: &[FixedPoint], turns: usize) -> Result<Grouped, SectionError> {
    let mut points: Vec<FixedPoint> = Vec::new();
    for fixed in found {
        if !points.iter().any(|other| other.turns == fixed.turns && are_same(&other.point, &fixed.point)) {
            points.push(*fixed);
        }
    }
    let mut grouped = Grouped::default();
    for m in 1..=turns {
        let own: Vec<FixedPoint> = points.iter().filter(|fixed| fixed.turns == m).copied().collect();
        grouped.index_sums.push(own.iter().map(FixedPoint::index).sum());
        let is_shorter = |fixed: &FixedPoint| {
            let divides = |other: &&FixedPoint| other.turns < m && m % other.turns == 0;
            points.iter().filter(divides).any(|other| are_same(&other.point, &fixed.point))
        };
        let mut left: Vec<FixedPoint> = own.into_iter().filter(|fixed| !is_shorter(fixed)).collect();
        let starts: Vec<Point> = left.iter().map(|fixed| fixed.point).collect();
        let mut cycles: Vec<Cycle> = Vec::new();
        for (first, ways) in starts.iter().zip(map.both_ways(&starts, m)?) {
            let Some(place) = left.iter().position(|fixed| fixed.point == *first) else { continue };
            let fixed = left.swap_remove(place);
            let mut members = vec![fixed.point];
            // The other maxima: half of them before the start.
            let others = [&ways.after[..], &ways.before[..ways.before.len().min(m - 1)]].concat();
            let mut is_whole = ways.ends(m).is_some();
            for image in others.iter().filter(|image| image.is_maximum) {
                match left.iter().position(|other| are_same(&other.point, &image.point)) {
                    Some(place) => members.push(left.swap_remove(place).point),
                    None => is_whole = false,
                }
            }
            grouped.incomplete += usize::from(!is_whole);
            members.sort_by(|a, b| from_the_top(map, a, b));
            cycles.push(Cycle { start: members[0], turns: m, period: fixed.period, index: fixed.index() });
        }
        // The periods of a mirror pair differ by rounding only.
        cycles.sort_by(|a, b| a.period.total_cmp(&b.period));
        for k in 1..cycles.len() {
            let [a, b] = [&cycles[k - 1], &cycles[k]];
            if b.period - a.period < SAME * a.period && lexicographic(&a.start, &b.start).is_gt() {
                cycles.swap(k - 1, k);
            }
        }
        grouped.cycles.extend(cycles);
    }
    Ok(grouped)
}

/// The larger ⟨γ, r⟩ first.
fn from_the_top(map: &SectionMap<'_>, a: &Point, b: &Point) -> Ordering {
    let r = map.surface().top().center();
    let height = |y: &Point| dot([y[0], y[1], y[2]], r);
    let difference = height(b) - height(a);
    if difference.abs() > SAME * map.surface().top().center_norm() {
        difference.total_cmp(&0.0)
    } else {
        lexicographic(a, b)
    }
}

/// By γ, then l; numbers within rounding count as equal.
fn lexicographic(a: &Point, b: &Point) -> Ordering {
    a.iter().zip(b.iter()).find(|(x, y)| (**x - **y).abs() > SAME).map_or(Ordering::Equal, |(x, y)| x.total_cmp(y))
}
