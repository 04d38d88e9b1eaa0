//! Columns of results as arrays of numpy, contiguous.

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// A column of numbers.
pub fn array<T: numpy::Element>(python: Python<'_>, values: impl Iterator<Item = T>) -> Bound<'_, PyArray1<T>> {
    values.collect::<Vec<_>>().into_pyarray(python)
}

/// A column of vectors: (n, WIDTH), contiguous.
pub fn vectors<const WIDTH: usize>(
    python: Python<'_>,
    values: impl ExactSizeIterator<Item = [f64; WIDTH]>,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let rows = values.len();
    array(python, values.flatten()).reshape([rows, WIDTH])
}
