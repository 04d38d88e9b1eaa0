//! Ranges of the parameters of a body, as they are written.

use std::str::FromStr;

use dashu_ratio::RBig;
use thiserror::Error;

use bifdiag_body::{Body, BodyError};
use bifdiag_numbers::{Number, ParseNumberError};
use bifdiag_schema::BodyParameter;

/// The parameter of this name.
///
/// # Errors
/// [`ParseRangeError::Parameter`].
pub fn parameter(text: &str) -> Result<BodyParameter, ParseRangeError> {
    let found = BodyParameter::ALL.into_iter().find(|parameter| parameter.name() == text.trim());
    found.ok_or_else(|| ParseRangeError::Parameter { text: text.trim().to_owned() })
}

/// A body with other values of some parameters.
///
/// # Errors
/// Where a moment is not positive.
pub fn with_values<'a>(
    body: &Body,
    values: impl IntoIterator<Item = (BodyParameter, &'a Number)>,
) -> Result<Body, BodyError> {
    let (mut moments, mut center) = (body.moments().clone(), body.center().clone());
    for (parameter, value) in values {
        let place = parameter.place();
        *moments.get_mut(place).unwrap_or_else(|| &mut center[place - 3]) = value.clone();
    }
    Body::new(moments, center)
}

/// The values that one parameter takes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParameterRange {
    /// Which.
    pub parameter: BodyParameter,
    /// Lower end.
    pub from: Number,
    /// Upper end.
    pub to: Number,
    /// Number of values in equal steps, both ends included; without it, the range is sampled, or halved by `scan border`.
    pub steps: Option<u32>,
}

/// Why a text is not a range of a parameter.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ParseRangeError {
    /// Not of the form.
    #[error("a range is written A2=0.5:2 or, for a grid of 200 values, A2=0.5:2:200")]
    Shape,
    /// No such parameter.
    #[error("`{text}` is no parameter of a body; the parameters are A1, A2, A3, r1, r2, r3")]
    Parameter {
        /// What was written.
        text: String,
    },
    /// An end is no number.
    #[error("{parameter}: {source}")]
    End {
        /// Of which parameter.
        parameter: BodyParameter,
        /// What is wrong.
        source: ParseNumberError,
    },
    /// The ends are in the wrong order.
    #[error("{parameter}={from}:{to} is empty; write the lower end first")]
    Empty {
        /// Of which parameter.
        parameter: BodyParameter,
        /// As written.
        from: String,
        /// As written.
        to: String,
    },
    /// The ends are one number.
    #[error("{parameter}={value}:{value} is one value, at which nothing varies; write two different ends")]
    Equal {
        /// Of which parameter.
        parameter: BodyParameter,
        /// As written.
        value: String,
    },
    /// The number of values is invalid.
    #[error("{parameter}: `{text}` is no number of grid values; write a whole number from 2 to 1000000")]
    Steps {
        /// Of which parameter.
        parameter: BodyParameter,
        /// As written.
        text: String,
    },
}

impl ParameterRange {
    /// Value k of a grid, rounded once from the exact fraction.
    pub(crate) fn grid_value(&self, k: u64, steps: u64) -> f64 {
        let (from, to) = (self.from.value(), self.to.value());
        let part = RBig::from_parts(k.into(), (steps - 1).max(1).into());
        (from + (to - from) * part).to_f64().value()
    }
}

impl FromStr for ParameterRange {
    type Err = ParseRangeError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const STEPS_MAX: u32 = 1_000_000;
        let (name, rest) = text.split_once('=').ok_or(ParseRangeError::Shape)?;
        let parameter = parameter(name)?;
        let parts: Vec<&str> = rest.split(':').collect();
        let (from, to, steps) = match parts[..] {
            [from, to] => (from, to, None),
            [from, to, steps] => (from, to, Some(steps)),
            _ => return Err(ParseRangeError::Shape),
        };
        let end = |text: &str| text.parse::<Number>().map_err(|source| ParseRangeError::End { parameter, source });
        let (from, to) = (end(from)?, end(to)?);
        if from == to {
            return Err(ParseRangeError::Equal { parameter, value: from.text().to_owned() });
        }
        if from > to {
            let [from, to] = [from, to].map(|end| end.text().to_owned());
            return Err(ParseRangeError::Empty { parameter, from, to });
        }
        let steps = match steps {
            None => None,
            Some(text) => {
                let count = text.trim().parse::<u32>().ok().filter(|count| (2..=STEPS_MAX).contains(count));
                Some(count.ok_or_else(|| ParseRangeError::Steps { parameter, text: text.to_owned() })?)
            }
        };
        Ok(Self { parameter, from, to, steps })
    }
}
