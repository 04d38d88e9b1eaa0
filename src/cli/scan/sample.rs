//! The scan itself.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use bifdiag_documents::words::counted;
use bifdiag_schema::RowDocument;
use bifdiag_survey::scan::ScanRow;
use bifdiag_survey::{BodyFamily, BodyList, Design, DesignError};
use rayon::prelude::*;
use sha2::{Digest, Sha256};

use super::arguments::SampleArguments;
use super::journal::{Identity, Rows};
use super::output;
use super::table::Format;
use crate::cli::export::answer;
use crate::cli::failure::Failure;
use crate::cli::input::values;
use crate::cli::terminal::{Progress, print, say};

/// The columns of a table of bodies.
const COLUMNS: [&str; 6] = ["A1", "A2", "A3", "r1", "r2", "r3"];
/// Bodies between two entries of the journal: what a killed scan loses at most.
const BLOCK: u64 = 256;

pub fn run(arguments: &SampleArguments, quiet: bool) -> Result<(), Failure> {
    let accuracy = arguments.accuracy;
    let design = design(arguments)?;
    let range = arguments.shard.map_or([0, design.count()], |shard| shard.range(design.count()));
    let identity = Identity::new(design, range, accuracy);
    let out = arguments.out.as_deref().ok_or_else(output::no_out)?;
    if out == Path::new("-") {
        return to_stdout(arguments, &identity, quiet);
    }
    let format = output::format_of(out, arguments.format)?;
    if arguments.keep && out.exists() {
        let document = output::finished(out, &identity)?;
        return answer(arguments.json, &document, || output::report(&document, out));
    }
    let mut journal = Rows::open(out, &identity, arguments.restart)?;
    if journal.count() > 0 && !quiet {
        say(&format!("resuming after {} done before", counted(journal.count(), "body", "bodies")));
    }
    let progress = Progress::new(journal.count(), range[1] - range[0], "bodies", quiet);
    while range[0] + journal.count() < range[1] {
        let rows = block(&identity, range[0] + journal.count());
        journal.append(&rows)?;
        progress.add(rows.len() as u64);
    }
    progress.finish();
    let document = output::write(out, format, &identity, |take| journal.for_each(take))?;
    journal.remove()?;
    answer(arguments.json, &document, || output::report(&document, out))
}

/// The rows of the next bodies.
fn block(identity: &Identity, from: u64) -> Vec<RowDocument> {
    let to = identity.range[1].min(from + BLOCK);
    (from..to).into_par_iter().map(|n| bifdiag_documents::scan::row(&row(identity, n))).collect()
}

/// One row; not even a defect of this program ends the scan.
fn row(identity: &Identity, n: u64) -> ScanRow {
    let values = identity.design.values(n);
    catch_unwind(AssertUnwindSafe(|| ScanRow::of(n, values, identity.accuracy))).unwrap_or_else(|_panic| {
        ScanRow::failed(n, values, "a defect of this program: the computation panicked".to_owned())
    })
}

/// Rows to stdout as they come, without journal and summary.
fn to_stdout(arguments: &SampleArguments, identity: &Identity, quiet: bool) -> Result<(), Failure> {
    let format = arguments.format.unwrap_or(Format::Jsonl);
    if format == Format::Parquet {
        return Err(Failure::input("--out -: Parquet cannot be written to stdout; use --format csv or --format jsonl"));
    }
    if arguments.json {
        return Err(Failure::input(
            "--json and --out - both want stdout; write the rows to a file, or leave out --json",
        ));
    }
    let [from, to] = identity.range;
    let progress = Progress::new(0, to - from, "bodies", quiet);
    let mut next = from;
    while next < to {
        let rows = block(identity, next);
        let mut sink = format.sink(Vec::new())?;
        rows.iter().try_for_each(|row| sink.write(row))?;
        let text = sink.finish()?;
        // One heading is enough.
        let heading = if format == Format::Csv && next > from { text.iter().position(|b| *b == b'\n') } else { None };
        print(&text[heading.map_or(0, |end| end + 1)..])?;
        next += rows.len() as u64;
        progress.add(rows.len() as u64);
    }
    progress.finish();
    Ok(())
}

/// What the options describe.
fn design(arguments: &SampleArguments) -> Result<Design, Failure> {
    let subject = arguments.body.optional_subject()?;
    if let Some(path) = &arguments.bodies {
        return match subject {
            None => listed(path),
            Some(_) => {
                Err(Failure::input("--bodies and a single body both say which bodies to scan; give one of them"))
            }
        };
    }
    let family = match (&arguments.family, subject) {
        (Some(_), Some(_)) => {
            let option = if arguments.body.body.is_some() { "--body" } else { "--A, --r" };
            return Err(Failure::input(format!("--family and {option} both describe the bodies; give one of them")));
        }
        (Some(family), None) => family.clone(),
        (None, Some(subject)) => {
            BodyFamily::Body { moments: subject.body.moments().clone(), center: subject.body.center().clone() }
        }
        (None, None) => {
            return Err(Failure::input(
                "no bodies are given; use --family general --samples 100000, --family katok, or a body with \
                 --vary A2=0.5:2:200",
            ));
        }
    };
    Design::new(family, arguments.vary.clone(), arguments.samples, arguments.seed).map_err(|error| match error {
        DesignError::NoSamples => Failure::input(
            "--samples is missing; give --samples 100000, or ranges with numbers of grid values such as --vary A2=0.5:2:200",
        ),
        DesignError::GridAndSamples => Failure::input(format!("--samples: {error}")),
        error => Failure::input(format!("--vary: {error}")),
    })
}

/// The bodies of a table.
fn listed(path: &Path) -> Result<Design, Failure> {
    let wrong = |what: String| Failure::input(format!("--bodies {}: {what}", path.display()));
    let unread = |error: csv::Error| wrong(format!("{error}; give a table with the columns {}", COLUMNS.join(", ")));
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(path).map_err(unread)?;
    let headings = reader.headers().map_err(unread)?.clone();
    let mut places = [0; 6];
    for (place, name) in places.iter_mut().zip(COLUMNS) {
        *place = headings
            .iter()
            .position(|heading| heading == name)
            .ok_or_else(|| wrong(format!("it has no column {name}; the columns are {}", COLUMNS.join(", "))))?;
    }
    let (mut bodies, mut digest) = (Vec::new(), Sha256::new());
    for (body, record) in reader.records().enumerate() {
        let record = record.map_err(unread)?;
        let mut values = [0.0; 6];
        for (value, (place, name)) in values.iter_mut().zip(places.iter().zip(COLUMNS)) {
            let number = values::float(&record[*place])
                .map_err(|error| wrong(format!("body {body}, numbered from 0: {name}: {error}")))?;
            // Without the sign of 0.
            *value = number + 0.0;
            digest.update(value.to_le_bytes());
        }
        let [a1, a2, a3, r1, r2, r3] = values;
        bodies.push([[a1, a2, a3], [r1, r2, r3]]);
    }
    let count = bodies.len() as u64;
    if count == 0 {
        return Err(wrong("it contains no body".to_owned()));
    }
    let list = BodyList::new(output::hexadecimal(digest), bodies);
    Design::new(BodyFamily::Listed(list), Vec::new(), Some(count), 0).map_err(Failure::input)
}
