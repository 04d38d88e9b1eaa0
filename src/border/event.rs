//! What happens at a border: the difference between two diagrams on its two sides.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bisection::Seen;
use crate::arrangement::{Arrangement, Change, Event};
use crate::atlas::{branch_name, curve_name};
use crate::equilibria::{Branch, CriticalSet};

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
    /// The curves that take part, by their names on the side named in `side`.
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
        curves.into_iter().map(|c| branch_name(&set.frame, set.curves[c].branch)).collect();
    names.sort();
    names
}

fn label(set: &CriticalSet, change: &Change) -> String {
    format!("{} of {}", kind_name(change), branches(set, change).join(" and "))
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
pub(super) fn between(low: &Seen, high: &Seen) -> BorderEvent {
    let (below, above) = (low.atlas.arrangement(), high.atlas.arrangement());
    let (labels_below, labels_above) = (by_label(below), by_label(above));
    let vanish = surplus(&labels_below, &labels_above);
    let appear = surplus(&labels_above, &labels_below);
    let (kind, text, group) = if vanish.is_empty() && appear.is_empty() {
        exchange(below)
    } else {
        let (richer, more, fewer) =
            if vanish.len() > appear.len() { (below, &vanish, &appear) } else { (above, &appear, &vanish) };
        creation(richer, more, fewer)
    };
    let (curves, h, l) = match &group {
        None => (Vec::new(), None, None),
        Some(group) => {
            let set = &group.side.set;
            let mut curves: Vec<usize> = group.events.iter().flat_map(|event| event.change.curves()).collect();
            curves.sort_unstable();
            curves.dedup();
            let n = group.events.len() as f64;
            let x = group.events.iter().map(|event| event.x).sum::<f64>() / n;
            let h = group.events.iter().map(|event| event.h).sum::<f64>() / n;
            let names = curves.into_iter().map(|c| curve_name(set, c)).collect();
            (names, Some(h * set.frame.energy_unit), Some((2.0 * x).sqrt() * set.frame.momentum_unit))
        }
    };
    BorderEvent { kind, text, curves, h, l, vanish, appear }
}

type Named<'a> = (BorderEventKind, String, Option<Group<'a>>);

/// Both sides have the same events in another order: those that are nearest to each other change places.
fn exchange(side: &Arrangement) -> Named<'_> {
    let branch_set = |event: &Event| branches(&side.set, &event.change);
    let mut best: Option<(f64, usize, usize)> = None;
    for (k, event) in side.events.iter().enumerate() {
        for (m, other) in side.events.iter().enumerate().skip(k + 1) {
            let shared = branch_set(event).iter().any(|name| branch_set(other).contains(name));
            let apart = distance(event, other);
            if shared && best.is_none_or(|(least, _, _)| apart < least) {
                best = Some((apart, k, m));
            }
        }
    }
    let Some((apart, k, m)) = best else {
        return (BorderEventKind::Other, "the regions differ, and no events are near each other".to_owned(), None);
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
    (kind, text, Some(Group { side, events: near }))
}

/// One side has events that the other has not.
fn creation<'a>(side: &'a Arrangement, more: &[String], fewer: &[String]) -> Named<'a> {
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
    let nearest = |candidates: &[Event]| -> Vec<Event> {
        let mut best: Option<(f64, [Event; 2])> = None;
        for (k, p) in candidates.iter().enumerate() {
            for q in &candidates[k + 1..] {
                if best.is_none_or(|(least, _)| distance(p, q) < least) {
                    best = Some((distance(p, q), [*p, *q]));
                }
            }
        }
        best.map(|(_, pair)| pair.to_vec()).unwrap_or_default()
    };
    if forks + lost_forks > 0 {
        let moments_pass = forks == lost_forks;
        return if moments_pass {
            let text = format!(
                "the {} goes to infinity and comes back as the {}: two moments of inertia pass each other",
                fewer.iter().find(|label| label.starts_with("pitchfork")).cloned().unwrap_or_default(),
                more.iter().find(|label| label.starts_with("pitchfork")).cloned().unwrap_or_default(),
            );
            (BorderEventKind::PitchforkAtInfinity, text, None)
        } else {
            (BorderEventKind::SymmetryBroken, "a symmetry is lost: pitchforks open into cusps".to_owned(), None)
        };
    }
    let fewer_none = lost_cusps + lost_crossings == 0;
    if cusps == 2 && fewer_none {
        let labels = of_kind(more, "cusp");
        let pair = nearest(&events_of(&labels));
        let text = format!("a swallowtail is born on branch {}", subject(&labels));
        return (BorderEventKind::Swallowtail, text, group(side, pair));
    }
    if cusps == 1 && fewer_none {
        let labels = of_kind(more, "cusp");
        let on_pair = side.events.iter().any(|event| {
            matches!(event.change, Change::Birth(_) | Change::Death(_))
                && labels.contains(&label(&side.set, &event.change))
                && event.change.curves().iter().any(|&c| matches!(side.set.curves[c].branch, Branch::Symmetric(_)))
        });
        if on_pair {
            let text = format!("the cusp of the pair {} reaches its pitchfork", subject(&labels));
            return (BorderEventKind::CuspAtPitchfork, text, group(side, events_of(&labels)));
        }
    }
    if cusps == 0 && crossings == 2 && fewer_none {
        let labels = of_kind(more, "crossing");
        let pair = nearest(&events_of(&labels));
        if let [p, q] = pair[..] {
            let (one, two) = (p.change.curves(), q.change.curves());
            let same = one.iter().all(|curve| two.contains(curve));
            let own: Vec<usize> = one.iter().chain(&two).filter(|c| !(one.contains(c) && two.contains(c))).copied().collect();
            let cusp = side.events.iter().find(|event| {
                matches!(event.change, Change::Birth(_) | Change::Death(_))
                    && own.iter().all(|curve| event.change.curves().contains(curve))
            });
            return match cusp {
                Some(cusp) if !same => {
                    let shared = one.iter().find(|curve| two.contains(curve));
                    let through = shared.map_or_else(String::new, |&c| branch_name(&side.set.frame, side.set.curves[c].branch));
                    let text =
                        format!("the {} passes through {through}", label(&side.set, &cusp.change));
                    (BorderEventKind::CuspOnCurve, text, group(side, vec![p, q, *cusp]))
                }
                _ => {
                    let text = format!("the curves {} touch", subject(&labels));
                    (BorderEventKind::Tangency, text, group(side, pair))
                }
            };
        }
    }
    if cusps == 0 && crossings == 1 && fewer_none {
        let labels = of_kind(more, "crossing");
        let text = format!("the {} comes from l = 0 or infinity", labels.join(", "));
        return (BorderEventKind::CrossingAtTheEdge, text, None);
    }
    let text = "several events appear and vanish together".to_owned();
    (BorderEventKind::Other, text, None)
}

fn group(side: &Arrangement, events: Vec<Event>) -> Option<Group<'_>> {
    if events.is_empty() { None } else { Some(Group { side, events }) }
}
