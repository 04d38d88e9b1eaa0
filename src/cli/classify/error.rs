//! Why a point has no answer.

use bifdiag_diagram::fast::FastError;
use bifdiag_equilibria::curves::MomentumError;
use bifdiag_exact::AnswerError;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

#[derive(Debug, Error)]
pub enum PointError {
    #[error("--l: {0}")]
    Momentum(MomentumError),
    #[error("the point could not be classified")]
    Answer(#[source] AnswerError),
}

impl From<AnswerError> for PointError {
    fn from(error: AnswerError) -> Self {
        match error {
            AnswerError::Fast(FastError::Momentum(error)) => Self::Momentum(error),
            error => Self::Answer(error),
        }
    }
}

impl CommandError for PointError {
    fn exit(&self) -> Exit {
        match self {
            Self::Momentum(_) => Exit::WrongInput,
            Self::Answer(_) => Exit::Failed,
        }
    }
}
