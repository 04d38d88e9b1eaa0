//! Functions of the body that vanish where its class ends, as its diagram suggests them: the heights of all its events over the
//! curves beneath and above them, the distances of cusps from each other and from pitchforks, and two exact excesses.

use crate::border::{EventOfBranches, Neighbourhood, Vanishing};
use bifdiag_diagram::arrangement::{Arrangement, Change, Event};
use bifdiag_equilibria::curves::{Branch, CriticalSet, CurveId, cusp_pairs};

/// All of them, for a diagram.
pub(super) fn all(arrangement: &Arrangement) -> Vec<Vanishing> {
    let set = &arrangement.set;
    let mut found = vec![Vanishing::MiddleMoment];
    for branch in branches(set) {
        match branch {
            Branch::Generic(interval) => found.extend(
                cusp_pairs(&set.frame, interval)
                    .into_iter()
                    .map(|pair| Vanishing::Swallowtail { interval, middle: Some(pair.middle) }),
            ),
            Branch::Symmetric(axis) => found.extend([Vanishing::Excess(axis), Vanishing::CuspAtPitchfork(axis)]),
            Branch::Axis(_) | Branch::Pole(_) => {}
        }
    }
    for event in &arrangement.events {
        let (over, _) = set.curves_over(event.x);
        found.extend(over.into_iter().filter_map(|curve| height(set, event, curve)));
    }
    found
}

/// The branches of a body, each once.
fn branches(set: &CriticalSet) -> Vec<Branch> {
    let mut found = Vec::new();
    for curve in &set.curves {
        if !found.contains(&curve.branch) {
            found.push(curve.branch);
        }
    }
    found
}

/// The height of an event over a curve that does not take part in it.
fn height(set: &CriticalSet, event: &Event, over: CurveId) -> Option<Vanishing> {
    let own = event.change.curves();
    if own.contains(&over) {
        return None;
    }
    let branch = |c: CurveId| set.curves[c].branch;
    let curve = branch(over);
    let near = Neighbourhood::of(&set.frame, event.x, event.h);
    let height = event.h - set.curves[over].point(&set.frame, event.x).h();
    let event = match event.change {
        Change::Birth([one, _]) | Change::Death([one, _]) => EventOfBranches::Cusp { branch: branch(one), near },
        Change::Open { pair, through } | Change::Close { pair, through } => {
            let Branch::Symmetric(axis) = branch(pair) else { return None };
            if [branch(pair), branch(through[0])].contains(&curve) {
                return None;
            }
            EventOfBranches::Pitchfork(axis)
        }
        // Where three curves meet, each two of them cross nearby: one of the three crossings is enough.
        Change::Swap(curves) if curves[0].max(curves[1]) > over => return None,
        Change::Swap(curves) => EventOfBranches::Crossing { branches: curves.map(branch), near },
    };
    Some(Vanishing::Height { event, curve, height })
}
