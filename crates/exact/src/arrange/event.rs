//! Points at which curves meet.
//!
//! What is not proved.
//!
//! Cusps, pitchforks and meetings with pole lines as events.

use crate::curves::Curves;
use crate::evaluator::{Evaluator, Passage};
use crate::family::Half;
use crate::id::MeetingId;
use crate::polar::{self, Meeting};
use bifdiag_equilibria::curves::{CurveId, CuspId, End, PitchforkId};
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::{Id, Table};
use bifdiag_numbers::wide::Interval384;
use dashu_ratio::RBig;

/// What an event is.
#[derive(Clone, Debug)]
pub(crate) enum EventSource {
    Cusp(CuspId),
    Pitchfork(PitchforkId),
    Pole(MeetingId),
    /// Crossing of these two.
    Crossing([CurveId; 2]),
}

/// A point at which curves meet; several sources when they are proved to be the same point.
#[derive(Clone, Debug)]
pub(crate) struct Event {
    pub sources: Vec<EventSource>,
    pub curves: Vec<CurveId>,
    /// x lies strictly between, or at, these.
    pub x: [RBig; 2],
    pub h: [f64; 2],
}

impl Event {
    /// x, rounded.
    pub fn x_middle(&self) -> f64 {
        let [from, to] = self.x.each_ref().map(|x| x.to_f64().value());
        0.5 * (from + to)
    }

    /// h, rounded.
    pub fn h_middle(&self) -> f64 {
        0.5 * (self.h[0] + self.h[1])
    }
}

/// Ends of curves through which another curve is proved to pass.
pub(super) fn known_meetings(curves: &Curves, events: &[Event]) -> Vec<Passage> {
    let mut known = Vec::new();
    for event in events.iter().filter(|event| event.sources.len() > 1) {
        for &curve in &event.curves {
            for side in [0, 1] {
                let ends_here = event.sources.iter().any(|source| match source {
                    EventSource::Cusp(number) => curves.list[curve].ends[side] == End::Cusp(*number),
                    EventSource::Pitchfork(number) => curves.list[curve].ends[side] == End::Pitchfork(*number),
                    _ => false,
                });
                if ends_here {
                    known.extend(event.curves.iter().filter(|&&other| other != curve).map(|&other| Passage {
                        curve,
                        side,
                        other,
                    }));
                }
            }
        }
    }
    known
}

/// Bounds of a height, moved away from 0 if they are 0 within rounding, so that any arithmetic can confirm them.
pub(super) fn confirmable([low, high]: [f64; 2]) -> [f64; 2] {
    const LEAST: f64 = 1e-50;
    [if low.abs() < LEAST { -LEAST } else { low }, if high.abs() < LEAST { LEAST } else { high }]
}

pub(super) fn crossing_event<E: Enclosure>(evaluator: &Evaluator<'_, E>, pair: [CurveId; 2], x: &[RBig; 2]) -> Event {
    // h rises with x.
    let height = |x: &RBig| {
        let point = evaluator.point(pair[0], &E::rational(x, evaluator.c.precision));
        point.map_or([f64::NEG_INFINITY, f64::INFINITY], |point| point.h().bounds())
    };
    let h = [height(&x[0])[0], height(&x[1])[1]];
    Event { sources: vec![EventSource::Crossing(pair)], curves: pair.to_vec(), x: x.clone(), h: confirmable(h) }
}

/// Why nothing more is proved.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Undecided {
    /// Roots that cannot be separated.
    Roots,
    /// A cusp on a pitchfork, or a degenerate point of the generic family.
    Degenerate,
    /// The order of two curves.
    Pair { curves: [CurveId; 2], x: [f64; 2] },
    /// Two events on a common curve.
    Events { curves: Vec<CurveId>, x: [f64; 2] },
    /// The order over one abscissa.
    Order { x: f64 },
    /// Orders on both sides of an event do not fit it.
    Gluing { x: f64 },
}

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
        events.push(event(EventSource::Cusp(number), cusp.curves.to_vec(), &state.x, &state.h())?);
    }
    for (number, fork) in curves.pitchforks.pairs() {
        let state = evaluator.state(Half::Over { group: fork.group }, &evaluator.c.small(0));
        let list = vec![fork.through[0], fork.through[1], fork.pair];
        events.push(event(EventSource::Pitchfork(number), list, &state.x, &state.h())?);
    }
    for (number, meeting) in meetings.pairs() {
        let state = evaluator.state(meeting.place.half, &evaluator.place(&meeting.place));
        let mut list = meeting.curves.clone();
        let mut onto = meeting.end;
        list.extend(line_at(evaluator, meeting, &state.x, &mut onto)?);
        // The events of cusps and pitchforks come first.
        let place = match onto {
            Some(End::Cusp(cusp)) => Some(cusp.index()),
            Some(End::Pitchfork(fork)) => Some(curves.cusps.len() + fork.index()),
            _ => None,
        };
        if let Some(place) = place {
            let target = &mut events[place];
            target.sources.push(EventSource::Pole(number));
            for curve in list {
                if !target.curves.contains(&curve) {
                    target.curves.push(curve);
                }
            }
        } else {
            events.push(event(EventSource::Pole(number), list, &state.x, &state.h())?);
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
