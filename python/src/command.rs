//! The command line of the package.

use std::ffi::OsString;

use pyo3::prelude::*;

/// Runs a command line, its first argument the name of the program, and returns the exit status.
///
/// It prints to the process's own streams and takes over its signals: for a process of its own.
#[pyfunction]
pub fn run(python: Python<'_>, arguments: Vec<OsString>) -> u8 {
    python.detach(|| bifdiag::cli::run(arguments))
}
