//! One line of a batch.

use std::fmt;
use std::sync::Arc;

use bifdiag_body::{Body, Number};
use bifdiag_documents::Subject;
use serde::de::{Error as _, IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;

use super::lines::MAX_LINE;
use crate::cli::failure::Failure;

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
    pub subject: Arc<Subject>,
    /// There if [`Wanted::Point`].
    pub h: Option<Number>,
    pub l: Number,
    /// The line's own body does not exist; for that of the command line a warning was printed.
    pub unphysical: bool,
    /// Keys that mean nothing here.
    pub ignored: Vec<String>,
}

/// The values keep their text: a number of JSON is the decimal that is written, never its nearest double.
#[derive(Default)]
struct RawQuery<'a> {
    moments: Option<&'a RawValue>,
    center: Option<&'a RawValue>,
    h: Option<&'a RawValue>,
    l: Option<&'a RawValue>,
    /// Other keys.
    others: Vec<String>,
}

/// A key of a line.
#[derive(Deserialize)]
#[serde(field_identifier)]
enum Key {
    #[serde(rename = "A")]
    Moments,
    #[serde(rename = "r")]
    Center,
    #[serde(rename = "h")]
    Energy,
    #[serde(rename = "l")]
    Momentum,
    Other(String),
}

impl<'de> Deserialize<'de> for RawQuery<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Keys)
    }
}

/// Takes the keys of a line one by one.
struct Keys;

impl<'de> Visitor<'de> for Keys {
    type Value = RawQuery<'de>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON object")
    }

    fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<Self::Value, M::Error> {
        let mut raw = RawQuery::default();
        let mut seen = [false; 4];
        while let Some(key) = map.next_key()? {
            let (place, name, value) = match key {
                Key::Moments => (0, "A", &mut raw.moments),
                Key::Center => (1, "r", &mut raw.center),
                Key::Energy => (2, "h", &mut raw.h),
                Key::Momentum => (3, "l", &mut raw.l),
                Key::Other(name) => {
                    map.next_value::<IgnoredAny>()?;
                    raw.others.push(name);
                    continue;
                }
            };
            if std::mem::replace(&mut seen[place], true) {
                return Err(M::Error::duplicate_field(name));
            }
            *value = map.next_value()?;
        }
        Ok(raw)
    }
}

/// What a line looks like.
const SHAPE: &str = "write {\"A\": [A1, A2, A3], \"r\": [r1, r2, r3], …}";

const MOMENTS: (&str, &str) = ("A", "\"A\": [2, 1.1, 1]");
const CENTER: (&str, &str) = ("r", "\"r\": [0.94868, 0, 0.61623]");
const ENERGY: (&str, &str) = ("h", "\"h\": 3.8");
const MOMENTUM: (&str, &str) = ("l", "\"l\": 3.25");

/// Reads line after line; a body that is written as in the line before is the same.
pub struct QueryReader<'a> {
    wanted: Wanted,
    /// The body of lines that name none.
    subject: Option<&'a Arc<Subject>>,
    last: Option<LastBody>,
}

/// A body and its text.
struct LastBody {
    moments: String,
    center: String,
    subject: Arc<Subject>,
    unphysical: bool,
}

impl<'a> QueryReader<'a> {
    /// Nothing is read yet; `subject` is the body of lines that name none.
    pub fn new(wanted: Wanted, subject: Option<&'a Arc<Subject>>) -> Self {
        Self { wanted, subject, last: None }
    }

    /// Reads a line.
    pub fn read(&mut self, line: &[u8]) -> Result<Query, Failure> {
        if line.len() > MAX_LINE {
            return Err(Failure::input(format!(
                "the line is longer than {MAX_LINE} bytes; write one point on each line"
            )));
        }
        let text = std::str::from_utf8(line).map_err(|error| {
            Failure::input(format!("the line is not UTF-8 from byte {} on", error.valid_up_to() + 1))
        })?;
        // Some editors put a byte order mark at the start of a file.
        let whole = text.trim_start_matches('\u{feff}');
        let text = whole.trim();
        if text.is_empty() {
            return Err(Failure::input(format!("the line is empty; {SHAPE}")));
        }
        if !text.starts_with('{') {
            return Err(Failure::input(format!("the line is not a JSON object; {SHAPE}")));
        }
        let raw: RawQuery = serde_json::from_str(text).map_err(|error| json_error(&error, whole))?;
        let (subject, unphysical) = match (raw.moments, raw.center, self.subject) {
            (None, None, Some(subject)) => (Arc::clone(subject), false),
            (moments, center, _) => self.body(moments, center)?,
        };
        let mut ignored = raw.others;
        let h = match self.wanted {
            Wanted::Point => Some(number(ENERGY, raw.h)?),
            Wanted::Momentum if ignored.iter().any(|key| key == "spin") => {
                return Err(Failure::input(
                    "spin: a line asks about one l; for a spin use `bifdiag critical --spin \"300 rpm\"`, or leave it \
                    out",
                ));
            }
            Wanted::Momentum => {
                ignored.extend(raw.h.map(|_| ENERGY.0.to_owned()));
                None
            }
        };
        let l = number(MOMENTUM, raw.l)?;
        Ok(Query { subject, h, l, unphysical, ignored })
    }

    /// The body of a line, and whether no mass distribution has its moments.
    fn body(&mut self, moments: Option<&RawValue>, center: Option<&RawValue>) -> Result<(Arc<Subject>, bool), Failure> {
        let same = |last: &&LastBody| {
            moments.is_some_and(|raw| raw.get() == last.moments) && center.is_some_and(|raw| raw.get() == last.center)
        };
        if let Some(last) = self.last.as_ref().filter(same) {
            return Ok((Arc::clone(&last.subject), last.unphysical));
        }
        let body = Body::parse(&list(MOMENTS, moments)?, &list(CENTER, center)?).map_err(Failure::input)?;
        let unphysical = body.flags().unphysical;
        let subject = Arc::new(Subject::from(body));
        let text = |raw: Option<&RawValue>| raw.map_or_else(String::new, |raw| raw.get().to_owned());
        let (moments, center) = (text(moments), text(center));
        self.last = Some(LastBody { moments, center, subject: Arc::clone(&subject), unphysical });
        Ok((subject, unphysical))
    }
}

fn missing(key: &str, example: &str) -> Failure {
    Failure::input(format!("{key} is missing; add {example}"))
}

/// What is wrong with a line, whose blanks at the start were skipped.
fn json_error(error: &serde_json::Error, line: &str) -> Failure {
    let message = error.to_string();
    let what = message.rsplit_once(" at line ").map_or(message.as_str(), |(what, _)| what);
    // What is JSON may still be another object, or have a key twice.
    let wrong = if error.is_data() { "a query" } else { "valid JSON" };
    // It counts bytes from the first one that is not blank.
    let bytes = line.len() - line.trim_start().len() + error.column();
    let column = line.char_indices().take_while(|(at, _)| *at < bytes).count();
    Failure::input(format!("the line is not {wrong}: {what} (column {column})"))
}

fn list((key, example): (&'static str, &'static str), raw: Option<&RawValue>) -> Result<Vec<String>, Failure> {
    let raw = raw.ok_or_else(|| missing(key, example))?;
    let items: Vec<&RawValue> = serde_json::from_str(raw.get()).map_err(|_not_a_list| {
        let value = shortened(raw.get());
        Failure::input(format!("{key}: {value} is not a list of three numbers; write it as {example}"))
    })?;
    items.iter().enumerate().map(|(i, item)| number_text(&format!("{key}{}", i + 1), item)).collect()
}

fn number((key, example): (&'static str, &'static str), raw: Option<&RawValue>) -> Result<Number, Failure> {
    let text = number_text(key, raw.ok_or_else(|| missing(key, example))?)?;
    text.parse().map_err(|error| Failure::input(format!("{key}: {error}")))
}

/// The text of a number, or of the string that denotes one.
fn number_text(key: &str, raw: &RawValue) -> Result<String, Failure> {
    let not_a_number = || {
        let value = shortened(raw.get());
        Failure::input(format!("{key}: {value} is not a number; write a number, or a string such as \"11/10\""))
    };
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

    fn parse(line: &str) -> Result<Query, Failure> {
        QueryReader::new(Wanted::Point, None).read(line.as_bytes())
    }

    #[test]
    fn numbers_are_the_decimals_that_are_written() {
        let query =
            parse(r#"{"A": [2, 1.10, "11/10"], "r": [-1e-3, 0, 0], "h": 0.1000000000000000055, "l": 3}"#).unwrap();
        let texts = query.subject.body.moments().each_ref().map(Number::text);
        assert_eq!(texts, ["2", "1.10", "11/10"]);
        assert_eq!(query.subject.body.moments()[1], query.subject.body.moments()[2]);
        assert_eq!(query.h.as_ref().map(Number::text), Some("0.1000000000000000055"));
        assert_ne!(query.h, Some("0.1".parse().unwrap()));
    }

    #[test]
    fn other_keys_are_listed_and_a_byte_order_mark_is_ignored() {
        let query = parse("\u{feff}{\"A\":[1,1,1],\"r\":[0,0,1],\"h\":1,\"l\":1,\"kind\":{\"x\":[[]]}}\r").unwrap();
        assert_eq!(query.ignored, ["kind"]);
    }

    #[test]
    fn a_line_without_a_body_takes_that_of_the_command_line() {
        let body = Body::parse(&["3", "2", "1"], &["0", "0", "1"]).unwrap();
        let subject = Arc::new(Subject::from(body.clone()));
        let line = br#"{"l": 1}"#;
        let query = QueryReader::new(Wanted::Momentum, Some(&subject)).read(line).unwrap();
        assert_eq!(query.subject.body, body);
        let half = br#"{"A": [1, 1, 1], "l": 1}"#;
        let error = QueryReader::new(Wanted::Momentum, Some(&subject)).read(half).unwrap_err();
        assert!(error.to_string().starts_with("r is missing"));
    }

    proptest! {
        /// Whatever a line holds, it is read or refused with a message; none of it stops the program.
        #[test]
        fn any_bytes_are_read_or_refused(line in prop::collection::vec(any::<u8>(), 0..200)) {
            if let Err(error) = QueryReader::new(Wanted::Point, None).read(&line) {
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
                Ok(query) => prop_assert!(query.subject.body.moments_f64().iter().all(|a| *a > 0.0)),
                Err(error) => prop_assert!(!error.to_string().is_empty()),
            }
        }

        /// A decimal of any length keeps its text and its value.
        #[test]
        fn long_decimals_are_not_rounded(digits in "[1-9][0-9]{20,60}") {
            let query = parse(&format!(r#"{{"A":[1.{digits},1,1],"r":[1,0,0],"h":0.{digits},"l":1}}"#)).unwrap();
            let exact: Number = format!("{digits}/1{}", "0".repeat(digits.len())).parse().unwrap();
            prop_assert_eq!(query.h, Some(exact));
            prop_assert_eq!(query.subject.body.moments()[0].text(), format!("1.{digits}"));
        }
    }
}
