//! What must hold for every arrangement; called by unit, property and fuzz tests.

use thiserror::Error;

use super::{Arrangement, Change, SlabId};
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::table::{Id, Partition};

/// Relative rounding of x at the end of a curve, and at the event there.
const SPAN_ROUNDING: f64 = 256.0 * UNIT_ROUNDOFF;

/// A broken invariant.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum InvariantError {
    /// Faces, edges and vertices do not satisfy Euler's formula.
    #[error("Euler's formula fails: {vertices} vertices − {edges} edges + {faces} faces ≠ {components} components")]
    Euler {
        /// Events and ends of curves.
        vertices: usize,
        /// Pieces of curves between vertices, and of the frame.
        edges: usize,
        /// Faces, the forbidden one included.
        faces: usize,
        /// Connected components of the graph.
        components: usize,
    },
    /// Two curves of a slab are in the wrong order at its middle, by more than the error bound.
    #[error("curves {lower:?} and {upper:?} are in the wrong order in {slab:?}")]
    Order {
        /// The slab.
        slab: SlabId,
        /// The curve that should be below.
        lower: CurveId,
        /// The curve that should be above.
        upper: CurveId,
    },
    /// A slab lists a curve that does not live there.
    #[error("{curve:?} does not cover {slab:?}")]
    Span {
        /// The slab.
        slab: SlabId,
        /// The curve.
        curve: CurveId,
    },
    /// The number of minima and maxima minus saddles is not 2.
    #[error("in {slab:?} the indices sum to {sum}, not to 2")]
    IndexSum {
        /// The slab.
        slab: SlabId,
        /// Σ (−1)^index.
        sum: i32,
    },
}

impl Arrangement {
    /// Checks Euler's formula, the vertical orders against computed heights (only where nothing was left undecided), and
    /// Σ(−1)^index = 2 in each slab.
    ///
    /// # Errors
    /// The first [`InvariantError`] found.
    pub fn check_invariants(&self) -> Result<(), InvariantError> {
        if self.slabs.is_empty() {
            return Ok(());
        }
        self.check_euler()?;
        for slab in self.slabs.ids() {
            self.check_slab(slab)?;
        }
        Ok(())
    }

    /// The half-plane is closed to a disc by a frame on which the ends of curves at l = 0 and ∞ lie.
    fn check_euler(&self) -> Result<(), InvariantError> {
        let curves = self.set.curves.len();
        let mut ends = 0;
        let mut pieces = curves;
        for curve in &self.set.curves {
            ends += usize::from(curve.x()[0] == 0.0) + usize::from(curve.x()[1].is_infinite());
        }
        let mut joined = Partition::new(curves + 1);
        for (c, curve) in self.set.curves.pairs() {
            if curve.x()[0] == 0.0 || curve.x()[1].is_infinite() {
                joined.unite(c.index(), curves);
            }
        }
        for event in &self.events {
            if let Change::Swap(_) = event.change {
                pieces += 2;
            }
            let meeting = event.change.curves();
            for pair in meeting.windows(2) {
                joined.unite(pair[0].index(), pair[1].index());
            }
        }
        let components = joined.count();
        let (vertices, edges, faces) = (self.events.len() + ends, pieces + ends, self.region_count + 1);
        if vertices + faces == edges + components {
            Ok(())
        } else {
            Err(InvariantError::Euler { vertices, edges, faces, components })
        }
    }

    fn check_slab(&self, number: SlabId) -> Result<(), InvariantError> {
        let slab = &self.slabs[number];
        let x = self.middle(number);
        for &curve in &slab.order {
            let [from, to] = self.set.curves[curve].x();
            // The ends of curves and the events are rounded on their own.
            if from > slab.x[0] * (1.0 + SPAN_ROUNDING) || to < slab.x[1] * (1.0 - SPAN_ROUNDING) {
                return Err(InvariantError::Span { slab: number, curve });
            }
        }
        let points: Vec<_> = slab.order.iter().map(|&c| self.set.curves[c].point(&self.set.frame, x)).collect();
        for (k, pair) in points.windows(2).enumerate() {
            let slack = pair[0].h_error() + pair[1].h_error();
            if self.undecided.is_empty() && pair[0].h() - pair[1].h() > slack {
                return Err(InvariantError::Order { slab: number, lower: slab.order[k], upper: slab.order[k + 1] });
            }
        }
        let sum: i32 = slab.order.iter().map(|&c| self.set.curves[c].euler_contribution()).sum();
        if sum == 2 { Ok(()) } else { Err(InvariantError::IndexSum { slab: number, sum }) }
    }

    /// An abscissa well inside a slab.
    #[must_use]
    pub fn middle(&self, slab: SlabId) -> f64 {
        let [from, to] = self.slabs[slab].x;
        match (from > 0.0, to.is_finite()) {
            (true, true) if to > 4.0 * from => from.sqrt() * to.sqrt(),
            (true, true) => 0.5 * (from + to),
            (true, false) => 2.0 * from,
            (false, true) => 0.5 * to,
            (false, false) => 1.0,
        }
    }
}
