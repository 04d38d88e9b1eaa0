//! What happens at a border, and the events of a diagram by what meets in them.

use std::fmt;

use bifdiag_body::BodyAxis;
use bifdiag_diagram::arrangement::{Change, Event};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::{BranchName, CriticalSet, CurveId, CurveName};
use bifdiag_numbers::decimal::enumerated;

/// What happens at a border.
#[derive(Clone, Debug, PartialEq)]
pub struct BorderEvent {
    /// Which kind.
    pub kind: BorderEventKind,
    /// The curves that take part, by their names on the side that has more of them.
    pub curves: Vec<CurveName>,
    /// Where it happens, if it is a place.
    pub place: Option<EventLocation>,
    /// Events that only the lower side of the border has.
    pub vanish: Vec<EventLabel>,
    /// Events that only the upper side has.
    pub appear: Vec<EventLabel>,
}

/// A place in the (h, l) plane, in the body's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EventLocation {
    /// Energy.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
    /// Estimate of the error of both.
    pub error: f64,
}

/// How an event of one curve meets another curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Encounter {
    /// Both sides have the same events, in another order.
    Meets,
    /// Crossings with the other curve are born or vanish.
    PassesThrough,
}

/// Kinds of borders, in general of codimension one.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum BorderEventKind {
    /// Two cusps, and with them a crossing, are born or vanish.
    Swallowtail {
        /// The branch that has them.
        branches: Vec<BranchName>,
    },
    /// Three curves meet in one point.
    TriplePoint {
        /// Their branches, each once.
        branches: Vec<BranchName>,
    },
    /// A cusp passes through another curve.
    CuspOnCurve {
        /// The branch that has the cusp.
        cusp: BranchName,
        /// How it meets the others.
        encounter: Encounter,
        /// The branches that it meets; those that only change places with it are among them.
        curves: Vec<BranchName>,
    },
    /// A pitchfork passes through another curve, or two pitchforks or crossings on one curve change places.
    PitchforkOnCurve {
        /// The branches of the pitchfork.
        pitchfork: [BranchName; 2],
        /// How it meets the others.
        encounter: Encounter,
        /// The branches that it meets.
        curves: Vec<BranchName>,
    },
    /// The cusp of a symmetric pair reaches its pitchfork.
    CuspAtPitchfork {
        /// The pair, or the circle of an axially symmetric body.
        pair: BranchName,
    },
    /// A pitchfork and a cusp of one of its branches are near each other at the border.
    CuspNearPitchfork {
        /// The branch that has the cusp.
        cusp: BranchName,
        /// The branches of the pitchfork.
        pitchfork: [BranchName; 2],
    },
    /// A pitchfork leaves to infinity on one curve and comes back on another: two moments of inertia pass each other.
    PitchforkAtInfinity {
        /// The branches of the pitchfork of the side with fewer events.
        from: [BranchName; 2],
        /// Those of the side with more.
        to: [BranchName; 2],
    },
    /// Components of r are 0 at the border alone, and with each the body has a symmetry: beside it some of its pitchforks open
    /// into cusps.
    SymmetryBroken {
        /// Which components.
        axes: Vec<BodyAxis>,
    },
    /// Moments of inertia are equal at the border.
    MomentsEqual {
        /// Their axes.
        axes: Vec<BodyAxis>,
    },
    /// r is 0 at the border.
    WeightVanishes,
    /// J_r passes the middle moment of inertia: crossings of the pole lines go to infinity and come back.
    PoleLinesAtInfinity {
        /// The axis of the body with this moment, from 0.
        axis: BodyAxis,
    },
    /// A crossing comes from, or goes to, l = 0 or infinity.
    CrossingAtTheEdge {
        /// Its branches.
        branches: [BranchName; 2],
    },
    /// Several of these at once: see the lists of events.
    Several,
    /// The same events in the same order, none near another, and other regions.
    Unexplained,
}

impl BorderEventKind {
    /// True for what happens where the body is special, and not at a place of the diagrams.
    pub(super) fn is_of_the_body(&self) -> bool {
        matches!(
            self,
            Self::PitchforkAtInfinity { .. }
                | Self::SymmetryBroken { .. }
                | Self::MomentsEqual { .. }
                | Self::WeightVanishes
        )
    }

    /// True for what is concluded only from events that are near each other.
    pub(super) fn is_guess(&self) -> bool {
        match self {
            Self::CuspOnCurve { encounter, .. } | Self::PitchforkOnCurve { encounter, .. } => {
                *encounter == Encounter::Meets
            }
            Self::TriplePoint { .. } | Self::CuspNearPitchfork { .. } => true,
            _ => false,
        }
    }
}

impl fmt::Display for Encounter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if *self == Self::Meets { "meets" } else { "passes through" })
    }
}

impl fmt::Display for BorderEventKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Swallowtail { branches } => {
                write!(f, "a swallowtail is born or vanishes on branch {}", joined(branches, ", "))
            }
            Self::TriplePoint { branches } => write!(f, "curves of {} meet in one point", joined(branches, ", ")),
            Self::CuspOnCurve { cusp, encounter, curves } => {
                write!(f, "the {} {encounter} {}", EventLabel::Cusp(*cusp), joined(curves, ", "))
            }
            Self::PitchforkOnCurve { pitchfork, encounter, curves } => {
                write!(f, "the {} {encounter} {}", EventLabel::Pitchfork(*pitchfork), joined(curves, " and "))
            }
            Self::CuspAtPitchfork { pair } => write!(f, "the cusp of {pair} reaches its pitchfork"),
            Self::CuspNearPitchfork { cusp, pitchfork } => {
                write!(f, "the {} meets the {}", EventLabel::Pitchfork(*pitchfork), EventLabel::Cusp(*cusp))
            }
            Self::PitchforkAtInfinity { from, to } => {
                let [from, to] = [from, to].map(|branches| joined(branches, " and "));
                write!(f, "a pitchfork goes through infinity: on one side it is that of {from}, on the other of {to}")
            }
            Self::SymmetryBroken { axes } => {
                let (are, symmetries) = if axes.len() > 1 { ("are", "symmetries") } else { ("is", "symmetry") };
                write!(f, "{} {are} 0 there: only there the body has the {symmetries}", listed("r", axes))
            }
            Self::MomentsEqual { axes } => write!(f, "the moments {} are equal there", listed("A", axes)),
            Self::WeightVanishes => f.write_str("r is 0 there: the body has no weight"),
            Self::PoleLinesAtInfinity { axis } => {
                write!(f, "J_r passes A{axis}: crossings of the pole lines go to infinity and come back")
            }
            Self::CrossingAtTheEdge { branches } => {
                write!(f, "the {} comes from l = 0 or infinity, or goes there", EventLabel::Crossing(*branches))
            }
            Self::Several => f.write_str("several events appear and vanish together"),
            Self::Unexplained => f.write_str("the regions differ, and no events are near each other"),
        }
    }
}

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
    /// The label of an event. Two branches are in the order of their names.
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
fn joined<T: fmt::Display>(names: &[T], between: &str) -> String {
    names.iter().map(T::to_string).collect::<Vec<_>>().join(between)
}

/// Numbers of axes, such as r1 and r3.
fn listed(letter: &str, axes: &[BodyAxis]) -> String {
    let names: Vec<String> = axes.iter().map(|axis| format!("{letter}{axis}")).collect();
    enumerated(&names)
}

/// An event with its place, in the body's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedEvent {
    /// What meets.
    pub label: EventLabel,
    /// Energy.
    pub h: f64,
    /// Vertical angular momentum.
    pub l: f64,
}

/// All events of an atlas.
#[must_use]
pub fn named_events(atlas: &Atlas) -> Vec<NamedEvent> {
    let arrangement = atlas.arrangement();
    let frame = &arrangement.set.frame;
    let named = |event: &Event| NamedEvent {
        label: EventLabel::of(&arrangement.set, &event.change),
        h: event.h * frame.energy_unit,
        l: (2.0 * event.x).sqrt() * frame.momentum_unit,
    };
    arrangement.events.iter().map(named).collect()
}
