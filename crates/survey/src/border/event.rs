//! What happens at a border: the difference between two diagrams on its two sides.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bisection::Seen;
use super::refine::{Place, Witness};
use top::atlas::Atlas;
use top::curves::{Branch, BranchName, CriticalSet, CurveId, CurveName};
use top::diagram::{Arrangement, Change, Event, EventId};

/// Kinds of borders, all of codimension one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BorderEventKind {
    /// Two cusps of one branch, and with them a crossing, are born or vanish.
    Swallowtail,
    /// Three curves meet in one point.
    TriplePoint,
    /// A cusp passes through another curve.
    CuspOnCurve,
    /// A pitchfork passes through another curve, or two pitchforks or crossings on one curve change places.
    PitchforkOnCurve,
    /// Two curves touch: two crossings are born or vanish.
    Tangency,
    /// The cusp of a symmetric pair reaches its pitchfork.
    CuspAtPitchfork,
    /// A pitchfork leaves to infinity on one curve and comes back on another: two moments of inertia pass each other.
    PitchforkAtInfinity,
    /// A symmetry is lost: where some r_i leaves 0, pitchforks open into cusps.
    SymmetryBroken,
    /// J_r passes the middle moment of inertia: crossings of the pole lines go to infinity and come back.
    PoleLinesAtInfinity,
    /// A crossing comes from, or goes to, l = 0 or infinity.
    CrossingAtTheEdge,
    /// Several of these at once, or something else; the lists tell.
    Other,
}

/// What happens at a border.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BorderEvent {
    /// Which kind.
    pub kind: BorderEventKind,
    /// In words.
    pub text: String,
    /// The curves that take part, by their names on the side that has more of them.
    pub curves: Vec<String>,
    /// Energy of the place where it happens, if it is a place.
    pub h: Option<f64>,
    /// Vertical angular momentum there.
    pub l: Option<f64>,
    /// Events that only the lower side of the border has.
    pub vanish: Vec<String>,
    /// Events that only the upper side has.
    pub appear: Vec<String>,
}

fn kind_name(change: &Change) -> &'static str {
    match change {
        Change::Birth(_) | Change::Death(_) => "cusp",
        Change::Open { .. } | Change::Close { .. } => "pitchfork",
        Change::Swap(_) => "crossing",
    }
}

/// The branches that meet in an event, by name, each once for each curve.
fn branches(set: &CriticalSet, change: &Change) -> Vec<String> {
    let mut curves = change.curves();
    if let Change::Open { through, pair } | Change::Close { through, pair } = change {
        curves = vec![through[0], *pair];
    }
    if let Change::Birth([one, _]) | Change::Death([one, _]) = change {
        curves = vec![*one];
    }
    let mut names: Vec<String> =
        curves.into_iter().map(|c| BranchName::of(&set.frame, set.curves[c].branch).to_string()).collect();
    names.sort();
    names
}

fn label(set: &CriticalSet, change: &Change) -> String {
    format!("{} of {}", kind_name(change), branches(set, change).join(" and "))
}

/// All events of an atlas by name, such as `crossing of L- and S3`, with their momenta in the body's units.
#[must_use]
pub fn named_events(atlas: &Atlas) -> Vec<(String, f64)> {
    let arrangement = atlas.arrangement();
    let unit = arrangement.set.frame.momentum_unit;
    let named = |event: &Event| (label(&arrangement.set, &event.change), (2.0 * event.x).sqrt() * unit);
    arrangement.events.iter().map(named).collect()
}

/// The events of each label.
fn by_label(arrangement: &Arrangement) -> BTreeMap<String, Vec<Event>> {
    let mut found: BTreeMap<String, Vec<Event>> = BTreeMap::new();
    for event in &arrangement.events {
        found.entry(label(&arrangement.set, &event.change)).or_default().push(*event);
    }
    found
}

/// The labels that `one` has more often than `other`.
fn surplus(one: &BTreeMap<String, Vec<Event>>, other: &BTreeMap<String, Vec<Event>>) -> Vec<String> {
    let mut found = Vec::new();
    for (label, events) in one {
        let also = other.get(label).map_or(0, Vec::len);
        found.extend(std::iter::repeat_n(label.clone(), events.len().saturating_sub(also)));
    }
    found
}

/// A few events of one side that happen together.
struct Group<'a> {
    side: &'a Arrangement,
    events: Vec<Event>,
}

/// Distance of two events in units in which the events of ordinary diagrams are about 1 apart.
fn distance(p: &Event, q: &Event) -> f64 {
    let scale = |a: f64, b: f64| a.abs().max(b.abs()).max(1e-300);
    let dx = (p.x - q.x).abs() / scale(p.x, q.x);
    let dh = (p.h - q.h).abs() / scale(p.h, q.h).max(1.0);
    dx.max(dh)
}

/// What tells the two sides apart.
pub(super) fn between(low: &Seen, high: &Seen) -> (BorderEvent, Witness) {
    let (below, above) = (low.atlas.arrangement(), high.atlas.arrangement());
    let (labels_below, labels_above) = (by_label(below), by_label(above));
    let vanish = surplus(&labels_below, &labels_above);
    let appear = surplus(&labels_above, &labels_below);
    let offsets = [below, above].map(|side| side.set.frame.offset[1]);
    let (kind, text, group, witness) = if vanish.is_empty() && appear.is_empty() {
        exchange(below)
    } else if offsets[0] * offsets[1] < 0.0 && vanish.len() == appear.len() && labels_cross(&vanish, &appear) {
        let axis = branch_axis(&below.set, 1);
        let text = format!("J_r passes A{axis}: crossings of the pole lines go to infinity and come back");
        (BorderEventKind::PoleLinesAtInfinity, text, None, Witness::MiddleMoment)
    } else {
        let (richer, more, fewer) =
            if vanish.len() > appear.len() { (below, &vanish, &appear) } else { (above, &appear, &vanish) };
        creation(richer, more, fewer, std::ptr::eq(richer, above))
    };
    let (curves, h, l) = match &group {
        None => (Vec::new(), None, None),
        Some(group) => {
            let set = &group.side.set;
            let mut curves: Vec<CurveId> = group.events.iter().flat_map(|event| event.change.curves()).collect();
            curves.sort_unstable();
            curves.dedup();
            let n = group.events.len() as f64;
            let x = group.events.iter().map(|event| event.x).sum::<f64>() / n;
            let h = group.events.iter().map(|event| event.h).sum::<f64>() / n;
            let names = curves.into_iter().map(|c| CurveName::of(set, c).to_string()).collect();
            (names, Some(h * set.frame.energy_unit), Some((2.0 * x).sqrt() * set.frame.momentum_unit))
        }
    };
    (BorderEvent { kind, text, curves, h, l, vanish, appear }, witness)
}

/// Only crossings with pole lines differ.
fn labels_cross(vanish: &[String], appear: &[String]) -> bool {
    vanish.iter().chain(appear).all(|label| label.starts_with("crossing") && label.contains(" P"))
}

/// The axis of the body, from 1, along which an axis of the frame lies.
fn branch_axis(set: &CriticalSet, axis: usize) -> usize {
    let rows = &set.frame.to_body;
    1 + (0..3).max_by(|&i, &j| rows[i][axis].abs().total_cmp(&rows[j][axis].abs())).unwrap_or_default()
}

type Named<'a> = (BorderEventKind, String, Option<Group<'a>>, Witness);

impl Group<'_> {
    fn place(&self) -> Option<Place> {
        self.events.first().map(|event| Place::of(&self.side.set.frame, event.x, event.h))
    }
}

/// Both sides have the same events in another order: those that are nearest to each other change places.
fn exchange(side: &Arrangement) -> Named<'_> {
    let branch_set = |event: &Event| branches(&side.set, &event.change);
    let mut best: Option<(f64, EventId, EventId)> = None;
    for (k, event) in side.events.pairs() {
        for (m, other) in side.events.pairs().skip_while(|(m, _)| *m <= k) {
            let shared = branch_set(event).iter().any(|name| branch_set(other).contains(name));
            let apart = distance(event, other);
            if shared && best.is_none_or(|(least, _, _)| apart < least) {
                best = Some((apart, k, m));
            }
        }
    }
    let Some((apart, k, m)) = best else {
        let text = "the regions differ, and no events are near each other".to_owned();
        return (BorderEventKind::Other, text, None, Witness::Nothing);
    };
    let near: Vec<Event> = side
        .events
        .iter()
        .filter(|event| distance(event, &side.events[k]).max(distance(event, &side.events[m])) <= 1e3 * apart + 1e-12)
        .copied()
        .collect();
    let mut names: Vec<String> = near.iter().flat_map(|event| branches(&side.set, &event.change)).collect();
    names.sort();
    names.dedup();
    let pitchfork = near.iter().find(|event| matches!(event.change, Change::Open { .. } | Change::Close { .. }));
    let cusp = near.iter().find(|event| matches!(event.change, Change::Birth(_) | Change::Death(_)));
    let (kind, text) = match (pitchfork, cusp) {
        (Some(event), _) => {
            let own = branches(&side.set, &event.change);
            let others: Vec<String> = names.iter().filter(|name| !own.contains(name)).cloned().collect();
            let what = if others.is_empty() { own.join(" and ") } else { others.join(" and ") };
            (BorderEventKind::PitchforkOnCurve, format!("the pitchfork of {} meets {what}", own.join(" and ")))
        }
        (None, Some(event)) => {
            let own = branches(&side.set, &event.change).join(" and ");
            (BorderEventKind::CuspOnCurve, format!("the cusp of {own} meets {}", names.join(", ")))
        }
        (None, None) => (BorderEventKind::TriplePoint, format!("the curves {} meet in one point", names.join(", "))),
    };
    let witness = exchanged(side, &near).unwrap_or(Witness::Nothing);
    (kind, text, Some(Group { side, events: near }), witness)
}

/// What vanishes where events change places: the height of a third curve over one of them.
fn exchanged(side: &Arrangement, near: &[Event]) -> Option<Witness> {
    let branch = |c: CurveId| side.set.curves[c].branch;
    let place = |event: &Event| Place::of(&side.set.frame, event.x, event.h);
    let (crossing, pair) = near.iter().find_map(|event| match event.change {
        Change::Swap(curves) => Some((event, curves.map(branch))),
        _ => None,
    })?;
    let beside = |own: &[Branch]| pair.into_iter().find(|branch| !own.contains(branch));
    for event in near {
        match event.change {
            Change::Open { through, pair } | Change::Close { through, pair } => {
                let Branch::Symmetric(axis) = branch(pair) else { return None };
                let curve = beside(&[branch(through[0]), branch(pair)])?;
                return Some(Witness::PitchforkOnCurve { axis, curve });
            }
            Change::Birth([one, _]) | Change::Death([one, _]) => {
                let (cusp, near) = (branch(one), place(event));
                return Some(Witness::CuspOnCurve { cusp, curve: beside(&[cusp])?, near });
            }
            Change::Swap(_) => {}
        }
    }
    let curve = near.iter().flat_map(|event| event.change.curves()).map(branch).find(|other| !pair.contains(other))?;
    Some(Witness::CurveOnCrossing { crossing: pair, curve, near: place(crossing) })
}

/// One side has events that the other has not.
fn creation<'a>(side: &'a Arrangement, more: &[String], fewer: &[String], above: bool) -> Named<'a> {
    let of_kind = |labels: &[String], kind: &str| -> Vec<String> {
        labels.iter().filter(|label| label.starts_with(kind)).cloned().collect()
    };
    let count = |kind| [of_kind(more, kind).len(), of_kind(fewer, kind).len()];
    let events_of = |labels: &[String]| -> Vec<Event> {
        side.events.iter().filter(|event| labels.contains(&label(&side.set, &event.change))).copied().collect()
    };
    let ([cusps, lost_cusps], [forks, lost_forks]) = (count("cusp"), count("pitchfork"));
    let [crossings, lost_crossings] = count("crossing");
    let subject = |labels: &[String]| {
        let mut names: Vec<&str> = labels.iter().filter_map(|label| label.split_once(" of ").map(|(_, n)| n)).collect();
        names.dedup();
        names.join(", ")
    };
    if forks + lost_forks > 0 {
        let moments_pass = forks == lost_forks;
        return if moments_pass {
            let names = |labels: &[String]| {
                let label = labels.iter().find(|label| label.starts_with("pitchfork")).cloned().unwrap_or_default();
                label.trim_start_matches("pitchfork of ").to_owned()
            };
            let text = format!("the pitchfork of {} goes through infinity to {}", names(fewer), names(more));
            (BorderEventKind::PitchforkAtInfinity, text, None, Witness::SpecialBody)
        } else {
            let text = "the symmetry of a pair is broken: its pitchfork opens into a cusp".to_owned();
            (BorderEventKind::SymmetryBroken, text, None, Witness::SpecialBody)
        };
    }
    let fewer_none = lost_cusps + lost_crossings == 0;
    if cusps == 2 && fewer_none {
        let labels = of_kind(more, "cusp");
        let pair = nearest(&events_of(&labels));
        let text = format!("a swallowtail is born on branch {}", subject(&labels));
        let group = group(side, pair);
        let branch = group.as_ref().map(|group| side.set.curves[group.events[0].change.curves()[0]].branch);
        let witness = match (branch, group.as_ref().and_then(Group::place)) {
            (Some(branch), Some(near)) => Witness::TwoCusps { branch, near, above },
            _ => Witness::Nothing,
        };
        return (BorderEventKind::Swallowtail, text, group, witness);
    }
    if cusps == 1 && fewer_none {
        let labels = of_kind(more, "cusp");
        let events = events_of(&labels);
        let branch = events.first().map(|event| side.set.curves[event.change.curves()[0]].branch);
        if let Some(Branch::Symmetric(axis)) = branch {
            let text = format!("the cusp of the pair {} reaches its pitchfork", subject(&labels));
            return (BorderEventKind::CuspAtPitchfork, text, group(side, events), Witness::Excess(axis));
        }
    }
    if cusps == 0
        && crossings == 2
        && fewer_none
        && let Some(found) = two_crossings(side, nearest(&events_of(&of_kind(more, "crossing"))))
    {
        return found;
    }
    if cusps == 0 && crossings == 1 && fewer_none {
        let labels = of_kind(more, "crossing");
        if let Some(found) = at_pitchfork(side, &events_of(&labels)) {
            return found;
        }
        let text = format!("the {} comes from l = 0 or infinity", labels.join(", "));
        return (BorderEventKind::CrossingAtTheEdge, text, None, Witness::Nothing);
    }
    let text = "several events appear and vanish together".to_owned();
    (BorderEventKind::Other, text, None, Witness::Nothing)
}

/// The two of these events that are nearest to each other.
fn nearest(candidates: &[Event]) -> Vec<Event> {
    let mut best: Option<(f64, [Event; 2])> = None;
    for (k, p) in candidates.iter().enumerate() {
        for q in &candidates[k + 1..] {
            if best.is_none_or(|(least, _)| distance(p, q) < least) {
                best = Some((distance(p, q), [*p, *q]));
            }
        }
    }
    best.map(|(_, pair)| pair.to_vec()).unwrap_or_default()
}

/// Two new crossings: a cusp has passed through a curve, or two curves touch.
fn two_crossings(side: &Arrangement, pair: Vec<Event>) -> Option<Named<'_>> {
    let [p, q] = pair[..] else { return None };
    let branch = |c: CurveId| side.set.curves[c].branch;
    let name = |c: CurveId| BranchName::of(&side.set.frame, branch(c));
    let (one, two) = (p.change.curves(), q.change.curves());
    let shared = one.iter().find(|curve| two.contains(curve)).copied();
    let own: Vec<CurveId> = one.iter().chain(&two).filter(|c| !(one.contains(c) && two.contains(c))).copied().collect();
    let cusp = side.events.iter().find(|event| {
        matches!(event.change, Change::Birth(_) | Change::Death(_))
            && own.iter().all(|curve| event.change.curves().contains(curve))
    });
    if let (Some(cusp), Some(through), false) = (cusp, shared, own.is_empty()) {
        let text = format!("the {} passes through {}", label(&side.set, &cusp.change), name(through));
        let near = Place::of(&side.set.frame, cusp.x, cusp.h);
        let witness = Witness::CuspOnCurve { cusp: branch(cusp.change.curves()[0]), curve: branch(through), near };
        return Some((BorderEventKind::CuspOnCurve, text, group(side, vec![*cusp, p, q]), witness));
    }
    let text = format!("the curves {} touch", branches(&side.set, &p.change).join(" and "));
    Some((BorderEventKind::Tangency, text, group(side, pair), Witness::Nothing))
}

/// A new crossing of a pair beside the pitchfork of this pair: the pitchfork has passed through the other curve.
fn at_pitchfork<'a>(side: &'a Arrangement, new: &[Event]) -> Option<Named<'a>> {
    let branch = |c: CurveId| side.set.curves[c].branch;
    let mut best: Option<(f64, Event, Event, CurveId)> = None;
    for crossing in new {
        for event in &side.events {
            let (Change::Open { pair, .. } | Change::Close { pair, .. }) = event.change else { continue };
            let apart = distance(crossing, event);
            let shares = crossing.change.curves().iter().any(|&c| branch(c) == branch(pair));
            if shares && best.is_none_or(|(least, _, _, _)| apart < least) {
                best = Some((apart, *crossing, *event, pair));
            }
        }
    }
    let (_, crossing, pitchfork, pair) = best.filter(|(apart, _, _, _)| *apart < 1e-3)?;
    let Branch::Symmetric(axis) = branch(pair) else { return None };
    let curve = crossing.change.curves().into_iter().map(branch).find(|other| *other != branch(pair))?;
    let text = format!(
        "the {} passes through {}",
        label(&side.set, &pitchfork.change),
        BranchName::of(&side.set.frame, curve)
    );
    let witness = Witness::PitchforkOnCurve { axis, curve };
    Some((BorderEventKind::PitchforkOnCurve, text, group(side, vec![pitchfork, crossing]), witness))
}

fn group(side: &Arrangement, events: Vec<Event>) -> Option<Group<'_>> {
    if events.is_empty() { None } else { Some(Group { side, events }) }
}
