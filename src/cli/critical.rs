//! `bifdiag critical`: all relative equilibria at one l, or at many.

use rayon::prelude::*;
use schema::{CriticalDocument, Multiplicity, Stability};
use thiserror::Error;
use top::critical::{CriticalError, critical};

use super::arguments::CriticalArguments;
use super::batch::{self, Wanted};
use super::failure::{Failure, InputError};
use super::report::Report;
use super::subject::Subject;
use super::table::{Table, fixed, significant};
use super::timings::Timings;
use super::{layout, output};

/// Significant digits of the table.
const DIGITS: usize = 10;

pub fn run(arguments: &CriticalArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    if let Some(path) = arguments.batch.path(&[("--l", arguments.momentum.is_some())])? {
        let subject = arguments.body.optional_subject()?;
        return batch::run(path, &arguments.batch, subject.as_ref(), Wanted::Momentum, quiet, |queries| {
            let answer = |query: &batch::Query| {
                let mut document = documents::critical(&query.body, &query.l, &critical(&query.body, &query.l)?);
                document.inertia.clone_from(&query.inertia);
                Ok::<_, Unanswered>(serde_json::to_string(&document)?)
            };
            timings.stage("chunk", || queries.par_iter().map(answer).collect())
        });
    }
    let subject = arguments.body.subject()?;
    let missing = InputError::NoPoint { missing: "--l", example: "the momentum, such as --l 3.25" };
    let l = arguments.momentum.as_ref().ok_or(missing)?;
    let found = timings.stage("critical", || critical(&subject.body, l))?;
    let mut document = documents::critical(&subject.body, l, &found);
    document.inertia.clone_from(&subject.inertia);
    let text = if arguments.json { layout::text(&document)? } else { report(&subject, &document) };
    Ok(output::print(text.as_bytes())?)
}

/// Why a line of a batch has no answer.
#[derive(Debug, Error)]
enum Unanswered {
    #[error(transparent)]
    Critical(#[from] CriticalError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

fn report(subject: &Subject, document: &CriticalDocument) -> String {
    let mut table = Table::new(&["h", "gamma", "omega", "index", "mult", "stability", "branch"]);
    for point in &document.critical {
        let [x, y, z] = point.gamma.map(|x| fixed(x, 6));
        table.row([
            significant(point.h, DIGITS),
            format!("({x:>9}, {y:>9}, {z:>9})"),
            significant(point.omega, 6),
            point.index.to_string(),
            match point.multiplicity {
                Multiplicity::Points(count) => count.to_string(),
                Multiplicity::Circle => "circle".to_owned(),
                Multiplicity::Sphere => "sphere".to_owned(),
            },
            stability_name(point.stability).to_owned(),
            point.branch.clone(),
        ]);
    }
    let mut report = Report::default();
    subject.head(&mut report);
    report.line(format!("l = {}", document.l));
    report.line("");
    report.line(table.text());
    report.line("");
    report.line(format!("error bound of h: {}", significant(document.error_bound, 2)));
    if !document.complete {
        report.line("there may be more: l is within rounding of a cusp or beyond what f64 can decide");
    }
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

fn stability_name(stability: Stability) -> &'static str {
    match stability {
        Stability::Elliptic => "elliptic",
        Stability::SaddleCentre => "saddle-centre",
        Stability::Saddle => "saddle",
        Stability::Complex => "complex",
        Stability::Degenerate => "degenerate",
    }
}
