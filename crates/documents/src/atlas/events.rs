//! Events of an atlas document, and what the arrangement leaves undecided.

use bifdiag_diagram::arrangement::{Change, Undecided};
use bifdiag_diagram::atlas::{Atlas, Window};
use bifdiag_equilibria::curves::{BranchName, CurveId, CurveName};
use bifdiag_schema::{EventDocument, EventKind, UndecidedDocument};

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

/// What the arrangement left undecided, in words.
pub(super) fn undecided(atlas: &Atlas) -> Vec<UndecidedDocument> {
    let arrangement = atlas.arrangement();
    let set = &arrangement.set;
    let document = |undecided: &Undecided| {
        let [x, h] = arrangement.place_of(undecided);
        let what = match *undecided {
            Undecided::Contact { .. } => "whether two curves cross, closer than f64 resolves".to_owned(),
            Undecided::Cusps { cluster } => {
                format!("whether branch {} has two more cusps", BranchName::Generic(set.clusters[cluster].interval))
            }
            Undecided::Simultaneous { .. } => "the order of two events closer than f64 resolves".to_owned(),
            Undecided::Order { .. } => "the order of the curves".to_owned(),
        };
        let name = |curve: CurveId| CurveName::of(set, curve).to_string();
        let curves = arrangement.curves_of(undecided).into_iter().map(name).collect();
        UndecidedDocument { what, l: atlas.momentum(x), h: atlas.energy(h), curves }
    };
    arrangement.undecided.iter().map(document).collect()
}
