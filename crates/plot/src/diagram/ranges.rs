//! Ranges of h and l, and windows: products of two.

use bifdiag_schema::WindowDocument;

/// The range of l of a curve or a cell; the upper end may be infinite.
pub(super) fn l_range(ends: [Option<f64>; 2]) -> [f64; 2] {
    [ends[0].unwrap_or(0.0), ends[1].unwrap_or(f64::INFINITY)]
}

pub(super) fn length(range: [f64; 2]) -> f64 {
    range[1] - range[0]
}

/// The smallest range that holds both.
pub(super) fn hull(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The common part; turned round where there is none.
pub(super) fn common(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].min(b[1])]
}

pub(super) fn area(window: &WindowDocument) -> f64 {
    length(window.h) * length(window.l)
}

/// Does one window hold the other?
pub(super) fn contains(outer: &WindowDocument, inner: &WindowDocument) -> bool {
    let within = |outer: [f64; 2], inner: [f64; 2]| outer[0] <= inner[0] && inner[1] <= outer[1];
    within(outer.h, inner.h) && within(outer.l, inner.l)
}

/// The common part of two windows.
pub(super) fn clipped(window: &WindowDocument, outer: &WindowDocument) -> WindowDocument {
    WindowDocument { h: common(window.h, outer.h), l: common(window.l, outer.l) }
}
