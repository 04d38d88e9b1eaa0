//! What the options say: values, bodies, parts, files that are read.

mod body;
mod numbers;
mod part;
mod plausible;
pub mod values;

use std::fs;
use std::io::{self, Read, Stdin};
use std::path::Path;

pub use body::{BodyArguments, PlainBodyArguments, PointArguments, add_integrals, head, integrable, motion_units};
pub use numbers::Numbers;
pub use part::{GivenPart, PART, PartArguments, shown, shown_of_part};
pub use values::accuracy;

/// The text of a whole file, or of stdin.
pub fn read(path: &Path) -> io::Result<String> {
    if path == Path::new("-") {
        let mut text = String::new();
        stdin()?.read_to_string(&mut text)?;
        return Ok(text);
    }
    fs::read_to_string(path)
}

/// Standard input, unless it was closed when the process began.
pub fn stdin() -> io::Result<Stdin> {
    if bifdiag_streams::stdin_was_closed() {
        Err(io::Error::other("standard input is closed"))
    } else {
        Ok(io::stdin())
    }
}
