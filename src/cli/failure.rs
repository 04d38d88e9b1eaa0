//! What can go wrong, and the exit status that it means.

use std::error::Error;
use std::fmt;

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

/// An error of a command or of a part of it.
pub trait CommandError: Error + Send + Sync + 'static {
    /// What it means.
    fn exit(&self) -> Exit {
        Exit::Failed
    }
}

/// Any error of a command.
#[derive(Debug)]
pub struct Failure(Box<dyn CommandError>);

impl<E: CommandError> From<E> for Failure {
    fn from(error: E) -> Self {
        Self(Box::new(error))
    }
}

impl Failure {
    /// What it means.
    pub fn exit(&self) -> Exit {
        self.0.exit()
    }
}

/// The error with its causes, as far as it does not name them itself.
impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut message = self.0.to_string();
        let mut source = self.0.source();
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
