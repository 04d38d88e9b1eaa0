//! What the options ask for.

use std::path::Path;

use top::body::Number;

use super::arguments::CriticalArguments;
use crate::cli::batch::BatchInput;
use crate::cli::failure::Failure;
use crate::cli::input::Subject;

pub enum Settings<'a> {
    Momentum { subject: Subject, l: &'a Number, json: bool },
    Batch { path: &'a Path, strict: bool, subject: Option<Subject> },
}

impl<'a> Settings<'a> {
    pub fn new(arguments: &'a CriticalArguments) -> Result<Self, Failure> {
        let l = arguments.momentum.as_ref();
        if let Some(path) = arguments.batch.path(&[("--l", l.is_some())])? {
            let subject = arguments.body.optional_subject()?;
            return Ok(Self::Batch { path, strict: arguments.batch.strict, subject });
        }
        let subject = arguments.body.subject()?;
        let l = l.ok_or(BatchInput::NoPoint { missing: "--l", example: "the momentum, such as --l 3.25" })?;
        Ok(Self::Momentum { subject, l, json: arguments.json })
    }
}
