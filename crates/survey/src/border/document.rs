//! A border as a document.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::bisection::Border;
use super::event::BorderEvent;
use super::segment::Segment;
use crate::scan::{Parameter, Range};
use schema::SCHEMA_VERSION;

/// The value of a parameter at a border.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BorderValue {
    /// The parameter.
    pub parameter: Parameter,
    /// Where the class changes.
    pub value: f64,
    /// Estimate of the error of `value`.
    pub error: f64,
    /// Values with the one and with the other class; the bodies between are undecided, or were not looked at.
    pub enclosure: [f64; 2],
}

/// The answer of `scan border`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BorderDocument {
    /// Version of this document.
    pub schema_version: String,
    /// The ranges that were searched.
    pub vary: Vec<Range>,
    /// Where the class changes.
    pub border: Vec<BorderValue>,
    /// True when every error is at most 1e-10.
    pub reached: bool,
    /// The classes at the two ends of the enclosure.
    pub classes: [String; 2],
    /// What happens there.
    pub event: BorderEvent,
    /// Bodies that were looked at.
    pub atlases: u32,
}

impl BorderDocument {
    /// The document of a border on a segment along `vary`.
    #[must_use]
    pub fn new(border: &Border, segment: &Segment, vary: &[Range]) -> Self {
        let values = vary.iter().map(|range| {
            let at = |t: f64| segment.coordinate(range.parameter.place(), t).to_f64().value();
            let error = border.error * (at(1.0) - at(0.0)).abs();
            BorderValue { parameter: range.parameter, value: at(border.t), error, enclosure: border.enclosure.map(at) }
        });
        Self {
            schema_version: SCHEMA_VERSION.to_owned(),
            border: values.collect(),
            vary: vary.to_vec(),
            reached: border.reached,
            classes: border.classes.each_ref().map(|class| class.id().to_owned()),
            event: border.event.clone(),
            atlases: border.atlases,
        }
    }
}
