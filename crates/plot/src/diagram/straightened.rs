//! The straightened plane as numbers, for those who draw it with their own means.

use super::page::Page;
use super::paint::Diagram;
use super::straight::Straight;
use super::windows::l_range;
use crate::page::{PlotError, Point, outlines};

/// A stretch of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightStretch {
    /// The number of the curve in the document.
    pub curve: usize,
    /// The number of its stretch of stability there; `None`: all of a curve without any.
    pub stretch: Option<usize>,
    /// Its points.
    pub points: Vec<Point>,
}

/// The label of a region.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightLabel {
    /// The number of the region in the document.
    pub region: usize,
    /// Lines, the second of which may be empty.
    pub lines: [String; 2],
    /// Its middle.
    pub at: Point,
    /// Where it points at, if it stands beside its region.
    pub tip: Option<Point>,
}

/// Where everything lies in the straightened plane, in the unit square: l to the right, h upwards. The picture of
/// [`draw`](super::draw) in this view has the same places.
pub struct StraightDiagram {
    straight: Straight,
    /// The outlines of each region; a hole is an outline of its own (even-odd rule).
    pub regions: Vec<Vec<Vec<Point>>>,
    /// The curves.
    pub curves: Vec<StraightStretch>,
    /// Lines of constant h.
    pub levels: Vec<Vec<Point>>,
    /// The events, in the order of the document, where they are shown.
    pub events: Vec<Option<Point>>,
    /// The labels.
    pub labels: Vec<StraightLabel>,
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
    pub(super) fn new(page: Page<'_>) -> Result<Self, PlotError> {
        let Diagram { scene, mut panels, texts, .. } = page.into_diagram();
        let panel = panels.swap_remove(0);
        let Some(straight) = &panel.straight else { return Err(PlotError::NotStraight) };
        let unit = |at: Point| in_unit_square(straight, at);
        let units = |line: Vec<Point>| line.into_iter().map(unit).collect::<Vec<Point>>();
        let outline = |cells: &Vec<super::scene::Cell>| outlines(cells.iter().map(|cell| straight.cell(cell)), 0);
        let regions = scene.cells.iter().map(|cells| outline(cells).into_iter().map(units).collect());
        let mut curves = Vec::new();
        for (curve, document) in scene.atlas.curves.iter().enumerate() {
            let mut add = |stretch, range| {
                let points = units(straight.curve(curve, l_range(range)));
                if points.len() > 1 {
                    curves.push(StraightStretch { curve, stretch, points });
                }
            };
            for (number, span) in document.stability.iter().enumerate() {
                add(Some(number), [Some(span.l_from), span.l_to]);
            }
            if document.stability.is_empty() {
                add(None, document.l_range);
            }
        }
        let label = |label: &super::labels::Label| {
            let (rect, name) = (&label.rect, &texts.names[label.region]);
            let middle = [rect.x + rect.width / 2.0, rect.y + rect.height / 2.0];
            let tip = label.leader.map(|[tip, _]| unit(tip));
            StraightLabel { region: label.region, lines: label.setting.texts(name), at: unit(middle), tip }
        };
        let along = |place: usize| move |tick: super::straight::Tick, at: Point| (at[place], tick.label);
        let momenta = straight.momenta().into_iter().map(|tick| {
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
            curves,
            levels: straight.level_lines().into_iter().map(units).collect(),
            events: scene.atlas.events.iter().map(|event| panel.event(&scene, event).map(unit)).collect(),
            labels: texts.labels[0].iter().map(label).collect(),
            momenta: momenta.collect(),
            energies: energies.map(Iterator::collect),
            l_end: straight.l_end().unwrap_or(0.0),
            straight: panel.straight.ok_or(PlotError::NotStraight)?,
        })
    }

    /// Where [h, l] lies; nowhere where there is no motion, and beyond the last l.
    #[must_use]
    pub fn position(&self, point: [f64; 2]) -> Option<Point> {
        self.straight.position(point).map(|at| in_unit_square(&self.straight, at))
    }
}

fn in_unit_square(straight: &Straight, [x, y]: Point) -> Point {
    let rect = &straight.rect;
    [(x - rect.x) / rect.width, (rect.bottom() - y) / rect.height]
}
