//! Batches: JSON Lines in, one line out for each, in the same order, errors in place.

mod lines;
mod query;

use std::fs::File;
use std::io::{self, IsTerminal, Read};
use std::path::Path;
use std::time::Duration;

use bifdiag::document::BatchErrorDocument;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

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
pub fn run(
    path: &Path,
    arguments: &BatchArguments,
    subject: Option<&Subject>,
    wanted: Wanted,
    quiet: bool,
    mut answer: impl FnMut(&[Query]) -> Vec<Result<String, serde_json::Error>>,
) -> Result<(), Failure> {
    let (source, bytes) = open(path).map_err(|source| InputError::BatchFile { path: path.to_owned(), source })?;
    let mut reader = LineReader::new(source);
    let mut progress = Progress::new(bytes, quiet);
    let (mut lines, mut bad) = (0, 0);
    loop {
        let chunk = reader.next_chunk().map_err(|source| Failure::BatchRead { path: path.to_owned(), source })?;
        if chunk.is_empty() {
            break;
        }
        let mut errors = Vec::new();
        let mut queries = Vec::new();
        for line in &chunk {
            lines += 1;
            progress.read(line.len());
            match Query::parse(line, wanted, subject) {
                Ok(query) => queries.push(query),
                Err(error) => errors.push(BatchErrorDocument { error: error.to_string(), line: lines }),
            }
        }
        bad += errors.len();
        output::print(&interleave(answer(&queries), errors, lines - chunk.len(), chunk.len())?)?;
        progress.show(lines);
    }
    progress.finish();
    if bad > 0 {
        if arguments.strict {
            return Err(InputError::BadLines { bad, lines }.into());
        }
        say(&format!("{bad} of {lines} lines of the batch are wrong; see the lines with \"error\""));
    }
    Ok(())
}

/// Answers and errors in the order of their lines, which start after line `before`.
fn interleave(
    answers: Vec<Result<String, serde_json::Error>>,
    errors: Vec<BatchErrorDocument>,
    before: usize,
    count: usize,
) -> Result<Vec<u8>, serde_json::Error> {
    let mut answers = answers.into_iter();
    let mut errors = errors.into_iter().peekable();
    let mut out = Vec::new();
    for line in before + 1..=before + count {
        match errors.next_if(|error| error.line == line) {
            Some(error) => serde_json::to_writer(&mut out, &error)?,
            None => out.extend(answers.next().transpose()?.unwrap_or_default().into_bytes()),
        }
        out.push(b'\n');
    }
    Ok(out)
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
