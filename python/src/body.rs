//! Bodies, and the questions that are asked of them alone.

use bifdiag::{Number, top};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat};

use crate::answers::{Classification, Equilibrium};
use crate::atlas::Atlas;
use crate::errors;

/// What `Body(…)` is called with: A and r.
type Arguments = ([String; 3], [String; 3]);

/// A number as it is meant: a float is its shortest decimal, everything else its own text.
pub fn number(value: &Bound<'_, PyAny>) -> PyResult<Number> {
    if value.is_instance_of::<PyBool>() {
        return Err(PyTypeError::new_err("a number is needed, not a bool"));
    }
    if let Ok(float) = value.cast::<PyFloat>() {
        return Number::from_f64(float.value()).map_err(errors::input);
    }
    value.str()?.to_str()?.parse().map_err(errors::input)
}

fn triple(name: &str, values: &Bound<'_, PyAny>) -> PyResult<[Number; 3]> {
    let numbers = values.try_iter()?.map(|value| number(&value?)).collect::<PyResult<Vec<_>>>()?;
    numbers
        .try_into()
        .map_err(|numbers: Vec<_>| errors::body(format!("{name} needs three numbers, {} given", numbers.len())))
}

/// A heavy rigid body with a fixed point: principal moments A and centre of mass r, exact.
#[pyclass(frozen, eq, module = "bifdiag")]
#[derive(Clone, PartialEq)]
pub struct Body {
    pub inner: top::body::Body,
}

#[pymethods]
impl Body {
    #[new]
    #[pyo3(signature = (A, r))]
    #[expect(non_snake_case, reason = "the paper's symbol")]
    fn new(A: &Bound<'_, PyAny>, r: &Bound<'_, PyAny>) -> PyResult<Self> {
        let inner = top::body::Body::new(triple("A", A)?, triple("r", r)?).map_err(errors::body)?;
        Ok(Self { inner })
    }

    /// A named body, such as "paper" or "katok:3".
    #[staticmethod]
    fn preset(name: &str) -> PyResult<Self> {
        let known = || top::body::Preset::all().iter().map(top::body::Preset::name).collect::<Vec<_>>().join(", ");
        let preset = top::body::Preset::find(name)
            .ok_or_else(|| errors::input(format!("there is no body `{name}`; the named bodies are {}", known())))?;
        Ok(Self { inner: preset.body() })
    }

    /// A1, A2, A3 as they were given.
    #[getter(A)]
    fn moments(&self) -> [String; 3] {
        bifdiag::documents::texts(self.inner.moments())
    }

    /// r1, r2, r3 as they were given.
    #[getter]
    fn r(&self) -> [String; 3] {
        bifdiag::documents::texts(self.inner.center())
    }

    /// Every region of the (h, l) plane.
    fn atlas(&self, python: Python<'_>) -> PyResult<Atlas> {
        Atlas::of(python, &self.inner)
    }

    /// The type of U, E and P at one point.
    fn classify(&self, h: &Bound<'_, PyAny>, l: &Bound<'_, PyAny>) -> PyResult<Classification> {
        let found = bifdiag::classify(&self.inner, &number(h)?, &number(l)?).map_err(errors::range)?;
        Ok(Classification::of(&found))
    }

    /// All relative equilibria at one l, by rising h.
    fn critical(&self, l: &Bound<'_, PyAny>) -> PyResult<Vec<Equilibrium>> {
        let found = bifdiag::critical(&self.inner, &number(l)?).map_err(errors::range)?;
        Ok(found.list.iter().map(Equilibrium::of).collect())
    }

    fn __reduce__(&self, python: Python<'_>) -> (Py<PyAny>, Arguments) {
        let class = python.get_type::<Self>().into_any().unbind();
        (class, (self.moments(), self.r()))
    }

    fn __repr__(&self) -> String {
        format!("Body(A=[{}], r=[{}])", self.moments().join(", "), self.r().join(", "))
    }
}
