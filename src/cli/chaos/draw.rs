//! `bifdiag chaos map`: the picture of a map.

use std::collections::{BTreeMap, BTreeSet};

use bifdiag_body::Body;
use bifdiag_diagram::atlas::{Atlas, PolylineOptions};
use bifdiag_documents::DocumentOptions;
use bifdiag_exact::Accuracy;
use bifdiag_plot::{ChaosCell, ChaosScene, body_line, draw_chaos};
use bifdiag_schema::{ChaosCellDocument, ChaosMapDocument};

use super::arguments::DrawArguments;
use super::merge::shard;
use crate::cli::export::FileSet;
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::{Report, Timings, print};

/// Room for the body's numbers, and the size of their letters.
const WIDE: f64 = 520.0;
const LARGE: f64 = 14.0;

pub fn run(arguments: &DrawArguments, timings: &Timings) -> Result<(), Failure> {
    let map = shard(&arguments.file)?;
    let body = Body::parse(&map.body.moments, &map.body.center)
        .map_err(|error| Failure::input(format!("{}: {error}", arguments.file.display())))?;
    let atlas = bifdiag_exact::atlas(&body, Accuracy::Exact).map_err(failed("the atlas could not be made"))?;
    let scene = scene(&map, &atlas);
    let picture = timings.stage("picture", || draw_chaos(&scene, arguments.picture.theme))?;
    let mut files = FileSet::new(&arguments.out);
    files.remove_pictures("chaos");
    files.pictures("chaos", &picture, &arguments.picture, timings)?;
    print(Report::of_written(&files.write()?).text())
}

/// What the picture shows.
fn scene(map: &ChaosMapDocument, atlas: &Atlas) -> ChaosScene {
    let options =
        PolylineOptions { chord_tolerance: DocumentOptions::default().chord_tolerance, l_least: map.window.l[1] };
    let set = &atlas.arrangement().set;
    let drawn = set.curves.pairs().filter(|(_, curve)| curve.is_critical());
    let mut cells: BTreeMap<[u64; 2], Vec<&ChaosCellDocument>> = BTreeMap::new();
    for row in &map.rows {
        cells.entry(row.cell).or_default().push(row);
    }
    let along = |[from, to]: [f64; 2], count: u64, cell: u64| {
        [cell, cell + 1].map(|cell| from + (to - from) * cell as f64 / count as f64)
    };
    let cell = |(&[i, j], rows): (&[u64; 2], &Vec<&ChaosCellDocument>)| ChaosCell {
        h: along(map.window.h, map.cells[0], i),
        l: along(map.window.l, map.cells[1], j),
        stripes: stripes(rows),
    };
    ChaosScene {
        h: map.window.h,
        l: map.window.l,
        cells: cells.iter().map(cell).collect(),
        curves: drawn.map(|(id, _)| atlas.polyline_of(id, &options)).collect(),
        labels: labels(map, &cells),
        title: body_line(&map.body.moments, &map.body.center, WIDE, LARGE),
        notes: notes(map),
    }
}

/// A stripe for each region in a cell, as wide as its part of the cell, with its components.
fn stripes(rows: &[&ChaosCellDocument]) -> Vec<(f64, Vec<Option<f64>>)> {
    let mut regions: Vec<(&str, f64, Vec<Option<f64>>)> = Vec::new();
    for row in rows {
        match regions.last_mut().filter(|(region, ..)| *region == row.region) {
            Some((.., shares)) => shares.push(row.fraction),
            None => regions.push((&row.region, row.part, vec![row.fraction])),
        }
    }
    regions.into_iter().map(|(_, part, shares)| (part, shares)).collect()
}

/// The name of each region in the middle of where it is widest: a cell of it is farthest from any other cell.
fn labels(map: &ChaosMapDocument, cells: &BTreeMap<[u64; 2], Vec<&ChaosCellDocument>>) -> Vec<([f64; 2], String)> {
    let mut regions: BTreeMap<&str, BTreeSet<[u64; 2]>> = BTreeMap::new();
    for (cell, rows) in cells {
        for row in rows.iter().filter(|row| row.part >= 1.0) {
            regions.entry(&row.region).or_default().insert(*cell);
        }
    }
    let place = |cell: [u64; 2]| {
        let of = |[from, to]: [f64; 2], k: usize| from + (to - from) * (cell[k] as f64 + 0.5) / map.cells[k] as f64;
        [of(map.window.h, 0), of(map.window.l, 1)]
    };
    let name = |(region, cells): (&str, BTreeSet<[u64; 2]>)| (place(innermost(cells)), region.to_owned());
    regions.into_iter().map(name).collect()
}

/// The middle one of the cells that are left last when their edge is taken away again and again.
fn innermost(mut cells: BTreeSet<[u64; 2]>) -> [u64; 2] {
    loop {
        let has = |i: Option<u64>, j: Option<u64>| matches!((i, j), (Some(i), Some(j)) if cells.contains(&[i, j]));
        let is_inner = |&&[i, j]: &&[u64; 2]| {
            let beside = [
                (i.checked_sub(1), Some(j)),
                (Some(i + 1), Some(j)),
                (Some(i), j.checked_sub(1)),
                (Some(i), Some(j + 1)),
            ];
            beside.into_iter().all(|(i, j)| has(i, j))
        };
        let inner: BTreeSet<[u64; 2]> = cells.iter().filter(is_inner).copied().collect();
        if inner.is_empty() {
            return cells.iter().nth(cells.len() / 2).copied().unwrap_or_default();
        }
        cells = inner;
    }
}

/// The open share and the error, over the parts of the cells.
fn notes(map: &ChaosMapDocument) -> Vec<String> {
    let known = || map.rows.iter().filter(|row| row.orbits > 0);
    let whole: f64 = known().map(|row| row.part).sum();
    let mean = |value: fn(&ChaosCellDocument) -> f64| {
        known().map(|row| row.part * value(row)).sum::<f64>() / whole.max(1e-300)
    };
    let open = 100.0 * mean(|row| row.open);
    let error = known().filter_map(|row| row.error).fold(0.0, f64::max);
    let [n, m] = map.cells;
    vec![
        format!(
            "{n} × {m} cells, standard deviations up to {error:.3}; {open:.1} % of the orbits are without a verdict"
        ),
        "Shares of Liouville measure; of several components one above the other".to_owned(),
    ]
}
