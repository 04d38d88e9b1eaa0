//! Points of the same body in a row.

use std::sync::Arc;

use bifdiag_body::Number;
use bifdiag_diagram::fast::FastError;
use bifdiag_diagram::topology::Classification;
use bifdiag_documents::Subject;
use bifdiag_exact::{AnswerError, Solver, classify};
use bifdiag_schema::Accuracy;
use rayon::prelude::*;
use thiserror::Error;

use crate::cli::batch::Query;
use crate::cli::failure::{CommandError, Exit};

/// So many points of one body in a row are answered cold before the body is prepared, where no regions are wanted: about
/// what preparing costs. The choice depends on the lines alone, never on how they arrive, so that equal input gives equal
/// output.
const COLD_POINTS: usize = 4;

/// Room for an answer, so that it is not moved while it is written.
const LINE: usize = 1024;

/// Why a line of a batch has no answer.
#[derive(Debug, Error)]
pub enum LineError {
    #[error(transparent)]
    Answer(#[from] AnswerError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

impl CommandError for LineError {
    fn exit(&self) -> Exit {
        match self {
            Self::Answer(AnswerError::Fast(FastError::Momentum(_))) => Exit::WrongInput,
            Self::Answer(_) | Self::Json(_) => Exit::Failed,
        }
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
    pub fn answer(&mut self, queries: &[Query]) -> Vec<Result<Vec<u8>, LineError>> {
        let jobs: Vec<_> = queries.iter().map(|query| self.job(query)).collect();
        let (accuracy, regions) = (self.accuracy, self.regions);
        jobs.par_iter()
            .map(|job| {
                let Query { subject, l, .. } = job.query;
                let h = job.query.h.clone().unwrap_or_else(|| Number::from_rational(0.into()));
                let found = job.answer(&h)?;
                let prepared = regions.then_some(&*job.prepared);
                let mut text = Vec::with_capacity(LINE);
                serde_json::to_writer(
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
