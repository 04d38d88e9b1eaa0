//! One panel: a window of the (h, l) plane and where it lies on the page.

use super::canvas::Point;
use super::geometry::Rect;
use super::grid::Grid;
use super::scene::Scene;
use super::trace::{Trace, traces};
use super::{PlotError, geometry};
use schema::WindowDocument;

/// Curves are off by at most this many pixels.
const CHORD_PIXELS: f64 = 0.05;

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
        (self.window.h[1] - self.window.h[0]) / self.rect.width
    }

    /// Vertical angular momenta in a pixel.
    pub(super) fn l_per_pixel(&self) -> f64 {
        (self.window.l[1] - self.window.l[0]) / self.rect.height
    }
}

/// A view with its curves and the regions of its pixels.
pub(super) struct Panel {
    pub view: View,
    pub traces: Vec<Trace>,
    pub grid: Grid,
}

impl Panel {
    pub(super) fn new(scene: &Scene<'_>, view: View) -> Result<Self, PlotError> {
        let traces = traces(scene, view.window.l, CHORD_PIXELS * view.h_per_pixel())?;
        let grid = Grid::new(scene, &view, &traces);
        Ok(Self { view, traces, grid })
    }

    /// The polygon of a region's cell inside the view, and a little beyond its ends in l: cells of one region overlap,
    /// so that no seam shows.
    pub(super) fn cell_polygon(&self, cell: &super::scene::Cell) -> Vec<Point> {
        let window = &self.view.window;
        let (from, to) = (cell.l[0].max(window.l[0]), cell.l[1].min(window.l[1]));
        if from >= to {
            return Vec::new();
        }
        let overlap = 0.3 * self.view.l_per_pixel();
        let widened = |mut points: Vec<[f64; 2]>| {
            if let (Some(first), Some(last)) = (points.first().copied(), points.last().copied()) {
                points.insert(0, [first[0], first[1] - overlap]);
                points.push([last[0], last[1] + overlap]);
            }
            points
        };
        let mut outline = widened(self.traces[cell.lower].part(from, to));
        let upper = match cell.upper {
            Some(upper) => widened(self.traces[upper].part(from, to)),
            None => {
                vec![[window.h[1] * 2.0 - window.h[0], from - overlap], [window.h[1] * 2.0 - window.h[0], to + overlap]]
            }
        };
        if outline.is_empty() || upper.is_empty() {
            return Vec::new();
        }
        outline.extend(upper.into_iter().rev());
        geometry::clip_polygon(&self.view.positions(&outline), &self.view.rect)
    }
}
