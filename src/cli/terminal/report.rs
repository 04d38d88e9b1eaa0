//! What a terminal shows, line by line.

use std::fmt::Display;
use std::path::PathBuf;

use bifdiag_schema::harmless;

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
