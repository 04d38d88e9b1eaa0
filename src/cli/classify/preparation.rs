//! Points of the same body in a row.

use std::sync::{Arc, OnceLock};

use proof::{CertifiedAtlas, NotProved};
use rayon::prelude::*;
use schema::Accuracy;
use thiserror::Error;
use top::atlas::Atlas;
use top::body::{Body, Number};
use top::classify::{Classification, ClassifyError, classify};

use crate::cli::batch::Query;

/// So many points of one body in a row are answered cold before the body is prepared: about what preparing costs.
/// The choice depends on the lines alone, never on how they arrive, so that equal input gives equal output.
const COLD_POINTS: usize = 4;

/// Why a line of a batch has no answer.
#[derive(Debug, Error)]
pub enum Unanswered {
    #[error(transparent)]
    NotProved(#[from] NotProved),
    #[error(transparent)]
    Classify(#[from] ClassifyError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

/// Points of the same body in a row; after the first few the body is prepared, once. A proof is made once in any case.
#[derive(Debug, Default)]
pub struct Preparation {
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
    pub fn answer(&mut self, queries: &[Query], accuracy: Accuracy) -> Vec<Result<String, Unanswered>> {
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
