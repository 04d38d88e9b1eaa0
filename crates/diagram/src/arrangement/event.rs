//! Events: the points of the (x, h) plane where curves meet.

use super::order::ProvedPair;
use bifdiag_equilibria::curves::{CriticalSet, CurveId, End};
use bifdiag_numbers::UNIT_ROUNDOFF;

/// What happens to the vertical order of the curves as x rises through an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Two curves appear between the same neighbours.
    Birth([CurveId; 2]),
    /// Two neighbouring curves vanish.
    Death([CurveId; 2]),
    /// Two neighbouring curves change places.
    Swap([CurveId; 2]),
    /// A curve continues as another, and a pair appears next to it.
    Open {
        /// The curve before and after.
        through: [CurveId; 2],
        /// The pair.
        pair: CurveId,
    },
    /// A pair vanishes into a curve, which continues as another.
    Close {
        /// The curve before and after.
        through: [CurveId; 2],
        /// The pair.
        pair: CurveId,
    },
}

impl Change {
    /// The curves that meet.
    #[must_use]
    pub fn curves(&self) -> Vec<CurveId> {
        match *self {
            Self::Birth(curves) | Self::Death(curves) | Self::Swap(curves) => curves.to_vec(),
            Self::Open { through, pair } | Self::Close { through, pair } => vec![through[0], through[1], pair],
        }
    }
}

/// An event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// What happens there.
    pub change: Change,
    /// x = l²/2.
    pub x: f64,
    /// Bound on the error of `x`.
    pub x_error: f64,
    /// h.
    pub h: f64,
    /// Bound on the error of `h`.
    pub h_error: f64,
}

/// Cusps, pitchforks and crossings by rising x.
pub(super) fn collect(set: &CriticalSet, pairs: &[ProvedPair]) -> Vec<Event> {
    // At a cusp x is stationary in μ, at a pitchfork μ is exact: both x are right to their rounding.
    let exact = |x: f64| 64.0 * UNIT_ROUNDOFF * x;
    let mut events = Vec::new();
    for cusp in &set.cusps {
        let change = if cusp.opens_upward { Change::Birth(cusp.curves) } else { Change::Death(cusp.curves) };
        let point = &cusp.point;
        let x_error = exact(point.x);
        let h_error = point.h_error() + x_error * point.slope();
        events.push(Event { change, x: point.x, x_error, h: point.h(), h_error });
    }
    for (number, pitchfork) in set.pitchforks.pairs() {
        // A pitchfork without a pair does not occur; it would be a change of name only.
        let Some(pair) = pitchfork.pair else { continue };
        let through = pitchfork.through;
        let opens = set.curves[pair].ends[0] == End::Pitchfork(number);
        let change = if opens { Change::Open { through, pair } } else { Change::Close { through, pair } };
        let point = &pitchfork.point;
        let x_error = exact(point.x);
        let h_error = point.h_error() + x_error * point.slope();
        events.push(Event { change, x: point.x, x_error, h: point.h(), h_error });
    }
    for ProvedPair { curves, order } in pairs {
        let height = |x: f64| {
            let point = set.curves[curves[0]].point(&set.frame, x);
            (point.h(), point.h_error())
        };
        events.extend(order.crossings(height).into_iter().map(|crossing| Event {
            change: Change::Swap(*curves),
            x: crossing.x,
            x_error: crossing.x_error,
            h: crossing.h,
            h_error: crossing.h_error,
        }));
    }
    events.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.h.total_cmp(&q.h)));
    events
}
