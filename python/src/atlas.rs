//! Atlases and their regions.

use bifdiag::top::atlas::Place;
use bifdiag::top::diagram::RegionId;
use bifdiag::top::topology::signature;
use bifdiag::{documents, top};
use pyo3::prelude::*;

use crate::answers::Component;
use crate::body::{Body, number};
use crate::errors;

/// Every region of the (h, l) half-plane of one body, ready to answer further points.
#[pyclass(frozen, module = "bifdiag")]
pub struct Atlas {
    inner: top::atlas::Atlas,
}

impl Atlas {
    pub fn of(python: Python<'_>, body: &top::body::Body) -> PyResult<Self> {
        let inner = python.detach(|| top::atlas::Atlas::new(body)).map_err(errors::range)?;
        Ok(Self { inner })
    }
}

#[pymethods]
impl Atlas {
    #[getter]
    fn body(&self) -> Body {
        Body { inner: self.inner.body().clone() }
    }

    /// The regions, in the order of their ids.
    #[getter]
    fn regions(&self) -> Vec<Region> {
        self.inner.regions().ids().map(|number| Region::of(&self.inner, number)).collect()
    }

    /// The id of the region of a point; None when forbidden or not decided.
    fn region(&self, h: &Bound<'_, PyAny>, l: &Bound<'_, PyAny>) -> PyResult<Option<String>> {
        let (h, l) = (number(h)?.to_f64(), number(l)?.to_f64());
        let location = self.inner.locate(h, l).map_err(errors::input)?;
        Ok(if let Place::Region(region) = location.place { Some(region.to_string()) } else { None })
    }

    /// The text of atlas.json, as the command line writes it.
    fn to_json(&self, python: Python<'_>) -> PyResult<String> {
        let text = python.detach(|| {
            documents::layout::text(&documents::atlas::document(&self.inner, &documents::DocumentOptions::default()))
        });
        text.map_err(errors::range)
    }

    fn __repr__(&self) -> String {
        let regions = self.regions().iter().map(Region::line).collect::<Vec<_>>();
        format!("Atlas of {} regions: {}", regions.len(), regions.join(", "))
    }
}

/// A region of the (h, l) half-plane.
#[pyclass(frozen, get_all, module = "bifdiag")]
pub struct Region {
    id: String,
    signature: Option<String>,
    components: Option<Vec<Component>>,
    /// A point (h, l) inside.
    sample: (f64, f64),
}

impl Region {
    fn of(atlas: &top::atlas::Atlas, number: RegionId) -> Self {
        let components = atlas.components(number).ok();
        let sample = atlas.sample(number);
        Self {
            id: number.to_string(),
            signature: components.and_then(signature),
            components: components.map(Component::list),
            sample: (sample.h, sample.l),
        }
    }

    fn line(&self) -> String {
        format!("{} {}", self.id, self.signature.as_deref().unwrap_or("-"))
    }
}

#[pymethods]
impl Region {
    fn __repr__(&self) -> String {
        format!("Region({})", self.line())
    }
}
