//! The times at which the motion is wanted.

use std::fmt;
use std::path::{Path, PathBuf};

use bifdiag_numbers::Number;

use crate::cli::failure::Failure;
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

/// A file of the times of a document, as its command names it.
const FILE: &str = "times.txt";

/// As the command of a document says them.
impl fmt::Display for Times {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range { from, to, count } => write!(f, "{from}:{to}:{count}"),
            Self::File(_) => f.write_str(FILE),
        }
    }
}

impl Times {
    /// What contains no colon is the name of a file.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        if !text.contains(':') {
            return Ok(Self::File(PathBuf::from(text)));
        }
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, count] = parts[..] else {
            return Err(Failure::input(
                "a range of times is written t0:t1:n, such as 0:10:101 for 101 times from 0 to 10",
            ));
        };
        let end = |name: &str, text: &str| {
            values::float(text).map_err(|_not_a_number| {
                let shape = "a range of times is written t0:t1:n, such as 0:10:101";
                Failure::input(format!("{name} = `{text}` is not a number {}; {shape}", range()))
            })
        };
        let [t0, t1] = [end("t0", from)?, end("t1", to)?];
        if t0 > t1 {
            return Err(Failure::input(format!("t0 = {from} is above t1 = {to}; write the earlier time first")));
        }
        match count.trim().parse() {
            Ok(count) if (1..=MOST).contains(&count) => Ok(Self::Range { from: t0, to: t1, count }),
            _ => Err(Failure::input(format!("n = `{count}` is not a whole number from 1 to {MOST}"))),
        }
    }

    /// The times themselves.
    pub fn list(&self) -> Result<Vec<f64>, Failure> {
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

/// What is read as a time.
fn range() -> String {
    format!("(0, or between {:e} and {:e} in magnitude)", Number::SMALLEST, Number::LARGEST)
}

/// Empty lines, lines that start with # and a header are skipped; the first of several columns is used.
fn of_file(path: &Path) -> Result<Vec<f64>, Failure> {
    let wrong = |what: String| Failure::input(format!("--times {}{what}", path.display()));
    let text = read(path).map_err(|error| {
        wrong(format!(": {error}; give t0:t1:n such as 0:10:101, a file that can be read, or - for stdin"))
    })?;
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
            return Err(wrong(format!(
                ", line {}: `{cell}` is not a number {}; write one time on each line",
                i + 1,
                range()
            )));
        };
        if let Some(&before) = times.last().filter(|&&before| before > time) {
            let line = i + 1;
            return Err(wrong(format!(", line {line}: {time} is below {before} on the line before; times must rise")));
        }
        times.push(time);
    }
    if times.is_empty() {
        return Err(wrong(" holds no time; write one on each line".to_owned()));
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
        let wrong = |text| Times::parse(text).unwrap_err().to_string();
        assert!(wrong("0:1").starts_with("a range of times is written t0:t1:n"));
        assert!(wrong("0:x:3").starts_with("t1 = `x` is not a number"));
        assert!(wrong("0:1:0").starts_with("n = `0` is not a whole number"));
        assert!(wrong("1:0:3").starts_with("t0 = 1 is above t1 = 0"));
        assert_eq!(Times::parse("times.txt").unwrap(), Times::File(PathBuf::from("times.txt")));
    }
}
