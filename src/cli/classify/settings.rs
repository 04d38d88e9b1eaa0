//! What the options ask for.

use std::path::Path;

use schema::Accuracy;
use top::body::Number;

use super::arguments::ClassifyArguments;
use crate::cli::batch::BatchInput;
use crate::cli::failure::Failure;
use crate::cli::input::Subject;

pub enum Settings<'a> {
    Point { subject: Subject, h: &'a Number, l: &'a Number, accuracy: Accuracy, json: bool },
    Batch { path: &'a Path, strict: bool, subject: Option<Subject>, accuracy: Accuracy },
}

impl<'a> Settings<'a> {
    pub fn new(arguments: &'a ClassifyArguments) -> Result<Self, Failure> {
        let accuracy = arguments.accuracy.level();
        let (h, l) = (arguments.energy.as_ref(), arguments.momentum.as_ref());
        if let Some(path) = arguments.batch.path(&[("--h", h.is_some()), ("--l", l.is_some())])? {
            let subject = arguments.body.optional_subject()?;
            return Ok(Self::Batch { path, strict: arguments.batch.strict, subject, accuracy });
        }
        let subject = arguments.body.subject()?;
        let h = h.ok_or(BatchInput::NoPoint { missing: "--h", example: "the energy, such as --h 3.8" })?;
        let l = l.ok_or(BatchInput::NoPoint { missing: "--l", example: "the momentum, such as --l 3.25" })?;
        Ok(Self::Point { subject, h, l, accuracy, json: arguments.json })
    }
}
