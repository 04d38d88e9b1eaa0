//! The samples of a motion as columns.

use bifdiag_dynamics::motion::MotionSample;
use bifdiag_schema::MotionDocument;

use crate::cli::export::{Columns, Values};

/// One row for each sample; `meta` is the document on one line.
pub fn of(document: &MotionDocument, samples: &[MotionSample]) -> Result<Columns, serde_json::Error> {
    let floats = |value: fn(&MotionSample) -> f64| Values::floats(samples.iter().map(value));
    let vectors = |value: fn(&MotionSample) -> [f64; 3]| Values::vectors(samples.iter().map(value));
    let columns = [
        ("time", floats(|s| s.time)),
        ("gamma", vectors(|s| s.gamma)),
        ("l", vectors(|s| s.l)),
        ("omega", vectors(|s| s.omega)),
        ("theta", floats(|s| s.theta)),
        ("psi", floats(|s| s.psi)),
        ("phi", floats(|s| s.phi)),
        ("attitude", Values::quaternions(samples.iter().map(|s| s.attitude.components()))),
    ];
    Columns::new(columns, document)
}
