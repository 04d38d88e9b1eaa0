//! Why a point has no answer.

use bifdiag_diagram::classify::ClassifyError;
use bifdiag_equilibria::curves::MomentumError;
use bifdiag_exact::Unanswered;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

#[derive(Debug, Error)]
pub enum PointError {
    #[error("--l: {0}")]
    Momentum(MomentumError),
    #[error("the point could not be classified")]
    Unanswered(#[source] Unanswered),
}

impl From<Unanswered> for PointError {
    fn from(error: Unanswered) -> Self {
        match error {
            Unanswered::Classify(ClassifyError::Momentum(error)) => Self::Momentum(error),
            error => Self::Unanswered(error),
        }
    }
}

impl CommandError for PointError {
    fn exit(&self) -> Exit {
        match self {
            Self::Momentum(_) => Exit::WrongInput,
            Self::Unanswered(_) => Exit::Failed,
        }
    }
}
