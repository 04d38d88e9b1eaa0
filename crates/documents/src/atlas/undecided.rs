//! What an atlas leaves undecided, in words.

use bifdiag_diagram::arrangement::Undecided;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::{BranchName, CurveId, CurveName};
use bifdiag_schema::UndecidedDocument;

/// What the arrangement left undecided.
pub(super) fn documents(atlas: &Atlas) -> Vec<UndecidedDocument> {
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
