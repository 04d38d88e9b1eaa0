//! Events in proved order, where their order matters.

use dashu_ratio::RBig;

use super::event::{Event, EventSource, Undecided, crossing_event};
use super::stages::STAGES;
use crate::evaluator::{Evaluator, Evaluators};
use crate::id::TransitionId;
use crate::pair::{PairProof, Proof};
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
    let mut groups: Vec<Vec<Event>> = Vec::new();
    let mut reach: Option<RBig> = None;
    for event in events {
        let end = event.x[1].clone();
        match (&reach, groups.last_mut()) {
            (Some(limit), Some(group)) if event.x[0] <= *limit => group.push(event),
            _ => groups.push(vec![event]),
        }
        reach = Some(reach.take().map_or_else(|| end.clone(), |limit| limit.max(end.clone())));
    }
    for group in &mut groups {
        group.sort_by(|p, q| p.x_middle().total_cmp(&q.x_middle()).then_with(|| p.h_middle().total_cmp(&q.h_middle())));
        for (k, p) in group.iter().enumerate() {
            for q in &group[k + 1..] {
                if p.curves.iter().any(|c| q.curves.contains(c)) {
                    let mut curves = p.curves.clone();
                    curves.extend(&q.curves);
                    curves.sort_unstable();
                    curves.dedup();
                    let x = [p.x[0].to_f64().value(), q.x[1].to_f64().value()];
                    return Err(vec![Undecided::Events { curves, x }]);
                }
            }
        }
    }
    let mut numbers = (0..).map(EventId::at);
    let transitions = groups.iter().map(|group| numbers.by_ref().take(group.len()).collect()).collect();
    Ok((groups.into_iter().flatten().collect(), transitions))
}
