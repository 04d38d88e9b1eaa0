//! All relative equilibria at one angular momentum.

use super::critical_set::{CriticalSet, end_tolerance};
use super::curve::Orbit;
use super::id::CurveId;
use super::point::Point;

/// A relative equilibrium at the x that was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeEquilibrium {
    /// Number of its curve.
    pub curve: CurveId,
    /// The point of the curve; its γ is this equilibrium's.
    pub point: Point,
    /// Morse index.
    pub index: u8,
    /// What it stands for.
    pub orbit: Orbit,
    /// x is within rounding of a cusp or pitchfork at which this point is degenerate, and the curves that meet there
    /// do not reach x.
    pub degenerate: bool,
}

/// What [`CriticalSet::equilibria_at`] found.
#[derive(Clone, Debug, PartialEq)]
pub struct EquilibriaAt {
    /// Relative equilibria by rising h (as rounded), then γ in the frame. A symmetric pair is two entries.
    pub list: Vec<RelativeEquilibrium>,
    /// False when x lies within rounding of a cusp or pitchfork, so that the number is not certain.
    pub complete: bool,
}

impl CriticalSet {
    /// All critical points of U_l at x = l²/2 > 0, in the frame.
    #[must_use]
    pub fn equilibria_at(&self, x: f64) -> EquilibriaAt {
        let (curves, near_end) = self.curves_over(x);
        let mut list = Vec::with_capacity(curves.len() + 2);
        if near_end {
            list.extend(self.merged_at(x, &curves));
        }
        for curve in curves {
            let Some(index) = self.curves[curve].index else { continue };
            let orbit = self.curves[curve].orbit;
            let point = self.curves[curve].point(&self.frame, x);
            for point in both_of_a_pair(orbit, point) {
                list.push(RelativeEquilibrium { curve, point, index, orbit, degenerate: false });
            }
        }
        list.sort_by(|p, q| {
            let by_gamma = (0..3).map(|k| p.point.gamma[k].total_cmp(&q.point.gamma[k]));
            by_gamma.fold(p.point.h().total_cmp(&q.point.h()), std::cmp::Ordering::then)
        });
        EquilibriaAt { list, complete: !near_end }
    }

    /// The degenerate points within rounding of x whose curves are not among those over x.
    fn merged_at(&self, x: f64, over: &[CurveId]) -> Vec<RelativeEquilibrium> {
        let cusps = self.cusps.iter().map(|cusp| (&cusp.point, cusp.curves));
        let pitchforks = self.pitchforks.iter().map(|pitchfork| (&pitchfork.point, pitchfork.through));
        cusps
            .chain(pitchforks)
            .filter(|(point, curves)| {
                (point.x - x).abs() <= end_tolerance(x) && !curves.iter().any(|curve| over.contains(curve))
            })
            .filter_map(|(point, curves)| {
                let curve = curves.into_iter().min_by_key(|&curve| self.curves[curve].index)?;
                let index = self.curves[curve].index?;
                Some(RelativeEquilibrium {
                    curve,
                    point: Point { x, ..*point },
                    index,
                    orbit: self.curves[curve].orbit,
                    degenerate: true,
                })
            })
            .collect()
    }
}

/// A point, or a pair with both signs of γ_i.
fn both_of_a_pair(orbit: Orbit, point: Point) -> impl Iterator<Item = Point> {
    let mirrored = match orbit {
        Orbit::Pair(axis) => {
            let mut mirrored = point;
            mirrored.gamma[axis] = -mirrored.gamma[axis];
            Some(mirrored)
        }
        _ => None,
    };
    std::iter::once(point).chain(mirrored)
}
