//! What can go wrong about a section.

use std::io;
use std::path::PathBuf;

use bifdiag_diagram::fast::FastError;
use bifdiag_documents::reading::ReadError;
use bifdiag_dynamics::poincare::PoincareError;
use bifdiag_equilibria::curves::MomentumError;
use bifdiag_schema::SCHEMA_VERSION;
use thiserror::Error;

use crate::cli::failure::{CommandError, Exit};
use crate::cli::input::BodyInput;

/// Why there is no section.
#[derive(Debug, Error)]
pub enum SectionFailure {
    #[error(transparent)]
    Input(#[from] SectionInput),
    #[error("the section could not be computed")]
    Poincare(#[source] PoincareError),
    #[error("interrupted: {finished} of {wanted} orbits are complete; no file was written")]
    Interrupted { finished: usize, wanted: usize },
    #[error(
        "interrupted: {finished} of {wanted} orbits are complete; {journal} holds what was found, and the same command goes on \
         from there",
        journal = journal.display()
    )]
    Halted { finished: usize, wanted: usize, journal: PathBuf },
    #[error("cannot use {path}: {source}", path = path.display())]
    Journal { path: PathBuf, source: io::Error },
}

impl From<PoincareError> for SectionFailure {
    fn from(error: PoincareError) -> Self {
        match error {
            PoincareError::Classify(FastError::Momentum(error)) => SectionInput::Momentum(error).into(),
            PoincareError::WeightlessBody
            | PoincareError::Forbidden { .. }
            | PoincareError::OnCurve { .. }
            | PoincareError::Undecided { .. } => SectionInput::NoSection(error).into(),
            error => Self::Poincare(error),
        }
    }
}

impl CommandError for SectionFailure {
    fn exit(&self) -> Exit {
        match self {
            Self::Input(_) => Exit::WrongInput,
            Self::Poincare(_) | Self::Interrupted { .. } | Self::Halted { .. } | Self::Journal { .. } => Exit::Failed,
        }
    }
}

impl CommandError for SectionInput {
    fn exit(&self) -> Exit {
        Exit::WrongInput
    }
}

/// Wrong input: each message names the argument, the value and what would be right.
#[derive(Debug, Error)]
pub enum SectionInput {
    #[error(transparent)]
    Body(#[from] BodyInput),
    #[error("--l: {0}")]
    Momentum(MomentumError),
    #[error("{0}")]
    NoSection(PoincareError),
    #[error("{missing} is missing; give {example}, or --region R4 for the sample of a region")]
    NoPoint { missing: &'static str, example: &'static str },
    #[error("--atlas and {option} both say what to integrate; leave out {option}, or leave out --atlas")]
    AtlasAnd { option: &'static str },
    #[error("--region and {option} both say where; leave out one of them")]
    RegionAnd { option: &'static str },
    #[error(transparent)]
    NoAtlas(bifdiag_exact::AnswerError),
    #[error("--atlas {path}: {source}; give an atlas.json that can be read, or - for stdin", path = path.display())]
    AtlasFile { path: PathBuf, source: io::Error },
    #[error("--atlas {path} is no atlas of version {SCHEMA_VERSION} (bifdiag atlas --json writes one): {source}", path = path.display())]
    NotAnAtlas { path: PathBuf, source: ReadError },
    #[error("--atlas {path}: its body is not one: {source}", path = path.display())]
    AtlasBody { path: PathBuf, source: bifdiag_body::BodyError },
    #[error("--atlas {path}: {source}", path = path.display())]
    AtlasRegion { path: PathBuf, source: bifdiag_diagram::arrangement::ParseRegionIdError },
    #[error("--region {region}: the body has no such region; {}", listed(known))]
    UnknownRegion { region: String, known: Vec<String> },
    #[error("--{given} cannot be used with --starts: the file says where the orbits start; leave out one of them")]
    SpreadWithSeeds { given: &'static str },
    #[error(
        "--verdict {verdict} and --color {color} contradict each other: what the colour tells is not measured then; leave out one of them"
    )]
    ColorWithoutMeasure { verdict: &'static str, color: &'static str },
    #[error("--starts {path}: {source}; give a file that can be read, or - for stdin", path = path.display())]
    SeedsFile { path: PathBuf, source: io::Error },
    #[error("--starts {path}, line {line}: {problem}", path = path.display())]
    SeedLine { path: PathBuf, line: usize, problem: SeedProblem },
    #[error("--starts {path} holds no start; write the heading theta,psi,sheet and one start on each line", path = path.display())]
    NoSeeds { path: PathBuf },
    #[error("{journal} is in use by another process; wait for it, or write to another place", journal = journal.display())]
    Busy { journal: PathBuf },
    #[error("--data: {journal} holds the beginning of another section; finish that, take the file away, or give another FILE", journal = journal.display())]
    OtherJournal { journal: PathBuf },
    #[error("--data - and --json both want stdout; give --data FILE.npz")]
    TwoOnStdout,
    #[error("--data -: several sections do not fit one table; give --data FILE.npz, or one --region")]
    ManyOnStdout,
}

/// What is wrong with a line of a file of starts.
#[derive(Debug, Error)]
pub enum SeedProblem {
    #[error("the heading `{0}` lacks {1}; write theta,psi,sheet")]
    Heading(String, &'static str),
    #[error("{found} values, but the heading has {wanted}")]
    Count { found: usize, wanted: usize },
    #[error("{name} = `{value}` is not a number; give an angle in radians, such as 1.57 or pi/2")]
    NotAnAngle { name: &'static str, value: String },
    #[error("theta = {value} is not between 0 and pi; it is the angle between gamma and r")]
    Theta { value: String },
    #[error("sheet = `{value}` is neither 1 (T+) nor -1 (T-)")]
    Sheet { value: String },
    #[error("the point is not accessible: U = {potential} there, above h = {h}")]
    Inaccessible { potential: f64, h: f64 },
}

fn listed(known: &[String]) -> String {
    if known.is_empty() { "there is none".to_owned() } else { format!("it has {}, or give all", known.join(", ")) }
}
