//! One panel: a view with its curves and the regions of its pixels.

use super::scene::{Cell, Scene};
use super::straight::Straight;
use super::trace::{Trace, traces};
use super::windows::{View, common};
use bifdiag_page::{Areas, Path, PlotError, Point, clip_polygon, clip_polyline, pixel, union};
use bifdiag_schema::EventDocument;

/// A region whose inscribed circle has at least this radius in pixels can be seen and pointed at.
pub(super) const LEGIBLE: f64 = 4.5;

/// Curves are off by at most this many pixels.
const CHORD_PIXELS: f64 = 0.05;

/// A view with its curves and the regions of its pixels.
pub(super) struct Panel {
    pub view: View,
    pub traces: Vec<Trace>,
    pub areas: Areas,
    /// For a panel of the straightened plane.
    pub straight: Option<Straight>,
}

impl Panel {
    pub(super) fn new(scene: &Scene<'_>, view: View) -> Result<Self, PlotError> {
        let traces = traces(scene, view.window.l, CHORD_PIXELS * view.h_per_pixel())?;
        let areas = areas(scene, &view, &traces, 0..scene.cells.len());
        Ok(Self { view, traces, areas, straight: None })
    }

    /// A panel of the straightened plane; its view says which part of the plane it shows.
    pub(super) fn straightened(scene: &Scene<'_>, view: View, straight: Straight) -> Result<Self, PlotError> {
        let traces = traces(scene, view.window.l, CHORD_PIXELS * view.h_per_pixel())?;
        let areas = straight.areas();
        Ok(Self { view, traces, areas, straight: Some(straight) })
    }

    /// Where [h, l] lies on the page, if it is shown.
    pub(super) fn position(&self, point: [f64; 2]) -> Option<Point> {
        let at = match &self.straight {
            Some(straight) => straight.position(point),
            None => Some(self.view.position(point)),
        };
        at.filter(|at| self.view.rect.contains(*at))
    }

    /// What lies at a position of the page: [h, l], or a point of the unit square of the straightened plane.
    pub(super) fn point(&self, at: Point) -> Point {
        self.straight.as_ref().map_or_else(|| self.view.point(at), |straight| straight.in_unit_square(at))
    }

    /// Where an event lies on the page, if it is shown.
    pub(super) fn event(&self, scene: &Scene<'_>, event: &EventDocument) -> Option<Point> {
        match &self.straight {
            Some(straight) => straight.event(scene, event),
            None => self.position([event.h, event.l]),
        }
    }

    /// The visible parts of a curve between two momenta.
    pub(super) fn curve(&self, curve: usize, l: [f64; 2]) -> Vec<Vec<Point>> {
        match &self.straight {
            Some(straight) => vec![straight.curve(curve, l)],
            None => clip_polyline(&self.view.positions(&self.traces[curve].part(l[0], l[1])), &self.view.rect),
        }
    }

    /// The visible part of a region.
    pub(super) fn region(&self, cells: &[Cell]) -> Path {
        // Cells meet along sides of one l.
        match &self.straight {
            Some(straight) => union(cells.iter().map(|cell| straight.cell(cell)), 0),
            None => union(cells.iter().map(|cell| self.cell_polygon(cell)), 1),
        }
    }

    /// The polygon of a region's cell inside the view.
    fn cell_polygon(&self, cell: &Cell) -> Vec<Point> {
        let window = &self.view.window;
        let [from, to] = common(cell.l, window.l);
        if from >= to {
            return Vec::new();
        }
        // The sides of two cells that meet at one l coincide exactly.
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

/// The pixels of some regions in a view.
pub(super) fn areas(
    scene: &Scene<'_>,
    view: &View,
    traces: &[Trace],
    regions: impl IntoIterator<Item = usize>,
) -> Areas {
    Areas::new(&view.rect, |[width, height], of| {
        let l_top = view.window.l[1];
        let column = |h: f64| pixel(((h - view.window.h[0]) / view.h_per_pixel() - 0.5).ceil(), width);
        // Row y holds l_top − (y + ½)·(l per pixel).
        let row = |l: f64| (l_top - l) / view.l_per_pixel() - 0.5;
        for (region, cell) in
            regions.into_iter().flat_map(|region| scene.cells[region].iter().map(move |c| (region, c)))
        {
            let Ok(region) = i32::try_from(region) else { continue };
            for y in pixel(row(cell.l[1]).ceil(), height)..pixel(row(cell.l[0]).floor() + 1.0, height) {
                let l = l_top - (y as f64 + 0.5) * view.l_per_pixel();
                let Some(lower) = traces[cell.lower].h_at(l) else { continue };
                let upper = cell.upper.map_or(Some(f64::INFINITY), |upper| traces[upper].h_at(l));
                let Some(upper) = upper else { continue };
                let (left, right) = (column(lower), column(upper));
                if left < right {
                    of[y * width + left..y * width + right].fill(region);
                }
            }
        }
    })
}
