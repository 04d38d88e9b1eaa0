//! Motions as arrays.

use std::sync::atomic::AtomicBool;

use bifdiag::dynamics::field::{HeavyTop, State, dot, norm};
use bifdiag::dynamics::motion::{MotionOptions, MotionSample, follow};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::body::Body;
use crate::columns::{array, vectors};
use crate::{errors, work};

/// A start at time 0 and what is wanted from there.
#[derive(FromPyObject)]
pub struct Request {
    /// The vertical, of any length.
    #[pyo3(item)]
    gamma: [f64; 3],
    /// Angular momentum or, if `is_omega`, angular velocity.
    #[pyo3(item)]
    l: [f64; 3],
    #[pyo3(item)]
    is_omega: bool,
    /// They rise.
    #[pyo3(item)]
    times: Vec<f64>,
    #[pyo3(item)]
    phi: f64,
    #[pyo3(item)]
    tolerance: f64,
}

/// The columns of a motion.
#[pyfunction]
pub fn motion<'py>(python: Python<'py>, body: &Body, request: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyDict>> {
    let Request { gamma, l, is_omega, times, phi, tolerance } = request.extract()?;
    let top = HeavyTop::new(&body.subject.body);
    let start = State { gamma: direction(gamma), l: if is_omega { top.inertia(l) } else { l } };
    let stop = AtomicBool::new(false);
    let options = MotionOptions { tolerance, phi, stop: &stop };
    let motion = work::run(python, 1, &stop, || follow(&top, &start, &times, &options))?
        .map_err(|error| errors::input(&error))?;
    if let Some(failure) = motion.report.failure {
        return Err(errors::range(&failure));
    }
    let samples = &motion.samples;
    let floats = |value: fn(&MotionSample) -> f64| array(python, samples.iter().map(value));
    let out = PyDict::new(python);
    out.set_item("time", floats(|s| s.time))?;
    out.set_item("gamma", vectors(python, samples.iter().map(|s| s.gamma))?)?;
    out.set_item("l", vectors(python, samples.iter().map(|s| s.l))?)?;
    out.set_item("omega", vectors(python, samples.iter().map(|s| s.omega))?)?;
    out.set_item("theta", floats(|s| s.theta))?;
    out.set_item("psi", floats(|s| s.psi))?;
    out.set_item("phi", floats(|s| s.phi))?;
    out.set_item("quaternion", vectors(python, samples.iter().map(|s| s.attitude.components()))?)?;
    out.set_item("energy", top.energy(&start))?;
    out.set_item("momentum", dot(start.gamma, start.l))?;
    out.set_item("energy_drift", motion.report.drift.energy)?;
    Ok(out)
}

/// A vector of length 1; one that has it to the last bits is left as it is.
fn direction(v: [f64; 3]) -> [f64; 3] {
    if (dot(v, v) - 1.0).abs() <= 2.0 * f64::EPSILON {
        return v;
    }
    let largest = v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let v = v.map(|x| x / largest);
    let length = norm(v);
    v.map(|x| x / length)
}
