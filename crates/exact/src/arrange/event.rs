//! Points at which curves meet.

use dashu_ratio::RBig;

use crate::curves::Curves;
use crate::id::MeetingId;
use crate::point::{Evaluator, Passage};
use bifdiag_equilibria::curves::{CurveId, CuspId, End, PitchforkId};
use bifdiag_numbers::enclosure::Enclosure;

/// What an event is.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    Cusp(CuspId),
    Pitchfork(PitchforkId),
    Pole(MeetingId),
    /// Crossing of these two.
    Crossing([CurveId; 2]),
}

/// A point at which curves meet; several sources when they are proved to be the same point.
#[derive(Clone, Debug)]
pub(crate) struct Event {
    pub sources: Vec<Source>,
    pub curves: Vec<CurveId>,
    /// x lies strictly between, or at, these.
    pub x: [RBig; 2],
    pub h: [f64; 2],
}

/// Ends of curves through which another curve is proved to pass.
pub(super) fn known_meetings(curves: &Curves, events: &[Event]) -> Vec<Passage> {
    let mut known = Vec::new();
    for event in events.iter().filter(|event| event.sources.len() > 1) {
        for &curve in &event.curves {
            for side in [0, 1] {
                let ends_here = event.sources.iter().any(|source| match source {
                    Source::Cusp(number) => curves.list[curve].ends[side] == End::Cusp(*number),
                    Source::Pitchfork(number) => curves.list[curve].ends[side] == End::Pitchfork(*number),
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

/// Bounds of a height, from which those that are 0 but for rounding are moved away: any arithmetic can confirm them then.
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
    Event { sources: vec![Source::Crossing(pair)], curves: pair.to_vec(), x: x.clone(), h: confirmable(h) }
}
