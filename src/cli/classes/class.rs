//! `bifdiag class NAME`: one class in words, with the diagram of its witness.

use std::path::PathBuf;

use bifdiag_body::{Body, BodyError};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::DocumentOptions;
use bifdiag_exact::{Accuracy, AnswerError};
use bifdiag_plot::{DiagramOptions, draw};
use bifdiag_schema::{AtlasDocument, ClassDocument, ClassesDocument};
use thiserror::Error;

use super::arguments::{ClassArguments, ClassesInput};
use super::share;
use crate::Curves;
use crate::cli::export::{ExportError, FileSet, RESOLUTION, answer, directory};
use crate::cli::failure::{CommandError, Failure};
use crate::cli::terminal::{Report, Table, Timings, significant};

/// The witness of a class that comes with the program has no diagram: a defect.
#[derive(Debug, Error)]
pub enum WitnessFailure {
    #[error("the witness of the class is no body")]
    Body(#[from] BodyError),
    #[error("the witness of the class has no atlas")]
    Answer(#[from] AnswerError),
}

impl CommandError for WitnessFailure {}

pub fn run(arguments: &ClassArguments, timings: &Timings) -> Result<(), Failure> {
    let mut class = find(&arguments.name)?;
    if arguments.json {
        bifdiag_documents::add_text(&mut class);
    }
    let directory = directory(arguments.out.as_deref(), !arguments.json && !arguments.no_plot)?;
    if arguments.json && directory.is_none() {
        return Ok(answer(true, &class, String::new)?);
    }
    let (atlas, document) = timings.stage("regions", || witness(&class))?;
    let mut written = Vec::new();
    if let Some(directory) = directory.filter(|_| !arguments.no_plot) {
        let mut files = FileSet::new(&directory);
        let name = format!("class-{}", class.name);
        let options = DiagramOptions { theme: arguments.picture.theme, ..DiagramOptions::default() };
        let picture =
            timings.stage("diagram", || draw(&document, Some(&Curves(&atlas)), &options)).map_err(ExportError::from)?;
        files.pictures(&name, &picture, &arguments.picture.format, RESOLUTION, timings)?;
        written = timings.stage("files", || files.write())?;
    }
    Ok(answer(arguments.json, &class, || report(&class, &document, &written))?)
}

/// The class whose name begins so.
fn find(name: &str) -> Result<ClassDocument, ClassesInput> {
    let ClassesDocument { classes, others, .. } = bifdiag_documents::shipped_classes();
    let all: Vec<ClassDocument> = classes.into_iter().chain(others).collect();
    let digits = name.to_ascii_lowercase();
    let mut found = all.iter().filter(|class| !name.is_empty() && class.name.starts_with(&digits));
    match (found.next(), found.count()) {
        (Some(only), 0) => Ok(only.clone()),
        (Some(first), more) => {
            Err(ClassesInput::Several { name: name.to_owned(), count: more + 1, first: first.name.clone() })
        }
        (None, _) => Err(ClassesInput::Unknown { name: name.to_owned(), nearest: nearest(&digits, &all) }),
    }
}

/// The known name with the longest beginning in common, if that is at least half a name.
fn nearest(digits: &str, all: &[ClassDocument]) -> String {
    let common = |class: &ClassDocument| class.name.bytes().zip(digits.bytes()).take_while(|(p, q)| p == q).count();
    let best = all.iter().max_by_key(|class| common(class)).filter(|class| 2 * common(class) >= class.name.len());
    best.map_or_else(String::new, |class| format!(" (the nearest is {})", class.name))
}

/// The diagram of the witness.
fn witness(class: &ClassDocument) -> Result<(Atlas, AtlasDocument), WitnessFailure> {
    let body = Body::parse(&class.witness.body.moments, &class.witness.body.center)?;
    let atlas = bifdiag_exact::atlas(&body, Accuracy::Exact)?;
    let document = bifdiag_documents::atlas::document(&atlas, &DocumentOptions::default());
    Ok((atlas, document))
}

fn report(class: &ClassDocument, document: &AtlasDocument, written: &[PathBuf]) -> String {
    let mut report = Report::default();
    let (whose, of) = if class.physical {
        ("a class of bodies that exist", "bodies that exist")
    } else {
        ("a class that no body that exists is known to have", "bodies with A > 0")
    };
    report.line(format!("class {}: {} regions; {whose}", class.name, class.regions));
    let among = match &class.stratum {
        Some(stratum) => {
            report.line(format!("special bodies: {stratum} (axes by rising moments)"));
            "such special "
        }
        None => "",
    };
    let sections: Vec<&str> = document.regions.iter().filter_map(|region| region.signature.as_deref()).collect();
    report.line(format!("sections of its regions: {}", sections.join(", ")));
    report.line(format!("types of components: {}", class.types.join(", ")));
    report.line(format!("share of {among}{of}: {} (± {}%)", share(class), significant(100.0 * class.measure_error, 1)));
    report.line("a body of it:");
    let (moments, center) = (class.witness.body.moments.join(","), class.witness.body.center.join(","));
    report.line(format!("  bifdiag --A {moments} --r {center}"));
    if class.distance > 0.0 {
        let distance = significant(class.distance, 3);
        report.line(format!("  no body of another class is known nearer than {distance}, special bodies among them"));
    }
    report.line("");
    if class.distance == 0.0 {
        report.line("the classes beside it, and how far they are from this body:");
        report.line(format!("  bifdiag classes --at --A {moments} --r {center}"));
    } else if class.neighbours.is_empty() {
        report.line("no class is known to lie beside it");
    } else {
        let mut table = Table::new(&["class beside it", "what happens on the border"]);
        for neighbour in &class.neighbours {
            let only = if class.physical && !neighbour.physical { " (among bodies that do not exist)" } else { "" };
            table.row([neighbour.class.clone(), format!("{}{only}", neighbour.event)]);
        }
        report.line(table.text());
    }
    report.written(written);
    report.text()
}
