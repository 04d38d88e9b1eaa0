//! Events of a diagram by what meets in them.

use std::fmt;

use bifdiag_diagram::arrangement::{Change, Event};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::{BranchName, CriticalSet, CurveId};

/// An event by its kind and the branches that meet in it; the two diagrams beside a border are compared by these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EventLabel {
    /// Two branches cross.
    Crossing([BranchName; 2]),
    /// A branch turns.
    Cusp(BranchName),
    /// A pair branches off another branch.
    Pitchfork([BranchName; 2]),
}

impl EventLabel {
    /// The label of an event. Two branches stand in the order of their names.
    #[must_use]
    pub fn of(set: &CriticalSet, change: &Change) -> Self {
        let name = |curve: CurveId| BranchName::of(&set.frame, set.curves[curve].branch);
        match *change {
            Change::Birth([one, _]) | Change::Death([one, _]) => Self::Cusp(name(one)),
            Change::Open { through, pair } | Change::Close { through, pair } => {
                Self::Pitchfork(in_order([name(through[0]), name(pair)]))
            }
            Change::Swap(curves) => Self::Crossing(in_order(curves.map(name))),
        }
    }

    /// The branches that meet.
    #[must_use]
    pub fn branches(&self) -> &[BranchName] {
        match self {
            Self::Crossing(branches) | Self::Pitchfork(branches) => branches,
            Self::Cusp(branch) => std::slice::from_ref(branch),
        }
    }

    /// True for a crossing with a pole line.
    pub(super) fn meets_pole_line(&self) -> bool {
        matches!(self, Self::Crossing(branches) if branches.iter().any(|branch| matches!(branch, BranchName::Pole(_))))
    }
}

impl fmt::Display for EventLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = match self {
            Self::Crossing(_) => "crossing",
            Self::Cusp(_) => "cusp",
            Self::Pitchfork(_) => "pitchfork",
        };
        write!(f, "{kind} of {}", joined(self.branches(), " and "))
    }
}

/// In the order of the names as texts, in which people look for them.
pub(super) fn sort_by_text<T: fmt::Display>(names: &mut [T]) {
    names.sort_by_cached_key(T::to_string);
}

fn in_order(mut branches: [BranchName; 2]) -> [BranchName; 2] {
    sort_by_text(&mut branches);
    branches
}

/// Names with something between them.
pub(super) fn joined<T: fmt::Display>(names: &[T], between: &str) -> String {
    names.iter().map(T::to_string).collect::<Vec<_>>().join(between)
}

/// All events of an atlas with their momenta in the body's units.
#[must_use]
pub fn named_events(atlas: &Atlas) -> Vec<(EventLabel, f64)> {
    let arrangement = atlas.arrangement();
    let unit = arrangement.set.frame.momentum_unit;
    let named = |event: &Event| (EventLabel::of(&arrangement.set, &event.change), (2.0 * event.x).sqrt() * unit);
    arrangement.events.iter().map(named).collect()
}
