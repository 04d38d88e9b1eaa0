//! What can go wrong, and the exit status that it means.

use std::error::Error;
use std::fmt::{self, Display};
use std::io;

/// What the end of a run means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// All that was wanted is done.
    Done = 0,
    /// Something else than the input is wrong.
    Failed = 1,
    /// The input is wrong; the message names the argument, the value and what would be right.
    WrongInput = 2,
}

/// Why a command ended early: its exit status, its message, and the error that caused it.
#[derive(Debug)]
pub struct Failure {
    exit: Exit,
    message: String,
    cause: Option<Box<dyn Error + Send + Sync>>,
}

impl Failure {
    /// The input is wrong.
    pub fn input(message: impl Display) -> Self {
        Self { exit: Exit::WrongInput, message: message.to_string(), cause: None }
    }

    /// Something else than the input is wrong.
    pub fn work(message: impl Display) -> Self {
        Self { exit: Exit::Failed, ..Self::input(message) }
    }

    /// The reader of standard output has gone: no failure of ours, and nobody wants a message.
    pub fn closed_pipe() -> Self {
        Self { exit: Exit::Done, ..Self::input("the reader of standard output has gone") }
    }

    /// With the error that caused it.
    pub fn because(self, cause: impl Error + Send + Sync + 'static) -> Self {
        Self { cause: Some(Box::new(cause)), ..self }
    }

    /// What it means.
    pub fn exit(&self) -> Exit {
        self.exit
    }
}

/// Turns an error into the cause of a failure with this message, for `map_err`.
pub fn failed<E: Error + Send + Sync + 'static>(message: impl Display) -> impl FnOnce(E) -> Failure {
    move |cause| Failure::work(message).because(cause)
}

/// An option that another one needs.
pub fn incomplete(given: &str, missing: &str, example: &str) -> Failure {
    Failure::input(format!("{missing} is missing: {given} also needs it, such as {example}"))
}

/// A curve that the body does not have; `all` are those of its steady rotations.
pub fn no_such_curve(option: &str, given: &str, all: impl IntoIterator<Item = impl Display>) -> Failure {
    let all: Vec<String> = all.into_iter().map(|name| name.to_string()).collect();
    let all = all.join(", ");
    Failure::input(format!("{option} {given}: the body has no such curve of steady rotations; it has {all}"))
}

/// The message, followed by the causes that it does not already name.
impl Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut message = self.message.clone();
        let mut source = self.source();
        while let Some(cause) = source {
            let text = cause.to_string();
            if !message.contains(&text) {
                message = format!("{message}: {text}");
            }
            source = cause.source();
        }
        formatter.write_str(&message)
    }
}

impl Error for Failure {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        self.cause.as_deref().map(|cause| cause as _)
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        Self::work("the answer could not be written as JSON").because(error)
    }
}

impl From<bifdiag_plot::PlotError> for Failure {
    fn from(error: bifdiag_plot::PlotError) -> Self {
        Self::work("the picture could not be drawn").because(error)
    }
}

impl From<zip::result::ZipError> for Failure {
    fn from(error: zip::result::ZipError) -> Self {
        Self::work("the archive of arrays could not be made").because(error)
    }
}

impl From<csv::Error> for Failure {
    fn from(error: csv::Error) -> Self {
        Self::work("the table could not be written as CSV").because(error)
    }
}

#[cfg(feature = "parquet")]
impl From<parquet::errors::ParquetError> for Failure {
    fn from(error: parquet::errors::ParquetError) -> Self {
        Self::work("the table could not be written as Parquet").because(error)
    }
}

/// For writers that know input and output alone.
impl From<Failure> for io::Error {
    fn from(failure: Failure) -> Self {
        Self::other(failure)
    }
}
