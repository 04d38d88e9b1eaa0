//! Why there is no list of relative equilibria.

use thiserror::Error;
use top::critical::CriticalError;

use crate::cli::failure::CommandError;

/// Why there is no answer.
#[derive(Debug, Error)]
#[error("the relative equilibria could not be found")]
pub struct NotFound(#[from] CriticalError);

impl CommandError for NotFound {}

/// Why a line of a batch has no answer.
#[derive(Debug, Error)]
pub enum Unanswered {
    #[error(transparent)]
    Critical(#[from] CriticalError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}
