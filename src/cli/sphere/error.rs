//! Why there is no picture of U.

use bifdiag_diagram::classify::ClassifyError;
use bifdiag_diagram::topology::merge::MergeError;
use bifdiag_equilibria::curves::MomentumError;
use bifdiag_exact::{NoAtlas, Unanswered};
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
    Unanswered(#[source] Unanswered),
    #[error("the components of U could not be told apart in f64")]
    Region(#[from] ClassifyError),
    #[error("the regions of this body could not be found")]
    Atlas(#[from] NoAtlas),
    #[error("the components of U could not be told apart")]
    Merge(#[from] MergeError),
    #[error("the sample of the region is beyond f64")]
    Sample(#[from] bifdiag_numbers::ParseNumberError),
    #[error("the relative equilibria could not be found")]
    Critical(#[from] bifdiag_equilibria::critical::CriticalError),
}

impl From<Unanswered> for SphereError {
    fn from(error: Unanswered) -> Self {
        match error {
            Unanswered::Classify(ClassifyError::Momentum(error)) => Self::Momentum(error),
            error => Self::Unanswered(error),
        }
    }
}

impl CommandError for SphereError {
    fn exit(&self) -> Exit {
        match self {
            Self::NoPoint { .. } | Self::UnknownRegion { .. } | Self::Empty { .. } | Self::Momentum(_) => {
                Exit::WrongInput
            }
            Self::Unanswered(_)
            | Self::Region(_)
            | Self::Atlas(_)
            | Self::Merge(_)
            | Self::Sample(_)
            | Self::Critical(_) => Exit::Failed,
        }
    }
}
