//! Atlases.

use std::sync::atomic::AtomicBool;

use bifdiag::diagram::atlas::Window;
use bifdiag::documents::{self, DocumentOptions, Drawn, Subject, atlas::document};
use bifdiag::equilibria::curves::CurveName;
use bifdiag::plot::DiagramView;
use bifdiag::schema::{Accuracy, AtlasDocument, WindowDocument};
use bifdiag::{CertifiedAtlas, Curves, Solver, plot};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::columns::{array, vectors};
use crate::picture::describe;
use crate::straightened::Straightened;
use crate::texts::{Numbers, json, number};
use crate::{errors, places, work};

/// So few points are answered sooner than a thread is started.
const FEW: usize = 64;

/// Ranges of h and l.
type Ranges = [[f64; 2]; 2];

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
    prepared: Solver,
    /// The proof, and the atlas as it is proved, if the document is to carry a certificate.
    proved: Option<(CertifiedAtlas, bifdiag::diagram::atlas::Atlas)>,
}

impl Atlas {
    /// An atlas that was made.
    pub fn of(python: Python<'_>, subject: &Subject, accuracy: Accuracy, certificate: bool) -> PyResult<Self> {
        let made = python.detach(|| bifdiag::atlas(&subject.body, accuracy));
        let prepared = Solver::of(made.map_err(|error| errors::range(&error))?, accuracy);
        let mut atlas = Self { subject: subject.clone(), prepared, proved: None };
        if certificate {
            let prove = || {
                let proof = CertifiedAtlas::new(&subject.body).map_err(|error| errors::range(&error))?;
                let drawn = proof.to_atlas().map_err(|error| errors::range(&error))?;
                Ok::<_, PyErr>((proof, drawn))
            };
            atlas.proved = Some(python.detach(prove)?);
        }
        Ok(atlas)
    }

    /// One that is made when it is needed; without it points are still answered.
    pub fn unmade(subject: &Subject, accuracy: Accuracy) -> Self {
        let prepared = Solver::new(subject.body.clone(), accuracy);
        Self { subject: subject.clone(), prepared, proved: None }
    }

    fn atlas(&self) -> &bifdiag::diagram::atlas::Atlas {
        self.prepared.atlas().expect("an atlas in the hands of Python is made")
    }

    fn accuracy(&self) -> Accuracy {
        self.prepared.accuracy()
    }

    fn document(&self, options: &DocumentOptions) -> PyResult<AtlasDocument> {
        if let Some((proof, drawn)) = &self.proved {
            let document = documents::certified_atlas_of(&self.subject, proof, drawn, options);
            return document.map_err(|error| errors::range(&error));
        }
        let mut document = document(self.atlas(), &DocumentOptions { accuracy: self.accuracy(), ..*options });
        documents::atlas::attach_part(&mut document, &self.subject);
        Ok(document)
    }

    fn undrawn(&self) -> PyResult<AtlasDocument> {
        self.document(&DocumentOptions { drawing: Drawn::Nothing, ..DocumentOptions::default() })
    }
}

fn themed(is_dark: bool) -> plot::DiagramOptions {
    let theme = if is_dark { plot::Theme::Dark } else { plot::Theme::Light };
    plot::DiagramOptions { theme, ..plot::DiagramOptions::default() }
}

fn window([h, l]: Ranges) -> WindowDocument {
    WindowDocument { h, l }
}

#[pymethods]
impl Atlas {
    /// The regions of the document, each a text, without their outlines.
    fn regions(&self, python: Python<'_>) -> PyResult<Vec<String>> {
        python.detach(|| {
            let regions = match self.proved {
                Some(_) => self.undrawn()?.regions,
                None => documents::atlas::regions(self.atlas()),
            };
            regions.iter().map(json).collect()
        })
    }

    /// The largest extent of each region in h; `None` if unbounded.
    fn h_widths(&self, python: Python<'_>) -> Vec<Option<f64>> {
        python.detach(|| self.atlas().h_widths().iter().copied().collect())
    }

    /// The events of the document.
    fn events(&self, python: Python<'_>) -> PyResult<String> {
        python.detach(|| match self.proved {
            Some(_) => json(&self.undrawn()?.events),
            None => json(&documents::atlas::events(self.atlas())),
        })
    }

    /// The text of atlas.json, as the command line writes it; a certified one has its changes of verdict in any case.
    fn to_json(
        &self,
        python: Python<'_>,
        ranges: Option<Ranges>,
        drawing: bool,
        verdict_changes: bool,
    ) -> PyResult<String> {
        let drawing = if drawing { Drawn::Everything } else { Drawn::Nothing };
        let options = DocumentOptions { window: ranges.map(window), drawing, ..DocumentOptions::default() };
        let text = python.detach(|| {
            let mut document = self.document(&options)?;
            if verdict_changes && self.proved.is_none() {
                documents::atlas::attach_verdict_changes(&mut document, self.atlas());
            }
            Ok::<_, PyErr>(documents::layout::text(&document))
        })?;
        text.map_err(|error| errors::range(&error))
    }

    /// The picture of the command line.
    fn svg(&self, python: Python<'_>) -> PyResult<String> {
        let picture = python.detach(|| {
            let document = self.document(&DocumentOptions::default())?;
            Ok::<_, PyErr>(plot::draw(&document, Some(&Curves(self.atlas())), &plot::DiagramOptions::default()))
        })?;
        picture.map(|picture| picture.svg).map_err(|error| errors::range(&error))
    }

    /// The view of the command's picture: "plane" or "straight".
    fn view(&self, python: Python<'_>) -> PyResult<&'static str> {
        let chosen = python.detach(|| {
            let document = self.document(&DocumentOptions::default())?;
            let view = plot::chosen_view(&document, Some(&Curves(self.atlas())), &plot::DiagramOptions::default());
            view.map_err(|error| errors::range(&error))
        })?;
        Ok(if chosen == DiagramView::Straight { "straight" } else { "plane" })
    }

    /// What the picture of the plane shows with its insets; of a window what one panel of so many pixels shows.
    fn picture<'py>(
        &self,
        python: Python<'py>,
        is_dark: bool,
        panel: Option<(Ranges, [f64; 2])>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let drawn = python.detach(|| {
            let document = self.document(&DocumentOptions::default())?;
            let source = Curves(self.atlas());
            let options = plot::DiagramOptions { view: DiagramView::Plane, no_samples: true, ..themed(is_dark) };
            let found = match panel {
                Some((ranges, size)) => plot::describe_panel(&document, Some(&source), window(ranges), size, &options),
                None => plot::describe(&document, Some(&source), &options),
            };
            found.map_err(|error| errors::range(&error))
        })?;
        let out = PyDict::new(python);
        describe(&out, &drawn)?;
        Ok(out)
    }

    /// Where everything lies in the straightened plane.
    fn straightened(&self, python: Python<'_>, is_dark: bool) -> PyResult<Straightened> {
        python.detach(|| {
            let document = self.document(&DocumentOptions::default())?;
            let found = plot::straight_diagram(&document, Some(&Curves(self.atlas())), &themed(is_dark));
            Ok(Straightened(found.map_err(|error| errors::range(&error))?))
        })
    }

    /// The outlines [h, l] of each region inside a window.
    fn outlines<'py>(&self, python: Python<'py>, ranges: Ranges) -> PyResult<Vec<Vec<Bound<'py, PyArray2<f64>>>>> {
        let [h, l] = ranges;
        let found = python.detach(|| self.atlas().outlines(&Window { h, l }));
        let arrays = |outlines: &Vec<Vec<[f64; 2]>>| {
            outlines.iter().map(|outline| vectors(python, outline.iter().copied())).collect::<PyResult<_>>()
        };
        found.iter().map(arrays).collect()
    }

    /// Points [h, l] of a curve over a range of l, off by so much in h at most; `None` where it does not run.
    fn polyline<'py>(
        &self,
        python: Python<'py>,
        curve: &str,
        l: [f64; 2],
        tolerance: f64,
    ) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        let name: CurveName = curve.parse().map_err(|error| errors::wrong(format!("{error}")))?;
        let found = python.detach(|| self.atlas().polyline(name, l, tolerance));
        found.map(|points| vectors(python, points.into_iter())).transpose()
    }

    /// The type at one point: the document.
    pub fn classify(&self, python: Python<'_>, h: &str, l: &str) -> PyResult<String> {
        let (h, l) = (number(h)?, number(l)?);
        let found = python.detach(|| self.prepared.classify(&h, &l)).map_err(|error| errors::range(&error))?;
        json(&documents::classification(&self.subject, &h, &l, &found, self.accuracy(), Some(&self.prepared)))
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
        let work = || places::of_points(&self.prepared, h, l, &stop);
        let found = if h.len() <= FEW { python.detach(work) } else { work::run(python, threads, &stop, work)? };
        let found = found.expect("an atlas in the hands of Python is made");
        Ok(found.map_err(|error| errors::range(&error))?.into_pyarray(python))
    }

    /// The place of each point, its distance in h from the nearest curve, a bound on the error of that, and the number of
    /// the curve (-1: none) among `curves`.
    fn measured<'py>(
        &self,
        python: Python<'py>,
        h: &Bound<'py, PyAny>,
        l: &Bound<'py, PyAny>,
        threads: usize,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (h, l) = (Numbers::of(h)?, Numbers::of(l)?);
        let stop = AtomicBool::new(false);
        let point = |k: usize| [h.at(k), l.at(k)];
        let work = || places::measured(&self.prepared, h.len().min(l.len()), point, &stop);
        let found = if h.len() <= FEW { python.detach(work) } else { work::run(python, threads, &stop, work)? };
        let found = found.map_err(|error| errors::range(&error))?;
        let mut curves = Vec::new();
        let mut numbered = |name: CurveName| {
            curves.iter().position(|known| *known == name).unwrap_or_else(|| {
                curves.push(name);
                curves.len() - 1
            })
        };
        let nearest = |point: &places::Measured| {
            point.nearest.map_or(-1, |name| i32::try_from(numbered(name)).expect("curves are few"))
        };
        let out = PyDict::new(python);
        out.set_item("nearest", array(python, found.iter().map(nearest)))?;
        out.set_item("place", array(python, found.iter().map(|point| point.place)))?;
        out.set_item("margin", array(python, found.iter().map(|point| point.margin)))?;
        out.set_item("error", array(python, found.iter().map(|point| point.error)))?;
        out.set_item("curves", curves.iter().map(ToString::to_string).collect::<Vec<_>>())?;
        Ok(out)
    }

    /// The place of one point of exact texts.
    fn place(&self, python: Python<'_>, h: &str, l: &str) -> PyResult<i64> {
        let (h, l) = (number(h)?, number(l)?);
        python.detach(|| places::of_point(&self.prepared, &h, &l)).map_err(|error| errors::range(&error))
    }
}
