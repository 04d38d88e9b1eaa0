//! What a run writes: data, documents and pictures.

use std::fs;
use std::path::{Path, PathBuf};

use super::plan::{Plan, stem};
use super::work::{Done, Sections};
use super::{picture, report, table};
use crate::cli::export::{Columns, DataFormat, DataTarget, FileSet, answer, unusable};
use crate::cli::failure::Failure;
use crate::cli::input::head;
use crate::cli::terminal::{Report, Timings, print};

/// Writes the files of a complete run, all or none, and then prints. An interrupted run only prints: no file is replaced
/// by one with less in it.
pub fn write(plan: &Plan<'_>, mut sections: Sections, complete: bool, timings: &Timings) -> Result<(), Failure> {
    let arguments = plan.arguments;
    let written = if complete { files(plan, &mut sections.done, timings)? } else { Vec::new() };
    if let (Some(DataTarget::Stdout), [section]) = (&arguments.data, &sections.done[..]) {
        return print(DataFormat::Csv.bytes(&columns(section)?)?);
    }
    let text = || text(plan, &sections, &written);
    match &sections.done[..] {
        // One document for one point, a list for an atlas.
        [section] if !plan.is_list() => answer(arguments.json, &section.document, text),
        done => {
            let all = done.iter().map(|section| section.document.clone()).collect();
            answer(
                arguments.json,
                &bifdiag_documents::sections(
                    &plan.sites.subject,
                    plan.sites.atlas.as_deref(),
                    &plan.sites.wanted(),
                    all,
                    sections.skipped.clone(),
                    sections.complete,
                ),
                text,
            )
        }
    }
}

/// Writes data, documents and pictures; then the journals go.
fn files(plan: &Plan<'_>, sections: &mut [Done], timings: &Timings) -> Result<Vec<PathBuf>, Failure> {
    let (arguments, directory) = (plan.arguments, plan.directory.as_ref());
    let mut files = FileSet::new(plan.directory.as_deref().unwrap_or(Path::new(".")));
    let mut journals = Vec::new();
    for section in sections.iter_mut() {
        let region = section.document.region.as_deref();
        journals.extend(section.journal.as_ref().map(|journal| journal.path().to_owned()));
        if let (Some((path, format)), Some(mut journal)) = (plan.streamed(), section.journal.take()) {
            journal.meta = serde_json::to_string(&section.document)?;
            let path = plan.file_of(path, region);
            files.add_written(&path, move |out| Ok(format.write(&mut journal, out)?));
            continue;
        }
        if let Some(DataTarget::File { path, format }) = &arguments.data {
            files.add_at(&plan.file_of(path, region), format.bytes(&columns(section)?)?);
        }
        if directory.is_some() {
            let stem = stem(region);
            files.json(&stem, &section.document)?;
            files.remove_pictures(&stem);
            if arguments.data.is_none() {
                files.add(format!("{stem}.npz"), DataFormat::Npz.bytes(&columns(section)?)?);
            }
        }
    }
    if directory.is_some() && !arguments.no_plot {
        // Regions that were listed are compared in one picture.
        let shown = if plan.sites.is_listed() { sections.len() } else { 1 };
        for part in sections.chunks(shown.max(1)) {
            let picture = timings.stage("picture", || picture::draw(plan, part))?;
            let stem = picture_stem(part);
            files.remove_pictures(&stem);
            files.pictures(&stem, &picture, &arguments.picture, timings)?;
        }
    }
    let written = timings.stage("files", || files.write())?;
    for path in journals {
        fs::remove_file(&path).map_err(|error| unusable(&path, error))?;
    }
    Ok(written)
}

/// How the names of a picture's files begin.
fn picture_stem(sections: &[Done]) -> String {
    let regions: Vec<&str> = sections.iter().filter_map(|section| section.document.region.as_deref()).collect();
    stem((!regions.is_empty()).then(|| regions.join("-")).as_deref())
}

fn columns(section: &Done) -> Result<Columns, Failure> {
    Ok(table::of(&section.document, &section.orbits, &section.chaos)?)
}

fn text(plan: &Plan<'_>, sections: &Sections, written: &[PathBuf]) -> String {
    let mut lines = Report::default();
    head(&plan.sites.subject, &mut lines);
    for section in &sections.done {
        report::add(&mut lines, &section.document);
    }
    lines.written(written);
    lines.text()
}
