//! What an answer must be worth.

use std::ffi::OsStr;

use clap::builder::{EnumValueParser, PossibleValue, TypedValueParser};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, Command, Error, ValueEnum};
use schema::Accuracy;

/// What the answer must be worth, as it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum AccuracyArgument {
    /// Never undecided: f64 where its error bounds suffice, exact arithmetic elsewhere
    Exact,
    /// f64 with error bounds alone; may say undecided
    Fast,
}

impl AccuracyArgument {
    /// The level.
    pub fn level(self) -> Accuracy {
        match self {
            Self::Exact => Accuracy::Exact,
            Self::Fast => Accuracy::Fast,
        }
    }

    /// Reads a level; the words of version 1 name their successors.
    pub fn parser() -> impl TypedValueParser<Value = Self> {
        AccuracyParser
    }
}

/// What became of the words of version 1.
const SUCCESSORS: [(&str, &str); 3] = [
    ("draft", "there are no coarser answers any more: leave it out for `exact`, or give `fast`"),
    ("standard", "leave it out for `exact`, which is never undecided, or give `fast` for f64 alone"),
    ("certified", "answers are `exact` by default; `bifdiag atlas --certificate` adds the certificate"),
];

#[derive(Clone)]
struct AccuracyParser;

impl TypedValueParser for AccuracyParser {
    type Value = AccuracyArgument;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<Self::Value, Error> {
        let parsed = EnumValueParser::new().parse_ref(command, arg, value);
        let successor = SUCCESSORS.into_iter().find(|(word, _)| value == *word);
        let Some((word, successor)) = successor else { return parsed };
        let mut error = Error::new(ErrorKind::InvalidValue).with_cmd(command);
        let option = arg.map_or_else(|| "--accuracy".to_owned(), ToString::to_string);
        let levels = ["exact", "fast"].map(str::to_owned).to_vec();
        error.insert(ContextKind::InvalidArg, ContextValue::String(option));
        error.insert(ContextKind::InvalidValue, ContextValue::String(word.to_owned()));
        error.insert(ContextKind::ValidValue, ContextValue::Strings(levels));
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![successor.into()]));
        Err(error)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let values = AccuracyArgument::value_variants().iter().filter_map(ValueEnum::to_possible_value);
        Some(Box::new(values.collect::<Vec<_>>().into_iter()))
    }
}
