//! `bifdiag scan map`.

use super::arguments::MapArguments;
use crate::cli::failure::Failure;
use crate::cli::timings::Timings;

pub fn run(_arguments: &MapArguments, _timings: &Timings) -> Result<(), Failure> {
    Ok(())
}
