//! Pictures: the tolerance of polylines against size, time and the deviation that is left.

use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::DocumentOptions;
use bifdiag_equilibria::curves::CurveName;
use bifdiag_plot::{DiagramOptions, draw};
use bifdiag_schema::AtlasDocument;

use super::clock::{quantiles, timed};
use super::points::Asked;

/// Bodies, and those of which a picture is drawn.
const BODIES: usize = 24;
const DRAWN: usize = 2;

/// Places between two vertices where the deviation is measured.
const BETWEEN: usize = 7;

pub fn run(all: &[Asked]) {
    let generic = all.iter().filter(|asked| asked.stratum == "generic");
    let atlases: Vec<Atlas> =
        generic.take(BODIES).filter_map(|asked| bifdiag_diagram::fast::atlas(&asked.body).ok()).collect();
    println!(
        "tolerance,bodies,vertices,json_bytes,svg_bytes,deviation_median,deviation_largest,\
         document_us,picture_us"
    );
    for chord_tolerance in [1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6] {
        let options = DocumentOptions { chord_tolerance, ..DocumentOptions::default() };
        let mut columns: [Vec<f64>; 6] = std::array::from_fn(|_| Vec::new());
        for (number, atlas) in atlases.iter().enumerate() {
            let (document, document_time) = timed(|| bifdiag_documents::atlas::document(atlas, &options));
            let json = serde_json::to_string(&document).map_or(0, |text| text.len());
            let vertices: usize = document.curves.iter().map(|curve| document.polyline(&curve.id).len()).sum();
            let row = [vertices as f64, json as f64, deviation(atlas, &document), document_time];
            columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
            if number < DRAWN {
                // Only the polylines of the document are drawn.
                let (picture, time) = timed(|| draw(&document, None, &DiagramOptions::default()));
                columns[4].push(picture.map_or(0, |picture| picture.svg.len()) as f64);
                columns[5].push(time);
            }
        }
        let medians = columns.each_mut().map(|column| quantiles(column)[0]);
        let largest = columns[2].last().copied().unwrap_or(0.0);
        let [vertices, json, deviation, document_time, svg, picture_time] = medians;
        println!(
            "{chord_tolerance:e},{},{vertices},{json},{svg},{deviation:.2e},{largest:.2e},{document_time:.1},\
             {picture_time:.1}",
            atlases.len()
        );
    }
}

/// The largest distance between a curve and its polyline, relative to the ranges of h and l of the whole document, as
/// the tolerance is.
fn deviation(atlas: &Atlas, document: &AtlasDocument) -> f64 {
    let all = || document.curves.iter().flat_map(|curve| document.polyline(&curve.id));
    let range = |k: usize| {
        let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p[k]), b.max(p[k])));
        high - low
    };
    let ranges = [range(0), range(1)];
    let set = &atlas.arrangement().set;
    let unit = &set.frame;
    let mut largest = 0.0_f64;
    for curve in &document.curves {
        let Some(number) = set.curves.ids().find(|&c| CurveName::of(set, c).to_string() == curve.id) else {
            continue;
        };
        let [from, to] = set.curves[number].x();
        for pair in document.polyline(&curve.id).windows(2) {
            let [run_h, run_l] = [(pair[1][0] - pair[0][0]) / ranges[0], (pair[1][1] - pair[0][1]) / ranges[1]];
            for k in 1..=BETWEEN {
                let t = k as f64 / (BETWEEN + 1) as f64;
                let l = pair[0][1] + t * (pair[1][1] - pair[0][1]);
                let scaled = l / unit.momentum_unit;
                let x = (0.5 * scaled * scaled).max(from).min(to);
                if x == 0.0 {
                    continue;
                }
                let chord = pair[0][0] + t * (pair[1][0] - pair[0][0]);
                let off = (set.curves[number].point(unit, x).h() * unit.energy_unit - chord).abs() / ranges[0];
                let length = (run_h * run_h + run_l * run_l).sqrt();
                if length > 0.0 {
                    largest = largest.max(off * run_l.abs() / length);
                }
            }
        }
    }
    largest
}
