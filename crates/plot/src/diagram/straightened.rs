//! The straightened plane as numbers, for those who draw it with their own means.

use super::described::DiagramDescription;
use super::page::Page;
use super::paint::Diagram;
use super::straight::{Straight, half_width};
use bifdiag_page::{PlotError, Point, Theme, outlines};

/// Where everything lies in the straightened plane, in the unit square: l to the right, h upwards. The picture of
/// [`draw`](super::draw) in this view has the same places.
pub struct StraightDiagram {
    straight: Straight,
    /// What is drawn there.
    pub described: DiagramDescription,
    /// The outlines of each region; a hole is an outline of its own (even-odd rule).
    pub regions: Vec<Vec<Vec<Point>>>,
    /// The points of each stroke.
    pub strokes: Vec<Vec<Point>>,
    /// Lines of constant h.
    pub levels: Vec<Vec<Point>>,
    /// The events, in the order of the document, where they are shown.
    pub events: Vec<Option<Point>>,
    /// Round numbers on the axis of l.
    pub momenta: Vec<(f64, String)>,
    /// Round numbers of h at l = 0 and at the last l.
    pub energies: [Vec<(f64, String)>; 2],
    /// The last l.
    pub l_end: f64,
}

impl StraightDiagram {
    /// Of a page of this view.
    ///
    /// # Errors
    /// [`PlotError::NotStraight`].
    pub(super) fn new(page: Page<'_>, theme: Theme) -> Result<Self, PlotError> {
        let described = DiagramDescription::of(&page, theme);
        let Diagram { scene, strokes, mut panels, .. } = page.into_diagram();
        let panel = panels.swap_remove(0);
        let Some(straight) = &panel.straight else { return Err(PlotError::NotStraight) };
        let unit = |at: Point| straight.in_unit_square(at);
        let units = |line: Vec<Point>| line.into_iter().map(unit).collect::<Vec<Point>>();
        let outline = |cells: &Vec<super::scene::Cell>| outlines(cells.iter().map(|cell| straight.cell(cell)), 0);
        let regions = scene.cells.iter().map(|cells| outline(cells).into_iter().map(units).collect());
        let strokes = strokes.iter().map(|stroke| units(straight.curve(stroke.curve, stroke.l)));
        let along = |place: usize| move |tick: super::straight::Tick, at: Point| (at[place], tick.label);
        let momenta = straight.momenta(half_width).into_iter().map(|tick| {
            let at = unit([tick.at, 0.0]);
            along(0)(tick, at)
        });
        let energies = straight.levels().map(|ticks| {
            ticks.into_iter().map(|tick| {
                let at = unit([0.0, tick.at]);
                along(1)(tick, at)
            })
        });
        Ok(Self {
            regions: regions.collect(),
            strokes: strokes.collect(),
            described,
            levels: straight.level_lines().into_iter().map(units).collect(),
            events: scene.atlas.events.iter().map(|event| panel.event(&scene, event).map(unit)).collect(),
            momenta: momenta.collect(),
            energies: energies.map(Iterator::collect),
            l_end: straight.l_end().unwrap_or(0.0),
            straight: panel.straight.ok_or(PlotError::NotStraight)?,
        })
    }

    /// Where [h, l] lies; nowhere where there is no motion, and beyond the last l.
    #[must_use]
    pub fn position(&self, point: [f64; 2]) -> Option<Point> {
        self.straight.position(point).map(|at| self.straight.in_unit_square(at))
    }
}
