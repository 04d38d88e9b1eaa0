//! The Python package: a thin guest of the library.

use pyo3::prelude::*;

mod answers;
mod atlas;
mod body;
mod errors;

/// The compiled part of the package `bifdiag`.
#[pymodule]
mod _core {
    #[pymodule_export]
    use crate::answers::{Classification, Component, Equilibrium};
    #[pymodule_export]
    use crate::atlas::{Atlas, Region};
    #[pymodule_export]
    use crate::body::Body;
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
