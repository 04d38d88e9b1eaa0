//! What the options ask for.

use std::path::Path;

use bifdiag_body::Number;

use super::arguments::{CriticalArguments, Method};
use super::error::RangeInput;
use super::momenta::Momenta;
use crate::cli::batch::BatchInput;
use crate::cli::export::DataTarget;
use crate::cli::failure::Failure;
use bifdiag_documents::Subject;

pub enum Settings<'a> {
    Momentum { subject: Subject, l: &'a Number, method: Method, json: bool },
    Momenta { subject: Subject, ends: [&'a Number; 2], count: u32, target: DataTarget },
    Batch { path: &'a Path, strict: bool, subject: Option<Subject> },
}

impl<'a> Settings<'a> {
    pub fn new(arguments: &'a CriticalArguments) -> Result<Self, Failure> {
        let l = arguments.momentum.as_ref();
        let method = arguments.method;
        if method == Method::Newton && (!matches!(l, None | Some(Momenta::One(_))) || arguments.batch.batch.is_some()) {
            return Err(RangeInput::NewtonOfMany.into());
        }
        if let Some(path) = arguments.batch.path(&[("--l", l.is_some()), ("--out", arguments.out.is_some())])? {
            let subject = arguments.body.optional_subject()?;
            return Ok(Self::Batch { path, strict: arguments.batch.strict, subject });
        }
        let subject = arguments.body.subject()?;
        let l = l.ok_or(BatchInput::NoPoint { missing: "--l", example: "the momentum, such as --l 3.25" })?;
        match l {
            Momenta::One(_) if arguments.out.is_some() => Err(RangeInput::OutWithoutRange.into()),
            Momenta::One(l) => Ok(Self::Momentum { subject, l, method, json: arguments.json }),
            Momenta::Range { .. } if arguments.json => Err(RangeInput::JsonOfRange.into()),
            Momenta::Range { from, to, count } => {
                let target = arguments.out.clone().unwrap_or(DataTarget::Stdout);
                Ok(Self::Momenta { subject, ends: [from, to], count: *count, target })
            }
        }
    }
}
