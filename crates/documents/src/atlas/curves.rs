//! Curves of an atlas document.

use schema::{Accuracy, CurveDocument, CurveKind, StabilitySpan, TailDocument, UndecidedDocument};
use top::atlas::{Atlas, CourseOptions};
use top::curves::{Branch, BranchName, Curve, CurveId, CurveName, Orbit, Pole};
use top::table::Table;

use super::DocumentOptions;
use crate::critical::stability;

pub(super) fn documents(
    atlas: &Atlas,
    options: &DocumentOptions,
    undecided: &mut Vec<UndecidedDocument>,
) -> Vec<CurveDocument> {
    let set = &atlas.arrangement().set;
    let mut documents: Table<CurveId, CurveDocument> =
        set.curves.ids().map(|c| document(atlas, c, options, undecided)).collect();
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
        let line = coincident_pole_line(&name, &pieces, documents.as_slice());
        documents.push(line);
    }
    documents.into_iter().collect()
}

/// A pole line that runs on critical curves: their union.
fn coincident_pole_line(name: &str, pieces: &[String], documents: &[CurveDocument]) -> CurveDocument {
    let parts: Vec<&CurveDocument> = documents.iter().filter(|d| pieces.contains(&d.id)).collect();
    let mut by_l = parts.clone();
    by_l.sort_by(|p, q| p.l_range[0].unwrap_or(0.0).total_cmp(&q.l_range[0].unwrap_or(0.0)));
    let mut polyline: Vec<[f64; 2]> = Vec::new();
    for part in by_l {
        let skip = usize::from(polyline.last() == part.polyline.first() && !polyline.is_empty());
        polyline.extend(part.polyline.iter().skip(skip));
    }
    CurveDocument {
        id: name.to_owned(),
        kind: if name == "P+" { CurveKind::PolePlus } else { CurveKind::PoleMinus },
        branch: name.to_owned(),
        index: None,
        multiplicity: 1,
        coincides_with: pieces.to_vec(),
        mu_range: None,
        l_range: [Some(0.0), None],
        stability: Vec::new(),
        polyline,
        tail: parts.iter().find_map(|part| part.tail.clone()),
    }
}

fn document(
    atlas: &Atlas,
    number: CurveId,
    options: &DocumentOptions,
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
        index: curve.index,
        multiplicity: if matches!(curve.orbit, Orbit::Pair(_)) { 2 } else { 1 },
        coincides_with: Vec::new(),
        mu_range: atlas.mu_range(number),
        l_range: [Some(from), to.is_finite().then_some(to)],
        stability: Vec::new(),
        polyline: Vec::new(),
        tail,
    };
    let seen = options.window.is_none_or(|window| from <= window.l[1] && to >= window.l[0]);
    if !options.polylines || !seen {
        return document;
    }
    let course = atlas.course(
        number,
        &CourseOptions {
            chord_tolerance: options.chord_tolerance,
            l_least: options.window.map_or(0.0, |window| window.l[1]),
            stability: options.accuracy != Accuracy::Draft,
        },
    );
    document.polyline = course.polyline;
    document.stability = course
        .stability
        .iter()
        .map(|span| StabilitySpan { l_from: span.l_from, l_to: span.l_to, stability: stability(span.stability) })
        .collect();
    if !course.finished {
        undecided.push(UndecidedDocument {
            what: "the stability along a curve that continuation did not finish; its shape is from the closed form"
                .to_owned(),
            l: document.polyline[0][1],
            h: document.polyline[0][0],
            curves: vec![document.id.clone()],
        });
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
