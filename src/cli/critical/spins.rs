//! The spins at which steady axes are wanted.

use std::path::PathBuf;

use bifdiag_body::part::{Spin, SpinUnit};

use crate::cli::export::{DataTarget, PictureFormat};
use crate::cli::failure::Failure;

/// Spins as the option says them.
#[derive(Clone, Debug, PartialEq)]
pub enum Spins {
    /// One.
    One(Spin),
    /// Equally spaced, both ends included.
    Range { from: Spin, to: Spin, count: u32 },
}

/// The most spins of a range.
const MOST: u32 = 1_000_000;

/// How a range is written.
const RANGE: &str =
    "a range of spins is written \"a:b:n UNIT\", such as \"0:3000:301 rpm\" for 301 spins from 0 to 3000 rpm";

impl Spins {
    /// Parses the option.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        if !text.contains(':') {
            return text.parse().map(Self::One).map_err(Failure::input);
        }
        let parts: Vec<&str> = text.split(':').map(str::trim).collect();
        let [from, to, last] = parts[..] else { return Err(Failure::input(RANGE)) };
        let Some((count, unit)) = SpinUnit::at_end(last) else {
            return Err(Failure::input(format!("`{last}` has none of the units rpm, Hz, rad/s and deg/s; {RANGE}")));
        };
        let end = |name: &str, number: &str| match number.parse() {
            Ok(number) => Ok(Spin::new(number, unit)),
            Err(error) => Err(Failure::input(format!("{name}: {error}; {RANGE}"))),
        };
        let (from, to): (Spin, Spin) = (end("a", from)?, end("b", to)?);
        if from.rad_per_s() < 0.0 || from.rad_per_s() > to.rad_per_s() {
            return Err(Failure::input(format!(
                "from {from} to {to}: write the smaller spin first, not below 0; {RANGE}"
            )));
        }
        match count.parse() {
            Ok(count) if (2..=MOST).contains(&count) => Ok(Self::Range { from, to, count }),
            _ => Err(Failure::input(format!("n = `{count}` is not a whole number from 2 to {MOST}; {RANGE}"))),
        }
    }
}

/// Spin `k` of a range.
pub fn spin_at([from, to]: [&Spin; 2], count: u32, k: u32) -> Spin {
    from.between(to, k, count - 1)
}

/// Where a table or a picture goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Output {
    /// A table.
    Data(DataTarget),
    /// A picture, in the format of its extension.
    Picture { path: PathBuf, format: PictureFormat },
}

impl Output {
    /// Parses the option.
    pub fn parse(text: &str) -> Result<Self, Failure> {
        let path = PathBuf::from(text);
        let format = match path.extension().and_then(|extension| extension.to_str()) {
            Some("svg") => PictureFormat::Svg,
            Some("png") => PictureFormat::Png,
            _ => {
                let unknown =
                    |error| Failure::input(format!("{error}; FILE.svg or FILE.png for a picture of a range of spins"));
                return DataTarget::parse(text).map(Self::Data).map_err(unknown);
            }
        };
        Ok(Self::Picture { path, format })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_of_spins_have_one_unit() {
        let Ok(Spins::Range { from, to, count }) = Spins::parse("0:3000:4 rpm") else { panic!("a range") };
        let spins: Vec<String> = (0..count).map(|k| spin_at([&from, &to], count, k).to_string()).collect();
        assert_eq!(spins, ["0 rpm", "1000 rpm", "2000 rpm", "3000 rpm"]);
        assert!(matches!(Spins::parse("1:2:3Hz"), Ok(Spins::Range { count: 3, .. })));
        let wrong = |text| Spins::parse(text).unwrap_err().to_string();
        assert!(wrong("0:3000:301").contains("has none of the units"));
        assert!(wrong("0:3000 rpm").starts_with("a range of spins is written"));
        assert!(wrong("9:3:4 rpm").contains("write the smaller spin first"));
        for (text, count) in
            [("1:3:1 rpm", "1"), ("0:60:11/2 rpm", "11/2"), ("0:6:2.5 Hz", "2.5"), ("0:6:ten rpm", "ten")]
        {
            assert!(wrong(text).starts_with(&format!("n = `{count}` is not a whole number")), "{}", wrong(text));
        }
        // One unit, behind n.
        assert!(wrong("0 rpm:20 Hz:11").contains("`11` has none of the units"));
        assert!(wrong("0 rpm:20 Hz:11 Hz").starts_with("a: `0 rpm` is not a number"));
        assert!(wrong("0:60:10 kHz").contains("`10 kHz` has none of the units"));
    }
}
