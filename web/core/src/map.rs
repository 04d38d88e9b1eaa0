//! Many bodies at once: the class of each, for maps of the space of bodies.

use std::collections::HashMap;

use bifdiag::diagram::class::{Class, ClassName};
use bifdiag::survey::border::{self, BodySegment, BorderOptions};
use bifdiag::{Accuracy, Body, atlas};
use wasm_bindgen::prelude::*;

use crate::body::{Refused, rows};

/// The classes that were met, numbered in the order in which they were.
#[wasm_bindgen]
#[derive(Default)]
pub struct Classes {
    numbers: HashMap<ClassName, usize>,
    names: Vec<String>,
}

#[wasm_bindgen]
impl Classes {
    /// None yet.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// For each body A1, A2, A3, r1, r2, r3 the number of its class (−1: no body, or open in `f64`) and of its regions.
    ///
    /// # Errors
    /// Numbers that are no rows of six.
    pub fn of(&mut self, bodies: &[f64]) -> Result<Vec<i32>, JsError> {
        let mut found = Vec::with_capacity(bodies.len() / 3);
        for [a1, a2, a3, r1, r2, r3] in rows("a list of bodies", bodies)? {
            found.extend(self.class([a1, a2, a3], [r1, r2, r3]).unwrap_or([-1, 0]));
        }
        Ok(found)
    }

    /// The name of a class.
    #[must_use]
    pub fn name(&self, number: usize) -> Option<String> {
        self.names.get(number).cloned()
    }
}

/// Where the class changes on the straight way from one body to another, both as six numbers: t from 0 to 1 and its error;
/// and, as the last text, what happens there.
///
/// # Errors
/// Bodies that are none, without a class, or of one class.
#[wasm_bindgen]
pub fn border(from: &[f64], to: &[f64]) -> Result<Vec<String>, JsError> {
    Ok(border_texts(from, to)?)
}

fn border_texts(from: &[f64], to: &[f64]) -> Result<Vec<String>, Refused> {
    let body = |numbers: &[f64]| {
        let row = rows("a body", numbers)?.next().unwrap_or_default();
        let [a1, a2, a3, r1, r2, r3] = row;
        Ok::<_, Refused>(Body::from_f64([a1, a2, a3], [r1, r2, r3])?)
    };
    let segment = BodySegment::new(body(from)?, body(to)?);
    let options = BorderOptions { accuracy: Accuracy::Fast, ..BorderOptions::default() };
    let border = border::find(&segment, &options)?;
    Ok(vec![border.t.to_string(), border.error.to_string(), border.event.kind.to_string()])
}

impl Classes {
    fn class(&mut self, moments: [f64; 3], center: [f64; 3]) -> Option<[i32; 2]> {
        let atlas = atlas(&Body::from_f64(moments, center).ok()?, Accuracy::Fast).ok()?;
        let class = Class::of(&atlas).ok()?;
        let names = &mut self.names;
        let number = *self.numbers.entry(class.name().clone()).or_insert_with(|| {
            names.push(class.name().to_string());
            names.len() - 1
        });
        Some([i32::try_from(number).ok()?, i32::try_from(atlas.regions().len()).ok()?])
    }
}
