//! What a run writes: data, documents and pictures.

use std::path::{Path, PathBuf};
use std::{fs, io};

use super::error::SectionFailure;
use super::settings::{Settings, stem};
use super::work::{Done, Sections};
use super::{picture, report, table};
use crate::cli::export::{Columns, DataFormat, DataTarget, ExportError, Exporter, FileSet, Json, RESOLUTION, answer};
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::{Report, Timings, print};

/// Writes the files of a complete run, all or none, and then prints. An interrupted run only prints: no file is replaced
/// by one with less in it.
pub fn write(settings: &Settings, mut sections: Sections, complete: bool, timings: &Timings) -> Result<(), Failure> {
    let outputs = &settings.outputs;
    let written = if complete { files(settings, &mut sections.done, timings)? } else { Vec::new() };
    if let (Some(DataTarget::Stdout), [section]) = (outputs.data, &sections.done[..]) {
        return Ok(print(DataFormat::Csv.bytes(&columns(section)?)?)?);
    }
    let text = || text(settings, &sections, &written);
    Ok(match &sections.done[..] {
        // One document for one point, a list for an atlas.
        [section] if !outputs.list => answer(outputs.json, &section.document, text),
        done => {
            let all = done.iter().map(|section| section.document.clone()).collect();
            answer(
                outputs.json,
                &bifdiag_documents::sections(&settings.sites.subject, all, sections.skipped.clone(), sections.complete),
                text,
            )
        }
    }?)
}

/// Writes data, documents and pictures; then the journals go.
fn files(settings: &Settings, sections: &mut [Done], timings: &Timings) -> Result<Vec<PathBuf>, Failure> {
    let outputs = &settings.outputs;
    let mut files = FileSet::new(outputs.directory.as_deref().unwrap_or(Path::new(".")));
    let mut journals = Vec::new();
    for section in sections {
        let region = section.document.region.as_deref();
        journals.extend(section.journal.as_ref().map(|journal| journal.path().to_owned()));
        if let (Some((path, format)), Some(mut journal)) = (settings.streamed(), section.journal.take()) {
            journal.meta = serde_json::to_string(&section.document).map_err(ExportError::from)?;
            let path = settings.file_of(path, region);
            files.add_written(&path, move |out| format.write(&mut journal, out).map_err(io::Error::other));
            continue;
        }
        if let Some(DataTarget::File { path, format }) = outputs.data {
            files.add_at(&settings.file_of(path, region), format.bytes(&columns(section)?)?);
        }
        if outputs.directory.is_some() {
            let stem = stem(region);
            files.export(&stem, &section.document, &Json)?;
            files.remove_pictures(&stem);
            if outputs.data.is_none() {
                files.export(&stem, &columns(section)?, &DataFormat::Npz)?;
            }
            if !outputs.formats.is_empty() {
                let picture = timings.stage("picture", || picture::draw(settings, section))?;
                files.pictures(&stem, &picture, outputs.formats, RESOLUTION, timings)?;
            }
        }
    }
    let written = timings.stage("files", || files.write())?;
    for path in journals {
        fs::remove_file(&path).map_err(|source| SectionFailure::Journal { path, source })?;
    }
    Ok(written)
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
