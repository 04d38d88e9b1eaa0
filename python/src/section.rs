//! Poincaré sections as arrays.

use bifdiag::body::{Body as Top, Number};
use bifdiag::documents::{self, SectionPlace, Subject};
use bifdiag::dynamics::poincare::{PoincareError, PoincareSection, SectionSetting};
use bifdiag::dynamics::section::chaos::ChaosOptions;
use bifdiag::dynamics::section::{Monitor, SectionCondition, SectionPoint, SweepOptions, TorusPoint};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::body::Body;
use crate::columns::{array, vectors};
use crate::texts::{json, number};
use crate::{errors, work};

/// How a section is made.
#[derive(FromPyObject)]
pub struct Request {
    #[pyo3(item)]
    orbits: usize,
    #[pyo3(item)]
    crossings: usize,
    #[pyo3(item)]
    seed: u64,
    #[pyo3(item)]
    max_time: f64,
    #[pyo3(item)]
    condition: String,
    #[pyo3(item)]
    tolerance: f64,
    #[pyo3(item)]
    chaos: bool,
    /// (theta, psi, sheet) of each start, instead of spread ones.
    #[pyo3(item)]
    starts: Option<Vec<(f64, f64, i8)>>,
}

/// The columns of a section, with its document as `meta`.
#[pyfunction]
pub fn section<'py>(
    python: Python<'py>,
    body: &Body,
    h: &str,
    l: &str,
    request: &Bound<'py, PyDict>,
    threads: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let request: Request = request.extract()?;
    let (h, l) = (number(h)?, number(l)?);
    let condition = match request.condition.as_str() {
        "height" => SectionCondition::Height,
        "angular-momentum" => SectionCondition::AngularMomentum,
        other => {
            let message = format!("condition = {other:?}: the conditions are \"height\" and \"angular-momentum\"");
            return Err(errors::wrong(message));
        }
    };
    let options = SweepOptions {
        crossings: request.crossings,
        max_time: request.max_time,
        tolerance: request.tolerance,
        condition,
        ..SweepOptions::default()
    };
    let monitor = Monitor::default();
    let work = || compute(&body.subject.body, [&h, &l], &request, &options, &monitor);
    let made = work::run(python, threads, &monitor.stop, work)?;
    let section = made.map_err(|error| refused(&error))?;
    columns(python, &body.subject, &section)
}

fn compute(
    body: &Top,
    [h, l]: [&Number; 2],
    request: &Request,
    options: &SweepOptions,
    monitor: &Monitor,
) -> Result<PoincareSection, PoincareError> {
    let setting = SectionSetting::new(body, h, l)?;
    let (starts, seed) = match &request.starts {
        Some(given) => (given.iter().map(|&(theta, psi, sheet)| TorusPoint { theta, psi, sheet }).collect(), None),
        None => (setting.spread_watched(request.orbits, request.seed, monitor)?, Some(request.seed)),
    };
    let mut section = setting.run(&starts, seed, options, monitor)?;
    if request.chaos {
        let chaos = ChaosOptions { tolerance: request.tolerance, ..ChaosOptions::default() };
        setting.measure(&mut section, &chaos, monitor)?;
    }
    Ok(section)
}

/// What the caller can mend is wrong input; the rest is a question without an answer.
pub fn refused(error: &PoincareError) -> PyErr {
    match error {
        PoincareError::WeightlessBody | PoincareError::Forbidden { .. } | PoincareError::OnCurve { .. } => {
            errors::input(error)
        }
        PoincareError::Section(_) => errors::input(error),
        _ => errors::range(error),
    }
}

fn columns<'py>(python: Python<'py>, subject: &Subject, section: &PoincareSection) -> PyResult<Bound<'py, PyDict>> {
    let points: Vec<&SectionPoint> = section.orbits.iter().flat_map(|orbit| &orbit.points).collect();
    let floats = |value: fn(&SectionPoint) -> f64| array(python, points.iter().map(|p| value(p)));
    let counts = |value: fn(&SectionPoint) -> u32| array(python, points.iter().map(|p| value(p).cast_signed()));
    let out = PyDict::new(python);
    out.set_item("orbit", counts(|p| p.orbit))?;
    out.set_item("index", counts(|p| p.index))?;
    out.set_item("time", floats(|p| p.time))?;
    out.set_item("gamma", vectors(python, points.iter().map(|p| p.gamma))?)?;
    out.set_item("l", vectors(python, points.iter().map(|p| p.l))?)?;
    out.set_item("sheet", array(python, points.iter().map(|p| p.sheet)))?;
    out.set_item("s_dot", floats(|p| p.s_dot))?;
    out.set_item("theta", floats(|p| p.theta))?;
    out.set_item("psi", floats(|p| p.psi))?;
    let document = documents::section(subject, section, SectionPlace::Point);
    if document.orbits.iter().any(|orbit| orbit.chaos.is_some()) {
        let spread = |value: &dyn Fn(usize) -> Option<f64>| {
            let rows =
                section.orbits.iter().enumerate().flat_map(|(number, orbit)| {
                    std::iter::repeat_n(value(number).unwrap_or(f64::NAN), orbit.points.len())
                });
            array(python, rows)
        };
        let chaos = |number: usize| document.orbits[number].chaos.as_ref();
        out.set_item("lyapunov", spread(&|number| Some(chaos(number)?.lyapunov?.exponent)))?;
        out.set_item("rotation", spread(&|number| Some(chaos(number)?.rotation?.number)))?;
        out.set_item(
            "exponent",
            array(python, section.chaos.iter().flat_map(|measure| measure.running.iter().copied())),
        )?;
    }
    out.set_item("meta", json(&document)?)?;
    Ok(out)
}
