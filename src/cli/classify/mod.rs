//! `bifdiag classify`: the type of U, E and P at one point, or at many.

mod arguments;
mod error;
mod preparation;
mod report;
mod settings;

use proof::CertifiedAtlas;
use schema::{Accuracy, ClassificationDocument};
use top::body::Number;
use top::classify::classify;

use super::batch::{Batch, Wanted};
use super::export::answer;
use super::failure::Failure;
use super::input::Subject;
use super::terminal::Timings;
use error::PointError;
use preparation::Preparation;
use settings::Settings;

pub use arguments::{ClassifyArguments, EXAMPLES};

pub fn run(arguments: &ClassifyArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    match Settings::new(arguments)? {
        Settings::Point { subject, h, l, accuracy, json } => {
            let document = timings.stage("classify", || point(&subject, h, l, accuracy))?;
            Ok(answer(json, &document, || report::text(&subject, &document))?)
        }
        Settings::Batch { path, strict, subject, accuracy } => {
            let mut preparation = Preparation::default();
            Batch { path, strict, subject, wanted: Wanted::Point, quiet }
                .run(|queries| timings.stage("chunk", || preparation.answer(queries, accuracy)))
        }
    }
}

fn point(subject: &Subject, h: &Number, l: &Number, accuracy: Accuracy) -> Result<ClassificationDocument, PointError> {
    let answer = if accuracy == Accuracy::Certified {
        CertifiedAtlas::new(&subject.body)?.classify(h, l)
    } else {
        classify(&subject.body, h, l)?
    };
    let mut document = documents::classification(&subject.body, h, l, &answer, accuracy);
    document.inertia.clone_from(&subject.inertia);
    Ok(document)
}
