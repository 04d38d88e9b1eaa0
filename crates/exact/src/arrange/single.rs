//! Cusps, pitchforks and meetings with pole lines as events.

use super::event::{Event, Source, confirmable};
use super::undecided::Undecided;
use crate::family::Half;
use crate::id::MeetingId;
use crate::point::Evaluator;
use crate::polar::{self, Meeting};
use bifdiag_equilibria::curves::{CurveId, End};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::{Id, Table};
use bifdiag_numbers::wide::Interval384;

/// Cusps, pitchforks and meetings with pole lines; those that are proved to coincide are one event.
pub(super) fn single_events(
    evaluator: &Evaluator<'_, Interval384>,
    meetings: &Table<MeetingId, Meeting>,
) -> Result<Vec<Event>, Vec<Undecided>> {
    let curves = evaluator.curves;
    let mut events: Vec<Event> = Vec::new();
    let event = |source, list: Vec<CurveId>, x: &Interval384, h: &Interval384| -> Result<Event, Vec<Undecided>> {
        let bounds = x.exact_bounds().ok_or_else(|| vec![Undecided::Roots])?;
        Ok(Event { sources: vec![source], curves: list, x: bounds, h: confirmable(h.bounds()) })
    };
    for (number, cusp) in curves.cusps.pairs() {
        let state = evaluator.state(cusp.place.half, &evaluator.place(&cusp.place));
        events.push(event(Source::Cusp(number), cusp.curves.to_vec(), &state.x, &state.h())?);
    }
    for (number, fork) in curves.pitchforks.pairs() {
        let state = evaluator.state(Half::Over { group: fork.group }, &evaluator.c.small(0));
        let list = vec![fork.through[0], fork.through[1], fork.pair];
        events.push(event(Source::Pitchfork(number), list, &state.x, &state.h())?);
    }
    for (number, meeting) in meetings.pairs() {
        let state = evaluator.state(meeting.place.half, &evaluator.place(&meeting.place));
        let mut list = meeting.curves.clone();
        let mut onto = meeting.end;
        list.extend(line_at(evaluator, meeting, &state.x, &mut onto)?);
        // The events of cusps and pitchforks stand first.
        let place = match onto {
            Some(End::Cusp(cusp)) => Some(cusp.index()),
            Some(End::Pitchfork(fork)) => Some(curves.cusps.len() + fork.index()),
            _ => None,
        };
        if let Some(place) = place {
            let target = &mut events[place];
            target.sources.push(Source::Pole(number));
            for curve in list {
                if !target.curves.contains(&curve) {
                    target.curves.push(curve);
                }
            }
        } else {
            events.push(event(Source::Pole(number), list, &state.x, &state.h())?);
        }
    }
    Ok(events)
}

/// The pole line of a meeting; when r lies on an axis, the piece of the line over x, or the pitchfork that lies there.
fn line_at(
    evaluator: &Evaluator<'_, Interval384>,
    meeting: &Meeting,
    x: &Interval384,
    onto: &mut Option<End>,
) -> Result<Vec<CurveId>, Vec<Undecided>> {
    let curves = evaluator.curves;
    let pieces = polar::line_pieces(curves, meeting.pole);
    let mut at = 0;
    for window in pieces.windows(2) {
        let End::Pitchfork(number) = curves.list[window[0]].ends[1] else { break };
        let limit = evaluator.pitchfork_x(number);
        if limit.is_below(x) {
            at += 1;
        } else if x.is_below(&limit) {
            break;
        } else if polar::meets_pitchfork(evaluator.model, &meeting.place, curves.pitchforks[number].group) {
            *onto = Some(End::Pitchfork(number));
            return Ok(Vec::new());
        } else {
            return Err(vec![Undecided::Events { curves: meeting.curves.clone(), x: x.bounds() }]);
        }
    }
    Ok(vec![pieces[at]])
}
