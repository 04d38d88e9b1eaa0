//! The straightened plane as arrays.

use bifdiag::plot::StraightDiagram;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::columns::vectors;
use crate::picture::describe;

/// Where everything of an atlas lies in the straightened plane, in the unit square.
#[pyclass(frozen, module = "bifdiag._core")]
pub struct Straightened(pub StraightDiagram);

#[pymethods]
impl Straightened {
    /// `regions`, `points` (of each stroke), `levels`, `events`, `momenta`, `energies`, `l_end`, and what is drawn.
    fn drawing<'py>(&self, python: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let line = |points: &Vec<[f64; 2]>| vectors(python, points.iter().copied());
        let lines = |all: &Vec<Vec<[f64; 2]>>| all.iter().map(line).collect::<PyResult<Vec<_>>>();
        let drawn = &self.0;
        let out = PyDict::new(python);
        out.set_item("regions", drawn.regions.iter().map(lines).collect::<PyResult<Vec<_>>>()?)?;
        out.set_item("points", lines(&drawn.strokes)?)?;
        out.set_item("levels", lines(&drawn.levels)?)?;
        out.set_item("events", drawn.events.clone())?;
        out.set_item("momenta", drawn.momenta.clone())?;
        out.set_item("energies", drawn.energies.clone())?;
        out.set_item("l_end", drawn.l_end)?;
        describe(&out, &drawn.described)?;
        Ok(out)
    }

    /// Where points [h, l] lie; NaN where there is no place.
    fn positions<'py>(
        &self,
        python: Python<'py>,
        h: &Bound<'py, PyArray1<f64>>,
        l: &Bound<'py, PyArray1<f64>>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let (h, l) = (h.readonly(), l.readonly());
        let points = h.as_slice()?.iter().zip(l.as_slice()?).map(|(h, l)| [*h, l.abs()]);
        vectors(python, points.map(|point| self.0.position(point).unwrap_or([f64::NAN; 2])))
    }
}
