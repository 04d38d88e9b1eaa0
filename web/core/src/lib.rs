//! The library for JavaScript: a thin guest. Bodies come as the text of a permalink, answers go as JSON.

use bifdiag::top::atlas::AtlasError;
use bifdiag::top::body::{BodyError, Preset};
use bifdiag::top::classify::ClassifyError;
use bifdiag::top::critical::CriticalError;
use bifdiag::{Atlas, Body, Number, documents, numbers::ParseNumberError};
use thiserror::Error;
use wasm_bindgen::prelude::*;

/// Why there is no answer.
#[derive(Debug, Error)]
enum Refused {
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
    #[error(transparent)]
    Atlas(#[from] AtlasError),
    #[error(transparent)]
    Classify(#[from] ClassifyError),
    #[error(transparent)]
    Critical(#[from] CriticalError),
    #[error("the answer cannot be written: {0}")]
    Json(String),
}

/// A body from a text such as `A=2,1.1,1&r=0.94868,0,0.61623` or `body=paper`.
fn body(text: &str) -> Result<Body, Refused> {
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

fn number(name: &'static str, text: &str) -> Result<Number, Refused> {
    text.parse().map_err(|source| Refused::Number { name, source })
}

fn atlas_text(text: &str) -> Result<String, Refused> {
    let document = documents::atlas::document(&Atlas::new(&body(text)?)?, &documents::DocumentOptions::default());
    documents::layout::text(&document).map_err(|error| Refused::Json(error.to_string()))
}

fn classify_text(text: &str, h: &str, l: &str) -> Result<String, Refused> {
    let (body, h, l) = (body(text)?, number("h", h)?, number("l", l)?);
    let found = bifdiag::classify(&body, &h, &l)?;
    let document = documents::classification(&body, &h, &l, &found, bifdiag::schema::Accuracy::default());
    documents::layout::text(&document).map_err(|error| Refused::Json(error.to_string()))
}

fn critical_text(text: &str, l: &str) -> Result<String, Refused> {
    let (body, l) = (body(text)?, number("l", l)?);
    let document = documents::critical(&body, &l, &bifdiag::critical(&body, &l)?);
    documents::layout::text(&document).map_err(|error| Refused::Json(error.to_string()))
}

/// The text of `atlas.json` of a body.
///
/// # Errors
/// A body that is none, or one without an atlas.
#[wasm_bindgen]
pub fn atlas(body: &str) -> Result<String, JsError> {
    Ok(atlas_text(body)?)
}

/// The type of one point (h, l), as `bifdiag classify --json` prints it.
///
/// # Errors
/// A body or numbers that are none, or a point without an answer.
#[wasm_bindgen]
pub fn classify(body: &str, h: &str, l: &str) -> Result<String, JsError> {
    Ok(classify_text(body, h, l)?)
}

/// All relative equilibria at one l, as `bifdiag critical --json` prints them.
///
/// # Errors
/// A body or a number that is none.
#[wasm_bindgen]
pub fn critical(body: &str, l: &str) -> Result<String, JsError> {
    Ok(critical_text(body, l)?)
}
