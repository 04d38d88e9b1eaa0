//! Borders at which both sides have the same events in another order.

use super::event::{BorderEventKind, Encounter};
use super::group::{Finding, Group, distance, label};
use super::label::{EventLabel, sort_by_text};
use super::vanishing::{Neighbourhood, Vanishing};
use bifdiag_diagram::arrangement::{Arrangement, Change, Event};
use bifdiag_equilibria::curves::{Branch, BranchName, CurveId, Pole};

/// The events that are nearest to each other change places.
pub(super) fn exchange(side: &Arrangement) -> Finding<'_> {
    let Some(near) = nearest_cluster(side) else {
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
        (Some(pitchfork), _) => {
            let others: Vec<BranchName> = branches.into_iter().filter(|name| !pitchfork.contains(name)).collect();
            let curves = if others.is_empty() { pitchfork.to_vec() } else { others };
            BorderEventKind::PitchforkOnCurve { pitchfork, encounter, curves }
        }
        (None, Some(cusp)) => BorderEventKind::CuspOnCurve { cusp, encounter, curves: branches },
        (None, None) => BorderEventKind::TriplePoint { branches },
    };
    let vanishing = exchanged(side, &near).unwrap_or(Vanishing::Nothing);
    Finding { kind, group: Group::new(side, near), vanishing }
}

/// The two events with a common branch that are nearest to each other, and those that are as near to both.
fn nearest_cluster(side: &Arrangement) -> Option<Vec<Event>> {
    let labels: Vec<EventLabel> = side.events.iter().map(|event| label(side, event)).collect();
    let mut best: Option<(f64, [Event; 2])> = None;
    for (k, event) in side.events.iter().enumerate() {
        for (m, other) in side.events.iter().enumerate().skip(k + 1) {
            let labels = [labels[k], labels[m]];
            let shared = labels[0].branches().iter().any(|name| labels[1].branches().contains(name));
            let apart = distance(event, other);
            if shared && !have_both_pole_lines(&labels) && best.is_none_or(|(least, _)| apart < least) {
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

/// What vanishes where events change places: the height of a third curve over one of them.
fn exchanged(side: &Arrangement, near: &[Event]) -> Option<Vanishing> {
    let branch = |c: CurveId| side.set.curves[c].branch;
    let place = |event: &Event| Neighbourhood::of(&side.set.frame, event.x, event.h);
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
                return Some(Vanishing::PitchforkOnCurve { axis, curve });
            }
            Change::Birth([one, _]) | Change::Death([one, _]) => {
                let (cusp, near) = (branch(one), place(event));
                return Some(Vanishing::CuspOnCurve { cusp, curve: beside(&[cusp])?, near });
            }
            Change::Swap(_) => {}
        }
    }
    let curve = near.iter().flat_map(|event| event.change.curves()).map(branch).find(|other| !pair.contains(other))?;
    Some(Vanishing::CurveOnCrossing { crossing: pair, curve, near: place(crossing) })
}
