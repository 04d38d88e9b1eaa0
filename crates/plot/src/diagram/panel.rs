//! One panel: a view with its curves and the regions of its pixels.

use super::grid::Grid;
use super::ranges::common;
use super::scene::{Cell, Scene};
use super::trace::{Trace, traces};
use super::view::View;
use crate::page::{PlotError, Point, clip_polygon};

/// Curves are off by at most this many pixels.
const CHORD_PIXELS: f64 = 0.05;

/// A view with its curves and the regions of its pixels.
pub(super) struct Panel {
    pub view: View,
    pub traces: Vec<Trace>,
    pub grid: Grid,
}

impl Panel {
    pub(super) fn new(scene: &Scene<'_>, view: View) -> Result<Self, PlotError> {
        let traces = traces(scene, view.window.l, CHORD_PIXELS * view.h_per_pixel())?;
        let grid = Grid::new(scene, &view, &traces, 0..scene.cells.len());
        Ok(Self { view, traces, grid })
    }

    /// The polygon of a region's cell inside the view.
    pub(super) fn cell_polygon(&self, cell: &Cell) -> Vec<Point> {
        let window = &self.view.window;
        let [from, to] = common(cell.l, window.l);
        if from >= to {
            return Vec::new();
        }
        // The sides of two cells that meet at one l lie exactly upon each other.
        let completed = |mut points: Vec<[f64; 2]>| {
            if let (Some(first), Some(last)) = (points.first().copied(), points.last().copied()) {
                points.insert(0, [first[0], from]);
                points.push([last[0], to]);
            }
            points
        };
        let mut outline = completed(self.traces[cell.lower].part(from, to));
        let upper = match cell.upper {
            Some(upper) => completed(self.traces[upper].part(from, to)),
            // Unbounded: up to far outside of the view.
            None => [from, to].map(|l| [window.h[1] * 2.0 - window.h[0], l]).to_vec(),
        };
        if outline.is_empty() || upper.is_empty() {
            return Vec::new();
        }
        outline.extend(upper.into_iter().rev());
        clip_polygon(&self.view.positions(&outline), &self.view.rect)
    }
}
