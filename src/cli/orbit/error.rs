//! What can go wrong about a motion.

use std::io;
use std::path::PathBuf;

use bifdiag_dynamics::integrator::StepError;
use bifdiag_dynamics::motion::MotionError;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};

/// Wrong input: each message names the argument, the value and what would be right.
#[derive(Debug, Error)]
pub enum OrbitInput {
    #[error(
        "no start is given; use --gamma 0.6,0,0.8 with --omega 1,0.3,1 (or --l-vector), or a point of the section: \
         --h 4.45 --l 3.25 --theta 1.2 --psi pi/2"
    )]
    NoStart,
    #[error("{missing} is missing: {given} also needs it, such as {example}")]
    Incomplete { given: &'static str, missing: &'static str, example: &'static str },
    #[error(
        "{first} and {second} both describe the start; give gamma with l-vector or omega, or h, l, theta, psi, sheet"
    )]
    TwoStarts { first: &'static str, second: &'static str },
    #[error("--theta and --psi need r ≠ 0, of which this body has none; give --gamma with --omega or --l-vector")]
    WeightlessTorus,
    #[error("--theta {theta}: it is the angle between gamma and r, from 0 to pi")]
    Theta { theta: f64 },
    #[error(
        "(theta, psi) = ({theta}, {psi}) is not accessible: U = {potential} there, above --h {h}; raise h or choose \
         another point"
    )]
    Inaccessible { theta: f64, psi: f64, potential: f64, h: f64 },
    #[error("--times {path}: {source}; give t0:t1:n such as 0:10:101, a file that can be read, or - for stdin", path = path.display())]
    TimesFile { path: PathBuf, source: io::Error },
    #[error("--times {path}, line {line}: `{value}` is not a number; write one time on each line", path = path.display())]
    TimesLine { path: PathBuf, line: usize, value: String },
    #[error("--times {path}, line {line}: {time} is below {before} on the line before; times must rise", path = path.display())]
    TimesFall { path: PathBuf, line: usize, time: f64, before: f64 },
    #[error("--times {path} holds no time; write one on each line", path = path.display())]
    NoTimes { path: PathBuf },
    #[error("--data - and --json both want stdout; give --data FILE.csv")]
    TwoOnStdout,
}

impl CommandError for OrbitInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// Why samples are missing.
#[derive(Debug, Error)]
pub enum OrbitFailure {
    #[error("the motion could not be computed")]
    Follow(#[from] MotionError),
    #[error("{done} of {wanted} samples were computed")]
    Motion { done: usize, wanted: usize, source: StepError },
    #[error("interrupted: {done} of {wanted} samples were computed; no file was written")]
    Interrupted { done: usize, wanted: usize },
}

impl CommandError for OrbitFailure {}
