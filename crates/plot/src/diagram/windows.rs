//! Windows of the (h, l) plane: products of two ranges, where they lie on the page, and how they keep apart.

use bifdiag_page::{Point, Rect};
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

/// The common part; inverted if there is none.
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

/// A window on the page, h to the right and l upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct View {
    pub window: WindowDocument,
    pub rect: Rect,
}

impl View {
    /// Position on the page of [h, l].
    pub(super) fn position(&self, point: [f64; 2]) -> Point {
        let [h, l] = point;
        let WindowDocument { h: [h0, h1], l: [l0, l1] } = self.window;
        [
            self.rect.x + (h - h0) / (h1 - h0) * self.rect.width,
            self.rect.y + self.rect.height - (l - l0) / (l1 - l0) * self.rect.height,
        ]
    }

    /// What lies at a position.
    pub(super) fn point(&self, [x, y]: Point) -> [f64; 2] {
        let WindowDocument { h, l } = self.window;
        let (across, up) = ((x - self.rect.x) / self.rect.width, (self.rect.bottom() - y) / self.rect.height);
        [h[0] + across * length(h), l[0] + up * length(l)]
    }

    pub(super) fn positions(&self, points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|point| self.position(*point)).collect()
    }

    /// Where another window lies in this one.
    pub(super) fn frame(&self, window: &WindowDocument) -> Rect {
        let [x, bottom] = self.position([window.h[0], window.l[0]]);
        let [right, y] = self.position([window.h[1], window.l[1]]);
        Rect { x, y, width: right - x, height: bottom - y }
    }

    /// Energies in a pixel.
    pub(super) fn h_per_pixel(&self) -> f64 {
        length(self.window.h) / self.rect.width
    }

    /// Vertical angular momenta in a pixel.
    pub(super) fn l_per_pixel(&self) -> f64 {
        length(self.window.l) / self.rect.height
    }
}

/// Between two windows, as a share of the smaller one.
const BETWEEN: f64 = 0.03;

/// Free space between two windows, in h and l.
fn between(a: &WindowDocument, b: &WindowDocument) -> [f64; 2] {
    [[a.h, b.h], [a.l, b.l]].map(|sides| BETWEEN * length(sides[0]).min(length(sides[1])))
}

/// Whether two windows meet, though neither holds the other.
pub(super) fn reach_into(a: &WindowDocument, b: &WindowDocument) -> bool {
    let meet = |p: [f64; 2], q: [f64; 2]| p[0] < q[1] && q[0] < p[1];
    meet(a.h, b.h) && meet(a.l, b.l) && !contains(a, b) && !contains(b, a)
}

/// The parts of a window on each of the four sides of another, the largest first.
pub(super) fn beside(window: &WindowDocument, other: &WindowDocument) -> Vec<WindowDocument> {
    let own = *window;
    let [dh, dl] = between(window, other);
    let mut parts = vec![
        WindowDocument { h: [own.h[0], own.h[1].min(other.h[0] - dh)], l: own.l },
        WindowDocument { h: [own.h[0].max(other.h[1] + dh), own.h[1]], l: own.l },
        WindowDocument { h: own.h, l: [own.l[0], own.l[1].min(other.l[0] - dl)] },
        WindowDocument { h: own.h, l: [own.l[0].max(other.l[1] + dl), own.l[1]] },
    ];
    parts.retain(|part| length(part.h) > 0.0 && length(part.l) > 0.0);
    parts.sort_by(|a, b| area(b).total_cmp(&area(a)));
    parts
}

/// The largest part of a window that holds `target` and reaches into none of `others`; `None`: there is no such part.
pub(super) fn clear(
    window: WindowDocument,
    target: &WindowDocument,
    others: &[WindowDocument],
) -> Option<WindowDocument> {
    let Some(other) = others.iter().find(|other| reach_into(&window, other)) else { return Some(window) };
    let parts = beside(&window, other).into_iter().filter(|part| contains(part, target));
    parts.filter_map(|part| clear(part, target, others)).max_by(|a, b| area(a).total_cmp(&area(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_are_trimmed_until_they_are_apart() {
        let window = |h, l| WindowDocument { h, l };
        let (a, b) = (window([100.0, 200.0], [100.0, 200.0]), window([180.0, 300.0], [150.0, 400.0]));
        assert!(reach_into(&a, &b) && !reach_into(&a, &window([0.0, 500.0], [0.0, 500.0])));
        let target = window([250.0, 260.0], [210.0, 220.0]);
        let cleared = clear(b, &target, &[a]).unwrap();
        assert!(!reach_into(&a, &cleared) && contains(&cleared, &target) && contains(&b, &cleared));
        // Beside the other, which leaves 97 · 250, more than the 120 · 197 above it.
        assert_eq!((cleared.h, cleared.l), ([203.0, 300.0], b.l));
        assert!(clear(b, &window([185.0, 250.0], [160.0, 300.0]), &[a]).is_none());
    }
}
