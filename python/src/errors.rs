//! Errors of the library as the exceptions of the package.

use std::fmt::Display;

use pyo3::prelude::*;
use pyo3::types::PyType;

fn exception(name: &str, message: String) -> PyErr {
    let class = Python::attach(|python| {
        let class = python.import("bifdiag.errors")?.getattr(name)?.cast_into::<PyType>()?;
        Ok::<_, PyErr>(PyErr::from_type(class, message))
    });
    class.unwrap_or_else(|missing| missing)
}

/// What the caller gave is wrong.
pub fn input(error: impl Display) -> PyErr {
    exception("InputError", error.to_string())
}

/// Not a body.
pub fn body(error: impl Display) -> PyErr {
    exception("BodyError", error.to_string())
}

/// A right question without an answer.
pub fn range(error: impl Display) -> PyErr {
    exception("RangeError", error.to_string())
}
