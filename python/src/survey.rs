//! Searches over bodies, and the check of atlases.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use bifdiag::documents::{self, CommandLine};
use bifdiag::schema::{AtlasDocument, SCHEMA_VERSION};
use bifdiag::survey::search::{self, SearchDomain, SearchOptions, Target};
use bifdiag::verify::Refused;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::atlas::accuracy;
use crate::texts::json;
use crate::{errors, work};

/// What a search looks for; one of these is given.
#[derive(FromPyObject)]
pub struct Wanted {
    #[pyo3(item)]
    kind: Option<String>,
    #[pyo3(item)]
    circles: Option<u32>,
    #[pyo3(item)]
    poles: Option<u32>,
    #[pyo3(item)]
    signature: Option<String>,
    #[pyo3(item)]
    critical_points: Option<u32>,
}

impl Wanted {
    fn target(&self) -> PyResult<Target> {
        let target = match (&self.kind, &self.signature, self.critical_points) {
            (Some(kind), _, _) => Target::of_type(kind),
            (_, Some(signature), _) => Target::of_signature(signature),
            (_, _, Some(count)) => return Ok(Target::CriticalPoints(count)),
            _ => return Ok(Target::Component { circles: self.circles, poles: self.poles }),
        };
        target.map_err(|error| errors::input(&error))
    }
}

/// A body and a point that show what is wanted: the document.
#[pyfunction]
pub fn find(
    python: Python<'_>,
    wanted: &Bound<'_, PyDict>,
    physical: bool,
    samples: u64,
    seed: Option<u64>,
    level: &str,
    threads: usize,
) -> PyResult<String> {
    let wanted: Wanted = wanted.extract()?;
    let target = wanted.target()?;
    let options = SearchOptions {
        domain: SearchDomain { physical, ..SearchDomain::default() },
        samples,
        seed: seed.unwrap_or_default(),
        accuracy: accuracy(level)?,
        ..SearchOptions::default()
    };
    let known = if seed.is_some() { Vec::new() } else { documents::shipped_witnesses() };
    let stop = AtomicBool::new(false);
    let found = work::run(python, threads, &stop, || {
        let mut watch =
            |_| if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        search::find(&target, &known, &options, &mut watch)
    })?;
    let command = CommandLine::new("find")
        .option_if("type", wanted.kind)
        .option_if("circles", wanted.circles)
        .option_if("poles", wanted.poles)
        .option_if("signature", wanted.signature)
        .option_if("critical-points", wanted.critical_points)
        .flag("physical", physical)
        .option("samples", samples)
        .option_if("seed", seed)
        .option_if("accuracy", documents::accuracy_option(accuracy(level)?));
    json(&documents::find(&target, &found, command))
}

/// Checks the text of an atlas.json that `name` tells; the number of its regions. With `bytes` the text must be what bifdiag
/// writes to the letter, as `bifdiag verify` wants it.
#[pyfunction]
pub fn verify(python: Python<'_>, text: &str, name: &str, bytes: bool) -> PyResult<usize> {
    let document = read(text, name)?;
    if bytes && document.certificate.is_some() {
        let own = documents::layout::text(&document).map_err(|error| errors::range(&error))?;
        if own.trim_end() != text.trim_end() {
            return Err(errors::damaged(name));
        }
    }
    let report = work::run(python, 1, &AtomicBool::new(false), || bifdiag::verify::verify(&document))?;
    let report = report.map_err(|error: Refused| errors::refused(&error))?;
    Ok(report.regions)
}

/// Refuses the text of what is no atlas of this version; of an older one with the command that makes it anew.
#[pyfunction]
pub fn readable(text: &str, name: &str) -> PyResult<()> {
    read(text, name).map(drop)
}

fn read(text: &str, name: &str) -> PyResult<AtlasDocument> {
    documents::reading::atlas(text, name)
        .map_err(|error| errors::wrong(format!("{name} is not an atlas of version {SCHEMA_VERSION}: {error}")))
}
