//! Why there is no list of relative equilibria.

use bifdiag_equilibria::critical::CriticalError;
use thiserror::Error;

use super::table::NoTable;
use crate::cli::failure::{CommandError, Exit};

/// Why there is no answer.
#[derive(Debug, Error)]
#[error("the relative equilibria could not be found")]
pub enum NotFound {
    Critical(#[from] CriticalError),
    Table(#[from] NoTable),
}

impl CommandError for NotFound {}

/// Options that do not fit together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum RangeInput {
    #[error("--out needs a range of momenta, such as --l 0:4:401; at one momentum --json writes to stdout")]
    OutWithoutRange,
    #[error("--json at a range of momenta: give --out FILE.jsonl instead (one object for each relative equilibrium)")]
    JsonOfRange,
    #[error("--method newton follows the curves to one momentum: give --l a number, and no --batch")]
    NewtonOfMany,
}

impl CommandError for RangeInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// Why a line of a batch has no answer.
#[derive(Debug, Error)]
pub enum Unanswered {
    #[error(transparent)]
    Critical(#[from] CriticalError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

impl CommandError for Unanswered {
    fn exit(&self) -> Exit {
        match self {
            Self::Critical(CriticalError::Momentum(_)) => Exit::WrongInput,
            Self::Critical(CriticalError::Equilibria(_) | CriticalError::Lost { .. }) | Self::Json(_) => Exit::Failed,
        }
    }
}
