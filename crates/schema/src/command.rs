//! The command line of a document: made from the body and the settings, never from what was typed, so that the program,
//! Python and a page write the same bytes.

use std::fmt::Display;

use super::{GivenBody, PartDocument};

/// The command line that makes the document containing it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommandLine(String);

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

    /// Adds the options that describe a body as given, or its part.
    #[must_use]
    pub fn body(self, given: &GivenBody, part: Option<&PartDocument>) -> Self {
        let Some(part) = part else {
            return self.option("A", given.moments.join(",")).option("r", given.center.join(","));
        };
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = &part.inertia;
        let products = [xy, xz, yz].iter().any(|product| *product != "0");
        self.option("inertia", [xx, yy, zz, xy, xz, yz].map(String::as_str).join(","))
            .option_if("products", products.then_some("tensor"))
            .option("com", part.com.join(","))
            .option("mass", &part.mass)
            .option("units", &part.units)
            .option("g", &part.g)
            .flag("unphysical", !part.physical)
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

/// A shell can read it unchanged.
#[must_use]
pub fn is_plain(c: u8) -> bool {
    c.is_ascii_alphanumeric() || b"+-./:=,_".contains(&c)
}

/// A value as a shell reads it.
#[must_use]
pub fn quoted(value: &str) -> String {
    if !value.is_empty() && value.bytes().all(is_plain) {
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
