//! Many points at once: a grid of energies and momenta, or a batch.

use std::path::Path;
use std::sync::Arc;

use bifdiag_body::Number;
use bifdiag_diagram::atlas::{Region, Spot};
use bifdiag_diagram::fast::FastError;
use bifdiag_diagram::topology::Classification;
use bifdiag_documents::{GridAxis, Subject};
use bifdiag_exact::{AnswerError, Solver, classify};
use bifdiag_numbers::table::Id;
use bifdiag_schema::Accuracy;
use rayon::prelude::*;

use crate::cli::batch::Query;
use crate::cli::export::{Archive, FileSet};
use crate::cli::failure::Failure;
use crate::cli::input::values::Grid;
use crate::cli::terminal::{Report, Timings, counted, print};

/// The file of a grid, whose extension selects the format: true for a picture.
pub fn target(out: Option<&Path>) -> Result<(bool, &Path), Failure> {
    let path = out.ok_or_else(|| Failure::input("--grid needs --out FILE.npz or --out FILE.png"))?;
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("npz") => Ok((false, path)),
        Some("png") => Ok((true, path)),
        _ => Err(Failure::input(format!(
            "--out {}: the extension selects the format; give FILE.npz or FILE.png",
            path.display()
        ))),
    }
}

/// The values of the array `region`: the index of the region, or one of the codes of [`grid`].
fn code(spot: Spot) -> i32 {
    match spot {
        Spot::Region(region) => i32::try_from(region.index()).unwrap_or(i32::MAX),
        Spot::Forbidden => -1,
        Spot::Critical => -2,
        Spot::Undecided => -3,
    }
}

/// Computes the grid and writes it.
pub fn grid(
    subject: &Subject,
    asked: &Grid,
    accuracy: Accuracy,
    (is_picture, path): (bool, &Path),
    timings: &Timings,
) -> Result<(), Failure> {
    let prepared = Solver::new(subject.body.clone(), accuracy);
    let [h, l] = [&asked.h, &asked.l].map(GridAxis::values);
    let atlas = prepared.atlas().ok_or_else(|| Failure::work(format!("--grid: {}", prepared.without_atlas())))?;
    let rows: Result<Vec<Vec<Spot>>, AnswerError> =
        timings.stage("rows", || l.par_iter().map(|&l| prepared.row(l, &h).unwrap_or(Ok(Vec::new()))).collect());
    let codes: Vec<i32> = rows
        .map_err(|error| Failure::input(format!("--grid: {error}")).because(error))?
        .into_iter()
        .flatten()
        .map(code)
        .collect();
    let bytes = if is_picture {
        let kind = |region: &Region| {
            let components = region.components.as_deref().ok();
            components.and_then(bifdiag_diagram::topology::signature).unwrap_or_default()
        };
        let kinds: Vec<String> = atlas.regions().iter().map(kind).collect();
        bifdiag_plot::draw_codes(h.len(), &codes, &kinds)?
    } else {
        let ids: Vec<String> = atlas.regions().ids().map(|region| region.to_string()).collect();
        let meta = bifdiag_schema::json(&bifdiag_documents::grid(subject, &asked.h, &asked.l, accuracy))?;
        archive(&h, &l, &codes, &ids, &meta)?
    };
    let mut files = FileSet::new(Path::new("."));
    files.add_at(path, bytes);
    print(Report::of_written(&timings.stage("files", || files.write())?).text())?;
    let undecided = codes.iter().filter(|code| **code == -3).count();
    if undecided > 0 && accuracy == Accuracy::Exact {
        return Err(Failure::work(format!(
            "{} of the grid could not be answered: -3 in the table",
            counted(undecided, "point", "points")
        )));
    }
    Ok(())
}

fn archive(h: &[f64], l: &[f64], codes: &[i32], ids: &[String], meta: &str) -> Result<Vec<u8>, zip::result::ZipError> {
    let mut archive = Archive::new();
    archive.floats("h", h)?;
    archive.floats("l", l)?;
    archive.matrix("region", l.len(), codes)?;
    archive.texts("regions", ids)?;
    archive.text("meta", meta)?;
    archive.bytes()
}

/// Points of one body in a row that are answered before the body is prepared, where no regions are wanted: about what
/// preparing costs. The choice depends on the lines alone, never on how they arrive, so that equal input gives equal
/// output.
const COLD_POINTS: usize = 4;

/// Room for an answer, so that it is not moved while it is written.
const LINE: usize = 1024;

/// A point without an answer; where that is due to its momentum, the input is wrong.
pub fn unanswered(error: AnswerError) -> Failure {
    match error {
        AnswerError::Fast(FastError::Momentum(error)) => Failure::input(format!("--l: {error}")),
        error => Failure::work("the point could not be classified").because(error),
    }
}

/// Likewise of a line of a batch, which has no options.
fn line_unanswered(error: &AnswerError) -> Failure {
    match error {
        AnswerError::Fast(FastError::Momentum(_)) => Failure::input(error),
        _ => Failure::work(error),
    }
}

/// Points of the same body in a row; after the first few the body is prepared, once.
#[derive(Debug)]
pub struct Preparation {
    accuracy: Accuracy,
    /// Whether the ids of regions are wanted.
    regions: bool,
    length: usize,
    last: Option<(Arc<Subject>, Arc<Solver>)>,
}

/// A query and what is, or will be, prepared of its body.
struct Job<'a> {
    query: &'a Query,
    prepared: Arc<Solver>,
    /// To be answered without an atlas.
    cold: bool,
}

impl Preparation {
    /// Nothing is prepared yet.
    pub fn new(accuracy: Accuracy, regions: bool) -> Self {
        Self { accuracy, regions, length: 0, last: None }
    }

    /// Answers queries in parallel, in their order.
    pub fn answer(&mut self, queries: &[Query]) -> Vec<Result<Vec<u8>, Failure>> {
        let jobs: Vec<_> = queries.iter().map(|query| self.job(query)).collect();
        let (accuracy, regions) = (self.accuracy, self.regions);
        jobs.par_iter()
            .map(|job| {
                let Query { subject, l, .. } = job.query;
                let h = job.query.h.clone().unwrap_or_else(|| Number::from_rational(0.into()));
                let found = job.answer(&h).map_err(|error| line_unanswered(&error))?;
                let prepared = regions.then_some(&*job.prepared);
                let mut text = Vec::with_capacity(LINE);
                bifdiag_schema::write_json(
                    &mut text,
                    &bifdiag_documents::classification(subject, &h, l, &found, accuracy, prepared),
                )?;
                Ok(text)
            })
            .collect()
    }

    fn job<'a>(&mut self, query: &'a Query) -> Job<'a> {
        let subject = &query.subject;
        let same = |known: &Arc<Subject>| Arc::ptr_eq(known, subject) || known.body == subject.body;
        let known = self.last.take().filter(|(known, _)| same(known)).map(|(_, prepared)| prepared);
        self.length = if known.is_some() { self.length + 1 } else { 1 };
        let fresh = || Arc::new(Solver::new(subject.body.clone(), self.accuracy));
        let prepared = known.unwrap_or_else(fresh);
        self.last = Some((Arc::clone(subject), Arc::clone(&prepared)));
        Job { query, prepared, cold: !self.regions && self.length <= COLD_POINTS }
    }
}

impl Job<'_> {
    fn answer(&self, h: &Number) -> Result<Classification, AnswerError> {
        let (body, l) = (&self.query.subject.body, &self.query.l);
        if self.cold { classify(body, h, l, self.prepared.accuracy()) } else { self.prepared.classify(h, l) }
    }
}
