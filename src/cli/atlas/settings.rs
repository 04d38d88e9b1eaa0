//! What the options ask for.

use std::path::PathBuf;

use schema::{Accuracy, WindowDocument};

use super::arguments::AtlasArguments;
use crate::cli::export::{PictureFormat, directory};
use crate::cli::failure::Failure;
use crate::cli::input::Subject;

pub struct Settings {
    pub subject: Subject,
    pub accuracy: Accuracy,
    pub window: Option<WindowDocument>,
    /// Where the files go, if any are wanted.
    pub directory: Option<PathBuf>,
    /// Of the diagram.
    pub formats: Vec<PictureFormat>,
    pub json: bool,
}

impl Settings {
    pub fn new(arguments: &AtlasArguments) -> Result<Self, Failure> {
        Ok(Self {
            subject: arguments.body.subject()?,
            accuracy: arguments.accuracy.level(),
            window: arguments.window,
            directory: directory(arguments.out.as_deref(), !arguments.json)?,
            formats: if arguments.no_plot { Vec::new() } else { arguments.format.clone() },
            json: arguments.json,
        })
    }
}
