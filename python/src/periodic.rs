//! Periodic orbits: documents.

use bifdiag::documents;
use bifdiag::dynamics::poincare::SectionSetting;
use bifdiag::dynamics::section::Monitor;
use bifdiag::periodic::catalogue::Catalogue;
use bifdiag::periodic::family::{FamilyOptions, Held};
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

/// The families that begin at the equilibria of one l, or of one h: the document.
#[pyfunction]
pub fn periodic_families(
    python: Python<'_>,
    body: &Body,
    held: &str,
    value: &str,
    curve: Option<&str>,
    members: usize,
    branches: bool,
) -> PyResult<String> {
    let (name, value) = (held, number(value)?);
    let held = if name == "l" { Held::Momentum } else { Held::Energy };
    let monitor = Monitor::default();
    let options = FamilyOptions { held, members, branches, monitor: &monitor };
    let subject = &body.subject;
    let work = || {
        let catalogue = Catalogue::new(&subject.body).map_err(|error| errors::range(&error))?;
        let known = catalogue.curves();
        let only = curve.map(|id| {
            known.iter().copied().find(|known| known.to_string() == id).ok_or_else(|| {
                let known: Vec<String> = known.iter().map(ToString::to_string).collect();
                errors::wrong(format!(
                    "curve = {id:?}: the body has no such curve of steady rotations; it has {}",
                    known.join(", ")
                ))
            })
        });
        let starts = catalogue.starts(held, &value, only.transpose()?).map_err(|error| errors::range(&error))?;
        if starts.is_empty() {
            let of = curve.map_or_else(|| "the body".to_owned(), |id| format!("the curve {id}"));
            return Err(errors::wrong(format!("{name} = {}: {of} has no equilibrium there", value.text())));
        }
        let mut found = Vec::with_capacity(starts.len());
        for start in starts {
            if monitor.is_stopped() {
                break;
            }
            let families = catalogue.families(&start, &options).map_err(|error| errors::range(&error))?;
            found.push((start, families));
        }
        let command = subject.command("periodic family").option_if("from", curve).option(name, value.text());
        let command = command.option("members", members).flag("branches", branches);
        Ok::<_, PyErr>(documents::periodic_families(subject, command, (held, value.text()), &found))
    };
    json(&work::run(python, 1, &monitor.stop, work)??)
}
