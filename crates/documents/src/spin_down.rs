//! How a rotation slows down, as a document.

use bifdiag_diagram::arrangement::Change;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::spin_down::{Stretch, Turn, spin_down as way};
use bifdiag_equilibria::curves::{CurveId, CurveName};
use bifdiag_schema::{CommandLine, SlowdownDocument, SlowdownEvent, SpinDownDocument};

use crate::body::{given, head};
use crate::subject::Subject;

/// The way of a rotation from l, in the body's units, on a curve.
#[must_use]
pub fn spin_down(subject: &Subject, command: CommandLine, atlas: &Atlas, from: CurveId, l: f64) -> SpinDownDocument {
    let set = &atlas.arrangement().set;
    let l = l / set.frame.momentum_unit;
    let x = 0.5 * l * l;
    let path = way(atlas.arrangement(), from, x).iter().map(|(stretch, turn)| document(atlas, stretch, turn)).collect();
    SpinDownDocument { head: head(command.json()), body: given(&subject.body), path, part: subject.part.clone() }
}

fn document(atlas: &Atlas, stretch: &Stretch, turn: &Turn) -> SlowdownDocument {
    let set = &atlas.arrangement().set;
    let name = |curve: CurveId| CurveName::of(set, curve).to_string();
    // (h, Ω); at rest the body hangs.
    let at = |x: f64| {
        if x == 0.0 {
            return (0.0 - set.frame.r_norm, 0.0);
        }
        let point = set.curves[stretch.curve].point(&set.frame, x);
        (point.h(), (2.0 * x).sqrt() / point.j)
    };
    let points = stretch.x.map(at);
    let is_cusp = |event| matches!(atlas.arrangement().events[event].change, Change::Birth(_) | Change::Death(_));
    let (event, onto) = match turn {
        Turn::Crossing(_) => (SlowdownEvent::Crossing, vec![stretch.curve]),
        Turn::Onto(_, next) => (SlowdownEvent::Turn, vec![*next]),
        Turn::Fall(event, left) if is_cusp(*event) => (SlowdownEvent::Cusp, left.clone()),
        Turn::Fall(_, left) => (SlowdownEvent::Pitchfork, left.clone()),
        Turn::Lost(left) => (SlowdownEvent::Start, left.clone()),
        Turn::Rest => (SlowdownEvent::Rest, vec![stretch.curve]),
    };
    SlowdownDocument {
        curve: name(stretch.curve),
        l: stretch.x.map(|x| atlas.momentum(x)),
        h: points.map(|(h, _)| atlas.energy(h)),
        omega: points.map(|(_, omega)| omega * set.frame.frequency_unit),
        regions: stretch.regions.map(|region| region.map(|region| region.to_string())),
        event,
        onto: onto.into_iter().map(name).collect(),
    }
}
