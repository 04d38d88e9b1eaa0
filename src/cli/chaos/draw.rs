//! `bifdiag chaos map`: the picture of a map.

use std::collections::{BTreeMap, BTreeSet};

use bifdiag_body::Body;
use bifdiag_chaos::Cells;
use bifdiag_diagram::atlas::{Atlas, Spot};
use bifdiag_equilibria::curves::CurveName;
use bifdiag_exact::{Accuracy, Solver};
use bifdiag_plot::{ChaosCell, ChaosPanel, ChaosScene, draw_chaos};
use bifdiag_schema::{ChaosCellDocument, ChaosMapDocument};

use super::arguments::DrawArguments;
use super::merge::{cells, shard};
use crate::cli::export::FileSet;
use crate::cli::failure::{Failure, failed};
use crate::cli::terminal::{Report, Timings, print};

/// How far drawn chords may leave a curve, in parts of the window: the diagram itself may reach much farther.
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
    let scene = scene(&map, atlas, &painted(&map, &solver)?);
    let picture = timings.stage("picture", || draw_chaos(&scene, arguments.picture.theme, arguments.width.width))?;
    let mut files = FileSet::new(&arguments.out);
    files.remove_pictures("chaos");
    files.pictures("chaos", &picture, &arguments.picture, timings)?;
    print(Report::of_written(&files.write()?).text())
}

/// What the picture shows.
fn scene(map: &ChaosMapDocument, atlas: &Atlas, painted: &[Painted]) -> ChaosScene {
    let tolerance = CHORD * (map.window.h[1] - map.window.h[0]);
    let set = &atlas.arrangement().set;
    let drawn = |critical: bool| {
        let own = set.curves.pairs().filter(move |(_, curve)| curve.is_critical() == critical);
        own.filter_map(|(id, _)| atlas.polyline_to_draw(CurveName::of(set, id), map.window.l, tolerance)).collect()
    };
    let most = map.rows.iter().map(|row| row.component).max().unwrap_or(0);
    ChaosScene {
        panels: (0..=most).map(|component| panel(map, painted, component, most)).collect(),
        curves: drawn(true),
        poles: drawn(false),
        moments: map.body.moments.clone(),
        center: map.body.center.clone(),
        notes: notes(map),
    }
}

/// One component of each region: the first in the whole window, another where there is one.
fn panel(map: &ChaosMapDocument, painted: &[Painted], component: u32, most: u32) -> ChaosPanel {
    let own = |row: &&ChaosCellDocument| row.component == component;
    let regions: BTreeSet<&str> = map.rows.iter().filter(own).map(|row| &row.region[..]).collect();
    let (h, l) = if component == 0 { (map.window.h, map.window.l) } else { part(map, component) };
    let shown = painted.iter().filter(|one| component == 0 || regions.contains(&one.region[..]));
    let cells =
        shown.map(|one| ChaosCell { h: one.h, l: one.l, share: one.shares.get(component as usize).copied().flatten() });
    let inside = |cell: &ChaosCell| cell.h[1] > h[0] && cell.h[0] < h[1] && cell.l[1] > l[0] && cell.l[0] < l[1];
    let name = match component {
        0 if most == 0 => String::new(),
        0 => "component 0 of E".to_owned(),
        _ => format!("component {component} of E, in {}", regions.iter().copied().collect::<Vec<_>>().join(", ")),
    };
    ChaosPanel { h, l, name, cells: cells.filter(inside).collect(), labels: labels(map, painted, component) }
}

/// The part of the window where a region has this component, and a margin.
fn part(map: &ChaosMapDocument, component: u32) -> ([f64; 2], [f64; 2]) {
    /// The margin at each side, as a share of the part, and in cells at least.
    const MARGIN: f64 = 0.05;
    let cells = cells(map);
    let along = |k: usize| {
        let own = || map.rows.iter().filter(|row| row.component == component).map(|row| row.cell[k]);
        let (from, to) = (own().min().unwrap_or(0) as f64, own().max().unwrap_or(0) as f64 + 1.0);
        let margin = (MARGIN * (to - from)).max(1.0);
        [(from - margin).max(0.0), (to + margin).min(map.cells[k] as f64)]
    };
    let (h, l) = (along(0), along(1));
    let [low, high] = [0, 1].map(|end| cells.place(h[end], l[end]));
    ([low[0], high[0]], [low[1], high[1]])
}

/// The rows of each cell.
fn by_cells(map: &ChaosMapDocument) -> BTreeMap<[u64; 2], Vec<&ChaosCellDocument>> {
    let mut cells: BTreeMap<[u64; 2], Vec<&ChaosCellDocument>> = BTreeMap::new();
    for row in &map.rows {
        cells.entry(row.cell).or_default().push(row);
    }
    cells
}

/// A rectangle in one region, with the shares of its components.
struct Painted {
    h: [f64; 2],
    l: [f64; 2],
    region: String,
    shares: Vec<Option<f64>>,
}

/// What is painted: whole cells, and of those through which a curve goes each square in the colour of its own region.
fn painted(map: &ChaosMapDocument, solver: &Solver) -> Result<Vec<Painted>, Failure> {
    let cells = cells(map);
    let mut painted = Vec::new();
    for ([i, j], rows) in by_cells(map) {
        let is_whole = rows.iter().all(|row| row.part >= 1.0) && is_uniform(solver, &cells, [i, j])?;
        let side = if is_whole { 1 } else { SQUARES };
        let corner = |k: u64, n: u64| cells.place(i as f64 + k as f64 / side as f64, j as f64 + n as f64 / side as f64);
        let along_h = |k: u64| [k, k + 1].map(|k| corner(k, 0)[0]);
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let energies: Vec<f64> = (0..side).map(|k| middle(along_h(k))).collect();
        for n in 0..side {
            let l = [n, n + 1].map(|n| corner(0, n)[1]);
            let spots = solver.row(middle(l), &energies).transpose().map_err(failed("a cell has no region"))?;
            for (k, spot) in (0..side).zip(spots.unwrap_or_default()) {
                let Spot::Region(region) = spot else { continue };
                let region = region.to_string();
                let mut own: Vec<_> = rows.iter().filter(|row| row.region == region).collect();
                own.sort_by_key(|row| row.component);
                // Where the 16 points of the cell have missed a region, its shares are not known.
                painted.push(Painted {
                    h: along_h(k),
                    l,
                    shares: own.iter().map(|row| row.fraction).collect(),
                    region,
                });
            }
        }
    }
    Ok(painted)
}

/// The corners, the middles of the sides and the centre of a cell are in one region: the 16 points at which it was measured can have
/// missed another one.
fn is_uniform(solver: &Solver, cells: &Cells, [i, j]: [u64; 2]) -> Result<bool, Failure> {
    let halves = [0.0, 0.5, 1.0];
    let energies = halves.map(|part| cells.place(i as f64 + part, 0.0)[0]);
    let mut found = Vec::new();
    for part in halves {
        let l = cells.place(0.0, j as f64 + part)[1];
        let spots = solver.row(l, &energies).transpose().map_err(failed("a cell has no region"))?;
        found.extend(spots.unwrap_or_default());
    }
    Ok(found.windows(2).all(|pair| pair[0] == pair[1]))
}

/// The name of each region with this component in the middle of where it is widest: a cell of it is farthest from any other cell.
/// A region without a whole cell has its name in the middle of its squares, in the cell where it has most of them.
fn labels(map: &ChaosMapDocument, painted: &[Painted], component: u32) -> Vec<([f64; 2], String)> {
    let mut regions: BTreeMap<&str, BTreeSet<[u64; 2]>> = BTreeMap::new();
    let own = || map.rows.iter().filter(|row| row.component == component);
    for row in own().filter(|row| row.part >= 1.0) {
        regions.entry(&row.region).or_default().insert(row.cell);
    }
    let mut most: BTreeMap<&str, &ChaosCellDocument> = BTreeMap::new();
    for row in own().filter(|row| !regions.contains_key(&row.region[..])) {
        let best = most.entry(&row.region).or_insert(row);
        if row.part > best.part {
            *best = row;
        }
    }
    regions.extend(most.into_iter().map(|(region, row)| (region, BTreeSet::from([row.cell]))));
    let cells = cells(map);
    let label = |(region, own): (&str, BTreeSet<[u64; 2]>)| {
        let [i, j] = innermost(own);
        let [low, high] = [0.0, 1.0].map(|more| cells.place(i as f64 + more, j as f64 + more));
        let middle = |one: &Painted| [one.h, one.l].map(|[from, to]| 0.5 * (from + to));
        let is_in = |at: [f64; 2]| (0..2).all(|axis| low[axis] <= at[axis] && at[axis] <= high[axis]);
        let squares: Vec<[f64; 2]> =
            painted.iter().filter(|one| one.region == region).map(middle).filter(|at| is_in(*at)).collect();
        let place = squares.get(squares.len() / 2).copied();
        (place.unwrap_or_else(|| cells.place(i as f64 + 0.5, j as f64 + 0.5)), region.to_owned())
    };
    regions.into_iter().map(label).collect()
}

/// The middle one of the cells that remain last when the edge cells are removed repeatedly.
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
    let [n, m] = map.cells;
    let known = || map.rows.iter().filter(|row| row.orbits > 0);
    if known().next().is_none() {
        return vec![format!("{n} × {m} cells; no orbit was judged in any of them")];
    }
    let whole: f64 = known().map(|row| row.part).sum();
    let mean = |value: fn(&ChaosCellDocument) -> f64| {
        known().map(|row| row.part * value(row)).sum::<f64>() / whole.max(1e-300)
    };
    let open = 100.0 * mean(|row| row.open);
    let error = known().filter_map(|row| row.error).fold(0.0, f64::max);
    vec![
        format!("{n} × {m} cells, standard deviations up to {error:.3}; {open:.1} % without a verdict"),
        "Shares of the Liouville measure of a component; thin: pole lines; grey: not measured".to_owned(),
    ]
}
