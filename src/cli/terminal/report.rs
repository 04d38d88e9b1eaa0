//! Standard output: text in lines and tables.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;

use bifdiag_schema::harmless;

use super::interrupt::uninterrupted;
use crate::cli::failure::{Failure, failed};

/// Writes bytes and flushes them; an interrupt waits until all are written.
pub fn print(bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
    let bytes = bytes.as_ref();
    if bifdiag_streams::stdout_was_closed() && !bytes.is_empty() {
        return Err(Failure::work("cannot write to standard output: it is closed"));
    }
    let _guard = uninterrupted();
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Failure::closed_pipe(),
        _ => failed("cannot write to standard output")(error),
    })
}

/// Lines of text.
#[derive(Debug, Default)]
pub struct Report {
    lines: Vec<String>,
}

impl Report {
    /// Adds a line, or several that are separated by line ends.
    pub fn line(&mut self, text: impl Display) {
        self.lines.push(text.to_string().trim_end().to_owned());
    }

    /// Adds the files that were written, one on each line.
    pub fn written(&mut self, paths: &[PathBuf]) {
        self.lines.extend(paths.iter().map(|path| format!("written: {}", path.display())));
    }

    /// Of nothing but the files that were written.
    pub fn of_written(paths: &[PathBuf]) -> Self {
        let mut report = Self::default();
        report.written(paths);
        report
    }

    /// All lines, each with its end, without control of the terminal: they may name what files contain.
    pub fn text(mut self) -> String {
        self.lines.push(String::new());
        harmless(&self.lines.join("\n"))
    }
}

/// Lines of at most 100 columns, indented.
pub fn wrapped(text: &str) -> String {
    const COLUMNS: usize = 100;
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= COLUMNS => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(format!("  {word}")),
        }
    }
    lines.join("\n")
}

/// Rows of cells under a heading, columns as wide as needed; a cell may hold several lines.
#[derive(Debug)]
pub struct Table {
    heading: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// An empty table.
    pub fn new(heading: &[&'static str]) -> Self {
        Self { heading: heading.to_vec(), rows: Vec::new() }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }

    /// The width of the widest line.
    pub fn width(&self) -> usize {
        self.widths().iter().map(|width| width + 2).sum::<usize>().saturating_sub(2)
    }

    fn widths(&self) -> Vec<usize> {
        let mut widths: Vec<usize> = self.heading.iter().map(|name| name.chars().count()).collect();
        for row in &self.rows {
            for (width, cell) in widths.iter_mut().zip(row) {
                let widest = cell.lines().map(|line| line.chars().count()).max().unwrap_or_default();
                *width = (*width).max(widest);
            }
        }
        widths
    }

    /// The table as text.
    pub fn text(&self) -> String {
        let widths = self.widths();
        let mut out = line(&self.heading, &widths);
        for row in &self.rows {
            let height = row.iter().map(|cell| cell.lines().count()).max().unwrap_or_default();
            for i in 0..height {
                let cells: Vec<&str> = row.iter().map(|cell| cell.lines().nth(i).unwrap_or_default()).collect();
                out.push_str(&line(&cells, &widths));
            }
        }
        out
    }
}

fn line(cells: &[&str], widths: &[usize]) -> String {
    let mut out = String::new();
    for (cell, width) in cells.iter().zip(widths) {
        if !out.is_empty() {
            out.push_str("  ");
        }
        out.push_str(cell);
        out.extend(std::iter::repeat_n(' ', width.saturating_sub(cell.chars().count())));
    }
    let trimmed = out.trim_end().len();
    out.truncate(trimmed);
    out.push('\n');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_wide_as_needed_and_cells_may_have_lines() {
        let mut table = Table::new(&["id", "U"]);
        table.row(["R1".to_owned(), "D2\nS2-2D2".to_owned()]);
        table.row(["R10".to_owned(), "S2".to_owned()]);
        assert_eq!(table.text(), "id   U\nR1   D2\n     S2-2D2\nR10  S2\n");
        assert_eq!(table.width(), 11);
    }
}
