//! `bifdiag chaos map`: the picture of a map.

use std::collections::{BTreeMap, BTreeSet};

use bifdiag_body::Body;
use bifdiag_diagram::atlas::{Atlas, PolylineOptions, Spot};
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_plot::{ChaosCell, ChaosScene, body_line, draw_chaos};
use bifdiag_schema::{ChaosCellDocument, ChaosMapDocument};

use super::arguments::DrawArguments;
use super::merge::{cells, shard};
use crate::cli::export::FileSet;
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::{Report, Timings, print};

/// Room for the body's numbers, and the size of their letters.
const WIDE: f64 = 520.0;
const LARGE: f64 = 14.0;
/// How far drawn chords may leave a curve, as for diagrams, but so that no corner shows in a small window.
const CHORD: f64 = 2e-5;
/// Squares along a side of a cell through which a curve goes.
const SQUARES: u64 = 16;

pub fn run(arguments: &DrawArguments, timings: &Timings) -> Result<(), Failure> {
    let map = shard(&arguments.file)?;
    let body = Body::parse(&map.body.moments, &map.body.center)
        .map_err(|error| Failure::input(format!("{}: {error}", arguments.file.display())))?;
    let solver = Solver::new(body, Accuracy::Exact);
    let unknown = || Failure::work("the diagram of this body is not known, and with it the regions of the cells");
    let atlas = solver.atlas().ok_or_else(unknown)?;
    let scene = scene(&map, atlas, painted(&map, &solver)?);
    let picture = timings.stage("picture", || draw_chaos(&scene, arguments.picture.theme))?;
    let mut files = FileSet::new(&arguments.out);
    files.remove_pictures("chaos");
    files.pictures("chaos", &picture, &arguments.picture, timings)?;
    print(Report::of_written(&files.write()?).text())
}

/// What the picture shows.
fn scene(map: &ChaosMapDocument, atlas: &Atlas, painted: Vec<ChaosCell>) -> ChaosScene {
    let options = PolylineOptions { chord_tolerance: CHORD, l_least: map.window.l[1] };
    let set = &atlas.arrangement().set;
    let drawn = set.curves.pairs().filter(|(_, curve)| curve.is_critical());
    ChaosScene {
        h: map.window.h,
        l: map.window.l,
        cells: painted,
        curves: drawn.map(|(id, _)| atlas.polyline_of(id, &options)).collect(),
        labels: labels(map),
        title: body_line(&map.body.moments, &map.body.center, WIDE, LARGE),
        notes: notes(map),
    }
}

/// The rows of each cell.
fn by_cells(map: &ChaosMapDocument) -> BTreeMap<[u64; 2], Vec<&ChaosCellDocument>> {
    let mut cells: BTreeMap<[u64; 2], Vec<&ChaosCellDocument>> = BTreeMap::new();
    for row in &map.rows {
        cells.entry(row.cell).or_default().push(row);
    }
    cells
}

/// What is painted: whole cells, and of those through which a curve goes each square in the colour of its own region.
fn painted(map: &ChaosMapDocument, solver: &Solver) -> Result<Vec<ChaosCell>, Failure> {
    let cells = cells(map);
    let mut painted = Vec::new();
    for ([i, j], rows) in by_cells(map) {
        let side = if rows.iter().all(|row| row.part >= 1.0) { 1 } else { SQUARES };
        let corner = |k: u64, n: u64| cells.place(i as f64 + k as f64 / side as f64, j as f64 + n as f64 / side as f64);
        let along_h = |k: u64| [k, k + 1].map(|k| corner(k, 0)[0]);
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let energies: Vec<f64> = (0..side).map(|k| middle(along_h(k))).collect();
        for n in 0..side {
            let l = [n, n + 1].map(|n| corner(0, n)[1]);
            let spots = solver.row(middle(l), &energies).transpose().map_err(failed("a cell has no region"))?;
            for (k, spot) in (0..side).zip(spots.unwrap_or_default()) {
                let Spot::Region(region) = spot else { continue };
                let name = region.to_string();
                let shares: Vec<_> = rows.iter().filter(|row| row.region == name).map(|row| row.fraction).collect();
                // The 16 points of the cell can have missed a region.
                let shares = if shares.is_empty() { vec![None] } else { shares };
                painted.push(ChaosCell { h: along_h(k), l, shares });
            }
        }
    }
    Ok(painted)
}

/// The name of each region in the middle of where it is widest: a cell of it is farthest from any other cell.
fn labels(map: &ChaosMapDocument) -> Vec<([f64; 2], String)> {
    let mut regions: BTreeMap<&str, BTreeSet<[u64; 2]>> = BTreeMap::new();
    for row in map.rows.iter().filter(|row| row.part >= 1.0) {
        regions.entry(&row.region).or_default().insert(row.cell);
    }
    let cells = cells(map);
    let label = |(region, own): (&str, BTreeSet<[u64; 2]>)| {
        let [i, j] = innermost(own);
        (cells.place(i as f64 + 0.5, j as f64 + 0.5), region.to_owned())
    };
    regions.into_iter().map(label).collect()
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
        format!("{n} × {m} cells, standard deviations up to {error:.3}; {open:.1} % without a verdict"),
        "Shares of Liouville measure; of several components one above the other; grey: not measured".to_owned(),
    ]
}
