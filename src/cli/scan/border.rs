//! `bifdiag scan border`.

use super::arguments::BorderArguments;
use crate::cli::failure::Failure;

pub fn run(_arguments: &BorderArguments) -> Result<(), Failure> {
    Ok(())
}
