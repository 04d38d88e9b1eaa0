//! What is drawn and how: the options, and an atlas with its ids resolved to indices.

use std::collections::BTreeMap;

use super::plan::Plan;
use super::windows::l_range;
use bifdiag_page::{PlotError, Theme, Width, is_proper};
use bifdiag_schema::{AtlasDocument, RegionDocument, RelativeEquilibriumDocument, SlowdownDocument, WindowDocument};

/// In which coordinates the plane is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DiagramView {
    /// Straightened where that saves more than two insets, else plane.
    #[default]
    Auto,
    /// h to the right, l upwards, with insets for what is small.
    Plane,
    /// l to the right, h upwards from the level lowest curve, each region as high as its label needs.
    Straight,
}

/// The place of the legend of a diagram. What is not in the picture is in its caption.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LegendPlace {
    /// In the picture, as long as that is not too high, else apart.
    #[default]
    Auto,
    /// In no picture.
    None,
    /// In the picture.
    Below,
    /// In a picture of its own.
    Apart,
}

/// The title of a diagram.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum DiagramTitle {
    /// The body.
    #[default]
    Body,
    /// A text.
    Text(String),
    /// Nothing.
    None,
}

/// How a diagram is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DiagramOptions {
    /// The part of the (h, l) plane of the main panel; `None`: chosen so that every event and every unbounded region
    /// is inside.
    pub window: Option<WindowDocument>,
    /// Points marked in place of the samples of the regions.
    pub points: Option<MarkedPoints>,
    /// Colours.
    pub theme: Theme,
    /// For what width the panels are laid out.
    pub width: Width,
    /// In which coordinates.
    pub view: DiagramView,
    /// Leaves the samples of the regions out, if no points are marked in their place.
    pub no_samples: bool,
    /// The place of the legend.
    pub legend: LegendPlace,
    /// The title.
    pub title: DiagramTitle,
    /// Whether the table of small motions is in the picture, if all of it fits there.
    pub table: bool,
}

/// Where polylines denser than those of the document come from.
pub trait CurveSource {
    /// Points [h, l] of the curve by rising l that cover the common part of its range and `l`, such that the straight
    /// line between neighbours is off by at most `tolerance` in h, or where the curve is steep by what cannot be seen in l.
    /// `None`: the document's polyline is used.
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>>;

    /// The energies of a curve at rising momenta within its range, exactly. `None`: those of a polyline are used.
    fn energies(&self, curve: &str, momenta: &[f64]) -> Option<Vec<f64>> {
        /// Chords need not be close to the curve where only their ends are used.
        const LOOSE: f64 = 1e30;
        let ends = |pair: &[f64]| {
            let points = self.polyline(curve, [pair[0], pair[1]], LOOSE)?;
            Some([points.first()?[0], points.last()?[0]])
        };
        let pairs: Vec<[f64; 2]> = momenta.windows(2).map(ends).collect::<Option<_>>()?;
        (!pairs.is_empty()).then_some(())?;
        Some(pairs.iter().map(|pair| pair[0]).chain(pairs.last().map(|pair| pair[1])).collect())
    }

    /// The relative equilibria at l, for the table of small motions; none where it is not wanted.
    fn equilibria(&self, _l: f64) -> Vec<RelativeEquilibriumDocument> {
        Vec::new()
    }
}

/// The curves of an atlas, for the tests of this folder.
#[cfg(test)]
pub(super) struct Curves(pub bifdiag_diagram::atlas::Atlas);

#[cfg(test)]
impl CurveSource for Curves {
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>> {
        self.0.polyline(curve.parse().ok()?, l, tolerance)
    }
}

/// A piece of a region between two curves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// Range of l; the upper end may be infinite.
    pub l: [f64; 2],
    /// Index of the curve at the lower h.
    pub lower: usize,
    /// Index of the curve at the upper h; `None`: unbounded.
    pub upper: Option<usize>,
}

/// Points that a diagram marks in place of the samples of the regions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MarkedPoints {
    /// [h, l] of each.
    pub points: Vec<[f64; 2]>,
    /// What the legend says they are.
    pub text: String,
    /// The way of a rotation that slows down, drawn below the curves.
    pub way: Vec<SlowdownDocument>,
}

/// A piece of a way.
pub(super) enum Step {
    /// Along a curve, by index, over a range of l.
    Along(usize, [f64; 2]),
    /// From one point [h, l] to another.
    Fall([[f64; 2]; 2]),
}

/// A point that is marked by a dot.
pub(super) struct Dot {
    /// [h, l].
    pub at: [f64; 2],
    /// Its id among the dots of a panel.
    pub id: String,
    /// The tooltip.
    pub title: String,
}

/// What is drawn.
pub(super) struct Scene<'a> {
    pub atlas: &'a AtlasDocument,
    pub source: Option<&'a dyn CurveSource>,
    /// How large the panels are.
    pub plan: Plan,
    /// The cells of every region, in the order of the regions.
    pub cells: Vec<Vec<Cell>>,
    /// Points that are marked.
    pub dots: Vec<Dot>,
    /// The way that is followed.
    pub way: Vec<Step>,
}

/// The stretches of a way, and the falls between them.
fn steps(way: &[SlowdownDocument], curves: &BTreeMap<&str, usize>) -> Vec<Step> {
    let mut steps = Vec::new();
    for (number, stretch) in way.iter().enumerate() {
        // A rotation that falls at once stays on its curve for a moment only.
        let curve = curves.get(stretch.curve.as_str()).filter(|_| stretch.l[0] != stretch.l[1]);
        steps.extend(curve.map(|&curve| Step::Along(curve, [stretch.l[1], stretch.l[0]])));
        if let Some(next) = way.get(number + 1) {
            steps.push(Step::Fall([[stretch.h[1], stretch.l[1]], [next.h[0], next.l[0]]]));
        }
    }
    steps
}

/// The points that were asked for, else the samples of the regions; in the straightened plane every region is seen without its
/// sample, which would take the room of its label.
fn dots(atlas: &AtlasDocument, options: &DiagramOptions, plan: &Plan) -> Vec<Dot> {
    let place = |[h, l]: [f64; 2]| format!("h = {h}, l = {l}");
    if let Some(marked) = &options.points {
        let dot = |(number, &at): (usize, &[f64; 2])| Dot { at, id: (number + 1).to_string(), title: place(at) };
        return marked.points.iter().enumerate().map(dot).collect();
    }
    let dot = |region: &RegionDocument| {
        let at = [region.sample.h, region.sample.l];
        Dot { at, id: region.id.clone(), title: format!("sample of {}: {}", region.id, place(at)) }
    };
    // Within its error a sample may lie in another region.
    let is_inside = |region: &&RegionDocument| region.sample.margin.h > region.sample.margin.error_bound;
    let are_drawn = !plan.straight && !options.no_samples;
    atlas.regions.iter().filter(|region| are_drawn && is_inside(region)).map(dot).collect()
}

impl<'a> Scene<'a> {
    pub(super) fn new(
        atlas: &'a AtlasDocument,
        source: Option<&'a dyn CurveSource>,
        options: &DiagramOptions,
        plan: Plan,
    ) -> Result<Self, PlotError> {
        let curves: BTreeMap<&str, usize> =
            atlas.curves.iter().enumerate().map(|(index, curve)| (curve.id.as_str(), index)).collect();
        let cells = atlas.regions.iter().map(|region| {
            let find = |curve: &String| {
                let unknown = || PlotError::UnknownCurve { region: region.id.clone(), curve: curve.clone() };
                curves.get(curve.as_str()).copied().ok_or_else(unknown)
            };
            let cells = region.cells.iter().map(|cell| {
                Ok(Cell {
                    l: l_range(cell.l_range),
                    lower: find(&cell.lower)?,
                    upper: cell.upper.as_ref().map(find).transpose()?,
                })
            });
            cells.collect::<Result<Vec<Cell>, PlotError>>()
        });
        let way = options.points.as_ref().map_or_else(Vec::new, |marked| steps(&marked.way, &curves));
        Ok(Self {
            atlas,
            source,
            plan,
            cells: cells.collect::<Result<_, _>>()?,
            dots: dots(atlas, options, &plan),
            way,
        })
    }
}

/// The sets of curves with the same (h, l), by index, each set once.
pub(super) fn coincidences(atlas: &AtlasDocument) -> Vec<Vec<usize>> {
    let mut set_of: Vec<usize> = (0..atlas.curves.len()).collect();
    for (index, curve) in atlas.curves.iter().enumerate() {
        for other in &curve.coincides_with {
            let Some(other) = atlas.curves.iter().position(|candidate| candidate.id == *other) else { continue };
            let (keep, drop) = (set_of[index].min(set_of[other]), set_of[index].max(set_of[other]));
            set_of.iter_mut().filter(|set| **set == drop).for_each(|set| *set = keep);
        }
    }
    let mut sets: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (index, set) in set_of.into_iter().enumerate() {
        sets.entry(set).or_default().push(index);
    }
    sets.into_values().collect()
}

/// The part of the plane that the main panel shows, and the part that insets may show: the window that was asked for, or the
/// main one and the whole of the body's view.
pub(super) fn windows(scene: &Scene<'_>, asked: Option<WindowDocument>) -> Result<[WindowDocument; 2], PlotError> {
    let drawing = scene.atlas.drawing.as_ref();
    let windows = match (asked.or(scene.atlas.window), drawing.map(|drawing| drawing.view)) {
        (Some(window), _) => [window; 2],
        (None, Some(view)) => [view.main, view.everything],
        (None, None) => return Err(PlotError::NoDrawing),
    };
    let WindowDocument { h, l } = windows[0];
    if is_proper(h) && is_proper(l) { Ok(windows) } else { Err(PlotError::EmptyWindow { h, l }) }
}
