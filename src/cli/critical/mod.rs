//! `bifdiag critical`: all relative equilibria at one l, or at many.

mod arguments;
mod error;
mod momenta;
mod report;
mod settings;
mod table;

use documents::Subject;
use std::sync::Arc;

use rayon::prelude::*;
use schema::CriticalDocument;
use top::body::Number;
use top::critical::{CriticalError, critical};

use super::batch::{Batch, Query, Wanted};
use super::export::{DataFormat, DataTarget, Exporter, FileSet, answer};
use super::failure::Failure;
use super::terminal::{Timings, print};
use error::{NotFound, Unanswered};
use settings::Settings;

pub use arguments::{CriticalArguments, EXAMPLES};

pub fn run(arguments: &CriticalArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match Settings::new(arguments)? {
        Settings::Momentum { subject, l, json } => {
            let found = timings.stage("critical", || equilibria(&subject, l));
            let document = found.map_err(NotFound::from)?;
            Ok(answer(json, &document, || report::text(&subject, &document))?)
        }
        Settings::Batch { path, strict, subject } => {
            Batch { path, strict, subject: subject.map(Arc::new), wanted: Wanted::Momentum, quiet }
                .run(|queries| timings.stage("chunk", || queries.par_iter().map(line).collect()))
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

/// The answer to a line of a batch.
fn line(query: &Query) -> Result<Vec<u8>, Unanswered> {
    Ok(serde_json::to_vec(&equilibria(&query.subject, &query.l)?)?)
}

fn equilibria(subject: &Subject, l: &Number) -> Result<CriticalDocument, CriticalError> {
    Ok(documents::critical(subject, l, &critical(&subject.body, l)?))
}
