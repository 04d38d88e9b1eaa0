//! Why there is no picture of U.

use bifdiag_diagram::fast::FastError;
use bifdiag_diagram::topology::merge::MergeError;
use bifdiag_equilibria::curves::MomentumError;
use bifdiag_exact::AnswerError;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

#[derive(Debug, Error)]
pub enum SphereError {
    #[error("{missing} is missing: a point such as --h 4.45 --l 3.25, or a region such as --region R4, is needed")]
    NoPoint { missing: &'static str },
    #[error("--region {id}: the atlas of this body has the regions {}", known.join(", "))]
    UnknownRegion { id: String, known: Vec<String> },
    #[error("--h {h}: U is empty, since h is below the minimum of the effective potential at this l; raise --h")]
    Empty { h: String },
    #[error("--l: {0}")]
    Momentum(MomentumError),
    #[error("the point could not be classified")]
    Point(#[source] AnswerError),
    #[error("the components of U could not be told apart in f64")]
    Region(#[from] FastError),
    #[error("the regions of this body could not be found")]
    Atlas(#[source] AnswerError),
    #[error("the components of U could not be told apart")]
    Merge(#[from] MergeError),
    #[error("the sample of the region is beyond f64")]
    Sample(#[from] bifdiag_numbers::ParseNumberError),
    #[error("the relative equilibria could not be found")]
    Critical(#[from] bifdiag_equilibria::critical::CriticalError),
}

impl From<AnswerError> for SphereError {
    fn from(error: AnswerError) -> Self {
        match error {
            AnswerError::Fast(FastError::Momentum(error)) => Self::Momentum(error),
            error => Self::Point(error),
        }
    }
}

impl CommandError for SphereError {
    fn exit(&self) -> Exit {
        match self {
            Self::NoPoint { .. } | Self::UnknownRegion { .. } | Self::Empty { .. } | Self::Momentum(_) => {
                Exit::WrongInput
            }
            Self::Point(_)
            | Self::Region(_)
            | Self::Atlas(_)
            | Self::Merge(_)
            | Self::Sample(_)
            | Self::Critical(_) => Exit::Failed,
        }
    }
}
