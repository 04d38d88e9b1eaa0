//! Files that are read.

use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The text of a whole file, or of stdin.
pub fn read(path: &Path) -> io::Result<String> {
    if path == Path::new("-") {
        let mut text = String::new();
        io::stdin().read_to_string(&mut text)?;
        return Ok(text);
    }
    fs::read_to_string(path)
}
