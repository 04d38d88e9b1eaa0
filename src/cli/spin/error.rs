//! Why there is no state.

use thiserror::Error;
use top::body::ParseNumberError;

use crate::cli::failure::{CommandError, Exit};

/// The options describe no state.
#[derive(Debug, Error)]
pub enum StateInput {
    #[error("{missing} is missing: {given} also needs it, such as {example}")]
    Incomplete { given: &'static str, missing: &'static str, example: &'static str },
    #[error("no state is given; use --spin \"3000 rpm\" --axis z, or --omega 1,0,2 --vertical 0,0,1")]
    Nothing,
    #[error("{first} and {second} both say how the body turns; give --spin with --axis, or --omega")]
    Two { first: &'static str, second: &'static str },
    #[error(
        "--axis: rotation about it is not permanent, so that it has no frequencies of its own; the nearest permanent axis is {axis}, {angle}° away"
    )]
    NotPermanent { axis: String, angle: String },
    #[error(
        "--axis: rotation about it is not permanent at every spin, so that it has no frequencies of its own; \
         `bifdiag critical-spin` gives the spin at which it is steady, if there is one"
    )]
    NotAtEverySpin,
    #[error("--tolerance and ± in the numbers of the part both say how well it is known; leave out one of them")]
    TwoTolerances,
}

impl CommandError for StateInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// A state whose energy or momentum leaves the range of numbers.
#[derive(Debug, Error)]
#[error("the state leaves the range of numbers")]
pub struct StateFailure(#[from] pub ParseNumberError);

impl CommandError for StateFailure {}
