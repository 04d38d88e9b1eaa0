//! The command line of the package.

use std::ffi::OsString;
use std::path::PathBuf;

use pyo3::prelude::*;

/// Runs a command line, its first argument the name of the program, and returns the exit status.
///
/// It prints to the process's own streams and takes over its signals: for a process of its own.
#[pyfunction]
pub fn run(python: Python<'_>, arguments: Vec<OsString>) -> u8 {
    python.detach(|| bifdiag::cli::run(arguments))
}

/// Serves the explorer's page from a folder to this machine until the process ends, and returns the port.
#[pyfunction]
#[expect(clippy::needless_pass_by_value, reason = "what was taken out of a path of Python")]
pub fn serve(page: PathBuf) -> PyResult<u16> {
    Ok(bifdiag::cli::serve(&page)?)
}
