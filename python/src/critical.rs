//! Relative equilibria at many l as columns.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use bifdiag::documents::codes::{self, Branches, MULTIPLICITIES, place};
use bifdiag::equilibria::critical::{CriticalError, Equilibria, Equilibrium, RelativeEquilibria};
use bifdiag::schema::{NonlinearVerdict, Reason, Stability};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use crate::body::Body;
use crate::columns::vectors;
use crate::texts::Numbers;
use crate::{errors, work};

/// Momenta that are answered before Ctrl-C is looked at again, and before their rows become columns.
const CHUNK: usize = 4096;
/// So few momenta are answered sooner than a thread is started.
const FEW: usize = 16;

#[derive(Default)]
struct Rows {
    l_index: Vec<i64>,
    l: Vec<f64>,
    h: Vec<f64>,
    gamma: Vec<[f64; 3]>,
    omega: Vec<f64>,
    index: Vec<i8>,
    multiplicity: Vec<i8>,
    stability: Vec<i8>,
    verdict: Vec<i8>,
    stable_by: Vec<i8>,
    survives_friction: Vec<bool>,
    eigenvalues: Vec<[f64; 4]>,
    eigenvalue_error: Vec<f64>,
    branch: Vec<i32>,
    branches: Branches,
    error_bound: f64,
    incomplete: bool,
}

impl Rows {
    fn extend(&mut self, found: &Equilibria, place: usize, l: f64) {
        self.error_bound = self.error_bound.max(found.error_bound);
        self.incomplete |= !found.complete;
        for point in &found.list {
            self.l_index.push(i64::try_from(place).unwrap_or(i64::MAX));
            self.l.push(l);
            self.push(point);
        }
    }

    fn push(&mut self, point: &Equilibrium) {
        self.h.push(point.h);
        self.gamma.push(point.gamma);
        self.omega.push(point.omega);
        self.index.push(point.index.cast_signed());
        self.multiplicity.push(codes::multiplicity(point.multiplicity));
        self.stability.push(place(Stability::ALL, &point.stability.term()));
        let found = &point.nonlinear;
        let [verdict, why] = if found.is_deferred() {
            [codes::NONE; 2]
        } else {
            [place(NonlinearVerdict::ALL, &found.verdict), place(Reason::ALL, &found.why)]
        };
        self.verdict.push(verdict);
        self.stable_by.push(why);
        self.survives_friction.push(point.friction.survives == Some(true));
        let [[a, b], [c, d]] = point.eigenvalues.pairs;
        self.eigenvalues.push([a, b, c, d]);
        self.eigenvalue_error.push(point.eigenvalues.error);
        self.branch.push(self.branches.code(point));
    }

    fn columns(self, python: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let out = PyDict::new(python);
        out.set_item("l_index", self.l_index.into_pyarray(python))?;
        out.set_item("l", self.l.into_pyarray(python))?;
        out.set_item("h", self.h.into_pyarray(python))?;
        out.set_item("gamma", vectors(python, self.gamma.into_iter())?)?;
        out.set_item("omega", self.omega.into_pyarray(python))?;
        out.set_item("index", self.index.into_pyarray(python))?;
        out.set_item("multiplicity", self.multiplicity.into_pyarray(python))?;
        out.set_item("stability", self.stability.into_pyarray(python))?;
        out.set_item("verdict", self.verdict.into_pyarray(python))?;
        out.set_item("stable_by", self.stable_by.into_pyarray(python))?;
        out.set_item("survives_friction", self.survives_friction.into_pyarray(python))?;
        out.set_item("eigenvalues", vectors(python, self.eigenvalues.into_iter())?)?;
        out.set_item("eigenvalue_error", self.eigenvalue_error.into_pyarray(python))?;
        out.set_item("branch", self.branch.into_pyarray(python))?;
        let words = PyDict::new(python);
        words.set_item("multiplicity", MULTIPLICITIES.map(codes::multiplicity_word))?;
        words.set_item("stability", Stability::ALL.iter().map(|kind| kind.word()).collect::<Vec<_>>())?;
        words.set_item("verdict", NonlinearVerdict::ALL.iter().map(|verdict| verdict.word()).collect::<Vec<_>>())?;
        words.set_item("stable_by", Reason::ALL.iter().map(|why| why.word()).collect::<Vec<_>>())?;
        words.set_item("branches", self.branches.0)?;
        out.set_item("words", words)?;
        out.set_item("error_bound", self.error_bound)?;
        out.set_item("complete", !self.incomplete)?;
        Ok(out)
    }
}

/// The relative equilibria at each l: columns, some of codes, with the words for these. Without `verdicts` those that only a
/// normal form decides are left out.
#[pyfunction]
pub fn critical<'py>(
    python: Python<'py>,
    body: &Body,
    l: &Bound<'py, PyAny>,
    verdicts: bool,
    threads: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let l = Numbers::of(l)?;
    let mut rows = Rows::default();
    let stop = AtomicBool::new(false);
    let answer = |rows: &mut Rows| {
        let prepared = RelativeEquilibria::new(&body.subject.body)?;
        let prepared = if verdicts { prepared } else { prepared.without_normal_forms() };
        for from in (0..l.len()).step_by(CHUNK) {
            if stop.load(Ordering::Relaxed) {
                break;
            }
            let momenta = from..l.len().min(from + CHUNK);
            for (place, found) in momenta.clone().zip(at_each(&prepared, &l, momenta, &stop)?) {
                rows.extend(&found, place, l.at(place).to_f64());
            }
        }
        Ok::<_, CriticalError>(())
    };
    let done = if l.len() <= FEW {
        python.detach(|| answer(&mut rows))
    } else {
        work::run(python, threads, &stop, || answer(&mut rows))?
    };
    done.map_err(|error| errors::range(&error))?;
    rows.columns(python)
}

fn at_each(
    prepared: &RelativeEquilibria<'_>,
    l: &Numbers,
    momenta: Range<usize>,
    stop: &AtomicBool,
) -> Result<Vec<Equilibria>, CriticalError> {
    let at = |place: usize| {
        let nothing = Equilibria { list: Vec::new(), error_bound: 0.0, complete: true, by_continuation: false };
        if stop.load(Ordering::Relaxed) { Ok(nothing) } else { prepared.at(&l.at(place)) }
    };
    if momenta.len() <= FEW { momenta.map(at).collect() } else { momenta.into_par_iter().map(at).collect() }
}
