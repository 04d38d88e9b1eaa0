//! What is wrong with the options of these commands.

use bifdiag_body::ParseNumberError;
use thiserror::Error;

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
        "--axis: rotation about it is not permanent at every spin, so that it has no frequencies over the spin; \
         the nearest axis that has them is {axis}, {angle}° away"
    )]
    NotPermanent { axis: String, angle: String },
    #[error(
        "--axis: rotation about it is not permanent at every spin, nor is that about any other axis of this body: there are no \
         frequencies over the spin; \
         `bifdiag critical-spin` gives the spin at which rotation about an axis is steady, if there is one"
    )]
    NoPermanentAxis,
    #[error(
        "no axis of this body is permanent at every spin: give --axis, or list all steady axes at one spin with \
         `bifdiag critical --spin \"300 rpm\"`"
    )]
    NoAxis,
    #[error(
        "without weight every principal axis is permanent, and nothing changes with the spin: give --axis x, y or z for its \
         type, or list all with `bifdiag critical --spin \"300 rpm\"`"
    )]
    NoWeight,
    #[error("--to {to}: the largest spin must be greater than 0, such as \"6000 rpm\"")]
    NoSpins { to: String },
    #[error("--to {to}: at such a spin the frequencies leave the range of numbers; give a smaller one")]
    TooFast { to: String },
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
