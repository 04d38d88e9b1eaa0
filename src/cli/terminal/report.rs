//! What a terminal shows, line by line.

use std::fmt::Display;
use std::path::PathBuf;

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

    /// The files that were written, one on each line.
    pub fn written(paths: &[PathBuf]) -> Self {
        Self { lines: paths.iter().map(|path| format!("written: {}", path.display())).collect() }
    }

    /// All lines, each with its end.
    pub fn text(mut self) -> String {
        self.lines.push(String::new());
        self.lines.join("\n")
    }
}
