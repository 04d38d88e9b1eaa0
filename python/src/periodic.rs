//! Periodic orbits: documents.

use bifdiag::documents;
use bifdiag::dynamics::poincare::SectionSetting;
use bifdiag::dynamics::section::Monitor;
use bifdiag::periodic::list::{ListError, ListOptions, list};
use pyo3::prelude::*;

use crate::body::Body;
use crate::section::refused;
use crate::texts::{json, number};
use crate::{errors, work};

/// Every orbit with few crossings of the section at one point.
#[pyfunction]
pub fn periodic_orbits(
    python: Python<'_>,
    body: &Body,
    h: &str,
    l: &str,
    crossings: u32,
    threads: usize,
) -> PyResult<String> {
    let (h, l) = (number(h)?, number(l)?);
    let options = ListOptions { crossings, ..ListOptions::default() };
    let monitor = Monitor::default();
    let work = || list(&SectionSetting::new(&body.subject.body, &h, &l)?, &options, &monitor);
    let found = work::run(python, threads, &monitor.stop, work)?.map_err(|error| match error {
        ListError::Setting(error) => refused(&error),
        error => errors::range(&error),
    })?;
    json(&documents::periodic(&body.subject, [&h, &l], crossings, &found))
}
