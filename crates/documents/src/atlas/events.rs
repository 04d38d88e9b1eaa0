//! Events of an atlas document.

use bifdiag_diagram::arrangement::Change;
use bifdiag_diagram::atlas::{Atlas, Window};
use bifdiag_equilibria::curves::CurveName;
use bifdiag_schema::{EventDocument, EventKind};

pub(super) fn documents(atlas: &Atlas, window: Option<&Window>) -> Vec<EventDocument> {
    let set = &atlas.arrangement().set;
    let events = atlas.arrangement().events.iter().map(|event| {
        let kind = match event.change {
            Change::Birth(_) | Change::Death(_) => EventKind::Cusp,
            Change::Open { .. } | Change::Close { .. } => EventKind::Pitchfork,
            Change::Swap(_) => EventKind::Crossing,
        };
        let l = atlas.momentum(event.x);
        let unit = set.frame.momentum_unit;
        EventDocument {
            kind,
            l,
            h: atlas.energy(event.h),
            curves: event.change.curves().into_iter().map(|c| CurveName::of(set, c).to_string()).collect(),
            // dl = dx/l.
            l_error: event.x_error * unit * unit / l,
            h_error: atlas.energy(event.h_error),
            enclosure: None,
        }
    });
    events.filter(|event| window.is_none_or(|window| window.contains(event.h, event.l))).collect()
}
