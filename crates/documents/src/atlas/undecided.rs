//! What an atlas leaves undecided, in words.

use bifdiag_diagram::arrangement::Undecided;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::{BranchName, CurveId, CurveName};
use bifdiag_schema::UndecidedDocument;

/// What the arrangement left undecided.
pub(super) fn documents(atlas: &Atlas) -> Vec<UndecidedDocument> {
    let set = &atlas.arrangement().set;
    let name = |c: CurveId| CurveName::of(set, c).to_string();
    let mut found: Vec<UndecidedDocument> = Vec::new();
    for undecided in &atlas.arrangement().undecided {
        found.push(match *undecided {
            Undecided::Contact { curves, x } => {
                // Of a range that is open or nearly so, the end where h is a number.
                let at = match x {
                    [from, to] if to <= 4.0 * from => from.midpoint(to),
                    [from, _] if from > 0.0 => from,
                    [_, to] => to.min(1.0),
                };
                let point = set.curves[curves[0]].point(&set.frame, at);
                // Where x² is beyond f64, h = x/J to every digit.
                let h = if point.h().is_finite() { point.h() } else { at * point.slope() };
                UndecidedDocument {
                    what: "whether two curves cross, closer than f64 resolves".to_owned(),
                    l: atlas.momentum(at),
                    h: atlas.energy(h),
                    curves: curves.map(name).to_vec(),
                }
            }
            Undecided::Cusps { cluster } => {
                let cluster = &set.clusters[cluster];
                UndecidedDocument {
                    what: format!("whether branch {} has two more cusps", BranchName::Generic(cluster.interval)),
                    l: atlas.momentum(cluster.point.x),
                    h: atlas.energy(cluster.point.h()),
                    curves: Vec::new(),
                }
            }
            Undecided::Simultaneous { events } => {
                let event = &atlas.arrangement().events[events[0]];
                let mut curves: Vec<CurveId> =
                    events.iter().flat_map(|&e| atlas.arrangement().events[e].change.curves()).collect();
                curves.sort_unstable();
                curves.dedup();
                UndecidedDocument {
                    what: "the order of two events closer than f64 resolves".to_owned(),
                    l: atlas.momentum(event.x),
                    h: atlas.energy(event.h),
                    curves: curves.into_iter().map(name).collect(),
                }
            }
            Undecided::Order { event } => {
                let event = &atlas.arrangement().events[event];
                UndecidedDocument {
                    what: "the order of the curves".to_owned(),
                    l: atlas.momentum(event.x),
                    h: atlas.energy(event.h),
                    curves: event.change.curves().into_iter().map(name).collect(),
                }
            }
        });
    }
    found
}
