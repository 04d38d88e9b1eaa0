//! What the document of an atlas holds.

use bifdiag_schema::{Accuracy, WindowDocument};

/// What of its drawing a document holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// There is no drawing.
    Nothing,
    /// The view and the curves.
    Curves,
    /// The regions, too.
    Everything,
}

/// What the document holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DocumentOptions {
    /// The part of the plane asked for; `None`: all of it.
    pub window: Option<WindowDocument>,
    /// Largest distance between a curve and its polyline, relative to the ranges of h and l of the events.
    pub chord_tolerance: f64,
    /// What of the drawing it holds.
    pub drawing: Drawn,
    /// The level of accuracy.
    pub accuracy: Accuracy,
}

impl Default for DocumentOptions {
    fn default() -> Self {
        Self { window: None, chord_tolerance: 1e-3, drawing: Drawn::Everything, accuracy: Accuracy::Exact }
    }
}

impl DocumentOptions {
    /// A range of l reaches into the window.
    pub(super) fn sees(&self, [from, to]: [f64; 2]) -> bool {
        self.window.is_none_or(|window| from <= window.l[1] && to >= window.l[0])
    }
}
