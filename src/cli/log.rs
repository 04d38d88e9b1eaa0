//! Warnings and what `-v` tells, on stderr.

use std::io::{self, IsTerminal};

use tracing::Level;

use super::arguments::CommonArguments;

/// Errors only with `-q`, else warnings; `-v` and `-vv` tell more.
pub fn start(common: &CommonArguments) {
    let level = match (common.quiet, common.verbose) {
        (true, _) => Level::ERROR,
        (false, 0) => Level::WARN,
        (false, 1) => Level::INFO,
        (false, _) => Level::DEBUG,
    };
    tracing_subscriber::fmt()
        .with_writer(io::stderr)
        .with_ansi(io::stderr().is_terminal())
        .with_max_level(level)
        .without_time()
        .with_target(false)
        .log_internal_errors(false)
        .init();
}
