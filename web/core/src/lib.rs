//! The library for JavaScript: a thin guest. Bodies come as the text of a permalink, documents go as JSON, pictures as rows
//! of numbers.

mod body;
mod diagram;
mod map;
mod section;
mod texts;

use bifdiag::body::Preset;
use wasm_bindgen::prelude::*;

pub use diagram::Diagram;
pub use map::{Classes, border};
pub use section::Section;

/// The text of `atlas.json` of a body.
///
/// # Errors
/// A body that is none, or one without an atlas.
#[wasm_bindgen]
pub fn atlas(body: &str) -> Result<String, JsError> {
    Ok(texts::atlas(body)?)
}

/// The type of one point (h, l), as `bifdiag classify --json` prints it.
///
/// # Errors
/// A body or numbers that are none, or a point without an answer.
#[wasm_bindgen]
pub fn classify(body: &str, h: &str, l: &str) -> Result<String, JsError> {
    Ok(texts::classify(body, h, l)?)
}

/// All relative equilibria at one l, as `bifdiag critical --json` prints them.
///
/// # Errors
/// A body or a number that is none.
#[wasm_bindgen]
pub fn critical(body: &str, l: &str) -> Result<String, JsError> {
    Ok(texts::critical(body, l)?)
}

/// The named bodies: for each its name, its note, A1, A2, A3, r1, r2, r3.
#[wasm_bindgen]
#[must_use]
pub fn presets() -> Vec<String> {
    let row = |preset: &Preset| {
        let body = preset.body();
        let numbers = body.moments().iter().chain(body.center()).map(|number| number.text().to_owned());
        [preset.name().to_owned(), preset.note().to_owned()].into_iter().chain(numbers).collect::<Vec<_>>()
    };
    Preset::all().iter().flat_map(row).collect()
}
