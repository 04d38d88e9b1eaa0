//! Standard error.

use std::io::{self, IsTerminal, Write};

/// A line on stderr; a closed stderr is no reason to stop.
pub fn say(message: &str) {
    let _closed = writeln!(io::stderr(), "{message}");
}

/// True if a person can read stderr as it is written.
pub fn is_terminal() -> bool {
    io::stderr().is_terminal()
}
