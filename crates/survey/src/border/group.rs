//! Events that happen together.

use super::event::{BorderEventKind, Place};
use super::label::EventLabel;
use super::vanishing::Vanishing;
use bifdiag_diagram::arrangement::{Arrangement, Event};
use bifdiag_equilibria::curves::{CurveId, CurveName};

/// What was found out about a border.
pub(super) struct Finding<'a> {
    pub kind: BorderEventKind,
    /// The events that draw together there.
    pub group: Option<Group<'a>>,
    pub vanishing: Vanishing,
}

impl Finding<'_> {
    /// An event that is no place in the plane.
    pub(super) fn nowhere(kind: BorderEventKind, vanishing: Vanishing) -> Self {
        Self { kind, group: None, vanishing }
    }
}

/// A few events of one side; at least one.
pub(super) struct Group<'a> {
    side: &'a Arrangement,
    events: Vec<Event>,
}

impl<'a> Group<'a> {
    pub(super) fn new(side: &'a Arrangement, events: Vec<Event>) -> Option<Self> {
        if events.is_empty() { None } else { Some(Self { side, events }) }
    }

    /// The middle of the events.
    pub(super) fn place(&self) -> Place {
        let n = self.events.len() as f64;
        let x = self.events.iter().map(|event| event.x).sum::<f64>() / n;
        let h = self.events.iter().map(|event| event.h).sum::<f64>() / n;
        let frame = &self.side.set.frame;
        let spread = |of: &dyn Fn(&Event) -> f64| self.events.iter().map(of).fold(0.0, f64::max);
        let momentum = |x: f64| (2.0 * x).sqrt() * frame.momentum_unit;
        let h_error = spread(&|event| (event.h - h).abs() + event.h_error) * frame.energy_unit;
        let l_error = spread(&|event| (momentum(event.x) - momentum(x)).abs());
        Place { h: h * frame.energy_unit, l: momentum(x), error: h_error.max(l_error) }
    }

    /// The curves that take part, each once.
    pub(super) fn curves(&self) -> Vec<CurveName> {
        let mut curves: Vec<CurveId> = self.events.iter().flat_map(|event| event.change.curves()).collect();
        curves.sort_unstable();
        curves.dedup();
        curves.into_iter().map(|curve| CurveName::of(&self.side.set, curve)).collect()
    }
}

/// The label of an event of one side.
pub(super) fn label(side: &Arrangement, event: &Event) -> EventLabel {
    EventLabel::of(&side.set, &event.change)
}

/// Distance of two events in units in which the events of ordinary diagrams are about 1 apart.
pub(super) fn distance(p: &Event, q: &Event) -> f64 {
    let scale = |a: f64, b: f64| a.abs().max(b.abs()).max(1e-300);
    let dx = (p.x - q.x).abs() / scale(p.x, q.x);
    let dh = (p.h - q.h).abs() / scale(p.h, q.h).max(1.0);
    dx.max(dh)
}

/// The two of these events that are nearest to each other.
pub(super) fn nearest(candidates: &[Event]) -> Option<[Event; 2]> {
    let mut best: Option<(f64, [Event; 2])> = None;
    for (k, p) in candidates.iter().enumerate() {
        for q in &candidates[k + 1..] {
            if best.is_none_or(|(least, _)| distance(p, q) < least) {
                best = Some((distance(p, q), [*p, *q]));
            }
        }
    }
    best.map(|(_, pair)| pair)
}
