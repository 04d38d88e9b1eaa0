//! `bifdiag critical`: all relative equilibria at one l, at many, or at one spin.

mod curve;
mod report;
mod spins;
mod table;

use std::sync::Arc;

use bifdiag_body::Number;
use bifdiag_body::part::Spin;
use bifdiag_documents::Subject;
use bifdiag_equilibria::critical::{CriticalError, RelativeEquilibria};
use clap::{Args, ValueEnum};
use rayon::prelude::*;

use super::batch::{Batch, BatchArguments, LINES_SAY_IT, Query, Wanted, no_point};
use super::export::{Columns, DataFormat, DataTarget, FileSet, answer};
use super::failure::{Failure, failed};
use super::input::{BodyArguments, Numbers};
use super::terminal::{Timings, print};
use spins::{Output, Spins, spin_at};
use table::{NOT_FOUND, no_axes_at, not_found};

pub const EXAMPLES: &str = "\
Examples:
  bifdiag critical --A 2,1.1,1 --r 0.94868,0,0.61623 --l 3.25
  bifdiag critical --body katok:6 --l 7/3 --json
  bifdiag critical --body paper --spin \"2 rad/s\"
  bifdiag critical --body paper --spin \"0:60:241 rpm\" --out axes.svg
  bifdiag critical --A 2,1.1,1 --r 0.94868,0,0.61623 --l 3.25 --method newton
  bifdiag critical --body lagrange --l 0:4:401 --out lagrange.npz
  bifdiag critical --batch momenta.jsonl > equilibria.jsonl

Each line of a batch is {\"A\": [2, 1.1, 1], \"r\": [0.94868, 0, 0.61623], \"l\": 3.25}, with numbers or strings; a \
line without A and r uses the body of the command line; other keys are ignored with a warning, but spin is an error. \
Each line is answered by one line, in the same order; an invalid line gives {\"error\": …, \"line\": n}.";

/// How relative equilibria are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Method {
    /// All of them from the closed form, with bounds
    #[default]
    ClosedForm,
    /// Follow each curve from l = 0, its cusp or its pitchfork by Newton continuation: slower, a second way to the same
    /// list; eigenvalues and verdicts come from the closed form
    Newton,
}

/// `bifdiag critical`.
#[derive(Debug, Args)]
pub struct CriticalArguments {
    #[command(flatten)]
    pub body: BodyArguments,
    /// Vertical angular momentum, or a range a:b:n of n values; its sign is that of omega
    #[arg(long = "l", value_name = "l|a:b:n", allow_hyphen_values = true, value_parser = Numbers::parse)]
    #[arg(help_heading = "Momentum")]
    pub momentum: Option<Numbers>,
    /// Instead of l: list every axis of steady rotation at this spin (rpm, Hz, rad/s, deg/s), or at a range of spins,
    /// such as "0:3000:301 rpm"
    #[arg(long, value_name = "\"300 rpm\"", allow_hyphen_values = true, conflicts_with = "momentum")]
    #[arg(value_parser = Spins::parse, help_heading = "Momentum")]
    pub spin: Option<Spins>,
    /// How to find them
    #[arg(long, value_enum, default_value_t, value_name = "METHOD", help_heading = "Momentum", hide_short_help = true)]
    pub method: Method,
    #[command(flatten)]
    pub batch: BatchArguments,
    /// Print the answer as JSON, for a range one line per momentum or spin (implied by --batch)
    #[arg(long, conflicts_with = "out", help_heading = "Output")]
    pub json: bool,
    /// Write the table of a range or a spin to FILE (.npz, .parquet, .csv, .jsonl; -: CSV to stdout, the default for a
    /// range); .svg or .png: plot the steady axes of a range of spins, angle from the centre of mass against rpm
    #[arg(long, value_name = "FILE", value_parser = Output::parse, help_heading = "Output")]
    pub out: Option<Output>,
}

pub fn run(arguments: &CriticalArguments, timings: &Timings, quiet: bool) -> Result<(), Failure> {
    let CriticalArguments { body, momentum, spin, method, batch, json, out } = arguments;
    let is_range = matches!(momentum, Some(Numbers::Range { .. }));
    if *method == Method::Newton && (is_range || spin.is_some() || batch.batch.is_some()) {
        return Err(Failure::input(
            "--method newton follows the curves to one momentum: give --l a number, and no --batch or --spin",
        ));
    }
    let refused = [
        ("--l", LINES_SAY_IT, momentum.is_some()),
        ("--spin", "a line asks about one l, not a spin", spin.is_some()),
        ("--out", "its answers are lines on stdout", out.is_some()),
    ];
    if let Some(path) = batch.path(&refused)? {
        let subject = body.optional_subject()?.map(Arc::new);
        return Batch { path, strict: batch.strict, subject, wanted: Wanted::Momentum, quiet }
            .run(|queries| timings.stage("chunk", || lines(queries)));
    }
    let subject = body.subject()?;
    if let (Some(Spins::Range { from, to, count }), Some(Output::Picture { path, format })) = (spin, out) {
        return curve::draw(&subject, [from, to], *count, (path, *format), timings);
    }
    let out = match out {
        Some(Output::Picture { .. }) => {
            return Err(Failure::input(
                "--out: a picture needs a range of spins, such as --spin \"0:3000:301 rpm\"; a table goes to FILE.csv, FILE.npz, \
                 FILE.parquet or FILE.jsonl",
            ));
        }
        Some(Output::Data(target)) => Some(target),
        None => None,
    };
    match (momentum, spin) {
        (_, Some(Spins::One(spin))) => at_spin(&subject, spin, *json, out, timings),
        (_, Some(Spins::Range { from, to, count })) if *json => {
            timings.stage("critical", || spin_lines(&subject, [from, to], *count))
        }
        (_, Some(Spins::Range { from, to, count })) => {
            let columns = timings.stage("critical", || table::at_spins(&subject, [from, to], *count));
            written(&columns?, out, timings)
        }
        (None, None) => Err(no_point("--l", "the momentum, such as --l 3.25, the spin, such as --spin \"300 rpm\"")),
        (Some(Numbers::One(_)), None) if out.is_some() => Err(Failure::input(
            "--out needs a range of momenta, such as --l 0:4:401, or --spin; at one momentum --json writes to stdout",
        )),
        (Some(Numbers::One(l)), None) => {
            let found = timings.stage("critical", || {
                let prepared = RelativeEquilibria::new(&subject.body)?;
                if *method == Method::Newton { prepared.continued(l) } else { prepared.at(l) }
            });
            let document = bifdiag_documents::critical(&subject, l, &found.map_err(not_found)?);
            answer(*json, &document, || report::text(&subject, &document))
        }
        (Some(Numbers::Range { from, to, count }), None) if *json => {
            timings.stage("critical", || ranged_lines(&subject, [from, to], *count))
        }
        (Some(Numbers::Range { from, to, count }), None) => {
            let columns = timings.stage("critical", || table::at_momenta(&subject.body, [from, to], *count));
            written(&columns?, out, timings)
        }
    }
}

/// Every axis about which the body turns steadily at a spin.
fn at_spin(
    subject: &Subject,
    spin: &Spin,
    json: bool,
    out: Option<&DataTarget>,
    timings: &Timings,
) -> Result<(), Failure> {
    let omega = spin.exact_rad_per_s() * subject.unit_of_time();
    let found = timings.stage("critical", || RelativeEquilibria::new(&subject.body)?.at_spin(&omega));
    let found = found.map_err(|error| no_axes_at(subject, spin, error))?;
    let document = bifdiag_documents::steady_axes(subject, spin, &found);
    match out {
        Some(_) => {
            let columns = table::at_spin(&subject.body, &document, &found)?;
            written(&columns, out, timings)
        }
        None => answer(json, &document, || report::steady_axes(subject, spin, &document)),
    }
}

/// Prints the steady axes at the spins of a range, a line for each spin.
fn spin_lines(subject: &Subject, ends: [&Spin; 2], count: u32) -> Result<(), Failure> {
    let prepared = RelativeEquilibria::new(&subject.body).map_err(failed(NOT_FOUND))?;
    for k in 0..count {
        let spin = spin_at(ends, count, k);
        let omega = spin.exact_rad_per_s() * subject.unit_of_time();
        let found = prepared.at_spin(&omega).map_err(|error| no_axes_at(subject, &spin, error))?;
        let mut line = Vec::with_capacity(LINE);
        bifdiag_schema::write_json(&mut line, &bifdiag_documents::steady_axes(subject, &spin, &found))?;
        line.push(b'\n');
        print(line)?;
    }
    Ok(())
}

/// Writes a table.
fn written(columns: &Columns, target: Option<&DataTarget>, timings: &Timings) -> Result<(), Failure> {
    let Some(DataTarget::File { path, format }) = target else {
        return print(DataFormat::Csv.bytes(columns)?);
    };
    let bytes = timings.stage("table", || format.bytes(columns))?;
    let mut files = FileSet::new(path.parent().unwrap_or(path));
    files.add_at(path, bytes);
    let written = timings.stage("files", || files.write())?;
    print(report::written(columns.rows(), &written))
}

/// The answers to lines of a batch; of lines in a row about one body its curves are found once in each block.
fn lines(queries: &[Query]) -> Vec<Result<Vec<u8>, Failure>> {
    let same = |one: &Query, other: &Query| {
        Arc::ptr_eq(&one.subject, &other.subject) || one.subject.body == other.subject.body
    };
    queries.par_chunks(BLOCK).flat_map_iter(|block| block.chunk_by(same).flat_map(of_one_body)).collect()
}

/// The answers to lines about one body.
fn of_one_body(queries: &[Query]) -> Vec<Result<Vec<u8>, Failure>> {
    let prepared = RelativeEquilibria::new(&queries[0].subject.body);
    let answer = |query: &Query| match &prepared {
        Ok(prepared) => line(&query.subject, prepared, &query.l, |error| unanswered(&error)),
        Err(error) => Err(unanswered(error)),
    };
    queries.iter().map(answer).collect()
}

/// The answer at one momentum on one line.
fn line(
    subject: &Subject,
    prepared: &RelativeEquilibria<'_>,
    l: &Number,
    unanswered: impl FnOnce(CriticalError) -> Failure,
) -> Result<Vec<u8>, Failure> {
    let found = prepared.at(l).map_err(unanswered)?;
    let mut text = Vec::with_capacity(LINE);
    bifdiag_schema::write_json(&mut text, &bifdiag_documents::critical(subject, l, &found))?;
    Ok(text)
}

/// A line without an answer; a momentum out of range makes it a wrong one.
fn unanswered(error: &CriticalError) -> Failure {
    match error {
        CriticalError::Momentum(_) => Failure::input(error),
        CriticalError::Equilibria(_) | CriticalError::Spin { .. } | CriticalError::Lost { .. } => Failure::work(error),
    }
}

/// Prints the answers at the momenta of a range, a line for each.
fn ranged_lines(subject: &Subject, ends: [&Number; 2], count: u32) -> Result<(), Failure> {
    let prepared = RelativeEquilibria::new(&subject.body).map_err(failed(NOT_FOUND))?;
    let numbers: Vec<u32> = (0..count).collect();
    for block in numbers.chunks(BLOCK) {
        let lines = block.par_iter().map(|&k| {
            let mut line = line(subject, &prepared, &Numbers::at(ends, count, k), not_found)?;
            line.push(b'\n');
            Ok::<_, Failure>(line)
        });
        let lines: Vec<Vec<u8>> = lines.collect::<Result<_, _>>()?;
        print(lines.concat())?;
    }
    Ok(())
}

/// Lines that one thread answers.
const BLOCK: usize = 256;

/// Room for an answer, so that it is not moved while it is written.
const LINE: usize = 2048;
