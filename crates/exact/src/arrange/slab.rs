//! The strips between events, with the order of the curves in each.

use dashu_ratio::RBig;

use super::event::{Event, EventSource, Undecided};
use super::stages::{Ordered, Stages};
use crate::curves::Curves;
use crate::id::TransitionId;
use bifdiag_diagram::arrangement::{EventId, RegionId, SlabId};
use bifdiag_equilibria::curves::{CurveId, End};
use bifdiag_numbers::table::{Id, Table};

/// A strip between events.
#[derive(Clone, Debug)]
pub(crate) struct Slab {
    /// The abscissa at which the order is proved.
    pub x: RBig,
    /// l with x = l²/2, if it is a double.
    pub l: Option<f64>,
    /// Curves by rising h.
    pub order: Vec<CurveId>,
    /// Enclosures of their heights.
    pub heights: Vec<[f64; 2]>,
    /// Region above each curve.
    pub region_above: Vec<RegionId>,
}

/// The slabs in which a curve lives.
fn span(
    curves: &Curves,
    events: &Table<EventId, Event>,
    transitions: &Table<TransitionId, Vec<EventId>>,
    curve: CurveId,
) -> [SlabId; 2] {
    let at = |end: End| {
        transitions.ids().find(|transition| {
            let group = &transitions[*transition];
            group.iter().any(|&event| {
                events[event].sources.iter().any(|source| match source {
                    EventSource::Cusp(number) => end == End::Cusp(*number),
                    EventSource::Pitchfork(number) => end == End::Pitchfork(*number),
                    _ => false,
                })
            })
        })
    };
    let [from, to] = curves.list[curve].ends;
    let last = transitions.next_id().before();
    [at(from).map_or(SlabId::at(0), TransitionId::after), at(to).map_or(last, TransitionId::before)]
}

/// x of a slab, and l when x = l²/2 for a double l: one with few bits, so that l² is exact.
fn sample(low: Option<&RBig>, high: Option<&RBig>) -> (RBig, Option<f64>) {
    let double = |x: &RBig| x.to_f64().value();
    let (from, to) = (low.map_or(0.0, double), high.map_or(f64::INFINITY, double));
    let [l_from, l_to] = [(2.0 * from).sqrt(), (2.0 * to).sqrt()];
    let target = match (from > 0.0, to.is_finite()) {
        (true, true) if l_to > 2.0 * l_from => (l_from * l_to).sqrt(),
        (true, true) => 0.5 * (l_from + l_to),
        (true, false) => 1.2 * l_from,
        (false, true) => 0.7 * l_to,
        (false, false) => 1.0,
    };
    for dropped in [44, 40, 36, 32, 28, 24, 20, 12, 4, 0] {
        let l = f64::from_bits((target.to_bits() >> dropped) << dropped);
        let Ok(exact) = RBig::try_from(l) else { break };
        let x = &exact * &exact / RBig::from(2);
        if low.is_none_or(|low| x > *low) && high.is_none_or(|high| x < *high) && l > 0.0 {
            return (x, Some(l));
        }
    }
    match (low, high) {
        (Some(low), Some(high)) => ((low + high) / RBig::from(2), None),
        (Some(low), None) => (low * RBig::from(2), None),
        (None, Some(high)) => (high / RBig::from(2), None),
        (None, None) => (RBig::ONE, None),
    }
}

pub(super) fn slabs(
    curves: &Curves,
    events: &Table<EventId, Event>,
    transitions: &Table<TransitionId, Vec<EventId>>,
    stages: &Stages<'_>,
) -> Result<Table<SlabId, Slab>, Vec<Undecided>> {
    let spans: Table<CurveId, [SlabId; 2]> =
        curves.list.ids().map(|curve| span(curves, events, transitions, curve)).collect();
    let end = |transition| transitions.get(transition)?.iter().map(|&e| &events[e].x[1]).max();
    let start = |transition| transitions.get(transition)?.iter().map(|&e| &events[e].x[0]).min();
    (0..=transitions.len())
        .map(|slab| {
            let slab = SlabId::at(slab);
            let (low, high) = (TransitionId::at_start(slab).and_then(end), start(TransitionId::at_end(slab)));
            let (x, l) = sample(low, high);
            let alive: Vec<CurveId> =
                curves.list.ids().filter(|&c| spans[c][0] <= slab && slab <= spans[c][1]).collect();
            let Ordered { curves: order, heights } =
                stages.order(&alive, &x).ok_or_else(|| vec![Undecided::Order { x: x.to_f64().value() }])?;
            Ok(Slab { x, l, order, heights, region_above: Vec::new() })
        })
        .collect()
}
