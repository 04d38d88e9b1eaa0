//! `bifdiag classify`: the type of U, E and P at one point, or at many.

mod arguments;
mod error;
mod grid;
mod preparation;
mod report;
mod settings;

use std::sync::Arc;

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_exact::{Solver, classify};
use bifdiag_schema::{Accuracy, ClassificationDocument};

use super::batch::{Batch, Wanted};
use super::export::answer;
use super::failure::Failure;
use super::terminal::Timings;
use error::PointError;
use preparation::Preparation;
use settings::Settings;

pub use arguments::{ClassifyArguments, EXAMPLES};

pub fn run(arguments: &ClassifyArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match Settings::new(arguments)? {
        Settings::Point { subject, h, l, accuracy, regions, json } => {
            let document = timings.stage("classify", || point(&subject, h, l, accuracy, regions))?;
            Ok(answer(json, &document, || report::text(&subject, &document))?)
        }
        Settings::Grid { subject, grid, accuracy, out } => grid::run(&subject, grid, accuracy, &out, timings),
        Settings::Batch { path, strict, subject, accuracy, regions } => {
            let mut preparation = Preparation::new(accuracy, regions);
            Batch { path, strict, subject: subject.map(Arc::new), wanted: Wanted::Point, quiet }
                .run(|queries| timings.stage("chunk", || preparation.answer(queries)))
        }
    }
}

fn point(
    subject: &Subject,
    h: &Number,
    l: &Number,
    accuracy: Accuracy,
    regions: bool,
) -> Result<ClassificationDocument, PointError> {
    let (found, prepared) = if regions {
        let prepared = Solver::new(subject.body.clone(), accuracy);
        (prepared.classify(h, l)?, Some(prepared))
    } else {
        (classify(&subject.body, h, l, accuracy)?, None)
    };
    Ok(bifdiag_documents::classification(subject, h, l, &found, accuracy, prepared.as_ref()))
}
