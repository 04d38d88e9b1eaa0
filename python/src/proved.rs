//! Motions with proved bounds as arrays.

use std::sync::atomic::{AtomicBool, AtomicU64};

use bifdiag::Number;
use bifdiag::documents::{EnclosureRow, ProofAsked, enclosure_rows, enclosures, proved_motion as document};
use bifdiag::enclosure::orbit::{ProofOptions, prove};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::body::Body;
use crate::columns::{array, vectors};
use crate::texts::{json, number};
use crate::{errors, work};

/// A start at time 0 and what is wanted from there.
#[derive(FromPyObject)]
pub struct Request {
    /// The vertical, of any length.
    #[pyo3(item)]
    gamma: [String; 3],
    /// Angular momentum or, if `is_omega`, angular velocity.
    #[pyo3(item)]
    l: [String; 3],
    #[pyo3(item)]
    is_omega: bool,
    #[pyo3(item)]
    phi: String,
    /// They rise.
    #[pyo3(item)]
    times: Vec<f64>,
    /// First, last and number of equidistant ones.
    #[pyo3(item)]
    span: Option<(f64, f64, usize)>,
    #[pyo3(item)]
    digits: Option<u32>,
    #[pyo3(item)]
    bound: f64,
}

/// The columns of a proved motion with its document as `meta`, and the decimals of the enclosures.
#[pyfunction]
pub fn proved_motion<'py>(
    python: Python<'py>,
    body: &Body,
    request: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    let Request { gamma, l, is_omega, phi, times, span, digits, bound } = request.extract()?;
    let numbers = |[x, y, z]: [String; 3]| Ok::<_, PyErr>([number(&x)?, number(&y)?, number(&z)?]);
    let turning = numbers(l)?;
    let moments = body.subject.body.moments();
    let by_inertia = |i: usize| Number::from_rational(turning[i].value() / moments[i].value());
    let omega = if is_omega { turning } else { std::array::from_fn(by_inertia) };
    // Others come line by line.
    let told = span.map_or_else(|| "-".to_owned(), |(first, last, count)| format!("{first}:{last}:{count}"));
    let asked = ProofAsked { gamma: numbers(gamma)?, omega, phi: number(&phi)?, times: told, digits, bound };
    let exact = times.iter().map(|time| Number::from_f64(*time).map(|time| time.value().clone()));
    let exact = exact.collect::<Result<Vec<_>, _>>().map_err(|error| errors::input(&error))?;
    let stop = AtomicBool::new(false);
    let options = ProofOptions { digits, bound, stop: &stop, steps: &AtomicU64::new(0) };
    let work = || {
        let motion = prove(&body.subject.body, &asked.start(), &exact, &options);
        let document = document(&body.subject, &asked, &times, &motion);
        ([0, 1].map(|side| enclosure_rows(&motion, side)), document, enclosures(&motion))
    };
    let (rows, document, decimals) = work::run(python, 1, &stop, work)?;
    let out = PyDict::new(python);
    out.set_item("time", array(python, document.times.iter().copied()))?;
    let vector = |name: &str, value: &dyn Fn(&EnclosureRow) -> [f64; 3]| {
        ["lo", "hi"]
            .iter()
            .zip(&rows)
            .try_for_each(|(end, rows)| out.set_item(format!("{name}_{end}"), vectors(python, rows.iter().map(value))?))
    };
    vector("gamma", &|row| row.gamma)?;
    vector("omega", &|row| row.omega)?;
    for k in 0..3 {
        vector(&format!("rotation{}", k + 1), &|row| row.rotation[k])?;
    }
    for (end, rows) in ["lo", "hi"].iter().zip(&rows) {
        out.set_item(format!("attitude_{end}"), vectors(python, rows.iter().map(|row| row.quaternion))?)?;
    }
    out.set_item("meta", json(&document)?)?;
    out.set_item("decimals", json(&decimals)?)?;
    Ok(out)
}
