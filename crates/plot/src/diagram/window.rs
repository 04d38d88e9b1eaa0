//! The windows that the panels may show.

use super::scene::Scene;
use crate::page::{PlotError, is_proper};
use bifdiag_schema::WindowDocument;

/// The part of the plane that the main panel shows, and the part that insets may show.
pub(super) struct Windows {
    /// The window that was asked for, or the main one of the body's view.
    pub main: WindowDocument,
    /// The window that was asked for, or the whole view.
    pub everything: WindowDocument,
}

pub(super) fn windows(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<Windows, PlotError> {
    let drawing = scene.atlas.drawing.as_ref();
    let windows = match (asked.or(scene.atlas.window), drawing.map(|drawing| drawing.view)) {
        (Some(window), _) => Windows { main: window, everything: window },
        (None, Some(view)) => Windows { main: view.main, everything: view.everything },
        (None, None) => return Err(PlotError::NoDrawing),
    };
    let WindowDocument { h, l } = windows.main;
    if is_proper(h) && is_proper(l) { Ok(windows) } else { Err(PlotError::EmptyWindow { h, l }) }
}
