//! Why there is no atlas.

use proof::{NotProved, NotWritten};
use thiserror::Error;
use top::atlas::AtlasError;

use crate::cli::failure::CommandError;

#[derive(Debug, Error)]
pub enum NoAtlas {
    #[error("the atlas could not be made")]
    Atlas(#[from] AtlasError),
    #[error("the atlas could not be proved")]
    NotProved(#[from] NotProved),
    #[error("the proved atlas could not be written")]
    NotWritten(#[from] NotWritten),
    #[error("the answer could not be written as JSON")]
    Json(#[from] serde_json::Error),
}

impl CommandError for NoAtlas {}
