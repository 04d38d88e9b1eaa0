//! Standard error.

use std::io::{self, IsTerminal, Write};

use bifdiag_schema::harmless;

/// A line on stderr, without control of the terminal: a message may quote files; a closed stderr is no reason to stop.
pub fn say(message: &str) {
    say_styled(&harmless(message));
}

/// Likewise, with the colours of a text of our own.
pub fn say_styled(text: &str) {
    let _closed = writeln!(io::stderr(), "{text}");
}

/// True if a person can read stderr as it is written.
pub fn is_terminal() -> bool {
    io::stderr().is_terminal()
}
