//! What can go wrong, and the exit status that it means.

use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;

use dynamics::integrator::{MethodError, StepError};
use dynamics::motion::MotionError;
use dynamics::poincare::PoincareError;
use dynamics::section::SectionError;
use plot::PlotError;
use thiserror::Error;
use top::atlas::AtlasError;
use top::atlas::MomentumError;
use top::body::InertiaError;
use top::classify::ClassifyError;
use top::critical::CriticalError;

use super::files::FilesError;
use super::orbit::OrbitInputError;
use super::output::OutputError;
use super::scan::{ScanFailure, ScanInput};
use super::section::SectionInputError;

/// The input is wrong; each message names the argument, the value and what would be right.
#[derive(Debug, Error)]
pub enum InputError {
    #[error("no body is given; use --A 2,1.1,1 --r 0.94868,0,0.61623, a named body such as --body paper, or --inertia")]
    NoBody,
    #[error("--A is missing: --r also needs the principal moments, such as --A 2,1.1,1")]
    NoMoments,
    #[error("--r is missing: --A also needs the centre of mass, such as --r 0.94868,0,0.61623")]
    NoCenter,
    #[error("{first} and {second} both describe the body; give one of --A with --r, --body, --inertia")]
    TwoBodies { first: &'static str, second: &'static str },
    #[error("{missing} is missing: {given} also needs it, such as {example}")]
    PartIncomplete { given: &'static str, missing: &'static str, example: &'static str },
    #[error("--inertia {value}: {source}")]
    Inertia { value: String, source: InertiaError },
    #[error("{missing} is missing; give {example}, or --batch FILE for many points")]
    NoPoint { missing: &'static str, example: &'static str },
    #[error("{option} cannot be used with --batch: the lines of the batch say it; leave out {option} or --batch")]
    PointWithBatch { option: &'static str },
    #[error("--strict needs --batch: it says what a wrong line of a batch means; add --batch FILE or leave it out")]
    StrictWithoutBatch,
    #[error("--batch {path}: {source}; give a file that can be read, or - for stdin", path = path.display())]
    BatchFile { path: PathBuf, source: io::Error },
    #[error("--strict: {bad} of {lines} lines of the batch are wrong; see the lines with \"error\"")]
    BadLines { bad: usize, lines: usize },
    #[error("{path}: {source}; give an atlas.json that can be read, or - for stdin", path = path.display())]
    AtlasFile { path: PathBuf, source: io::Error },
    #[error("{path} is no atlas: {source}; give an atlas.json that bifdiag has written", path = path.display())]
    NoAtlas { path: PathBuf, source: serde_json::Error },
    #[error("{option} stands before the command {command}; write it after: bifdiag {command} {option} …")]
    OptionBeforeCommand { option: String, command: String },
    #[error("--l: {0}")]
    Momentum(MomentumError),
    #[error("{option} has no value ({next} follows it); write it as {option} {value}, or {option}=VALUE")]
    ValueMissing { option: String, next: String, value: String },
    #[error("--format pdf: {0}")]
    Format(PlotError),
    #[error("--out -: a directory is needed; leave --out away and use --json to write the atlas to stdout")]
    OutIsStdout,
    #[error(transparent)]
    Scan(#[from] ScanInput),
    #[error("--{name} {value} is not usable; {expected}", name = .0.name, value = .0.value, expected = .0.expected)]
    Fineness(MethodError),
    #[error("{option} is for {owners}; {integrator} takes {instead}")]
    WrongFineness { option: &'static str, owners: &'static str, integrator: String, instead: &'static str },
    #[error(transparent)]
    Section(#[from] SectionInputError),
    #[error(transparent)]
    Orbit(#[from] OrbitInputError),
}

/// Why a run stopped.
#[derive(Debug, Error)]
pub enum Failure {
    #[error(transparent)]
    Input(#[from] InputError),
    #[error(transparent)]
    Output(#[from] OutputError),
    #[error(transparent)]
    Files(#[from] FilesError),
    #[error("the atlas could not be made")]
    Atlas(#[from] AtlasError),
    #[error("the atlas could not be proved")]
    NotProved(#[from] proof::NotProved),
    #[error("the proved atlas could not be written")]
    NotWritten(#[from] proof::NotWritten),
    #[error("{path} is refused: its bytes are not those that bifdiag writes for a certified atlas", path = path.display())]
    Damaged { path: PathBuf },
    #[error("the atlas is refused")]
    Refused(#[from] verify::Refused),
    #[error("the point could not be classified")]
    Classify(#[source] ClassifyError),
    #[error("the relative equilibria could not be found")]
    Critical(#[from] CriticalError),
    #[error("the sections of a figure could not be computed")]
    FigureSection(#[from] SectionError),
    #[error("the picture could not be drawn")]
    Plot(#[from] PlotError),
    #[error("the answer could not be written as JSON")]
    Json(#[from] serde_json::Error),
    #[error("--batch {path}: reading stopped", path = path.display())]
    BatchRead { path: PathBuf, source: io::Error },
    #[error("the threads could not be started")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("the answer to interrupts could not be set up")]
    Interrupt(#[from] ctrlc::Error),
    #[error(transparent)]
    Scan(#[from] ScanFailure),
    #[error("{name} cannot be made")]
    Page { name: String, source: io::Error },
    #[error("the section could not be computed")]
    Poincare(#[source] PoincareError),
    #[error("the archive of arrays could not be made")]
    Archive(#[from] zip::result::ZipError),
    #[error(
        "interrupted: {finished} of {wanted} orbits are complete; what was finished is kept and marked as incomplete"
    )]
    Interrupted { finished: usize, wanted: usize },
    #[error("the motion could not be computed")]
    Follow(#[from] MotionError),
    #[error("{done} of {wanted} samples were computed")]
    Motion { done: usize, wanted: usize, source: StepError },
    #[error("interrupted: {done} of {wanted} samples were computed; they are kept and marked as incomplete")]
    MotionInterrupted { done: usize, wanted: usize },
}

impl From<PoincareError> for Failure {
    fn from(error: PoincareError) -> Self {
        match error {
            PoincareError::Classify(ClassifyError::Momentum(error)) => InputError::Momentum(error).into(),
            PoincareError::WeightlessBody
            | PoincareError::Forbidden { .. }
            | PoincareError::OnCurve { .. }
            | PoincareError::Undecided { .. } => SectionInputError::NoSection(error).into(),
            error => Self::Poincare(error),
        }
    }
}

impl From<OrbitInputError> for Failure {
    fn from(error: OrbitInputError) -> Self {
        Self::Input(error.into())
    }
}

impl From<SectionInputError> for Failure {
    fn from(error: SectionInputError) -> Self {
        Self::Input(error.into())
    }
}

impl From<ScanInput> for Failure {
    fn from(error: ScanInput) -> Self {
        InputError::from(error).into()
    }
}

impl From<ClassifyError> for Failure {
    fn from(error: ClassifyError) -> Self {
        match error {
            ClassifyError::Momentum(error) => InputError::Momentum(error).into(),
            error => Self::Classify(error),
        }
    }
}

impl Failure {
    /// Tells it on stderr. A reader that closed the pipe wants no more, and no message.
    pub fn print(&self) -> u8 {
        if matches!(self, Self::Output(OutputError::ClosedPipe)) {
            return 0;
        }
        let mut message = format!("error: {self}");
        let mut source = std::error::Error::source(self);
        while let Some(cause) = source {
            let cause_text = cause.to_string();
            if !message.contains(&cause_text) {
                message = format!("{message}: {cause_text}");
            }
            source = cause.source();
        }
        say(&message);
        if matches!(self, Self::Input(_)) { 2 } else { 1 }
    }
}

/// A command line that clap or we do not accept; also the answer to --help and --version.
#[derive(Debug)]
pub enum Refusal {
    Clap(clap::Error),
    Input(InputError),
}

impl From<clap::Error> for Refusal {
    fn from(error: clap::Error) -> Self {
        Self::Clap(error)
    }
}

impl From<InputError> for Refusal {
    fn from(error: InputError) -> Self {
        Self::Input(error)
    }
}

impl Refusal {
    /// Prints help to stdout, errors to stderr.
    pub fn print(self) -> u8 {
        let error = match self {
            Self::Clap(error) => error,
            Self::Input(error) => return Failure::from(error).print(),
        };
        let text = error.render();
        if error.use_stderr() {
            let text = if io::stderr().is_terminal() { text.ansi().to_string() } else { text.to_string() };
            say(text.trim_end());
            return 2;
        }
        let text = if io::stdout().is_terminal() { text.ansi().to_string() } else { text.to_string() };
        match super::output::print(text.as_bytes()) {
            Ok(()) => 0,
            Err(error) => Failure::from(error).print(),
        }
    }
}

/// A line on stderr; a closed stderr is no reason to stop.
pub fn say(message: &str) {
    let _closed = writeln!(io::stderr(), "{message}");
}
