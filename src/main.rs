//! The command line of bifdiag.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    let options = match cli::Options::parse() {
        Ok(options) => options,
        Err(refusal) => return refusal.print(),
    };
    match cli::start(&options).and_then(|()| cli::run(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.print(),
    }
}
