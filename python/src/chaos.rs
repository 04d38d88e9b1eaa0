//! The chaotic share of energy surfaces: a document for a point, columns for a map.

use bifdiag::chaos::{Cells, PointError, ShareOptions, map_tiles, point_shares};
use bifdiag::dynamics::section::Monitor;
use bifdiag::dynamics::section::chaos::DecisionOptions;
use bifdiag::numbers::table::Id;
use bifdiag::schema::{Accuracy, ChaosCellDocument};
use bifdiag::{Solver, documents};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::body::Body;
use crate::columns::array;
use crate::texts::{json, number};
use crate::{errors, work};

/// Tiles that are measured together.
const GROUP: u64 = 16;

fn options(error: f64, steps: usize, seed: u64) -> ShareOptions {
    ShareOptions { error, seed, orbits: DecisionOptions { steps, ..DecisionOptions::default() } }
}

/// The shares at one point: the document.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "what the package has checked")]
pub fn chaos_point(
    python: Python<'_>,
    body: &Body,
    h: &str,
    l: &str,
    error: f64,
    steps: usize,
    seed: u64,
    threads: usize,
) -> PyResult<String> {
    let (h, l, options) = (number(h)?, number(l)?, options(error, steps, seed));
    let monitor = Monitor::default();
    let work = || {
        let solver = Solver::new(body.subject.body.clone(), Accuracy::Exact);
        point_shares(&solver, [&h, &l], &options, &monitor)
    };
    let found = work::run(python, threads, &monitor.stop, work)?.map_err(|error| match error {
        PointError::Nowhere(_) | PointError::TooNear => errors::input(&error),
        _ => errors::range(&error),
    })?;
    json(&documents::chaos_point(&body.subject, [&h, &l], &found, &options))
}

/// The columns of a map, with its document as `meta`. Without a window it is that of the diagram.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "what the package has checked")]
pub fn chaos_map<'py>(
    python: Python<'py>,
    body: &Body,
    window: Option<[[f64; 2]; 2]>,
    cells: [u64; 2],
    error: f64,
    steps: usize,
    seed: u64,
    threads: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let options = options(error, steps, seed);
    let monitor = Monitor::default();
    let work = || {
        let solver = Solver::new(body.subject.body.clone(), Accuracy::Exact);
        let view = solver.atlas().map(|atlas| atlas.view().main).ok_or(bifdiag::chaos::MapError::NoAtlas)?;
        let [h, l] = window.unwrap_or([view.h, view.l]);
        let cells = Cells { h, l, counts: cells };
        let (mut rows, mut next) = (Vec::new(), 0);
        while next < cells.tiles() && !monitor.is_stopped() {
            let end = cells.tiles().min(next + GROUP);
            rows.extend(map_tiles(&solver, &cells, next..end, &options, &monitor)?);
            next = end;
        }
        let codes: Vec<i32> = rows.iter().map(|row| i32::try_from(row.region.index()).unwrap_or(-1)).collect();
        let rows: Vec<_> = rows.iter().map(documents::chaos_cell).collect();
        Ok((documents::chaos_map(&body.subject, &cells, [0, cells.tiles()], &options), codes, rows))
    };
    let found: Result<_, bifdiag::chaos::MapError> = work::run(python, threads, &monitor.stop, work)?;
    let (document, codes, rows) = found.map_err(|error| errors::range(&error))?;
    let whole = |value: fn(&ChaosCellDocument) -> u64| {
        array(python, rows.iter().map(|row| i32::try_from(value(row)).unwrap_or(i32::MAX)))
    };
    let real = |value: fn(&ChaosCellDocument) -> f64| array(python, rows.iter().map(value));
    let out = PyDict::new(python);
    out.set_item("i", whole(|row| row.cell[0]))?;
    out.set_item("j", whole(|row| row.cell[1]))?;
    out.set_item("h", real(|row| row.h))?;
    out.set_item("l", real(|row| row.l))?;
    out.set_item("region", array(python, codes.into_iter()))?;
    out.set_item("component", whole(|row| row.component.into()))?;
    out.set_item("part", real(|row| row.part))?;
    out.set_item("block", whole(|row| row.block.into()))?;
    out.set_item("fraction", real(|row| row.fraction.unwrap_or(f64::NAN)))?;
    out.set_item("error", real(|row| row.error.unwrap_or(f64::NAN)))?;
    out.set_item("open", real(|row| row.open))?;
    out.set_item("orbits", whole(|row| row.orbits))?;
    out.set_item("crossings", whole(|row| row.crossings))?;
    out.set_item("meta", json(&document)?)?;
    Ok(out)
}
