//! Exact texts in, texts of documents out.

use bifdiag::Number;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::errors;

/// A number of an exact text.
pub fn number(text: &str) -> PyResult<Number> {
    text.parse().map_err(|error: bifdiag::numbers::ParseNumberError| errors::input(&error))
}

/// A document on one line.
pub fn json(document: &impl serde::Serialize) -> PyResult<String> {
    bifdiag::schema::json(document).map_err(|error| errors::range(&error))
}

/// Numbers that were given: an array of doubles, each meaning its shortest decimal, or a list of exact texts.
pub enum Numbers {
    Doubles(Vec<f64>),
    Texts(Vec<Number>),
}

impl Numbers {
    pub fn of(given: &Bound<'_, PyAny>) -> PyResult<Self> {
        match given.cast::<PyArray1<f64>>() {
            Ok(doubles) => Ok(Self::Doubles(doubles.readonly().as_slice()?.to_vec())),
            Err(_texts) => Ok(Self::Texts(
                given.extract::<Vec<String>>()?.iter().map(|text| number(text)).collect::<PyResult<_>>()?,
            )),
        }
    }

    pub fn len(&self) -> usize {
        match self {
            Self::Doubles(doubles) => doubles.len(),
            Self::Texts(texts) => texts.len(),
        }
    }

    /// Number `k`.
    pub fn at(&self, k: usize) -> Number {
        match self {
            Self::Doubles(doubles) => Number::from_f64(doubles[k]).expect("the package passes finite doubles only"),
            Self::Texts(texts) => texts[k].clone(),
        }
    }
}
