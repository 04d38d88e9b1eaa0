//! What a run writes: data, documents and pictures.

use std::fs;
use std::path::{Path, PathBuf};

use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_dynamics::section::{FAMILIES, Portrait, PortraitOptions, families};
use bifdiag_plot::{
    OrbitColors, OrbitFamilies, OrbitValues, Picture, SectionOptions, SectionScene, draw_section, section_type,
};
use bifdiag_schema::{ConditionName, OrbitDocument, SectionDocument, VerdictName, VerdictsName};

use super::arguments::ColorArgument;
use super::plan::{Plan, stem};
use super::sites::poincare_failure;
use super::work::{Done, Sections};
use super::{report, table};
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
                &bifdiag_documents::sections(&plan.sites.subject, all, sections.skipped.clone(), sections.complete),
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
    for section in sections {
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
            if !arguments.no_plot {
                let picture = timings.stage("picture", || draw(plan, section))?;
                files.pictures(&stem, &picture, &arguments.picture, timings)?;
            }
        }
    }
    let written = timings.stage("files", || files.write())?;
    for path in journals {
        fs::remove_file(&path).map_err(|error| unusable(&path, error))?;
    }
    Ok(written)
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

/// Draws a section with its orbits.
fn draw(plan: &Plan<'_>, section: &Done) -> Result<Picture, Failure> {
    let (arguments, document, body) = (plan.arguments, &section.document, &plan.sites.subject.body);
    let options = PortraitOptions { condition: arguments.condition, ..PortraitOptions::default() };
    let portrait = Portrait::new(body, section.h, section.l, &options)
        .map_err(|error| poincare_failure(PoincareError::from(error)))?;
    if !portrait.report().is_complete() {
        tracing::warn!("the boundary or the line of tangency of this section may be incomplete in the picture");
    }
    let color = arguments.color.unwrap_or_else(|| {
        let is_judged = document.verdicts != VerdictsName::None;
        if is_judged { ColorArgument::Verdict } else { ColorArgument::Orbit }
    });
    let values = values(color, document);
    let sides = || families(body, section.h, section.l, &section.orbits);
    let (of, names, colors) = match color {
        ColorArgument::Verdict => (verdicts(document), &VERDICTS[..], OrbitColors::Verdicts),
        ColorArgument::Side => (sides(), &FAMILIES[..], OrbitColors::Families),
        _ => (sides(), &FAMILIES[..], OrbitColors::Orbits),
    };
    let scene = SectionScene {
        portrait: &portrait,
        orbits: &section.orbits,
        values: values.as_ref().map(|(label, values)| OrbitValues { label, values }),
        families: Some(OrbitFamilies { of: &of, names, colors }),
        caption: &caption(document),
    };
    let (projection, theme, width) = (arguments.projection, arguments.picture.theme, arguments.width.width);
    let options = SectionOptions { projection, theme, width, ..SectionOptions::default() };
    Ok(draw_section(&scene, &options)?)
}

/// What stands beside (h, l): the region and the type.
fn caption(document: &SectionDocument) -> String {
    // The type is that of the paper's section.
    let own = document.condition == ConditionName::Height;
    let signature = document.signature.as_ref().filter(|_| own).map(|signature| section_type(signature));
    let parts = [document.region.clone(), signature];
    parts.into_iter().flatten().collect::<Vec<_>>().join(",  ")
}

/// What verdicts are called.
const VERDICTS: [&str; 3] = ["regular", "chaotic", "undecided"];

/// The verdict of each orbit, a place in [`VERDICTS`].
fn verdicts(document: &SectionDocument) -> Vec<usize> {
    let verdict = |orbit: &OrbitDocument| match orbit.verdict {
        VerdictName::Regular => 0,
        VerdictName::Chaotic => 1,
        VerdictName::Open => 2,
    };
    document.orbits.iter().map(verdict).collect()
}

/// The numbers that colour the orbits, and what they are.
fn values(color: ColorArgument, document: &SectionDocument) -> Option<(&'static str, Vec<f64>)> {
    let (label, value): (_, fn(&_) -> Option<f64>) = match color {
        ColorArgument::Orbit | ColorArgument::Side | ColorArgument::Verdict => return None,
        ColorArgument::Lyapunov => ("Lyapunov exponent", table::lyapunov),
        ColorArgument::Rotation => ("rotation number", table::rotation),
    };
    let of = |orbit: &OrbitDocument| orbit.chaos.as_ref().and_then(value).unwrap_or(f64::NAN);
    Some((label, document.orbits.iter().map(of).collect()))
}
