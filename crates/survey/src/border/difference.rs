//! How the diagrams on the two sides of a border differ, and the event that explains it.

use std::collections::BTreeMap;

use super::event::{BorderEvent, BorderEventKind, Encounter, EventLabel, sort_by_text};
use super::group::{EventGroup, Finding, distance, exchange, label, nearest};
use super::vanishing::{EventOfBranches, Neighbourhood, Vanishing};
use bifdiag_body::{Axis, BodyAxis};
use bifdiag_diagram::arrangement::{Arrangement, Change, Event};
use bifdiag_equilibria::curves::{Branch, BranchName, CriticalSet, CurveId};

/// How many events have each label.
fn counts(side: &Arrangement) -> BTreeMap<EventLabel, usize> {
    let mut found = BTreeMap::new();
    for event in &side.events {
        *found.entry(label(side, event)).or_default() += 1;
    }
    found
}

/// The labels that `one` has more often than `other`, as often as it has more.
fn surplus(one: &BTreeMap<EventLabel, usize>, other: &BTreeMap<EventLabel, usize>) -> Vec<EventLabel> {
    let more = |(label, count): (&EventLabel, &usize)| {
        std::iter::repeat_n(*label, count.saturating_sub(other.get(label).copied().unwrap_or_default()))
    };
    let mut found: Vec<EventLabel> = one.iter().flat_map(more).collect();
    sort_by_text(&mut found);
    found
}

/// What happens between two diagrams, and what vanishes there.
pub(crate) fn between(below: &Arrangement, above: &Arrangement) -> (BorderEvent, Vanishing) {
    let (counts_below, counts_above) = (counts(below), counts(above));
    let vanish = surplus(&counts_below, &counts_above);
    let appear = surplus(&counts_above, &counts_below);
    let offsets = [below, above].map(|side| side.set.frame.offset[1]);
    let pole_lines_differ = || vanish.iter().chain(&appear).all(EventLabel::meets_pole_line);
    // One of the bodies may be on the border itself.
    let is_between = offsets[0] * offsets[1] < 0.0 && vanish.len() == appear.len();
    let is_passed = is_between || (offsets[0] == 0.0) != (offsets[1] == 0.0);
    let Finding { kind, group, vanishing } = if vanish.is_empty() && appear.is_empty() {
        exchange(below, above)
    } else if is_passed && pole_lines_differ() {
        let kind = BorderEventKind::PoleLinesAtInfinity { axis: axis_of_body(&below.set, Axis::ALL[1]) };
        Finding::nowhere(kind, Vanishing::MiddleMoment)
    } else if vanish.len() > appear.len() {
        creation(&Surplus { side: below, more: &vanish, fewer: &appear })
    } else {
        creation(&Surplus { side: above, more: &appear, fewer: &vanish })
    };
    let curves = group.as_ref().map_or_else(Vec::new, EventGroup::curves);
    let place = group.as_ref().map(EventGroup::place);
    (BorderEvent { kind, curves, place, vanish, appear }, vanishing)
}

/// The axis of the body along which an axis of the frame lies.
fn axis_of_body(set: &CriticalSet, axis: Axis) -> BodyAxis {
    let rows = &set.frame.to_body;
    BodyAxis::ALL
        .into_iter()
        .max_by(|&i, &j| rows[i][axis].abs().total_cmp(&rows[j][axis].abs()))
        .unwrap_or(BodyAxis::ALL[0])
}

/// What the two sides do not share.
struct Surplus<'a, 'b> {
    /// The diagram of the side that has more.
    side: &'a Arrangement,
    /// The events that only this side has.
    more: &'b [EventLabel],
    /// The events that only the other side has.
    fewer: &'b [EventLabel],
}

/// The labels of each kind.
struct ByKind {
    crossings: Vec<[BranchName; 2]>,
    cusps: Vec<BranchName>,
    pitchforks: Vec<[BranchName; 2]>,
}

impl ByKind {
    fn of(labels: &[EventLabel]) -> Self {
        let mut found = Self { crossings: Vec::new(), cusps: Vec::new(), pitchforks: Vec::new() };
        for label in labels {
            match *label {
                EventLabel::Crossing(branches) => found.crossings.push(branches),
                EventLabel::Cusp(branch) => found.cusps.push(branch),
                EventLabel::Pitchfork(branches) => found.pitchforks.push(branches),
            }
        }
        found
    }
}

impl<'a> Surplus<'a, '_> {
    /// The events of the richer side with a label of its surplus that is wanted.
    fn events(&self, wanted: impl Fn(&EventLabel) -> bool) -> Vec<Event> {
        let is_wanted = |event: &&Event| {
            let label = label(self.side, event);
            wanted(&label) && self.more.contains(&label)
        };
        self.side.events.iter().filter(is_wanted).copied().collect()
    }

    fn cusps(&self) -> Vec<Event> {
        self.events(|label| matches!(label, EventLabel::Cusp(_)))
    }

    fn crossings(&self) -> Vec<Event> {
        self.events(|label| matches!(label, EventLabel::Crossing(_)))
    }

    fn branch(&self, curve: CurveId) -> Branch {
        self.side.set.curves[curve].branch
    }

    fn name(&self, branch: Branch) -> BranchName {
        BranchName::of(&self.side.set.frame, branch)
    }

    fn near(&self, event: &Event) -> Neighbourhood {
        Neighbourhood::of(&self.side.set.frame, event.x, event.h)
    }

    fn found(&self, kind: BorderEventKind, events: Vec<Event>, vanishing: Vanishing) -> Finding<'a> {
        Finding { kind, group: EventGroup::new(self.side, events), vanishing }
    }
}

/// What gives birth to the events of one side.
fn creation<'a>(surplus: &Surplus<'a, '_>) -> Finding<'a> {
    let (more, fewer) = (ByKind::of(surplus.more), ByKind::of(surplus.fewer));
    if let Some(found) = pitchforks(&more, &fewer) {
        return found;
    }
    let nothing_lost = fewer.cusps.is_empty() && fewer.crossings.is_empty();
    let found = match (more.cusps.len(), more.crossings.len()) {
        _ if !nothing_lost => None,
        (2, _) => Some(swallowtail(surplus, more.cusps)),
        (1, _) => cusp_at_pitchfork(surplus, more.cusps[0]),
        (0, 2) => two_crossings(surplus),
        (0, 1) => Some(one_crossing(surplus, more.crossings[0])),
        _ => None,
    };
    found.unwrap_or_else(|| Finding::nowhere(BorderEventKind::Several, Vanishing::Nothing))
}

/// Pitchforks differ, as they do where the body is special.
fn pitchforks<'a>(more: &ByKind, fewer: &ByKind) -> Option<Finding<'a>> {
    let kind = match (&fewer.pitchforks[..], &more.pitchforks[..]) {
        ([], []) => return None,
        ([from, ..], [to, ..]) if fewer.pitchforks.len() == more.pitchforks.len() => {
            BorderEventKind::PitchforkAtInfinity { from: *from, to: *to }
        }
        _ => BorderEventKind::Several,
    };
    Some(Finding::nowhere(kind, Vanishing::Nothing))
}

fn swallowtail<'a>(surplus: &Surplus<'a, '_>, mut branches: Vec<BranchName>) -> Finding<'a> {
    branches.dedup();
    let pair = nearest(&surplus.cusps()).map_or_else(Vec::new, Vec::from);
    let vanishing = pair.first().map_or(Vanishing::Nothing, |cusp| match surplus.branch(cusp.change.curves()[0]) {
        Branch::Generic(interval) => Vanishing::Swallowtail { interval, middle: None },
        _ => Vanishing::Nothing,
    });
    surplus.found(BorderEventKind::Swallowtail { branches }, pair, vanishing)
}

/// One new cusp: that of a symmetric pair has come out of its pitchfork.
fn cusp_at_pitchfork<'a>(surplus: &Surplus<'a, '_>, pair: BranchName) -> Option<Finding<'a>> {
    let events = surplus.cusps();
    let Branch::Symmetric(axis) = surplus.branch(events.first()?.change.curves()[0]) else { return None };
    Some(surplus.found(BorderEventKind::CuspAtPitchfork { pair }, events, Vanishing::Excess(axis)))
}

/// Two new crossings: a cusp has passed through a curve. That two curves touch is no cause: none do (Theorem 4.12 of
/// docs/mathematics.md).
fn two_crossings<'a>(surplus: &Surplus<'a, '_>) -> Option<Finding<'a>> {
    let [p, q] = nearest(&surplus.crossings())?;
    let (one, two) = (p.change.curves(), q.change.curves());
    let shared = one.iter().find(|curve| two.contains(curve)).copied();
    let own: Vec<CurveId> = one.iter().chain(&two).filter(|c| !(one.contains(c) && two.contains(c))).copied().collect();
    let cusp = surplus.side.events.iter().find(|event| {
        matches!(event.change, Change::Birth(_) | Change::Death(_))
            && own.iter().all(|curve| event.change.curves().contains(curve))
    });
    let (cusp, through) = cusp.zip(shared).filter(|_| !own.is_empty())?;
    let (branch, curve) = (surplus.branch(cusp.change.curves()[0]), surplus.branch(through));
    let kind = BorderEventKind::CuspOnCurve {
        cusp: surplus.name(branch),
        encounter: Encounter::PassesThrough,
        curves: vec![surplus.name(curve)],
    };
    let event = EventOfBranches::Cusp { branch, near: surplus.near(cusp) };
    let vanishing = Vanishing::Height { event, curve, height: 0.0 };
    Some(surplus.found(kind, vec![*cusp, p, q], vanishing))
}

fn one_crossing<'a>(surplus: &Surplus<'a, '_>, branches: [BranchName; 2]) -> Finding<'a> {
    at_pitchfork(surplus)
        .unwrap_or_else(|| Finding::nowhere(BorderEventKind::CrossingAtTheEdge { branches }, Vanishing::Nothing))
}

/// A new crossing of a pair beside the pitchfork of this pair: the pitchfork has passed through the other curve.
fn at_pitchfork<'a>(surplus: &Surplus<'a, '_>) -> Option<Finding<'a>> {
    /// Further apart they have nothing to do with each other.
    const NEAR: f64 = 1e-3;
    let branch = |c: CurveId| surplus.branch(c);
    let mut best: Option<(f64, Event, Event, CurveId)> = None;
    for crossing in surplus.crossings() {
        for event in &surplus.side.events {
            let (Change::Open { pair, .. } | Change::Close { pair, .. }) = event.change else { continue };
            let apart = distance(&crossing, event);
            let shares = crossing.change.curves().iter().any(|&c| branch(c) == branch(pair));
            if shares && best.is_none_or(|(least, _, _, _)| apart < least) {
                best = Some((apart, crossing, *event, pair));
            }
        }
    }
    let (_, crossing, event, pair) = best.filter(|(apart, _, _, _)| *apart < NEAR)?;
    let Branch::Symmetric(axis) = branch(pair) else { return None };
    let curve = crossing.change.curves().into_iter().map(branch).find(|other| *other != branch(pair))?;
    let EventLabel::Pitchfork(pitchfork) = label(surplus.side, &event) else { return None };
    let (encounter, curves) = (Encounter::PassesThrough, vec![surplus.name(curve)]);
    let kind = BorderEventKind::PitchforkOnCurve { pitchfork, encounter, curves };
    let vanishing = Vanishing::Height { event: EventOfBranches::Pitchfork(axis), curve, height: 0.0 };
    Some(surplus.found(kind, vec![event, crossing], vanishing))
}
