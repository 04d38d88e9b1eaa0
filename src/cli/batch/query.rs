//! One line of a batch.

use schema::InertiaDocument;
use serde::Deserialize;
use serde_json::value::RawValue;
use thiserror::Error;
use top::body::{Body, BodyError, Number, ParseNumberError};

use super::lines::MAX_LINE;
use crate::cli::input::Subject;

/// What a line must say besides the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// h and l.
    Point,
    /// l.
    Momentum,
}

/// What a line asks.
#[derive(Clone, Debug)]
pub struct Query {
    pub body: Body,
    pub inertia: Option<InertiaDocument>,
    /// There if [`Wanted::Point`].
    pub h: Option<Number>,
    pub l: Number,
    /// The line's own body violates the triangle inequality; of the command line's the user has been told.
    pub unphysical: bool,
}

/// Why a line is wrong.
#[derive(Debug, Error)]
pub enum QueryError {
    #[error("the line is empty; write {{\"A\": [A1, A2, A3], \"r\": [r1, r2, r3], …}}")]
    Empty,
    #[error("the line is longer than {MAX_LINE} bytes; write one point on each line")]
    TooLong,
    #[error("the line is not UTF-8 from byte {at} on")]
    NotUtf8 { at: usize },
    #[error("the line is not a JSON object; write {{\"A\": [A1, A2, A3], \"r\": [r1, r2, r3], …}}")]
    NotAnObject,
    #[error("the line is not valid JSON: {what} (column {column})")]
    Json { what: String, column: usize },
    #[error("{key} is missing; add {example}")]
    Missing { key: &'static str, example: &'static str },
    #[error("{key}: {value} is not a list of three numbers; write it as {example}")]
    NotAList { key: &'static str, value: String, example: &'static str },
    #[error("{key}: {value} is not a number; write a number, or a string such as \"11/10\"")]
    NotANumber { key: String, value: String },
    #[error("{key}: {source}")]
    Number { key: String, source: ParseNumberError },
    #[error(transparent)]
    Body(#[from] BodyError),
}

/// The values keep their text: a number of JSON is the decimal that is written, never its nearest double.
#[derive(Deserialize)]
struct RawQuery<'a> {
    #[serde(borrow, rename = "A")]
    moments: Option<&'a RawValue>,
    #[serde(borrow, rename = "r")]
    center: Option<&'a RawValue>,
    #[serde(borrow)]
    h: Option<&'a RawValue>,
    #[serde(borrow)]
    l: Option<&'a RawValue>,
}

const MOMENTS: (&str, &str) = ("A", "\"A\": [2, 1.1, 1]");
const CENTER: (&str, &str) = ("r", "\"r\": [0.94868, 0, 0.61623]");
const ENERGY: (&str, &str) = ("h", "\"h\": 3.8");
const MOMENTUM: (&str, &str) = ("l", "\"l\": 3.25");

impl Query {
    /// Reads a line; `subject` is the body of lines that name none.
    pub fn parse(line: &[u8], wanted: Wanted, subject: Option<&Subject>) -> Result<Self, QueryError> {
        if line.len() > MAX_LINE {
            return Err(QueryError::TooLong);
        }
        let text = std::str::from_utf8(line).map_err(|error| QueryError::NotUtf8 { at: error.valid_up_to() + 1 })?;
        // Some editors put a byte order mark at the start of a file.
        let text = text.trim_start_matches('\u{feff}').trim();
        if text.is_empty() {
            return Err(QueryError::Empty);
        }
        if !text.starts_with('{') {
            return Err(QueryError::NotAnObject);
        }
        let raw: RawQuery = serde_json::from_str(text).map_err(|error| json_error(&error))?;
        let (body, inertia, unphysical) = match (raw.moments, raw.center, subject) {
            (None, None, Some(subject)) => (subject.body.clone(), subject.inertia.clone(), false),
            (moments, center, _) => {
                let moments = list(MOMENTS, moments)?;
                let body = Body::parse(&moments, &list(CENTER, center)?)?;
                let unphysical = body.flags().unphysical;
                (body, None, unphysical)
            }
        };
        let h = match wanted {
            Wanted::Point => Some(number(ENERGY, raw.h)?),
            Wanted::Momentum => None,
        };
        let l = number(MOMENTUM, raw.l)?;
        Ok(Self { body, inertia, h, l, unphysical })
    }
}

fn json_error(error: &serde_json::Error) -> QueryError {
    let message = error.to_string();
    let what = message.rsplit_once(" at line ").map_or(message.as_str(), |(what, _)| what).to_owned();
    QueryError::Json { what, column: error.column() }
}

fn list((key, example): (&'static str, &'static str), raw: Option<&RawValue>) -> Result<Vec<String>, QueryError> {
    let raw = raw.ok_or(QueryError::Missing { key, example })?;
    let items: Vec<&RawValue> = serde_json::from_str(raw.get()).map_err(|_not_a_list| QueryError::NotAList {
        key,
        value: shortened(raw.get()),
        example,
    })?;
    items.iter().enumerate().map(|(i, item)| number_text(&format!("{key}{}", i + 1), item)).collect()
}

fn number((key, example): (&'static str, &'static str), raw: Option<&RawValue>) -> Result<Number, QueryError> {
    let raw = raw.ok_or(QueryError::Missing { key, example })?;
    number_text(key, raw)?.parse().map_err(|source| QueryError::Number { key: key.to_owned(), source })
}

/// The text of a number, or of the string that denotes one.
fn number_text(key: &str, raw: &RawValue) -> Result<String, QueryError> {
    let not_a_number = || QueryError::NotANumber { key: key.to_owned(), value: shortened(raw.get()) };
    match raw.get().as_bytes().first() {
        Some(b'"') => serde_json::from_str(raw.get()).map_err(|_bad_escape| not_a_number()),
        Some(b'-' | b'0'..=b'9') => Ok(raw.get().to_owned()),
        _ => Err(not_a_number()),
    }
}

fn shortened(text: &str) -> String {
    const SHOWN: usize = 40;
    if text.chars().count() <= SHOWN {
        text.to_owned()
    } else {
        text.chars().take(SHOWN).chain("…".chars()).collect()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn parse(line: &str) -> Result<Query, QueryError> {
        Query::parse(line.as_bytes(), Wanted::Point, None)
    }

    #[test]
    fn numbers_are_the_decimals_that_are_written() {
        let query =
            parse(r#"{"A": [2, 1.10, "11/10"], "r": [-1e-3, 0, 0], "h": 0.1000000000000000055, "l": 3}"#).unwrap();
        let texts = query.body.moments().each_ref().map(Number::text);
        assert_eq!(texts, ["2", "1.10", "11/10"]);
        assert_eq!(query.body.moments()[1], query.body.moments()[2]);
        assert_eq!(query.h.as_ref().map(Number::text), Some("0.1000000000000000055"));
        assert_ne!(query.h, Some("0.1".parse().unwrap()));
    }

    #[test]
    fn other_keys_are_ignored_and_a_byte_order_mark_too() {
        assert!(parse("\u{feff}{\"A\":[1,1,1],\"r\":[0,0,1],\"h\":1,\"l\":1,\"kind\":{\"x\":[[]]}}\r").is_ok());
    }

    #[test]
    fn a_line_without_a_body_takes_that_of_the_command_line() {
        let body = Body::parse(&["3", "2", "1"], &["0", "0", "1"]).unwrap();
        let subject = Subject { body: body.clone(), inertia: None };
        let line = br#"{"l": 1}"#;
        let query = Query::parse(line, Wanted::Momentum, Some(&subject)).unwrap();
        assert_eq!(query.body, body);
        let half = br#"{"A": [1, 1, 1], "l": 1}"#;
        let error = Query::parse(half, Wanted::Momentum, Some(&subject)).unwrap_err();
        assert!(matches!(error, QueryError::Missing { key: "r", .. }));
    }

    proptest! {
        /// Whatever a line holds, it is read or refused with a message; none of it stops the program.
        #[test]
        fn any_bytes_are_read_or_refused(line in prop::collection::vec(any::<u8>(), 0..200)) {
            if let Err(error) = Query::parse(&line, Wanted::Point, None) {
                prop_assert!(!error.to_string().is_empty());
            }
        }

        #[test]
        fn any_values_in_place_of_numbers_are_read_or_refused(
            a in r#"[-+0-9.eE/"\[\]{}nulxtr\\]{0,12}"#,
            h in r#"[-+0-9.eE/"\[\]{}nulxtr\\]{0,12}"#,
        ) {
            let line = format!(r#"{{"A":[{a},1,1],"r":[1,0,0],"h":{h},"l":"{h}"}}"#);
            match parse(&line) {
                Ok(query) => prop_assert!(query.body.moments_f64().iter().all(|a| *a > 0.0)),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }

        /// A decimal of any length keeps its text and its value.
        #[test]
        fn long_decimals_are_not_rounded(digits in "[1-9][0-9]{20,60}") {
            let query = parse(&format!(r#"{{"A":[1.{digits},1,1],"r":[1,0,0],"h":0.{digits},"l":1}}"#)).unwrap();
            let exact: Number = format!("{digits}/1{}", "0".repeat(digits.len())).parse().unwrap();
            prop_assert_eq!(query.h, Some(exact));
            prop_assert_eq!(query.body.moments()[0].text(), format!("1.{digits}"));
        }
    }
}
