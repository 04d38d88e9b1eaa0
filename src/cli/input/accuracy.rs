//! What an answer must be worth.

use std::ffi::OsStr;

use bifdiag_schema::Accuracy;
use clap::builder::{PossibleValue, TypedValueParser};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, Error};

use super::values::{Named, named};

/// What the answer must be worth, as it is written.
const LEVELS: [Named<Accuracy>; 2] = [
    ("exact", "Never undecided: f64 where its error bounds suffice, exact arithmetic elsewhere", Accuracy::Exact),
    ("fast", "f64 with error bounds alone; may say undecided", Accuracy::Fast),
];

/// What became of the words of version 1.
const SUCCESSORS: [(&str, &str); 3] = [
    ("draft", "there are no coarser answers any more: leave it out for `exact`, or give `fast`"),
    ("standard", "leave it out for `exact`, which is never undecided, or give `fast` for f64 alone"),
    ("certified", "answers are `exact` by default; `bifdiag atlas --certificate` adds the certificate"),
];

/// Reads a level; the words of version 1 name their successors.
pub fn accuracy() -> impl TypedValueParser<Value = Accuracy> {
    AccuracyParser
}

#[derive(Clone)]
struct AccuracyParser;

impl TypedValueParser for AccuracyParser {
    type Value = Accuracy;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<Self::Value, Error> {
        let successor = SUCCESSORS.into_iter().find(|(word, _)| value == *word);
        let Some((word, successor)) = successor else { return named(&LEVELS).parse_ref(command, arg, value) };
        let mut error = Error::new(ErrorKind::InvalidValue).with_cmd(command);
        let option = arg.map_or_else(|| "--accuracy".to_owned(), ToString::to_string);
        let levels = LEVELS.map(|(word, ..)| word.to_owned()).to_vec();
        error.insert(ContextKind::InvalidArg, ContextValue::String(option));
        error.insert(ContextKind::InvalidValue, ContextValue::String(word.to_owned()));
        error.insert(ContextKind::ValidValue, ContextValue::Strings(levels));
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![successor.into()]));
        Err(error)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let levels: Vec<_> = named(&LEVELS).possible_values()?.collect();
        Some(Box::new(levels.into_iter()))
    }
}
