//! The part of the (h, l) plane that was asked for.

use crate::document::WindowDocument;

/// True when the point lies in the window.
pub(super) fn contains(window: &WindowDocument, h: f64, l: f64) -> bool {
    (window.h[0]..=window.h[1]).contains(&h) && (window.l[0]..=window.l[1]).contains(&l)
}

/// The part of a range of l inside the window.
pub(super) fn clip_l(window: &WindowDocument, l: [f64; 2]) -> Option<[f64; 2]> {
    let clipped = [l[0].max(window.l[0]), l[1].min(window.l[1])];
    (clipped[0] < clipped[1]).then_some(clipped)
}
