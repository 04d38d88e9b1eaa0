//! `bifdiag classify`: the type of U, E and P at one point, or at many.

use std::sync::{Arc, OnceLock};

use proof::{CertifiedAtlas, NotProved};
use rayon::prelude::*;
use schema::{Accuracy, ClassificationDocument, ComponentDocument, Status};
use thiserror::Error;
use top::atlas::Atlas;
use top::body::{Body, Number};
use top::classify::{Classification, ClassifyError, classify};

use super::arguments::ClassifyArguments;
use super::batch::{self, Query, Wanted};
use super::failure::{Failure, InputError};
use super::report::Report;
use super::subject::Subject;
use super::table::{Table, significant};
use super::timings::Timings;
use super::{layout, output};

/// So many points of one body in a row are answered cold before the body is prepared: about what preparing costs.
/// The choice depends on the lines alone, never on how they arrive, so that equal input gives equal output.
const COLD_POINTS: usize = 4;

pub fn run(arguments: &ClassifyArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let accuracy = arguments.accuracy.level();
    let (h, l) = (&arguments.energy, &arguments.momentum);
    if let Some(path) = arguments.batch.path(&[("--h", h.is_some()), ("--l", l.is_some())])? {
        let subject = arguments.body.optional_subject()?;
        let mut preparation = Preparation::default();
        return batch::run(path, &arguments.batch, subject.as_ref(), Wanted::Point, quiet, |queries| {
            timings.stage("chunk", || preparation.answer(queries, accuracy))
        });
    }
    let subject = arguments.body.subject()?;
    let h = h.as_ref().ok_or(InputError::NoPoint { missing: "--h", example: "the energy, such as --h 3.8" })?;
    let l = l.as_ref().ok_or(InputError::NoPoint { missing: "--l", example: "the momentum, such as --l 3.25" })?;
    let answer = if accuracy == Accuracy::Certified {
        timings.stage("classify", || CertifiedAtlas::new(&subject.body))?.classify(h, l)
    } else {
        timings.stage("classify", || classify(&subject.body, h, l))?
    };
    let mut document = documents::classification(&subject.body, h, l, &answer, accuracy);
    document.inertia.clone_from(&subject.inertia);
    let text = if arguments.json { layout::text(&document)? } else { report(&subject, &document) };
    Ok(output::print(text.as_bytes())?)
}

/// Why a line of a batch has no answer.
#[derive(Debug, Error)]
enum Unanswered {
    #[error(transparent)]
    NotProved(#[from] NotProved),
    #[error(transparent)]
    Classify(#[from] ClassifyError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

/// Points of the same body in a row; after the first few the body is prepared, once. A proof is made once in any case.
#[derive(Debug, Default)]
struct Preparation {
    body: Option<Body>,
    length: usize,
    prepared: Arc<Prepared>,
}

/// What answers further points of a body, made when first asked for.
#[derive(Debug, Default)]
struct Prepared {
    atlas: OnceLock<Option<Atlas>>,
    proof: OnceLock<Result<CertifiedAtlas, NotProved>>,
}

/// A query and what is, or will be, prepared of its body.
struct Job<'a> {
    query: &'a Query,
    prepared: Arc<Prepared>,
    /// To be answered without an atlas.
    cold: bool,
}

impl Preparation {
    /// Answers queries in parallel, in their order.
    fn answer(&mut self, queries: &[Query], accuracy: Accuracy) -> Vec<Result<String, Unanswered>> {
        let jobs: Vec<_> = queries.iter().map(|query| self.job(query)).collect();
        jobs.par_iter()
            .map(|job| {
                let Query { body, l, .. } = job.query;
                let h = job.query.h.clone().unwrap_or_else(|| Number::from_rational(0.into()));
                let answer = job.answer(&h, accuracy)?;
                let mut document = documents::classification(body, &h, l, &answer, accuracy);
                document.inertia.clone_from(&job.query.inertia);
                Ok(serde_json::to_string(&document)?)
            })
            .collect()
    }

    fn job<'a>(&mut self, query: &'a Query) -> Job<'a> {
        if self.body.as_ref() == Some(&query.body) {
            self.length += 1;
        } else {
            *self = Self { body: Some(query.body.clone()), length: 1, prepared: Arc::default() };
        }
        Job { query, prepared: Arc::clone(&self.prepared), cold: self.length <= COLD_POINTS }
    }
}

impl Job<'_> {
    fn answer(&self, h: &Number, accuracy: Accuracy) -> Result<Classification, Unanswered> {
        let Query { body, l, .. } = self.query;
        if accuracy == Accuracy::Certified {
            let proof = self.prepared.proof.get_or_init(|| CertifiedAtlas::new(body));
            return Ok(proof.as_ref().map_err(Clone::clone)?.classify(h, l));
        }
        // A body of which no atlas can be made is still answered point by point.
        let atlas = if self.cold { None } else { self.prepared.atlas.get_or_init(|| Atlas::new(body).ok()).as_ref() };
        Ok(atlas.map_or_else(|| classify(body, h, l), |atlas| atlas.classify(h, l))?)
    }
}

fn report(subject: &Subject, document: &ClassificationDocument) -> String {
    let mut report = Report::default();
    subject.head(&mut report);
    report.line(format!("h = {}", document.h));
    report.line(format!("l = {}", document.l));
    report.line("");
    report.line(match document.status {
        Status::Regular => "regular",
        Status::Forbidden => "forbidden: h is below the minimum of the effective potential, U is empty",
        Status::Critical => "critical: exactly on a curve; the classes that meet there are",
        Status::Undecided => "undecided: closer to a curve than the error bound; the possible classes are",
    });
    if let Some(components) = document.components.as_ref().filter(|components| !components.is_empty()) {
        report.line("");
        report.line(component_table(components));
    }
    for (i, candidate) in document.candidates.iter().enumerate() {
        report.line("");
        report.line(format!("({})", i + 1));
        report.line(component_table(candidate));
    }
    report.line("");
    let margin = &document.margin;
    report.line(format!(
        "margin: {} in h to {} (error bound {})",
        significant(margin.h, 6),
        margin.nearest,
        significant(margin.error_bound, 2),
    ));
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

/// The components of one class.
fn component_table(class: &[ComponentDocument]) -> String {
    if class.is_empty() {
        return "U is empty\n".to_owned();
    }
    let mut table = Table::new(&["U", "E", "P", "genus", "poles"]);
    let missing = || "-".to_owned();
    for component in class {
        table.row([
            component.accessible_region.clone(),
            component.energy_surface.clone(),
            component.section.clone().unwrap_or_else(missing),
            component.genus.map_or_else(missing, |genus| genus.to_string()),
            component.poles.as_ref().map_or_else(missing, |poles| poles.join(" ")),
        ]);
    }
    table.text()
}
