//! Errors of the library as the exceptions of the package.

use std::error::Error;

use pyo3::prelude::*;
use pyo3::types::PyType;

fn exception(name: &str, message: String) -> PyErr {
    let class = Python::attach(|python| {
        let class = python.import("bifdiag.errors")?.getattr(name)?.cast_into::<PyType>()?;
        Ok::<_, PyErr>(PyErr::from_type(class, message))
    });
    class.unwrap_or_else(|missing| missing)
}

/// An error with its causes, those left out that its own message repeats.
fn told(error: &dyn Error) -> String {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let text = error.to_string();
        if !message.contains(&text) {
            message = format!("{message}: {text}");
        }
        cause = error.source();
    }
    message
}

/// What the caller gave is wrong.
pub fn input(error: &dyn Error) -> PyErr {
    exception("InputError", told(error))
}

/// The same, in words.
pub fn wrong(message: impl Into<String>) -> PyErr {
    exception("InputError", message.into())
}

/// Not a body.
pub fn body(error: &dyn Error) -> PyErr {
    exception("BodyError", told(error))
}

/// The same, in words.
pub fn no_body(message: impl Into<String>) -> PyErr {
    exception("BodyError", message.into())
}

/// A right question without an answer.
pub fn range(error: &dyn Error) -> PyErr {
    exception("RangeError", told(error))
}

/// A document that somebody changed.
pub fn damaged(name: &str) -> PyErr {
    let message =
        format!("{name} is refused: its bytes are not those that bifdiag writes for an atlas with a certificate");
    exception("VerifyError", message)
}

/// A document that says something wrong.
pub fn refused(error: &dyn Error) -> PyErr {
    exception("VerifyError", told(error))
}
