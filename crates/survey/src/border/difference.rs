//! What tells the two sides of a border apart.

use std::collections::BTreeMap;

use super::creation::{Surplus, creation};
use super::event::{BorderEvent, BorderEventKind};
use super::exchange::exchange;
use super::group::{Finding, label};
use super::label::{EventLabel, sort_by_text};
use super::vanishing::Vanishing;
use bifdiag_body::{Axis, BodyAxis};
use bifdiag_diagram::arrangement::Arrangement;
use bifdiag_equilibria::curves::CriticalSet;

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
pub(super) fn between(below: &Arrangement, above: &Arrangement) -> (BorderEvent, Vanishing) {
    let (counts_below, counts_above) = (counts(below), counts(above));
    let vanish = surplus(&counts_below, &counts_above);
    let appear = surplus(&counts_above, &counts_below);
    let offsets = [below, above].map(|side| side.set.frame.offset[1]);
    let pole_lines_differ = || vanish.iter().chain(&appear).all(EventLabel::meets_pole_line);
    let Finding { kind, group, vanishing } = if vanish.is_empty() && appear.is_empty() {
        exchange(below)
    } else if offsets[0] * offsets[1] < 0.0 && vanish.len() == appear.len() && pole_lines_differ() {
        let kind = BorderEventKind::PoleLinesAtInfinity { axis: axis_of_body(&below.set, Axis::ALL[1]) };
        Finding::nowhere(kind, Vanishing::MiddleMoment)
    } else if vanish.len() > appear.len() {
        creation(&Surplus { side: below, more: &vanish, fewer: &appear, above: false })
    } else {
        creation(&Surplus { side: above, more: &appear, fewer: &vanish, above: true })
    };
    let curves = group.as_ref().map_or_else(Vec::new, super::group::Group::curves);
    let place = group.as_ref().map(super::group::Group::place);
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
