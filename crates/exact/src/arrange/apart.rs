//! Events in proved order, where their order matters.

use std::ops::Range;

use dashu_ratio::RBig;

use super::event::{Event, EventSource, Undecided, crossing_event};
use super::stages::STAGES;
use crate::id::TransitionId;
use crate::pair::{PairProof, Proof};
use crate::point::{Evaluator, Evaluators};
use bifdiag_diagram::arrangement::EventId;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::{Id, Table};

/// Narrows the boxes of crossings that overlap other events of their curves, with as many bits as it takes; which bits.
pub(super) fn separate(events: &mut [Event], pairs: &mut [PairProof], evaluators: &Evaluators<'_>) -> usize {
    let mut used = 0;
    let mut open = overlapping(events);
    if !open.is_empty() {
        used = STAGES[0];
        narrow(evaluators.middle(), &open, events, pairs);
        open = overlapping(events);
    }
    if !open.is_empty() {
        used = STAGES[1];
        narrow(evaluators.wide(), &open, events, pairs);
    }
    used
}

/// The crossings whose boxes overlap other events of their curves.
fn overlapping(events: &[Event]) -> Vec<usize> {
    let overlaps = |p: &Event, q: &Event| {
        p.x[0] <= q.x[1] && q.x[0] <= p.x[1] && p.curves.iter().any(|curve| q.curves.contains(curve))
    };
    (0..events.len())
        .filter(|&n| matches!(events[n].sources[..], [EventSource::Crossing(_)]))
        .filter(|&n| (0..events.len()).any(|m| m != n && overlaps(&events[n], &events[m])))
        .collect()
}

/// Narrows the boxes of these crossings.
fn narrow<E: Enclosure>(evaluator: &Evaluator<'_, E>, open: &[usize], events: &mut [Event], pairs: &mut [PairProof]) {
    for &n in open {
        let [EventSource::Crossing(pair)] = events[n].sources[..] else { continue };
        if let Some(x) = evaluator.narrowed(pair, &events[n].x) {
            let proofs = pairs.iter_mut().filter(|proof| proof.curves == pair).flat_map(|proof| &mut proof.stretches);
            for stretch in proofs.filter(|stretch| stretch.proof == Proof::Crossing(events[n].x.clone())) {
                stretch.proof = Proof::Crossing(x.clone());
            }
            events[n] = crossing_event(evaluator, pair, &x);
        }
    }
}

/// Numbers of the events between two slabs.
pub(super) type Transitions = Table<TransitionId, Vec<EventId>>;

/// The events by rising x, and groups of those whose x cannot be separated; each group must consist of events on different
/// curves. In a group they stand as they are listed: by rising x in doubles, then by h.
pub(super) fn transitions(mut events: Vec<Event>) -> Result<(Table<EventId, Event>, Transitions), Vec<Undecided>> {
    events.sort_by(|p, q| p.x[0].cmp(&q.x[0]).then(p.x[1].cmp(&q.x[1])));
    let mut ends: Vec<usize> = Vec::new();
    let mut reach: Option<RBig> = None;
    for (number, event) in events.iter().enumerate() {
        if reach.as_ref().is_some_and(|limit| event.x[0] > *limit) {
            ends.push(number);
        }
        reach = Some(reach.take().map_or_else(|| event.x[1].clone(), |limit| limit.max(event.x[1].clone())));
    }
    let starts = std::iter::once(0).chain(ends.iter().copied());
    let ranges: Vec<Range<usize>> = starts.zip(ends.iter().copied().chain([events.len()])).map(|(a, b)| a..b).collect();
    for range in &ranges {
        let place = |event: &Event| [event.x_middle(), event.h_middle()];
        events[range.clone()].sort_by(|p, q| {
            let ([x, h], [other_x, other_h]) = (place(p), place(q));
            x.total_cmp(&other_x).then(h.total_cmp(&other_h))
        });
    }
    let events = Table::from(events);
    let groups: Vec<Vec<EventId>> =
        ranges.into_iter().filter(|range| !range.is_empty()).map(|range| range.map(EventId::at).collect()).collect();
    for group in &groups {
        for (k, &p) in group.iter().enumerate() {
            for &q in &group[k + 1..] {
                if events[p].curves.iter().any(|c| events[q].curves.contains(c)) {
                    let mut curves = events[p].curves.clone();
                    curves.extend(&events[q].curves);
                    curves.sort_unstable();
                    curves.dedup();
                    let x = [events[p].x[0].to_f64().value(), events[q].x[1].to_f64().value()];
                    return Err(vec![Undecided::Events { curves, x }]);
                }
            }
        }
    }
    Ok((events, groups.into()))
}
