//! Batches: JSON Lines in, one line out for each, in the same order, errors in place.

mod lines;
mod query;

use std::fmt::Display;
use std::fs::File;
use std::io::{self, IsTerminal, Read};
use std::path::Path;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;
use schema::BatchErrorDocument;

use super::arguments::BatchArguments;
use super::failure::{Failure, InputError, say};
use super::output;
use super::subject::Subject;
use lines::LineReader;
pub use query::{Query, Wanted};

/// Batches shorter than this are over before a bar could be read.
const PROGRESS_AFTER: Duration = Duration::from_secs(1);

/// Reads `path`, answers every line and writes the answers to stdout.
///
/// What has arrived is answered before more is waited for, so that a program can write a line and read its answer.
pub fn run<E: Display>(
    path: &Path,
    arguments: &BatchArguments,
    subject: Option<&Subject>,
    wanted: Wanted,
    quiet: bool,
    mut answer: impl FnMut(&[Query]) -> Vec<Result<String, E>>,
) -> Result<(), Failure> {
    let (source, bytes) = open(path).map_err(|source| InputError::BatchFile { path: path.to_owned(), source })?;
    let mut reader = LineReader::new(source);
    let mut progress = Progress::new(bytes, quiet);
    let (mut lines, mut bad, mut unphysical) = (0, 0, 0);
    loop {
        let chunk = reader.next_chunk().map_err(|source| Failure::BatchRead { path: path.to_owned(), source })?;
        if chunk.is_empty() {
            break;
        }
        let parsed: Vec<_> = chunk.par_iter().map(|line| Query::parse(line, wanted, subject)).collect();
        let mut queries = Vec::with_capacity(chunk.len());
        let mut refused = Vec::with_capacity(chunk.len());
        for query in parsed {
            refused.push(query.map(|query| queries.push(query)).err());
        }
        unphysical += queries.iter().filter(|query| query.unphysical).count();
        let mut answers = answer(&queries).into_iter();
        let mut out = Vec::new();
        for (line, refused) in chunk.iter().zip(refused) {
            lines += 1;
            progress.read(line.len());
            let answered = match refused {
                None => answers.next().transpose().map(Option::unwrap_or_default).map_err(|error| error.to_string()),
                Some(error) => Err(error.to_string()),
            };
            match answered {
                Ok(text) => out.extend_from_slice(text.as_bytes()),
                Err(error) => {
                    bad += 1;
                    serde_json::to_writer(&mut out, &BatchErrorDocument { error, line: lines })?;
                }
            }
            out.push(b'\n');
        }
        output::print(&out)?;
        progress.show(lines);
    }
    progress.finish();
    if unphysical > 0 {
        tracing::warn!("{unphysical} of {lines} lines have A that violates the triangle inequality Ai + Aj >= Ak");
    }
    if bad > 0 {
        if arguments.strict {
            return Err(InputError::BadLines { bad, lines }.into());
        }
        if !quiet {
            say(&format!("{bad} of {lines} lines of the batch are wrong; see the lines with \"error\""));
        }
    }
    Ok(())
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

/// A progress bar on long work, on a terminal.
struct Progress {
    bar: Option<ProgressBar>,
    read: u64,
}

impl Progress {
    fn new(bytes: Option<u64>, quiet: bool) -> Self {
        if quiet || !io::stderr().is_terminal() {
            return Self { bar: None, read: 0 };
        }
        let bar = match bytes {
            Some(bytes) => ProgressBar::with_draw_target(Some(bytes), ProgressDrawTarget::hidden())
                .with_style(style("{bar:40} {percent}% {msg}, {eta} left")),
            None => {
                ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()).with_style(style("{spinner} {msg}"))
            }
        };
        Self { bar: Some(bar), read: 0 }
    }

    fn read(&mut self, bytes: usize) {
        // One more for the end of the line.
        self.read += bytes as u64 + 1;
    }

    fn show(&mut self, lines: usize) {
        if let Some(bar) = &self.bar {
            if bar.is_hidden() && bar.elapsed() > PROGRESS_AFTER {
                bar.set_draw_target(ProgressDrawTarget::stderr());
            }
            bar.set_position(self.read);
            bar.set_message(format!("{lines} lines"));
        }
    }

    fn finish(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_unknown_key| ProgressStyle::default_bar())
}
