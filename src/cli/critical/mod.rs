//! `bifdiag critical`: all relative equilibria at one l, or at many.

mod arguments;
mod error;
mod momenta;
mod report;
mod settings;
mod table;

use std::sync::Arc;

use bifdiag_equilibria::critical::{CriticalError, RelativeEquilibria, critical};
use rayon::prelude::*;

use super::batch::{Batch, Query, Wanted};
use super::export::{DataFormat, DataTarget, Exporter, FileSet, answer};
use super::failure::Failure;
use super::terminal::{Timings, print};
use arguments::Method;
use error::{NotFound, Unanswered};
use settings::Settings;

pub use arguments::{CriticalArguments, EXAMPLES};

pub fn run(arguments: &CriticalArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match Settings::new(arguments)? {
        Settings::Momentum { subject, l, method, json } => {
            let found = timings.stage("critical", || match method {
                Method::ClosedForm => critical(&subject.body, l),
                Method::Newton => RelativeEquilibria::new(&subject.body)?.continued(l),
            });
            let document = bifdiag_documents::critical(&subject, l, &found.map_err(NotFound::from)?);
            Ok(answer(json, &document, || report::text(&subject, &document))?)
        }
        Settings::Batch { path, strict, subject } => {
            Batch { path, strict, subject: subject.map(Arc::new), wanted: Wanted::Momentum, quiet }
                .run(|queries| timings.stage("chunk", || lines(queries)))
        }
        Settings::Momenta { subject, ends, count, target } => {
            let columns =
                timings.stage("critical", || table::of(&subject.body, ends, count)).map_err(NotFound::from)?;
            match target {
                DataTarget::Stdout => Ok(print(DataFormat::Csv.bytes(&columns)?)?),
                DataTarget::File { path, format } => {
                    let bytes = timings.stage("table", || format.bytes(&columns))?;
                    let mut files = FileSet::new(path.parent().unwrap_or(&path));
                    files.add_at(&path, bytes);
                    let written = timings.stage("files", || files.write())?;
                    Ok(print(report::written(columns.rows(), &written))?)
                }
            }
        }
    }
}

/// The answers to lines of a batch; of lines in a row about one body its curves are found once in each block.
fn lines(queries: &[Query]) -> Vec<Result<Vec<u8>, Unanswered>> {
    let same = |one: &Query, other: &Query| {
        Arc::ptr_eq(&one.subject, &other.subject) || one.subject.body == other.subject.body
    };
    queries.par_chunks(BLOCK).flat_map_iter(|block| block.chunk_by(same).flat_map(of_one_body)).collect()
}

/// The answers to lines about one body.
fn of_one_body(queries: &[Query]) -> Vec<Result<Vec<u8>, Unanswered>> {
    let prepared = RelativeEquilibria::new(&queries[0].subject.body);
    let line = |query: &Query| {
        let found = prepared.as_ref().map_err(CriticalError::clone)?.at(&query.l)?;
        let mut text = Vec::with_capacity(LINE);
        serde_json::to_writer(&mut text, &bifdiag_documents::critical(&query.subject, &query.l, &found))?;
        Ok(text)
    };
    queries.iter().map(line).collect()
}

/// Lines that one thread answers.
const BLOCK: usize = 256;

/// Room for an answer, so that it is not moved while it is written.
const LINE: usize = 2048;
