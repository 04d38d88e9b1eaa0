//! The compiled part of the Python package, a thin guest of the library: it takes exact texts and arrays, and gives arrays
//! and the texts of documents. What users see stands in `package/bifdiag`.

use pyo3::prelude::*;

mod atlas;
mod body;
mod chaos;
mod columns;
mod command;
mod critical;
mod errors;
mod motion;
mod part;
mod periodic;
mod picture;
mod places;
mod proved;
mod section;
mod straightened;
mod survey;
mod texts;
mod work;

/// The compiled part of the package `bifdiag`.
#[pymodule]
mod _core {
    #[pymodule_export]
    use crate::atlas::Atlas;
    #[pymodule_export]
    use crate::body::Body;
    #[pymodule_export]
    use crate::chaos::{chaos_map, chaos_point};
    #[pymodule_export]
    use crate::command::{run, serve};
    #[pymodule_export]
    use crate::critical::critical;
    #[pymodule_export]
    use crate::motion::motion;
    #[pymodule_export]
    use crate::part::{body_of_file, body_of_tensor, in_units};
    #[pymodule_export]
    use crate::periodic::{periodic_families, periodic_orbits};
    #[pymodule_export]
    use crate::proved::proved_motion;
    #[pymodule_export]
    use crate::section::section;
    #[pymodule_export]
    use crate::straightened::Straightened;
    #[pymodule_export]
    use crate::survey::{find, readable, verify};
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
