//! Where a window of the (h, l) plane lies on the page.

use super::ranges::length;
use crate::page::{Point, Rect};
use bifdiag_schema::WindowDocument;

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
