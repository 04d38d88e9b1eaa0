//! `bifdiag atlas`, the main job: the table of regions, `atlas.json` and the diagram.

mod arguments;
mod error;
mod events;
mod report;
mod settings;
mod stability;
mod work;

use std::borrow::Cow;

use bifdiag_plot::{DiagramOptions, draw};

use super::export::{ExportError, FileSet, Json, RESOLUTION, answer};
use super::failure::Failure;
use super::terminal::Timings;
use crate::Curves;
use settings::Settings;

pub use arguments::{AtlasArguments, EXAMPLES};

pub fn run(arguments: &AtlasArguments, timings: &Timings) -> Result<(), Failure> {
    let settings = Settings::new(arguments)?;
    let (atlas, document) = work::atlas(&settings, timings)?;
    tracing::info!(
        regions = document.summary.regions,
        events = document.summary.events,
        undecided = document.summary.undecided.len(),
        "atlas made"
    );
    // Pictures and the table of regions need the drawing.
    let mut stored = Cow::Borrowed(&document);
    if !settings.drawing {
        bifdiag_documents::leave_out_drawing(stored.to_mut(), &settings.subject).map_err(ExportError::from)?;
    }
    let mut written = Vec::new();
    if let Some(directory) = &settings.directory {
        let mut files = FileSet::new(directory);
        files.export("atlas", &*stored, &Json)?;
        files.remove_pictures("diagram");
        // A window without a region would be an empty frame.
        if !settings.formats.is_empty() && !document.regions.is_empty() {
            let (theme, width) = (settings.theme, settings.width);
            let options = DiagramOptions { window: settings.window, points: None, theme, width };
            let picture = timings
                .stage("diagram", || draw(&document, Some(&Curves(&atlas)), &options))
                .map_err(ExportError::from)?;
            files.pictures("diagram", &picture, &settings.formats, RESOLUTION, timings)?;
        }
        written = timings.stage("files", || files.write())?;
    }
    Ok(answer(settings.json, &*stored, || report::text(&settings.subject, &document, &written))?)
}
