//! All curves of critical values and both pole lines of a body.

use thiserror::Error;

use super::curve::{Branch, ClusterId, Curve, CurveId, CuspId, IntervalId, Orbit, PitchforkId};
use super::curve_point::Point;
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::table::{Id, Table};

/// A cusp: two curves of critical points meet and vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cusp {
    /// The point in the (x, h) plane.
    pub point: Point,
    /// The two curves, in the order of the branch's parameter.
    pub curves: [CurveId; 2],
    /// The curves lie at larger x (they are born there as x rises).
    pub opens_upward: bool,
}

/// A pitchfork: a symmetric pair (or a circle) leaves a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pitchfork {
    /// The point in the (x, h) plane.
    pub point: Point,
    /// The axis of the frame over which the pair lies.
    pub axis: Axis,
    /// The curve that is left, before and after, by rising x.
    pub through: [CurveId; 2],
    /// The curve of the pair that ends here (always there once the set is made).
    pub pair: Option<CurveId>,
}

/// A place where f64 cannot count the cusps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuspCluster {
    /// The point in the (x, h) plane.
    pub point: Point,
    /// On this interval of the generic family.
    pub interval: IntervalId,
}

/// Why a body's critical points cannot be computed in `f64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum EquilibriaError {
    /// Products of the body's data leave the range of `f64`.
    #[error(
        "the body's data differ by more than 10^25 in size (a moment, a difference of moments or a component of r); \
         f64 cannot resolve them"
    )]
    Range,
}

/// The curves of critical values, complete, with the points where they end.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalSet {
    /// The body.
    pub frame: Frame,
    /// Curves; pole lines last.
    pub curves: Table<CurveId, Curve>,
    /// Where two curves end in one another.
    pub cusps: Table<CuspId, Cusp>,
    /// Where a symmetric pair leaves a curve.
    pub pitchforks: Table<PitchforkId, Pitchfork>,
    /// Places where the number of cusps is open.
    pub clusters: Table<ClusterId, CuspCluster>,
}

impl CriticalSet {
    /// Finds every curve of the body.
    ///
    /// # Errors
    /// [`EquilibriaError::Range`] when the data differ in size so much that products leave the range of `f64`.
    pub fn new(frame: Frame) -> Result<Self, EquilibriaError> {
        check_range(&frame)?;
        let mut set =
            Self { frame, curves: Table::new(), cusps: Table::new(), pitchforks: Table::new(), clusters: Table::new() };
        let (active, passive) = (set.frame.active(), set.frame.passive());
        match active.len() {
            0 => set.add_euler(&passive),
            1 => {
                set.add_axis(active[0], &passive);
                set.add_symmetric(&passive);
            }
            _ => {
                set.add_generic(&active, &passive);
                set.add_symmetric(&passive);
                set.add_pole_lines();
            }
        }
        Ok(set)
    }

    /// The body is symmetric about r.
    #[must_use]
    pub fn is_lagrange(&self) -> bool {
        let active = self.frame.active();
        active.len() == 1 && {
            let [i, j] = active[0].others();
            self.frame.diff[i][j] == 0.0
        }
    }

    /// The curve that begins at l = 0 with the hanging or the standing body.
    #[must_use]
    pub fn at_rest(&self, hangs: bool) -> Option<CurveId> {
        let begins = |curve: &Curve| curve.is_critical() && curve.x()[0] == 0.0 && (curve.index == Some(0)) == hangs;
        self.curves.pairs().find(|(_, curve)| begins(curve)).map(|(id, _)| id)
    }

    /// A further integral confines the motion near a curve, unless an eigenvalue has a positive real part.
    #[must_use]
    pub fn has_integral(&self, curve: &Curve) -> bool {
        let is_set = matches!(curve.orbit, Orbit::Circle(_) | Orbit::Sphere);
        is_set || self.frame.is_euler() || (self.is_lagrange() && curve.pole.is_some())
    }

    /// Numbers of the curves over x, and whether an end lies within rounding of x.
    #[must_use]
    pub fn curves_over(&self, x: f64) -> (Vec<CurveId>, bool) {
        let tolerance = end_tolerance(x);
        let over = self.curves.pairs().filter(|(_, curve)| {
            let [from, to] = curve.x();
            from < x && x < to
        });
        let near = self.curves.iter().any(|curve| curve.x().iter().any(|end| (end - x).abs() <= tolerance))
            || self.clusters.iter().any(|cluster| (cluster.point.x - x).abs() <= 1e-6 * x);
        (over.map(|(c, _)| c).collect(), near)
    }

    /// Whether x lies within rounding of an end of one of these curves, or near cusps on their branch that f64 does not
    /// count.
    #[must_use]
    pub fn ends_near(&self, branch: Branch, curves: std::ops::Range<CurveId>, x: f64) -> bool {
        let tolerance = end_tolerance(x);
        let range = curves.start.index()..curves.end.index();
        self.curves.as_slice()[range].iter().any(|curve| curve.x().iter().any(|end| (end - x).abs() <= tolerance))
            || self
                .clusters
                .iter()
                .any(|cluster| branch == Branch::Generic(cluster.interval) && (cluster.point.x - x).abs() <= 1e-6 * x)
    }
}

/// Distance in x from the end of a curve within which rounding leaves open on which side of it x lies.
fn end_tolerance(x: f64) -> f64 {
    64.0 * UNIT_ROUNDOFF * x
}

fn check_range(frame: &Frame) -> Result<(), EquilibriaError> {
    // Fifth powers of differences and fourth powers of components are multiplied.
    const SMALLEST: f64 = 1e-25;
    let too_small = |x: f64, scale: f64| x != 0.0 && x.abs() < SMALLEST * scale;
    let bad = (0..3).any(|k| {
        too_small(frame.r[k], frame.r_norm)
            || too_small(frame.a[k], frame.a[2])
            || (0..k).any(|m| too_small(frame.diff[k][m], frame.a[2]))
    });
    if bad { Err(EquilibriaError::Range) } else { Ok(()) }
}
