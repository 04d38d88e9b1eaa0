//! Bodies and numbers from the texts of a permalink, and everything that can be wrong with them.

use bifdiag::body::{BodyError, Preset};
use bifdiag::dynamics::motion::MotionError;
use bifdiag::dynamics::poincare::PoincareError;
use bifdiag::dynamics::section::SectionError;
use bifdiag::equilibria::critical::CriticalError;
use bifdiag::{AnswerError, Body, Number, numbers::ParseNumberError};
use thiserror::Error;

/// Why there is no answer.
#[derive(Debug, Error)]
pub enum Refused {
    #[error("`{0}` is not part of a body; write A=2,1.1,1&r=0.94868,0,0.61623 or body=paper")]
    Unknown(String),
    #[error("{0} is missing; write A=2,1.1,1&r=0.94868,0,0.61623 or body=paper")]
    Missing(&'static str),
    #[error("there is no body `{0}`")]
    Preset(String),
    #[error(transparent)]
    Body(#[from] BodyError),
    #[error("{name}: {source}")]
    Number { name: &'static str, source: ParseNumberError },
    #[error("{what} needs a multiple of {unit} numbers, {found} given")]
    Rows { what: &'static str, unit: usize, found: usize },
    #[error(transparent)]
    Answer(#[from] AnswerError),
    #[error(transparent)]
    Critical(#[from] CriticalError),
    #[error(transparent)]
    Poincare(#[from] PoincareError),
    #[error(transparent)]
    Section(#[from] SectionError),
    #[error(transparent)]
    Motion(#[from] MotionError),
    #[error(transparent)]
    Border(#[from] bifdiag::survey::border::BorderError),
    #[error("the answer cannot be written: {0}")]
    Json(String),
}

/// A body from a text such as `A=2,1.1,1&r=0.94868,0,0.61623` or `body=paper`.
pub fn body(text: &str) -> Result<Body, Refused> {
    let (mut moments, mut center) = (None, None);
    for part in text.split('&') {
        match part.split_once('=') {
            Some(("A", list)) => moments = Some(list.split(',').collect::<Vec<_>>()),
            Some(("r", list)) => center = Some(list.split(',').collect::<Vec<_>>()),
            Some(("body", name)) => {
                return Preset::find(name).map(Preset::body).ok_or_else(|| Refused::Preset(name.to_owned()));
            }
            _ => return Err(Refused::Unknown(part.to_owned())),
        }
    }
    Ok(Body::parse(&moments.ok_or(Refused::Missing("A"))?, &center.ok_or(Refused::Missing("r"))?)?)
}

pub fn number(name: &'static str, text: &str) -> Result<Number, Refused> {
    text.parse().map_err(|source| Refused::Number { name, source })
}

/// Rows of so many numbers.
pub fn rows<'a, const N: usize>(
    what: &'static str,
    numbers: &'a [f64],
) -> Result<impl Iterator<Item = [f64; N]> + 'a, Refused> {
    let (rows, rest) = numbers.as_chunks::<N>();
    if rest.is_empty() { Ok(rows.iter().copied()) } else { Err(Refused::Rows { what, unit: N, found: numbers.len() }) }
}
