//! How accurate an answer must be.

use clap::ValueEnum;
use schema::Accuracy;

/// How accurate the answer must be, as it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum AccuracyArgument {
    /// Regions as in standard; coarser curves from the closed form, without stability
    Draft,
    /// f64 with error bounds; undecided where they do not suffice
    Standard,
    /// Proved, with a certificate that `bifdiag verify` checks
    Certified,
}

impl AccuracyArgument {
    /// The level.
    pub fn level(self) -> Accuracy {
        match self {
            Self::Draft => Accuracy::Draft,
            Self::Standard => Accuracy::Standard,
            Self::Certified => Accuracy::Certified,
        }
    }
}
