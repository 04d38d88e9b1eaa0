//! Events closer than their errors, in the order that proved orders of curves and the gluing of regions demand.

use std::cmp::Ordering;

use super::event::{Change, Event};
use super::faces::{Faces, InconsistentOrder};
use super::id::{EventId, SlabId};
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::table::{Id, Table};

/// Brings crossings of one curve with two others that are closer than their errors into the order that the proved order
/// of those two demands: a rising curve meets the lower one first.
pub(super) fn settle(events: &mut [Event], order: impl Fn(CurveId, CurveId, [f64; 2]) -> Option<Ordering>) {
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
/// allow. An order of events that cannot be glued is wrong; one that can is taken, and events that are then still
/// within their errors of each other are reported by the caller.
pub(super) fn settle_by_gluing(
    events: &mut [Event],
    orders: impl Fn(&[Event]) -> Table<SlabId, Vec<CurveId>>,
) -> (Table<SlabId, Vec<CurveId>>, Result<Faces, InconsistentOrder>) {
    /// Exchanges that are tried; each costs a gluing.
    const TRIES: usize = 256;
    let glue = |events: &[Event]| {
        let orders = orders(events);
        let changes: Table<EventId, Change> = events.iter().map(|event| event.change).collect();
        let faces = Faces::glue(&orders, &changes);
        (orders, faces)
    };
    let mut best = glue(events);
    let mut tries = 0;
    while let Err(InconsistentOrder { event }) = best.1 {
        let stuck = event.index();
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
            let further = found.1.as_ref().map_or_else(|error| error.event > event, |_| true);
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

/// The two events are crossings of one curve with two others, in the wrong order.
fn must_swap(first: &Event, second: &Event, order: &impl Fn(CurveId, CurveId, [f64; 2]) -> Option<Ordering>) -> bool {
    let Some(SharedCurve { curve: moving, others: [p, q] }) = common_curve(first, second) else { return false };
    let range = [first.x.min(second.x) - first.x_error, first.x.max(second.x) + second.x_error];
    if second.x - first.x > first.x_error + second.x_error {
        return false;
    }
    let below = [range[0] - 4.0 * first.x_error, range[0]];
    match (order(p, q, range), order(moving, p, below)) {
        // Below both: the lower of p and q comes first. Above both: the upper one.
        (Some(p_to_q), Some(moving_to_p)) => p_to_q == moving_to_p.reverse(),
        _ => false,
    }
}

/// The curve that two crossings share, and the other curve of each.
pub(super) struct SharedCurve {
    pub curve: CurveId,
    pub others: [CurveId; 2],
}

/// What two crossings share, if each has one curve of its own.
pub(super) fn common_curve(first: &Event, second: &Event) -> Option<SharedCurve> {
    let (Change::Swap([a, b]), Change::Swap([c, d])) = (first.change, second.change) else { return None };
    [(a, b, c, d), (a, b, d, c), (b, a, c, d), (b, a, d, c)]
        .into_iter()
        .find(|(shared, other, same, rest)| shared == same && other != rest)
        .map(|(curve, other, _, rest)| SharedCurve { curve, others: [other, rest] })
}
