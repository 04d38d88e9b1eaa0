//! Batches: JSON Lines in, one line out for each, in the same order, errors in place.

mod lines;
mod query;

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use bifdiag_schema::{BatchErrorDocument, shown};
use clap::Args;
use rayon::prelude::*;

use super::failure::{Exit, Failure, failed};
use super::input::stdin;
use super::terminal::{Progress, counted, print, say};
use bifdiag_documents::Subject;
use lines::{Chunk, LineReader};

use query::QueryReader;
pub use query::{Query, Wanted};

/// Many points at once.
#[derive(Debug, Args)]
#[command(next_help_heading = "Batch")]
pub struct BatchArguments {
    /// Read one JSON object per line from FILE (-: stdin) and answer each with one line
    #[arg(long, value_name = "FILE")]
    pub batch: Option<PathBuf>,
    /// Exit with status 2 if a line of the batch is invalid
    #[arg(long, hide_short_help = true)]
    pub strict: bool,
}

impl BatchArguments {
    /// The file of the batch, if one is asked for and none of the options that do not go with it is given; each with the
    /// reason.
    pub fn path(&self, refused: &[(&'static str, &'static str, bool)]) -> Result<Option<&Path>, Failure> {
        let Some(path) = &self.batch else {
            if self.strict {
                let why = "it applies to invalid lines of a batch; add --batch FILE or leave it out";
                return Err(Failure::input(format!("--strict needs --batch: {why}")));
            }
            return Ok(None);
        };
        match refused.iter().find(|(.., given)| *given) {
            Some((option, why, _)) => Err(Failure::input(format!(
                "{option} cannot be used with --batch: {why}; leave out {option} or --batch"
            ))),
            None => Ok(Some(path)),
        }
    }
}

/// Why a part of the point is no option beside a batch.
pub const LINES_SAY_IT: &str = "each line gives its own";

/// A part of the point that is neither an option nor in a batch.
pub fn no_point(missing: &str, example: &str) -> Failure {
    Failure::input(format!("{missing} is missing; give {example}, or --batch FILE for many points"))
}

/// A batch that is to be answered.
pub struct Batch<'a> {
    pub path: &'a Path,
    /// A wrong line makes the whole batch wrong input.
    pub strict: bool,
    /// The body of lines that name none.
    pub subject: Option<Arc<Subject>>,
    pub wanted: Wanted,
    pub quiet: bool,
}

/// What was counted.
#[derive(Default)]
struct Tally {
    bytes: u64,
    lines: usize,
    /// Wrong lines.
    bad: usize,
    /// Right questions without an answer.
    unanswered: usize,
    unphysical: usize,
    /// Lines with each key that means nothing here.
    ignored: BTreeMap<String, usize>,
}

/// The most ignored keys that are counted.
const KEYS_MAX: usize = 8;

/// Lines that one thread reads one after the other: what is known of a body is used again for the next line.
const BLOCK: usize = 256;

impl Batch<'_> {
    /// Answers every line and writes the answers to stdout.
    ///
    /// What has arrived is answered before more is waited for, so that a program can write a line and read its answer.
    pub fn run(&self, mut answer: impl FnMut(&[Query]) -> Vec<Result<Vec<u8>, Failure>>) -> Result<(), Failure> {
        let path = self.path.display();
        let (source, bytes) = open(self.path).map_err(|error| {
            Failure::input(format!("--batch {path}: {error}; give a file that can be read, or - for stdin"))
        })?;
        let mut reader = LineReader::new(source);
        let progress = Progress::of_bytes(bytes, self.quiet);
        let (mut tally, mut chunk) = (Tally::default(), Chunk::default());
        loop {
            reader.next_chunk(&mut chunk).map_err(failed(format!("--batch {path}: reading stopped")))?;
            if chunk.len() == 0 {
                break;
            }
            print(self.answers(&chunk, &mut tally, &mut answer)?)?;
            progress.message(counted(tally.lines, "line", "lines"));
            progress.set(tally.bytes);
        }
        progress.finish();
        self.conclude(&tally)
    }

    /// A line for each line.
    fn answers(
        &self,
        chunk: &Chunk,
        tally: &mut Tally,
        answer: &mut impl FnMut(&[Query]) -> Vec<Result<Vec<u8>, Failure>>,
    ) -> Result<Vec<u8>, serde_json::Error> {
        let lines: Vec<&[u8]> = chunk.lines().collect();
        let blocks: Vec<Vec<_>> = lines
            .par_chunks(BLOCK)
            .map(|lines| {
                let mut reader = QueryReader::new(self.wanted, self.subject.as_ref());
                lines.iter().map(|line| reader.read(line)).collect()
            })
            .collect();
        let mut queries = Vec::with_capacity(chunk.len());
        let mut refused = Vec::with_capacity(chunk.len());
        for query in blocks.into_iter().flatten() {
            refused.push(query.map(|query| queries.push(query)).err());
        }
        for key in queries.iter().flat_map(|query| &query.ignored) {
            if tally.ignored.len() < KEYS_MAX || tally.ignored.contains_key(key) {
                *tally.ignored.entry(key.clone()).or_default() += 1;
            }
        }
        tally.unphysical += queries.iter().filter(|query| query.unphysical).count();
        let mut answers = answer(&queries).into_iter();
        let mut out = Vec::new();
        for (line, refused) in lines.into_iter().zip(refused) {
            tally.lines += 1;
            // One more for the end of the line.
            tally.bytes += line.len() as u64 + 1;
            let answered = match refused {
                Some(failure) => Err(failure),
                None => answers.next().transpose(),
            };
            match answered {
                Ok(text) => out.extend(text.unwrap_or_default()),
                Err(failure) => {
                    let wrong = failure.exit() == Exit::WrongInput;
                    tally.bad += usize::from(wrong);
                    tally.unanswered += usize::from(!wrong);
                    bifdiag_schema::write_json(
                        &mut out,
                        &BatchErrorDocument { error: failure.to_string(), line: tally.lines },
                    )?;
                }
            }
            out.push(b'\n');
        }
        Ok(out)
    }

    fn conclude(&self, tally: &Tally) -> Result<(), Failure> {
        let &Tally { lines, bad, unanswered, unphysical, ref ignored, .. } = tally;
        if unphysical > 0 {
            tracing::warn!(
                "the {} of {unphysical} of {} cannot exist: neither Ai + Aj > Ak nor Ai + Aj = Ak with rk = 0",
                if unphysical == 1 { "body" } else { "bodies" },
                counted(lines, "line", "lines")
            );
        }
        if !ignored.is_empty() {
            let count = |(key, lines): (&String, &usize)| format!("{} ({lines})", shown(key));
            let keys: Vec<String> = ignored.iter().map(count).collect();
            tracing::warn!("these keys have no meaning here and were ignored (number of lines): {}", keys.join(", "));
        }
        let of_batch = |what: &str, count: usize| {
            let (lines, verb) = (counted(lines, "line", "lines"), if count == 1 { "is" } else { "are" });
            format!("{count} of {lines} of the batch {verb} {what}; see those with \"error\"")
        };
        if bad > 0 && self.strict {
            return Err(Failure::input(format!("--strict: {}", of_batch("invalid", bad))));
        }
        if bad > 0 && !self.quiet {
            say(&of_batch("invalid", bad));
        }
        if unanswered == 0 {
            return Ok(());
        }
        Err(Failure::work(of_batch("without an answer", unanswered)))
    }
}

/// The file or stdin, and the number of its bytes if that is known.
fn open(path: &Path) -> io::Result<(Box<dyn Read>, Option<u64>)> {
    if path == Path::new("-") {
        return Ok((Box::new(stdin()?), None));
    }
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    if metadata.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory"));
    }
    Ok((Box::new(file), metadata.is_file().then_some(metadata.len())))
}
