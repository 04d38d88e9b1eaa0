//! What a run writes: data, documents and pictures.

use std::path::{Path, PathBuf};
use std::{fs, io};

use super::error::SectionFailure;
use super::settings::Settings;
use super::work::{Done, Sections};
use super::{picture, report, table};
use crate::cli::export::{Columns, DataFormat, DataTarget, ExportError, Exporter, FileSet, Json, RESOLUTION, answer};
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::interrupt::Stoppable;
use crate::cli::terminal::{Report, Timings, print};

/// Writes the files, all or none, and then prints. An interrupted run draws no more pictures.
pub fn write(settings: &Settings, mut sections: Sections, work: &Stoppable, timings: &Timings) -> Result<(), Failure> {
    let outputs = &settings.outputs;
    let mut files = FileSet::new(outputs.directory.as_deref().unwrap_or(Path::new(".")));
    let mut csv = None;
    let mut journals = Vec::new();
    for section in &mut sections.done {
        if let (Some(streamed), Some((_, format))) = (section.streamed.take(), settings.streamed()) {
            let (path, mut journal) = streamed.close(&section.document).map_err(ExportError::from)?;
            journals.push(journal.path().to_owned());
            files.add_written(&path, move |out| format.write(&mut journal, out).map_err(io::Error::other));
            continue;
        }
        match outputs.data {
            Some(DataTarget::Stdout) => csv = Some(DataFormat::Csv.bytes(&columns(section)?)?),
            Some(DataTarget::File { path, format }) => {
                let name = settings.file_of(path, section.document.region.as_deref());
                files.add_at(&name, format.bytes(&columns(section)?)?);
            }
            None => {}
        }
        if outputs.directory.is_some() {
            let stem = match &section.document.region {
                Some(region) => format!("section-{region}"),
                None => "section".to_owned(),
            };
            files.export(&stem, &section.document, &Json)?;
            files.remove_pictures(&stem);
            if outputs.data.is_none() {
                files.export(&stem, &columns(section)?, &DataFormat::Npz)?;
            }
            if !outputs.formats.is_empty() && sections.complete && !work.told() {
                let picture = timings.stage("picture", || picture::draw(settings, section))?;
                files.pictures(&stem, &picture, outputs.formats, RESOLUTION, timings)?;
            }
        }
    }
    let written = timings.stage("files", || files.write())?;
    for path in journals {
        fs::remove_file(&path).map_err(|source| SectionFailure::Journal { path, source })?;
    }
    if let Some(csv) = csv {
        return Ok(print(csv)?);
    }
    let text = || text(settings, &sections, &written);
    Ok(match &sections.done[..] {
        // One document for one point, a list for an atlas.
        [section] if !outputs.list => answer(outputs.json, &section.document, text),
        done => {
            let all = done.iter().map(|section| section.document.clone()).collect();
            answer(
                outputs.json,
                &documents::sections(&settings.sites.subject, all, sections.skipped.clone(), sections.complete),
                text,
            )
        }
    }?)
}

fn columns(section: &Done) -> Result<Columns, ExportError> {
    Ok(table::of(&section.document, &section.orbits, &section.chaos)?)
}

fn text(settings: &Settings, sections: &Sections, written: &[PathBuf]) -> String {
    let mut lines = Report::default();
    head(&settings.sites.subject, &mut lines);
    for section in &sections.done {
        report::add(&mut lines, &section.document);
    }
    lines.written(written);
    lines.text()
}
