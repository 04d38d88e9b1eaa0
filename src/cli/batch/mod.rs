//! Batches: JSON Lines in, one line out for each, in the same order, errors in place.

mod arguments;
mod error;
mod lines;
mod query;

use std::fmt::Display;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use rayon::prelude::*;
use schema::BatchErrorDocument;

use super::export::ExportError;
use super::failure::Failure;
use super::input::Subject;
use super::terminal::{Progress, print, say};
use error::BatchRead;
use lines::LineReader;

pub use arguments::BatchArguments;
pub use error::BatchInput;
pub use query::{Query, Wanted};

/// A batch that is to be answered.
pub struct Batch<'a> {
    pub path: &'a Path,
    /// A wrong line makes the whole batch wrong input.
    pub strict: bool,
    /// The body of lines that name none.
    pub subject: Option<Subject>,
    pub wanted: Wanted,
    pub quiet: bool,
}

/// What was counted.
#[derive(Default)]
struct Tally {
    bytes: u64,
    lines: usize,
    bad: usize,
    unphysical: usize,
}

impl Batch<'_> {
    /// Answers every line and writes the answers to stdout.
    ///
    /// What has arrived is answered before more is waited for, so that a program can write a line and read its answer.
    pub fn run<E: Display>(&self, mut answer: impl FnMut(&[Query]) -> Vec<Result<String, E>>) -> Result<(), Failure> {
        let (source, bytes) =
            open(self.path).map_err(|source| BatchInput::File { path: self.path.to_owned(), source })?;
        let mut reader = LineReader::new(source);
        let progress = Progress::of_bytes(bytes, self.quiet);
        let mut tally = Tally::default();
        loop {
            let chunk = reader.next_chunk().map_err(|source| BatchRead { path: self.path.to_owned(), source })?;
            if chunk.is_empty() {
                break;
            }
            print(self.answers(&chunk, &mut tally, &mut answer).map_err(ExportError::from)?)?;
            progress.message(format!("{} lines", tally.lines));
            progress.set(tally.bytes);
        }
        progress.finish();
        self.conclude(&tally)
    }

    /// A line for each line.
    fn answers<E: Display>(
        &self,
        chunk: &[Vec<u8>],
        tally: &mut Tally,
        answer: &mut impl FnMut(&[Query]) -> Vec<Result<String, E>>,
    ) -> Result<Vec<u8>, serde_json::Error> {
        let subject = self.subject.as_ref();
        let parsed: Vec<_> = chunk.par_iter().map(|line| Query::parse(line, self.wanted, subject)).collect();
        let mut queries = Vec::with_capacity(chunk.len());
        let mut refused = Vec::with_capacity(chunk.len());
        for query in parsed {
            refused.push(query.map(|query| queries.push(query)).err());
        }
        tally.unphysical += queries.iter().filter(|query| query.unphysical).count();
        let mut answers = answer(&queries).into_iter();
        let mut out = Vec::new();
        for (line, refused) in chunk.iter().zip(refused) {
            tally.lines += 1;
            // One more for the end of the line.
            tally.bytes += line.len() as u64 + 1;
            let answered = match refused {
                None => answers.next().transpose().map(Option::unwrap_or_default).map_err(|error| error.to_string()),
                Some(error) => Err(error.to_string()),
            };
            match answered {
                Ok(text) => out.extend_from_slice(text.as_bytes()),
                Err(error) => {
                    tally.bad += 1;
                    serde_json::to_writer(&mut out, &BatchErrorDocument { error, line: tally.lines })?;
                }
            }
            out.push(b'\n');
        }
        Ok(out)
    }

    fn conclude(&self, &Tally { lines, bad, unphysical, .. }: &Tally) -> Result<(), Failure> {
        if unphysical > 0 {
            tracing::warn!("{unphysical} of {lines} lines have A that violates the triangle inequality Ai + Aj >= Ak");
        }
        if bad > 0 && self.strict {
            return Err(BatchInput::BadLines { bad, lines }.into());
        }
        if bad > 0 && !self.quiet {
            say(&format!("{bad} of {lines} lines of the batch are wrong; see the lines with \"error\""));
        }
        Ok(())
    }
}

/// The file or stdin, and the number of its bytes if that is known.
fn open(path: &Path) -> io::Result<(Box<dyn Read>, Option<u64>)> {
    if path == Path::new("-") {
        return Ok((Box::new(io::stdin()), None));
    }
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    if metadata.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a directory"));
    }
    Ok((Box::new(file), metadata.is_file().then_some(metadata.len())))
}
