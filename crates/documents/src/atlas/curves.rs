//! Curves of an atlas document.

use bifdiag_diagram::atlas::Atlas;
use bifdiag_equilibria::curves::{Branch, BranchName, Curve, CurveId, CurveName, Orbit, Pole, branch_words};
use bifdiag_numbers::table::Table;
use bifdiag_schema::{CurveDocument, CurveKind, TailDocument, UndecidedDocument};

use super::options::DocumentOptions;
use super::stability::Stability;

pub(super) fn documents(
    atlas: &Atlas,
    options: &DocumentOptions,
    stability: &Stability<'_>,
    undecided: &mut Vec<UndecidedDocument>,
) -> Vec<CurveDocument> {
    let set = &atlas.arrangement().set;
    let mut documents: Table<CurveId, CurveDocument> =
        set.curves.ids().map(|c| document(atlas, c, options, stability, undecided)).collect();
    for pole in [Pole::Plus, Pole::Minus] {
        let on_axis: Vec<CurveId> =
            set.curves.ids().filter(|&c| set.curves[c].pole == Some(pole) && set.curves[c].is_critical()).collect();
        if on_axis.is_empty() {
            continue;
        }
        let name = CurveName::Pole(pole).to_string();
        let pieces: Vec<String> = on_axis.iter().map(|&c| CurveName::of(set, c).to_string()).collect();
        for &c in &on_axis {
            documents[c].coincides_with.push(name.clone());
        }
        let words = branch_words(set, Branch::Pole(pole));
        let line = coincident_pole_line(&name, words, &pieces, documents.as_slice());
        documents.push(line);
    }
    documents.into_iter().collect()
}

/// A pole line that runs on critical curves: their union.
fn coincident_pole_line(name: &str, words: String, pieces: &[String], documents: &[CurveDocument]) -> CurveDocument {
    let parts: Vec<&CurveDocument> = documents.iter().filter(|d| pieces.contains(&d.id)).collect();
    CurveDocument {
        id: name.to_owned(),
        kind: if name == "P+" { CurveKind::PolePlus } else { CurveKind::PoleMinus },
        branch: name.to_owned(),
        branch_name: words,
        index: None,
        multiplicity: 1,
        coincides_with: pieces.to_vec(),
        mu_range: None,
        l_range: [Some(0.0), None],
        stability: Vec::new(),
        tail: parts.iter().find_map(|part| part.tail.clone()),
    }
}

fn document(
    atlas: &Atlas,
    number: CurveId,
    options: &DocumentOptions,
    stability: &Stability<'_>,
    undecided: &mut Vec<UndecidedDocument>,
) -> CurveDocument {
    let set = &atlas.arrangement().set;
    let curve = &set.curves[number];
    let [from, to] = curve.x().map(|x| atlas.momentum(x));
    let tail = atlas.tail(number).map(|tail| TailDocument { moment: tail.moment, h_offset: tail.h_offset });
    let mut document = CurveDocument {
        id: CurveName::of(set, number).to_string(),
        kind: kind(curve),
        branch: BranchName::of(&set.frame, curve.branch).to_string(),
        branch_name: branch_words(set, curve.branch),
        index: curve.index,
        multiplicity: if matches!(curve.orbit, Orbit::Pair(_)) { 2 } else { 1 },
        coincides_with: Vec::new(),
        mu_range: atlas.mu_range(number),
        l_range: [Some(from), to.is_finite().then_some(to)],
        stability: Vec::new(),
        tail,
    };
    if options.sees([from, to]) {
        document.stability = stability.spans(number, undecided);
    }
    document
}

fn kind(curve: &Curve) -> CurveKind {
    match (curve.orbit, curve.branch) {
        (Orbit::Pole(Pole::Plus), _) => CurveKind::PolePlus,
        (Orbit::Pole(Pole::Minus), _) => CurveKind::PoleMinus,
        (Orbit::Sphere, _) => CurveKind::Sphere,
        (Orbit::Circle(_), _) => CurveKind::Circle,
        (Orbit::Pair(_), _) => CurveKind::Pair,
        (Orbit::Point, Branch::Axis(_)) => CurveKind::Axis,
        (Orbit::Point, _) => CurveKind::Generic,
    }
}
