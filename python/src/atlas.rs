//! Atlases.

use std::sync::atomic::AtomicBool;

use bifdiag::documents::{self, DocumentOptions, Located, Subject, atlas::document};
use bifdiag::proof::Prepared;
use bifdiag::schema::Accuracy;
use bifdiag::{plot, top};
use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::prelude::*;

use crate::texts::{json, number};
use crate::{errors, places, work};

/// A level of accuracy by its name.
pub fn accuracy(level: &str) -> PyResult<Accuracy> {
    match level {
        "exact" => Ok(Accuracy::Exact),
        "fast" => Ok(Accuracy::Fast),
        _ => Err(errors::wrong(format!("accuracy = {level:?}: the levels are \"exact\" and \"fast\""))),
    }
}

/// Every region of the (h, l) half-plane of one body, ready to answer further points.
#[pyclass(frozen, module = "bifdiag._core")]
pub struct Atlas {
    subject: Subject,
    prepared: Prepared,
}

impl Atlas {
    /// An atlas that was made.
    pub fn of(python: Python<'_>, subject: &Subject, accuracy: Accuracy) -> PyResult<Self> {
        let atlas = Self::unmade(subject, accuracy);
        if python.detach(|| atlas.prepared.atlas().is_none()) {
            let missing = python.detach(|| bifdiag::atlas_of(&subject.body, accuracy.into()));
            return Err(missing.map_or_else(|error| errors::range(&error), |_| errors::wrong("there is no atlas")));
        }
        Ok(atlas)
    }

    /// One that is made when it is needed; without it points are still answered.
    pub fn unmade(subject: &Subject, accuracy: Accuracy) -> Self {
        Self { subject: subject.clone(), prepared: Prepared::new(subject.body.clone(), accuracy.into()) }
    }

    fn atlas(&self) -> &top::atlas::Atlas {
        self.prepared.atlas().expect("an atlas in the hands of Python is made")
    }

    fn accuracy(&self) -> Accuracy {
        self.prepared.accuracy().into()
    }

    fn document(&self, options: &DocumentOptions) -> bifdiag::schema::AtlasDocument {
        let mut document = document(self.atlas(), &DocumentOptions { accuracy: self.accuracy(), ..*options });
        documents::atlas::attach_part(&mut document, &self.subject);
        document
    }
}

#[pymethods]
impl Atlas {
    /// The regions of the document, without their outlines and cells.
    fn regions(&self, python: Python<'_>) -> PyResult<String> {
        python.detach(|| {
            let mut regions = documents::atlas::regions(self.atlas());
            for region in &mut regions {
                region.cells.clear();
            }
            json(&regions)
        })
    }

    /// The events of the document.
    fn events(&self, python: Python<'_>) -> PyResult<String> {
        python.detach(|| json(&documents::atlas::events(self.atlas())))
    }

    /// The text of atlas.json, as the command line writes it.
    fn to_json(&self, python: Python<'_>) -> PyResult<String> {
        let text = python.detach(|| documents::layout::text(&self.document(&DocumentOptions::default())));
        text.map_err(|error| errors::range(&error))
    }

    /// The picture of the command line.
    fn svg(&self, python: Python<'_>) -> PyResult<String> {
        let picture = python.detach(|| {
            let document = self.document(&DocumentOptions::default());
            plot::draw(&document, None, &plot::DiagramOptions::default())
        });
        picture.map(|picture| picture.svg).map_err(|error| errors::range(&error))
    }

    /// The type at one point: the document.
    pub fn classify(&self, python: Python<'_>, h: &str, l: &str) -> PyResult<String> {
        let (h, l) = (number(h)?, number(l)?);
        let found = python.detach(|| self.prepared.classify(&h, &l)).map_err(|error| errors::range(&error))?;
        let located = Located::of(Some(&self.prepared));
        json(&documents::classification(&self.subject, &h, &l, &found, self.accuracy(), located))
    }

    /// The place of each point (h, l) of two equally long arrays of doubles.
    fn places<'py>(
        &self,
        python: Python<'py>,
        h: &Bound<'py, PyArray1<f64>>,
        l: &Bound<'py, PyArray1<f64>>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let (h, l) = (h.readonly(), l.readonly());
        let (h, l) = (h.as_slice()?, l.as_slice()?);
        let stop = AtomicBool::new(false);
        let found = work::run(python, threads, &stop, || places::of_points(&self.prepared, h, l, &stop))?;
        let found = found.expect("an atlas in the hands of Python is made");
        Ok(found.map_err(|error| errors::range(&error))?.into_pyarray(python))
    }

    /// The place of one point of exact texts.
    fn place(&self, python: Python<'_>, h: &str, l: &str) -> PyResult<i64> {
        let (h, l) = (number(h)?, number(l)?);
        python.detach(|| places::of_point(&self.prepared, &h, &l)).map_err(|error| errors::range(&error))
    }
}
