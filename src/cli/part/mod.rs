//! `bifdiag body`: a real part as it was understood.

mod arguments;
mod report;

use bifdiag_body::part::file::edges;
use bifdiag_documents::Subject;
use bifdiag_plot::{PartScene, draw_part};
use thiserror::Error;

use super::export::{ExportError, FileSet, RESOLUTION, answer};
use super::failure::{CommandError, Exit, Failure};
use super::input::PartInput;
use super::terminal::Timings;

pub use arguments::{BODY_EXAMPLES, PartBodyArguments};

/// Why there is no part to be shown.
#[derive(Debug, Error)]
enum NoPart {
    #[error("no part is given; use --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.02,0.15 --mass 2.5, or --inertia")]
    Nothing,
    #[error(transparent)]
    Input(#[from] PartInput),
}

impl CommandError for NoPart {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

pub fn run(arguments: &PartBodyArguments, timings: &Timings) -> Result<(), Failure> {
    let given = arguments.part.shown().map_err(NoPart::from)?.ok_or(NoPart::Nothing)?;
    let document = bifdiag_documents::part(&given.part, &given.principal);
    let mut written = Vec::new();
    if let Some(directory) = &arguments.out {
        let mut files = FileSet::new(directory);
        let picture = draw_part(&document, &scene(arguments), arguments.picture.theme).map_err(ExportError::from)?;
        files.pictures("part", &picture, &arguments.picture.format, RESOLUTION, timings)?;
        written = files.write()?;
    }
    let text = || report::text(&given, &document, &written);
    let subject = Subject { body: given.principal.body.clone(), part: Some(document.clone()) };
    Ok(answer(arguments.json, &subject.part_answer(), text)?)
}

/// The mesh behind the ellipsoid.
fn scene(arguments: &PartBodyArguments) -> PartScene {
    let pivot =
        arguments.part.pivot.as_ref().map_or([0.0; 3], |pivot| pivot.0.each_ref().map(bifdiag_body::Number::to_f64));
    PartScene { edges: arguments.part.file.as_ref().map(|path| edges(path, pivot)).unwrap_or_default() }
}
