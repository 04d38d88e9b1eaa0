//! The command line of a document: made from the body and the settings, never from what was typed, so that the program,
//! Python and a page write the same bytes.

use std::fmt::Display;

use bifdiag_body::Body;
use bifdiag_numbers::Number;
use bifdiag_schema::{Head, SCHEMA_VERSION};

/// A command line that makes the document in which it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommandLine(String);

/// Version of the program, for its documents.
#[must_use]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}

/// What a document begins with; `command` makes it.
#[must_use]
pub fn head(command: String) -> Head {
    Head { schema_version: SCHEMA_VERSION.to_owned(), version: version(), command }
}

impl CommandLine {
    /// `bifdiag COMMAND`, without options yet.
    #[must_use]
    pub fn new(command: &str) -> Self {
        Self(format!("bifdiag {command}"))
    }

    /// Adds `--name value`.
    #[must_use]
    pub fn option(mut self, name: &str, value: impl Display) -> Self {
        let value = value.to_string();
        // After a blank, a value that starts with a hyphen could be taken for an option.
        let separator = if value.starts_with('-') { "=" } else { " " };
        self.0.extend([" --", name, separator, &quoted(&value)]);
        self
    }

    /// Adds an argument that is no option.
    #[must_use]
    pub fn argument(mut self, value: impl Display) -> Self {
        self.0.extend([" ", &quoted(&value.to_string())]);
        self
    }

    /// Adds `--name value` where there is a value.
    #[must_use]
    pub fn option_if(self, name: &str, value: Option<impl Display>) -> Self {
        match value {
            Some(value) => self.option(name, value),
            None => self,
        }
    }

    /// Adds `--name` if it is wanted.
    #[must_use]
    pub fn flag(mut self, name: &str, wanted: bool) -> Self {
        if wanted {
            self.0.push_str(" --");
            self.0.push_str(name);
        }
        self
    }

    /// Adds principal moments and centre of mass, as they were given.
    #[must_use]
    pub fn body(self, body: &Body) -> Self {
        let list = |numbers: &[Number; 3]| numbers.each_ref().map(Number::text).join(",");
        self.option("A", list(body.moments())).option("r", list(body.center()))
    }

    /// The text.
    #[must_use]
    pub fn text(self) -> String {
        self.0
    }

    /// The text, which ends with `--json`: the document itself on stdout.
    #[must_use]
    pub fn json(self) -> String {
        self.flag("json", true).0
    }
}

/// A value as a shell reads it.
fn quoted(value: &str) -> String {
    // These it reads as they stand.
    let plain = |c: u8| c.is_ascii_alphanumeric() || b"+-./:=,_".contains(&c);
    if !value.is_empty() && value.bytes().all(plain) {
        value.to_owned()
    } else {
        format!("'{}'", value.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_so_that_they_are_read_back() {
        let line = CommandLine::new("find").option("signature", "S2+T2").option("h", "-1/2").option("out", "it's a b");
        assert_eq!(line.json(), r"bifdiag find --signature S2+T2 --h=-1/2 --out 'it'\''s a b' --json");
    }
}
