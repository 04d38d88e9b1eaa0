//! The points of a section as columns.

use bifdiag::document::SectionDocument;
use bifdiag::section::{OrbitSection, SectionPoint};

use crate::cli::data::{Column, DataTable, Values};

/// One row for each point; `meta` is the document on one line.
pub fn of(document: &SectionDocument, orbits: &[OrbitSection]) -> Result<DataTable, serde_json::Error> {
    let points: Vec<&SectionPoint> = orbits.iter().flat_map(|orbit| &orbit.points).collect();
    let floats = |value: fn(&SectionPoint) -> f64| Values::Float(points.iter().map(|p| value(p)).collect());
    let vectors = |value: fn(&SectionPoint) -> [f64; 3]| Values::Vector(points.iter().map(|p| value(p)).collect());
    // The options allow no more than fit.
    let counts =
        |value: fn(&SectionPoint) -> u32| Values::Int32(points.iter().map(|p| value(p).cast_signed()).collect());
    let columns = [
        ("orbit", counts(|p| p.orbit)),
        ("index", counts(|p| p.index)),
        ("time", floats(|p| p.time)),
        ("gamma", vectors(|p| p.gamma)),
        ("l", vectors(|p| p.l)),
        ("sheet", Values::Int8(points.iter().map(|p| p.sheet).collect())),
        ("s_dot", floats(|p| p.s_dot)),
        ("theta", floats(|p| p.theta)),
        ("psi", floats(|p| p.psi)),
    ];
    Ok(DataTable {
        columns: columns.into_iter().map(|(name, values)| Column { name, values }).collect(),
        meta: serde_json::to_string(document)?,
    })
}
