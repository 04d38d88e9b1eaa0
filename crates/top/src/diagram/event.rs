//! Events: the points of the (x, h) plane where curves meet.

use crate::curves::{CriticalSet, End};
use numbers::UNIT_ROUNDOFF;

use super::faces::{Faces, InconsistentOrder};
use super::order::PairOrder;

/// What happens to the vertical order of the curves as x rises through an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Two curves appear between the same neighbours.
    Birth([usize; 2]),
    /// Two neighbouring curves vanish.
    Death([usize; 2]),
    /// Two neighbouring curves change places.
    Swap([usize; 2]),
    /// A curve continues as another, and a pair appears next to it.
    Open {
        /// The curve before and after.
        through: [usize; 2],
        /// The pair.
        pair: usize,
    },
    /// A pair vanishes into a curve, which continues as another.
    Close {
        /// The curve before and after.
        through: [usize; 2],
        /// The pair.
        pair: usize,
    },
}

impl Change {
    /// The curves that meet.
    #[must_use]
    pub fn curves(&self) -> Vec<usize> {
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
pub(super) fn collect(set: &CriticalSet, pairs: &[(usize, usize, PairOrder)]) -> Vec<Event> {
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
    for (number, pitchfork) in set.pitchforks.iter().enumerate() {
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
    for (a, b, order) in pairs {
        let height = |x: f64| {
            let point = set.curves[*a].point(&set.frame, x);
            (point.h(), point.h_error())
        };
        events.extend(order.crossings(height).into_iter().map(|crossing| Event {
            change: Change::Swap([*a, *b]),
            x: crossing.x,
            x_error: crossing.x_error,
            h: crossing.h,
            h_error: crossing.h_error,
        }));
    }
    events.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.h.total_cmp(&q.h)));
    events
}

/// Brings crossings of one curve with two others that are closer than their errors into the order that the proved order
/// of those two demands: a rising curve meets the lower one first.
pub(super) fn settle(events: &mut [Event], order: impl Fn(usize, usize, [f64; 2]) -> Option<i8>) {
    // Neighbours only, and as often as it takes for the longest run of such crossings.
    for _ in 0..events.len() {
        let mut changed = false;
        for k in 1..events.len() {
            if must_swap(&events[k - 1], &events[k], &order) {
                events.swap(k - 1, k);
                changed = true;
            }
        }
        if !changed {
            break;
        }
    }
}

/// Glues the faces; where orders and events contradict each other, tries those orders of the events that their errors
/// allow. An order of events that cannot be glued is wrong; one that can is taken, and events that then still stand
/// within their errors of each other are found and told by the caller.
pub(super) fn settle_by_gluing(
    events: &mut [Event],
    orders: impl Fn(&[Event]) -> Vec<Vec<usize>>,
) -> (Vec<Vec<usize>>, Result<Faces, InconsistentOrder>) {
    /// Exchanges that are tried; each costs a gluing.
    const TRIES: usize = 256;
    let glue = |events: &[Event]| {
        let orders = orders(events);
        let changes: Vec<Change> = events.iter().map(|event| event.change).collect();
        let faces = Faces::glue(&orders, &changes);
        (orders, faces)
    };
    let mut best = glue(events);
    let mut tries = 0;
    while let Err(InconsistentOrder { event: stuck }) = best.1 {
        // Earlier places first: the contradiction shows where the wrong order ends, not where it begins.
        let exchange = (0..events.len()).flat_map(|k| (0..k).map(move |j| (j, k))).filter(|&(j, k)| {
            let reach = |event: &Event| 4.0 * event.x_error;
            j <= stuck + 1 && k + 4 >= stuck && events[k].x - events[j].x <= reach(&events[j]) + reach(&events[k])
        });
        let better = exchange.collect::<Vec<_>>().into_iter().find_map(|(j, k)| {
            tries += 1;
            if tries > TRIES {
                return None;
            }
            let mut moved = events.to_vec();
            moved[j..=k].rotate_right(1);
            let found = glue(&moved);
            let further = found.1.as_ref().map_or_else(|error| error.event > stuck, |_| true);
            further.then_some((moved, found))
        });
        let Some((moved, found)) = better else { break };
        events.copy_from_slice(&moved);
        best = found;
    }
    if tries > 0 {
        // Slabs are searched by x: it must not fall.
        for k in 1..events.len() {
            if events[k].x < events[k - 1].x {
                events[k].x_error += events[k - 1].x - events[k].x;
                events[k].x = events[k - 1].x;
            }
        }
    }
    best
}

/// The two events are crossings of one curve with two others, and stand in the wrong order.
fn must_swap(first: &Event, second: &Event, order: &impl Fn(usize, usize, [f64; 2]) -> Option<i8>) -> bool {
    let Some((moving, p, q)) = common_curve(first, second) else { return false };
    let range = [first.x.min(second.x) - first.x_error, first.x.max(second.x) + second.x_error];
    if second.x - first.x > first.x_error + second.x_error {
        return false;
    }
    let below = [range[0] - 4.0 * first.x_error, range[0]];
    match (order(p, q, range), order(moving, p, below)) {
        // Below both: the lower of p and q comes first. Above both: the upper one.
        (Some(p_minus_q), Some(moving_minus_p)) => p_minus_q * moving_minus_p < 0,
        _ => false,
    }
}

/// The curve that two crossings share, and the other curve of each.
pub(super) fn common_curve(first: &Event, second: &Event) -> Option<(usize, usize, usize)> {
    let (Change::Swap([a, b]), Change::Swap([c, d])) = (first.change, second.change) else { return None };
    [(a, b, c, d), (a, b, d, c), (b, a, c, d), (b, a, d, c)]
        .into_iter()
        .find(|(shared, other, same, rest)| shared == same && other != rest)
        .map(|(shared, other, _, rest)| (shared, other, rest))
}
