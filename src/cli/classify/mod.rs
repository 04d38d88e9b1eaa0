//! `bifdiag classify`: the type of U, E and P at one point, or at many.

mod many;
mod proof;

use std::path::PathBuf;
use std::sync::Arc;

use bifdiag_body::Number;
use bifdiag_documents::Subject;
use bifdiag_exact::{Solver, classify};
use bifdiag_schema::{Accuracy, ClassificationDocument, ComponentDocument, Status};
use clap::Args;

use super::batch::{Batch, BatchArguments, LINES_SAY_IT, Wanted, no_point};
use super::export::answer;
use super::failure::Failure;
use super::input::values::Grid;
use super::input::{BodyArguments, PointArguments, accuracy, head, values};
use super::terminal::{Report, Table, Timings, bound, significant};
use many::Preparation;
pub use many::unanswered;

pub const EXAMPLES: &str = "\
Examples:
  bifdiag classify --A 2,1.1,1 --r 0.94868,0,0.61623 --h 3.8 --l 3.25
  bifdiag classify --body kovalevskaya --h 1.84 --l=-1.84 --json
  bifdiag classify --body paper --h 3.8 --l 3.25 --certificate > point.json
  bifdiag classify --body paper --grid -1:6:200,0:4:200 --out grid.npz
  bifdiag classify --batch points.jsonl > types.jsonl
  echo '{\"h\": 3.8, \"l\": \"13/4\"}' | bifdiag classify --body paper --batch -

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"h\": 3.8, \"l\": 3.25}, with numbers or \
strings; a line without A and r uses the body of the command line; other keys are ignored with a warning. Each line \
is answered by one line, in the same order; an invalid line gives {\"error\": …, \"line\": n}.";

/// `bifdiag classify`.
#[derive(Debug, Args)]
pub struct ClassifyArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    #[command(flatten)]
    pub point: PointArguments,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// Find the regions of a grid of n energies and m momenta, both ends included; needs --out FILE
    #[arg(long, value_name = "hmin:hmax:n,lmin:lmax:m", allow_hyphen_values = true, value_parser = values::grid)]
    #[arg(help_heading = "Grid")]
    pub grid: Option<Grid>,
    /// Write the grid to FILE.npz (arrays h, l, region, regions, meta) or FILE.png (one pixel per point)
    #[arg(long, value_name = "FILE", help_heading = "Grid")]
    pub out: Option<PathBuf>,
    /// Required accuracy of the answer
    #[arg(long, value_parser = accuracy(), default_value = "exact", help_heading = "Work", hide_short_help = true)]
    pub accuracy: Accuracy,
    /// Omit the ids of the regions, so that no atlas is made (for batches over many bodies)
    #[arg(long, help_heading = "Work", hide_short_help = true)]
    pub no_region: bool,
    /// Print the answer for one point as JSON with its proof, which `bifdiag verify` checks
    #[arg(long, help_heading = "Output")]
    pub certificate: bool,
    /// Print the answer as JSON (implied by --batch)
    #[arg(long, help_heading = "Output")]
    pub json: bool,
}

pub fn run(arguments: &ClassifyArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let (h, l) = (arguments.point.energy.as_ref(), arguments.point.momentum.as_ref());
    let (accuracy, regions) = (arguments.accuracy, !arguments.no_region);
    check_proof(arguments)?;
    if let Some(grid) = &arguments.grid {
        let batch = arguments.batch.batch.is_some();
        let replaced = [("--h", h.is_some()), ("--l", l.is_some()), ("--batch", batch)];
        if let Some((option, _)) = replaced.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(format!("--grid and {option} both give the points; leave out one of them")));
        }
        let strict = arguments.batch.strict;
        let idle = [("--no-region", arguments.no_region), ("--json", arguments.json), ("--strict", strict)];
        if let Some((option, _)) = idle.into_iter().find(|(_, given)| *given) {
            return Err(Failure::input(format!("--grid writes the region of each point to --out; leave {option} out")));
        }
        let out = many::target(arguments.out.as_deref())?;
        return many::grid(&arguments.body.subject()?, grid, accuracy, out, timings);
    }
    if arguments.out.is_some() {
        return Err(Failure::input("--out is for --grid; leave it out"));
    }
    if let Some(path) =
        arguments.batch.path(&[("--h", LINES_SAY_IT, h.is_some()), ("--l", LINES_SAY_IT, l.is_some())])?
    {
        let subject = arguments.body.optional_subject()?.map(Arc::new);
        let mut preparation = Preparation::new(accuracy, regions);
        return Batch { path, strict: arguments.batch.strict, subject, wanted: Wanted::Point, quiet }
            .run(|queries| timings.stage("chunk", || preparation.answer(queries)));
    }
    let subject = arguments.body.subject()?;
    let h = h.ok_or_else(|| no_point("--h", "the energy, such as --h 3.8"))?;
    let l = l.ok_or_else(|| no_point("--l", "the momentum, such as --l 3.25"))?;
    if arguments.certificate {
        return proof::run(&subject, h, l, timings);
    }
    let document = timings.stage("classify", || {
        let (found, prepared) = if regions {
            let prepared = Solver::new(subject.body.clone(), accuracy);
            (prepared.classify(h, l)?, Some(prepared))
        } else {
            (classify(&subject.body, h, l, accuracy)?, None)
        };
        Ok(bifdiag_documents::classification(&subject, h, l, &found, accuracy, prepared.as_ref()))
    });
    let document = document.map_err(unanswered)?;
    answer(arguments.json, &document, || report(&subject, &document))
}

/// What does not go with `--certificate`.
fn check_proof(arguments: &ClassifyArguments) -> Result<(), Failure> {
    let others = [
        ("--grid", arguments.grid.is_some()),
        ("--out", arguments.out.is_some()),
        ("--batch", arguments.batch.batch.is_some()),
        ("--no-region", arguments.no_region),
        ("--accuracy fast", arguments.accuracy == Accuracy::Fast),
    ];
    match others.into_iter().find(|(_, given)| *given && arguments.certificate) {
        Some((option, _)) => Err(Failure::input(format!(
            "--certificate proves one point exactly, with its region, as JSON on stdout; leave {option} out"
        ))),
        None => Ok(()),
    }
}

/// What the terminal shows of a point.
fn report(subject: &Subject, document: &ClassificationDocument) -> String {
    let mut report = Report::default();
    head(subject, &mut report);
    report.line(format!("h = {}", document.h));
    report.line(format!("l = {}", document.l));
    report.line("");
    if let Some(region) = &document.region {
        report.line(format!("region {region}"));
    }
    let is_turning = document.l.parse().is_ok_and(|l: Number| !l.value().is_zero());
    report.line(match document.status {
        Status::Regular => "regular",
        Status::Forbidden => "forbidden: h is below the minimum of the effective potential, U is empty",
        // Other curves may be within the error bound, but not at l = 0.
        Status::Critical if document.accuracy == Accuracy::Fast && document.candidates.len() > 2 && is_turning => {
            "critical: exactly on a curve, where all or some of these meet"
        }
        Status::Critical => "critical: exactly on a curve, where these meet",
        Status::Undecided => "undecided: closer to a curve than the error bound; candidates",
    });
    if let Some(components) = document.components.as_ref().filter(|components| !components.is_empty()) {
        report.line("");
        report.line(component_table(components));
    }
    for (i, candidate) in document.candidates.iter().enumerate() {
        report.line("");
        report.line(match (&candidate.region, candidate.status) {
            (Some(region), _) => format!("region {region}"),
            (None, Status::Forbidden) => "the forbidden region".to_owned(),
            (None, _) => format!("class {}", i + 1),
        });
        report.line(component_table(&candidate.components));
    }
    report.line("");
    let margin = &document.margin;
    report.line(format!(
        "margin: {} in h to {} (error bound {})",
        significant(margin.h, 6),
        margin.nearest,
        bound(margin.error_bound, 2),
    ));
    if let Some(note) = &document.note {
        report.line(format!("note: {note}"));
    }
    report.text()
}

/// The components of one class.
fn component_table(class: &[ComponentDocument]) -> String {
    if class.is_empty() {
        return "U is empty\n".to_owned();
    }
    let mut table = Table::new(&["U", "E", "P", "genus", "poles"]);
    let missing = || "-".to_owned();
    for component in class {
        table.row([
            component.accessible_region.clone(),
            component.energy_surface.clone(),
            component.section.clone().unwrap_or_else(missing),
            component.genus.map_or_else(missing, |genus| genus.to_string()),
            component.poles.as_ref().map_or_else(missing, |poles| poles.join(" ")),
        ]);
    }
    table.text()
}
