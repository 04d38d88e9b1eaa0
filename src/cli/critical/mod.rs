//! `bifdiag critical`: all relative equilibria at one l, or at many.

mod arguments;
mod error;
mod report;
mod settings;

use rayon::prelude::*;
use schema::{CriticalDocument, InertiaDocument};
use top::body::{Body, Number};
use top::critical::{CriticalError, critical};

use super::batch::{Batch, Query, Wanted};
use super::export::answer;
use super::failure::Failure;
use super::terminal::Timings;
use error::{NotFound, Unanswered};
use settings::Settings;

pub use arguments::{CriticalArguments, EXAMPLES};

pub fn run(arguments: &CriticalArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match Settings::new(arguments)? {
        Settings::Momentum { subject, l, json } => {
            let found = timings.stage("critical", || equilibria(&subject.body, l, subject.inertia.as_ref()));
            let document = found.map_err(NotFound::from)?;
            Ok(answer(json, &document, || report::text(&subject, &document))?)
        }
        Settings::Batch { path, strict, subject } => Batch { path, strict, subject, wanted: Wanted::Momentum, quiet }
            .run(|queries| timings.stage("chunk", || queries.par_iter().map(line).collect())),
    }
}

/// The answer to a line of a batch.
fn line(query: &Query) -> Result<String, Unanswered> {
    Ok(serde_json::to_string(&equilibria(&query.body, &query.l, query.inertia.as_ref())?)?)
}

fn equilibria(body: &Body, l: &Number, inertia: Option<&InertiaDocument>) -> Result<CriticalDocument, CriticalError> {
    let mut document = documents::critical(body, l, &critical(body, l)?);
    document.inertia = inertia.cloned();
    Ok(document)
}
