//! What the document of an atlas holds.

use schema::{Accuracy, WindowDocument};

/// What the document holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DocumentOptions {
    /// The part of the plane asked for; `None`: all of it.
    pub window: Option<WindowDocument>,
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// Whether curves carry polylines and stability at all.
    pub polylines: bool,
    /// Whether regions carry their outlines.
    pub polygons: bool,
    /// The level of accuracy.
    pub accuracy: Accuracy,
}

impl Default for DocumentOptions {
    fn default() -> Self {
        Self { window: None, chord_tolerance: 1e-3, polylines: true, polygons: true, accuracy: Accuracy::Exact }
    }
}
