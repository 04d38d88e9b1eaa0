//! Runs of the program, written as sentences.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// The program.
pub const PROGRAM: &str = env!("CARGO_BIN_EXE_bifdiag");

/// A command line to be run.
pub struct Run {
    command: assert_cmd::Command,
    line: String,
}

/// What a run has done.
pub struct Done {
    line: String,
    output: Output,
}

/// `bifdiag` with the words of `line` as arguments.
pub fn bifdiag(line: &str) -> Run {
    let mut command = Command::new(PROGRAM);
    command.args(line.split_whitespace());
    Run { command: assert_cmd::Command::from_std(command), line: line.to_owned() }
}

impl Run {
    /// With one more argument, which may hold blanks.
    pub fn and(mut self, argument: impl AsRef<Path>) -> Self {
        self.command.arg(argument.as_ref());
        self.line = format!("{} {}", self.line, argument.as_ref().display());
        self
    }

    /// With the words of a line as further arguments.
    pub fn arguments(mut self, line: &str) -> Self {
        self.command.args(line.split_whitespace());
        self.line = format!("{} {line}", self.line);
        self
    }

    /// With a text on stdin.
    pub fn reading(mut self, stdin: impl Into<Vec<u8>>) -> Self {
        self.command.write_stdin(stdin);
        self
    }

    /// In a directory.
    pub fn inside(mut self, directory: &Path) -> Self {
        self.command.current_dir(directory);
        self
    }

    /// Where no programs are installed but those of a directory.
    pub fn finding_programs_in(mut self, directory: &Path) -> Self {
        self.command.env("PATH", directory);
        self
    }

    fn ends_with(mut self, status: i32) -> Done {
        let output = self.command.output().expect("the program starts");
        let done = Done { line: self.line, output };
        assert_eq!(done.output.status.code(), Some(status), "bifdiag {}\n{}", done.line, done.stderr());
        done
    }

    /// Exit status 0.
    pub fn succeeds(self) -> Done {
        self.ends_with(0)
    }

    /// Exit status 2: the input is wrong.
    pub fn refused(self) -> Done {
        self.ends_with(2)
    }

    /// Exit status 0, or `None` with exit status 2: there is no answer for this input.
    pub fn succeeds_unless_refused(mut self) -> Option<Done> {
        let output = self.command.output().expect("the program starts");
        let done = Done { line: self.line, output };
        assert!(matches!(done.output.status.code(), Some(0 | 2)), "bifdiag {}\n{}", done.line, done.stderr());
        done.output.status.success().then_some(done)
    }

    /// Exit status 1: something else went wrong.
    pub fn fails(self) -> Done {
        self.ends_with(1)
    }
}

/// A picture without the marks of its formulas, so that texts are found in it.
pub fn plain(svg: &str) -> String {
    let parts = svg.split("<tspan").enumerate();
    let kept = parts.map(|(number, part)| match part.split_once('>') {
        Some((_, rest)) if number > 0 => rest,
        _ => part,
    });
    kept.collect::<String>().replace("</tspan>", "")
}

impl Done {
    /// With this on stderr.
    pub fn telling(self, message: &str) -> Self {
        assert!(self.stderr().contains(message), "bifdiag {}\nwanted: {message}\ngot: {}", self.line, self.stderr());
        self
    }

    /// With nothing on stderr.
    pub fn telling_nothing(self) -> Self {
        assert_eq!(self.stderr(), "", "bifdiag {}", self.line);
        self
    }

    /// With this on stdout.
    pub fn printing(self, text: &str) -> Self {
        assert!(self.stdout().contains(text), "bifdiag {}\nwanted: {text}\ngot: {}", self.line, self.stdout());
        self
    }

    /// With nothing on stdout.
    pub fn printing_nothing(self) -> Self {
        assert_eq!(self.stdout(), "", "bifdiag {}", self.line);
        self
    }

    /// Stdout as text.
    pub fn stdout(&self) -> String {
        String::from_utf8(self.output.stdout.clone()).expect("stdout is UTF-8")
    }

    /// Stderr as text.
    pub fn stderr(&self) -> String {
        String::from_utf8(self.output.stderr.clone()).expect("stderr is UTF-8")
    }

    /// Stdout as one JSON document.
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.output.stdout).unwrap_or_else(|error| panic!("{error}: {}", self.stdout()))
    }

    /// Stdout as JSON Lines.
    pub fn json_lines(&self) -> Vec<Value> {
        let parse = |line: &str| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
        self.stdout().lines().map(parse).collect()
    }
}
