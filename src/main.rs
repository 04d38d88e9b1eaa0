//! The command `bifdiag`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(bifdiag::cli::run(std::env::args_os()))
}
