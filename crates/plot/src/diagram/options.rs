//! How a diagram is drawn.

use super::scene::MarkedPoints;
use crate::page::{Theme, Width};
use bifdiag_schema::WindowDocument;

/// How a diagram is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DiagramOptions {
    /// The part of the (h, l) plane of the main panel; `None`: chosen so that every event and every unbounded region
    /// is inside.
    pub window: Option<WindowDocument>,
    /// Points marked in place of the samples of the regions.
    pub points: Option<MarkedPoints>,
    /// Colours.
    pub theme: Theme,
    /// For what width the panels are laid out.
    pub width: Width,
}
