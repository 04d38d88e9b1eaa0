//! What the options ask for.

use std::path::{Path, PathBuf};

use bifdiag_body::Number;
use bifdiag_schema::Accuracy;

use super::arguments::ClassifyArguments;
use super::grid::{GridError, GridFormat};
use crate::cli::batch::BatchInput;
use crate::cli::failure::Failure;
use crate::cli::input::values::Grid;
use bifdiag_documents::Subject;

pub enum Settings<'a> {
    Point { subject: Subject, h: &'a Number, l: &'a Number, accuracy: Accuracy, regions: bool, json: bool },
    Grid { subject: Subject, grid: &'a Grid, accuracy: Accuracy, out: (GridFormat, PathBuf) },
    Batch { path: &'a Path, strict: bool, subject: Option<Subject>, accuracy: Accuracy, regions: bool },
}

impl<'a> Settings<'a> {
    pub fn new(arguments: &'a ClassifyArguments) -> Result<Self, Failure> {
        let (accuracy, regions) = (arguments.accuracy, !arguments.no_region);
        let (h, l) = (arguments.energy.as_ref(), arguments.momentum.as_ref());
        if let Some(grid) = &arguments.grid {
            let replaced = [("--h", h.is_some()), ("--l", l.is_some()), ("--batch", arguments.batch.batch.is_some())];
            if let Some((option, _)) = replaced.into_iter().find(|(_, given)| *given) {
                return Err(GridError::Both(option).into());
            }
            let out = GridFormat::of(arguments.out.as_deref())?;
            return Ok(Self::Grid { subject: arguments.body.subject()?, grid, accuracy, out });
        }
        if arguments.out.is_some() {
            return Err(GridError::OutAlone.into());
        }
        if let Some(path) = arguments.batch.path(&[("--h", h.is_some()), ("--l", l.is_some())])? {
            let subject = arguments.body.optional_subject()?;
            return Ok(Self::Batch { path, strict: arguments.batch.strict, subject, accuracy, regions });
        }
        let subject = arguments.body.subject()?;
        let h = h.ok_or(BatchInput::NoPoint { missing: "--h", example: "the energy, such as --h 3.8" })?;
        let l = l.ok_or(BatchInput::NoPoint { missing: "--l", example: "the momentum, such as --l 3.25" })?;
        Ok(Self::Point { subject, h, l, accuracy, regions, json: arguments.json })
    }
}
