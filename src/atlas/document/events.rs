//! Events of an atlas document.

use super::super::Atlas;
use super::super::names::curve_name;
use super::window;
use crate::arrangement::Change;
use crate::document::{EventDocument, EventKind, WindowDocument};

pub(super) fn documents(atlas: &Atlas, window: Option<&WindowDocument>) -> Vec<EventDocument> {
    let set = &atlas.arrangement.set;
    let events = atlas.arrangement.events.iter().map(|event| {
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
            curves: event.change.curves().into_iter().map(|c| curve_name(set, c)).collect(),
            // dl = dx/l.
            l_error: event.x_error * unit * unit / l,
            h_error: atlas.energy(event.h_error),
            enclosure: None,
        }
    });
    events.filter(|event| window.is_none_or(|window| window::contains(window, event.h, event.l))).collect()
}
