//! What pictures of an atlas show: polylines, outlines, widths, and where the diagram is seen.

use std::collections::BTreeMap;

use bifdiag_diagram::arrangement::RegionId;
use bifdiag_diagram::atlas::{Atlas, PolylineOptions, View, Window};
use bifdiag_equilibria::curves::{CurveId, CurveName, Pole};
use bifdiag_schema::{CurveDrawing, DrawingDocument, RegionDocument, RegionDrawing, ViewDocument, WindowDocument};

use super::options::{DocumentOptions, Drawn};

/// The drawing of the regions of a document and of all curves.
pub(super) fn document(
    atlas: &Atlas,
    options: &DocumentOptions,
    regions: &[RegionDocument],
) -> Option<DrawingDocument> {
    let View { main, everything } = atlas.view();
    let seen = |Window { h, l }: Window| WindowDocument { h, l };
    let view = ViewDocument { everything: seen(everything), main: seen(main) };
    let drawn = match options.drawing {
        Drawn::Nothing => return None,
        Drawn::Curves => BTreeMap::new(),
        Drawn::Everything => {
            let window = options.window.map_or(everything, |WindowDocument { h, l }| Window { h, l });
            of_regions(atlas, &window, regions)
        }
    };
    Some(DrawingDocument { view, curves: of_curves(atlas, options), regions: drawn })
}

fn of_curves(atlas: &Atlas, options: &DocumentOptions) -> BTreeMap<String, CurveDrawing> {
    let set = &atlas.arrangement().set;
    let course_options = PolylineOptions {
        chord_tolerance: options.chord_tolerance,
        l_least: options.window.map_or(0.0, |window| window.l[1]),
    };
    let course = |id: CurveId| {
        let range = set.curves[id].x().map(|x| atlas.momentum(x));
        if options.sees(range) { atlas.polyline_of(id, &course_options) } else { Vec::new() }
    };
    let polylines: Vec<(CurveId, Vec<[f64; 2]>)> = set.curves.ids().map(|id| (id, course(id))).collect();
    let mut curves = BTreeMap::new();
    for pole in [Pole::Plus, Pole::Minus] {
        // A pole line that runs on critical curves is their union.
        let is_on = |id: CurveId| set.curves[id].pole == Some(pole) && set.curves[id].is_critical();
        let mut parts: Vec<&(CurveId, Vec<[f64; 2]>)> = polylines.iter().filter(|(id, _)| is_on(*id)).collect();
        if parts.is_empty() {
            continue;
        }
        parts.sort_by(|(p, _), (q, _)| set.curves[*p].x()[0].total_cmp(&set.curves[*q].x()[0]));
        let mut polyline: Vec<[f64; 2]> = parts.into_iter().flat_map(|(_, part)| part.iter().copied()).collect();
        polyline.dedup();
        curves.insert(CurveName::Pole(pole).to_string(), CurveDrawing { polyline });
    }
    let named = |(id, polyline)| (CurveName::of(set, id).to_string(), CurveDrawing { polyline });
    curves.extend(polylines.into_iter().map(named));
    curves
}

fn of_regions(atlas: &Atlas, window: &Window, regions: &[RegionDocument]) -> BTreeMap<String, RegionDrawing> {
    let (outlines, widths) = (atlas.outlines(window), atlas.h_widths());
    let drawn = |region: &RegionDocument| {
        let id: RegionId = region.id.parse().ok()?;
        let polygon = outlines.get(id).cloned().unwrap_or_default();
        Some((region.id.clone(), RegionDrawing { polygon, h_width: widths[id] }))
    };
    regions.iter().filter_map(drawn).collect()
}
