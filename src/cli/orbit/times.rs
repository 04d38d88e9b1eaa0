//! The times at which the motion is wanted.

use std::fmt;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::error::OrbitInput;
use crate::cli::input::{read, values};

/// Times as the option says them.
#[derive(Clone, Debug, PartialEq)]
pub enum Times {
    /// Equally spaced, both ends included.
    Range { from: f64, to: f64, count: u32 },
    /// One on each line of a file.
    File(PathBuf),
}

/// The most samples of a range.
const MOST: u32 = 10_000_000;

/// Why a range of times is refused.
#[derive(Debug, PartialEq, Error)]
pub enum TimesError {
    #[error("a range of times is written t0:t1:n, such as 0:10:101 for 101 times from 0 to 10")]
    Shape,
    #[error("{name} = `{value}` is not a number; a range of times is written t0:t1:n, such as 0:10:101")]
    End { name: &'static str, value: String },
    #[error("n = `{value}` is not a whole number from 1 to {MOST}")]
    Count { value: String },
    #[error("t0 = {from} is above t1 = {to}; write the earlier time first")]
    Falling { from: f64, to: f64 },
}

impl fmt::Display for Times {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range { from, to, count } => write!(f, "{from}:{to}:{count}"),
            Self::File(path) => write!(f, "{}", path.display()),
        }
    }
}

impl Times {
    /// What contains no colon is the name of a file.
    pub fn parse(text: &str) -> Result<Self, TimesError> {
        if !text.contains(':') {
            return Ok(Self::File(PathBuf::from(text)));
        }
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, count] = parts[..] else { return Err(TimesError::Shape) };
        let end = |name, text: &str| {
            values::float(text).map_err(|_not_a_number| TimesError::End { name, value: text.to_owned() })
        };
        let (from, to) = (end("t0", from)?, end("t1", to)?);
        if from > to {
            return Err(TimesError::Falling { from, to });
        }
        let wrong = || TimesError::Count { value: count.to_owned() };
        match count.parse() {
            Ok(count) if (1..=MOST).contains(&count) => Ok(Self::Range { from, to, count }),
            _ => Err(wrong()),
        }
    }

    /// The times themselves.
    pub fn list(&self) -> Result<Vec<f64>, OrbitInput> {
        match self {
            Self::Range { from, count: 1, .. } => Ok(vec![*from]),
            Self::Range { from, to, count } => {
                let last = count - 1;
                // Weighted so that both ends are exact.
                let at = |k: u32| (f64::from(last - k) * from + f64::from(k) * to) / f64::from(last);
                Ok((0..=last).map(at).collect())
            }
            Self::File(path) => of_file(path),
        }
    }
}

/// Empty lines, lines that start with # and a heading are passed over; of several columns the first counts.
fn of_file(path: &Path) -> Result<Vec<f64>, OrbitInput> {
    let text = read(path).map_err(|source| OrbitInput::TimesFile { path: path.to_owned(), source })?;
    let mut times: Vec<f64> = Vec::new();
    let mut heading_possible = true;
    for (i, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let cell = line.split(',').next().unwrap_or_default().trim();
        if cell.is_empty() || cell.starts_with('#') {
            continue;
        }
        let heading = std::mem::replace(&mut heading_possible, false) && matches!(cell, "time" | "t");
        if heading {
            continue;
        }
        let Ok(time) = values::float(cell) else {
            return Err(OrbitInput::TimesLine { path: path.to_owned(), line: i + 1, value: cell.to_owned() });
        };
        if let Some(&before) = times.last().filter(|&&before| before > time) {
            return Err(OrbitInput::TimesFall { path: path.to_owned(), line: i + 1, time, before });
        }
        times.push(time);
    }
    if times.is_empty() {
        return Err(OrbitInput::NoTimes { path: path.to_owned() });
    }
    Ok(times)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_include_both_ends_exactly() {
        let times = Times::parse("-0.1:0.7:9").unwrap().list().unwrap();
        assert_eq!((times.len(), times[0], times[8]), (9, -0.1, 0.7));
        assert!((times[1] - 0.0).abs() < 1e-16);
        assert_eq!(Times::parse("3:3:1").unwrap().list().unwrap(), [3.0]);
    }

    #[test]
    fn wrong_ranges_are_explained() {
        assert_eq!(Times::parse("0:1"), Err(TimesError::Shape));
        assert_eq!(Times::parse("0:x:3"), Err(TimesError::End { name: "t1", value: "x".to_owned() }));
        assert_eq!(Times::parse("0:1:0"), Err(TimesError::Count { value: "0".to_owned() }));
        assert_eq!(Times::parse("1:0:3"), Err(TimesError::Falling { from: 1.0, to: 0.0 }));
        assert_eq!(Times::parse("times.txt"), Ok(Times::File(PathBuf::from("times.txt"))));
    }
}
