//! Bodies, and the questions that are asked of them alone.

use bifdiag::documents::{self, Subject};
use bifdiag::schema::{Accuracy, PartDocument};
use pyo3::prelude::*;

use crate::atlas::{Atlas, accuracy};
use crate::texts::json;
use crate::{errors, part};

/// A heavy rigid body with a fixed point: principal moments A and centre of mass r, exact.
#[pyclass(frozen, module = "bifdiag._core")]
pub struct Body {
    pub subject: Subject,
    /// Some number of the part is known to within so much only; the body has the nominal ones.
    pub is_measured: bool,
}

impl From<bifdiag::body::Body> for Body {
    fn from(body: bifdiag::body::Body) -> Self {
        Self { subject: body.into(), is_measured: false }
    }
}

#[pymethods]
impl Body {
    #[new]
    #[expect(clippy::needless_pass_by_value, reason = "what was taken out of a sequence")]
    fn new(moments: [String; 3], center: [String; 3]) -> PyResult<Self> {
        Ok(bifdiag::body::Body::parse(&moments, &center).map_err(|error| errors::body(&error))?.into())
    }

    /// A1, A2, A3 and r1, r2, r3 of a named body, as they are written there.
    #[staticmethod]
    fn preset(name: &str) -> PyResult<Self> {
        let known =
            || bifdiag::body::Preset::all().iter().map(bifdiag::body::Preset::name).collect::<Vec<_>>().join(", ");
        let preset = bifdiag::body::Preset::find(name)
            .ok_or_else(|| errors::wrong(format!("there is no body `{name}`; the named bodies are {}", known())))?;
        Ok(preset.body().into())
    }

    /// Names of the named bodies, each with a note.
    #[staticmethod]
    fn presets() -> Vec<(&'static str, &'static str)> {
        bifdiag::body::Preset::all().iter().map(|preset| (preset.name(), preset.note())).collect()
    }

    /// A1, A2, A3 as they were given.
    #[getter]
    fn moments(&self) -> [String; 3] {
        documents::texts(self.subject.body.moments())
    }

    /// r1, r2, r3 as they were given.
    #[getter]
    fn center(&self) -> [String; 3] {
        documents::texts(self.subject.body.center())
    }

    /// The exact values, whatever their texts; of a part also what it was made from.
    fn values(&self) -> Vec<String> {
        let numbers = self.subject.body.moments().iter().chain(self.subject.body.center());
        let values = numbers.map(|number| number.value().to_string());
        let part = self.subject.part.iter().flat_map(|part| {
            let PartDocument { inertia, com, mass, g, units, .. } = part;
            inertia.iter().flatten().chain(com).chain([mass, g, units]).cloned()
        });
        values.chain(part).collect()
    }

    /// The block `part` of the documents, if the body is a real part.
    fn part(&self) -> PyResult<Option<String>> {
        self.subject.part.as_ref().map(json).transpose()
    }

    /// The units of mass, length and time of a part in kg, m and s.
    fn scales(&self) -> PyResult<Option<[f64; 3]>> {
        let units = self.subject.part.as_ref().map(|part| part::parsed(&part.units)).transpose()?;
        Ok(units.map(|units| [units.mass(), units.length(), units.time()].map(|factor| factor.to_f64().value())))
    }

    /// Whether some number of the part is known to within so much only.
    fn measured(&self) -> bool {
        self.is_measured
    }

    /// Whether some distribution of mass has these moments.
    fn physical(&self) -> bool {
        self.subject.part.as_ref().map_or(!self.subject.body.flags().unphysical, |part| part.physical)
    }

    /// Every region of the (h, l) plane, with its proof if that is wanted.
    #[pyo3(name = "atlas")]
    fn py_atlas(&self, python: Python<'_>, level: &str, certificate: bool) -> PyResult<Atlas> {
        let accuracy = accuracy(level)?;
        if certificate && accuracy == Accuracy::Fast {
            return Err(errors::wrong(
                "a certificate is a proof, and the accuracy \"fast\" does without; leave out one of them",
            ));
        }
        Atlas::of(python, &self.subject, accuracy, certificate)
    }

    /// The type of U, E and P at one point: the document.
    fn classify(&self, python: Python<'_>, h: &str, l: &str, level: &str) -> PyResult<String> {
        Atlas::unmade(&self.subject, accuracy(level)?).classify(python, h, l)
    }
}
