//! Why a point has no answer.

use proof::NotProved;
use thiserror::Error;
use top::atlas::MomentumError;
use top::classify::ClassifyError;

use crate::cli::failure::{CommandError, Exit};

#[derive(Debug, Error)]
pub enum PointError {
    #[error("--l: {0}")]
    Momentum(MomentumError),
    #[error("the point could not be classified")]
    Classify(#[source] ClassifyError),
    #[error("the atlas could not be proved")]
    NotProved(#[from] NotProved),
}

impl From<ClassifyError> for PointError {
    fn from(error: ClassifyError) -> Self {
        match error {
            ClassifyError::Momentum(error) => Self::Momentum(error),
            error => Self::Classify(error),
        }
    }
}

impl CommandError for PointError {
    fn exit(&self) -> Exit {
        match self {
            Self::Momentum(_) => Exit::WrongInput,
            Self::Classify(_) | Self::NotProved(_) => Exit::Failed,
        }
    }
}
