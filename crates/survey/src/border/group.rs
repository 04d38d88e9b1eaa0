//! Events of one diagram that draw together at a border, and borders at which they only change places.

use super::event::{BorderEventKind, Encounter, EventLabel, EventLocation, sort_by_text};
use super::vanishing::{EventOfBranches, Neighbourhood, Vanishing};
use bifdiag_diagram::arrangement::{Arrangement, Change, Event};
use bifdiag_equilibria::curves::{Branch, BranchName, CurveId, CurveName, Pole};

/// What was found out about a border.
pub(super) struct Finding<'a> {
    pub kind: BorderEventKind,
    /// The events that draw together there.
    pub group: Option<EventGroup<'a>>,
    pub vanishing: Vanishing,
}

impl Finding<'_> {
    /// An event that is no place in the plane.
    pub(super) fn nowhere(kind: BorderEventKind, vanishing: Vanishing) -> Self {
        Self { kind, group: None, vanishing }
    }
}

/// A few events of one side; at least one.
pub(super) struct EventGroup<'a> {
    side: &'a Arrangement,
    events: Vec<Event>,
}

impl<'a> EventGroup<'a> {
    pub(super) fn new(side: &'a Arrangement, events: Vec<Event>) -> Option<Self> {
        if events.is_empty() { None } else { Some(Self { side, events }) }
    }

    /// The middle of the events.
    pub(super) fn place(&self) -> EventLocation {
        let n = self.events.len() as f64;
        let x = self.events.iter().map(|event| event.x).sum::<f64>() / n;
        let h = self.events.iter().map(|event| event.h).sum::<f64>() / n;
        let frame = &self.side.set.frame;
        let spread = |of: &dyn Fn(&Event) -> f64| self.events.iter().map(of).fold(0.0, f64::max);
        let momentum = |x: f64| (2.0 * x).sqrt() * frame.momentum_unit;
        let h_error = spread(&|event| (event.h - h).abs() + event.h_error) * frame.energy_unit;
        let l_error = spread(&|event| (momentum(event.x) - momentum(x)).abs());
        EventLocation { h: h * frame.energy_unit, l: momentum(x), error: h_error.max(l_error) }
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

/// Of the events that change their order, or are told differently, those that are nearest to each other change places.
pub(super) fn exchange<'a>(side: &'a Arrangement, other: &Arrangement) -> Finding<'a> {
    let ranks = ranks(side, other);
    let changes = |k: usize, m: usize| ranks[k].zip(ranks[m]).is_none_or(|(k, m)| k > m);
    let Some(near) = nearest_cluster(side, changes).or_else(|| nearest_cluster(side, |_, _| true)) else {
        return Finding::nowhere(BorderEventKind::Unexplained, Vanishing::Nothing);
    };
    let labels: Vec<EventLabel> = near.iter().map(|event| label(side, event)).collect();
    let mut branches: Vec<BranchName> = labels.iter().flat_map(EventLabel::branches).copied().collect();
    sort_by_text(&mut branches);
    branches.dedup();
    let pitchfork =
        labels.iter().find_map(|label| if let EventLabel::Pitchfork(own) = label { Some(*own) } else { None });
    let cusp = labels.iter().find_map(|label| if let EventLabel::Cusp(own) = label { Some(*own) } else { None });
    let encounter = Encounter::Meets;
    let kind = match (pitchfork, cusp) {
        (Some(pitchfork), cusp) => {
            let others: Vec<BranchName> = branches.into_iter().filter(|name| !pitchfork.contains(name)).collect();
            match cusp {
                Some(cusp) if others.is_empty() => BorderEventKind::CuspNearPitchfork { cusp, pitchfork },
                _ if others.is_empty() => BorderEventKind::TriplePoint { branches: pitchfork.to_vec() },
                _ => BorderEventKind::PitchforkOnCurve { pitchfork, encounter, curves: others },
            }
        }
        (None, Some(cusp)) => BorderEventKind::CuspOnCurve { cusp, encounter, curves: branches },
        (None, None) => BorderEventKind::TriplePoint { branches },
    };
    let vanishing = exchanged(side, &near).unwrap_or(Vanishing::Nothing);
    Finding { kind, group: EventGroup::new(side, near), vanishing }
}

/// The number that each event of a side has on the other one, of the same kind and curves; none where these are not met there.
fn ranks(side: &Arrangement, other: &Arrangement) -> Vec<Option<usize>> {
    let keys = |side: &Arrangement| -> Vec<_> {
        let name = |curve| CurveName::of(&side.set, curve);
        let key = |event: &Event| {
            (std::mem::discriminant(&event.change), event.change.curves().into_iter().map(name).collect::<Vec<_>>())
        };
        side.events.iter().map(key).collect()
    };
    let (own, others) = (keys(side), keys(other));
    let same = |keys: &[_], k: usize| keys.iter().filter(|key| **key == own[k]).count();
    // Curves that cross twice do so in the same order.
    let rank = |k: usize| {
        let earlier = same(&own[..k], k);
        (0..others.len()).filter(|&m| others[m] == own[k]).nth(earlier)
    };
    (0..own.len()).map(rank).collect()
}

/// The two events with a common branch that are nearest to each other, and those that are as near to both, among pairs by their
/// numbers that `changes` takes.
fn nearest_cluster(side: &Arrangement, changes: impl Fn(usize, usize) -> bool) -> Option<Vec<Event>> {
    let labels: Vec<EventLabel> = side.events.iter().map(|event| label(side, event)).collect();
    let mut best: Option<(f64, [Event; 2])> = None;
    for (k, event) in side.events.iter().enumerate() {
        for (m, other) in side.events.iter().enumerate().skip(k + 1) {
            let labels = [labels[k], labels[m]];
            let shared = labels[0].branches().iter().any(|name| labels[1].branches().contains(name));
            let apart = distance(event, other);
            if shared && changes(k, m) && !have_both_pole_lines(&labels) && best.is_none_or(|(least, _)| apart < least)
            {
                best = Some((apart, [*event, *other]));
            }
        }
    }
    let (apart, [p, q]) = best?;
    let is_near = |event: &&Event| distance(event, &p).max(distance(event, &q)) <= 1e3 * apart + 1e-12;
    let mut near = vec![p, q];
    let mut labels: Vec<EventLabel> = near.iter().map(|event| label(side, event)).collect();
    for event in side.events.iter().filter(is_near).filter(|event| **event != p && **event != q) {
        labels.push(label(side, event));
        if have_both_pole_lines(&labels) {
            labels.pop();
        } else {
            near.push(*event);
        }
    }
    Some(near)
}

/// Far out the two pole lines look near to each other, but they are parallel: no place has both.
fn have_both_pole_lines(labels: &[EventLabel]) -> bool {
    let has = |pole| labels.iter().any(|label| label.branches().contains(&BranchName::Pole(pole)));
    has(Pole::Plus) && has(Pole::Minus)
}

/// What vanishes where events change places: the height of a third curve over one of them, or the distance of a cusp from a
/// pitchfork.
fn exchanged(side: &Arrangement, near: &[Event]) -> Option<Vanishing> {
    let branch = |c: CurveId| side.set.curves[c].branch;
    let place = |event: &Event| Neighbourhood::of(&side.set.frame, event.x, event.h);
    let pitchfork = near.iter().find_map(|event| match event.change {
        Change::Open { through, pair } | Change::Close { through, pair } => match branch(pair) {
            Branch::Symmetric(axis) => Some((axis, [branch(through[0]), branch(pair)])),
            _ => None,
        },
        _ => None,
    });
    let cusp = near.iter().find_map(|event| match event.change {
        Change::Birth([one, _]) | Change::Death([one, _]) => Some((branch(one), place(event))),
        _ => None,
    });
    if let (Some((axis, _)), Some(_)) = (pitchfork, cusp) {
        return Some(Vanishing::CuspAtPitchfork(axis));
    }
    let (crossing, pair) = near.iter().find_map(|event| match event.change {
        Change::Swap(curves) => Some((event, curves.map(branch))),
        _ => None,
    })?;
    let beside = |own: &[Branch]| pair.into_iter().find(|branch| !own.contains(branch));
    let (event, curve) = if let Some((axis, own)) = pitchfork {
        (EventOfBranches::Pitchfork(axis), beside(&own)?)
    } else if let Some((branch, near)) = cusp {
        (EventOfBranches::Cusp { branch, near }, beside(&[branch])?)
    } else {
        let others = near.iter().flat_map(|event| event.change.curves()).map(branch);
        let event = EventOfBranches::Crossing { branches: pair, near: place(crossing) };
        (event, others.into_iter().find(|other| !pair.contains(other))?)
    };
    Some(Vanishing::Height { event, curve, height: 0.0 })
}
