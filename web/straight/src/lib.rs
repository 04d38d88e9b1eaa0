//! The straightened diagram for JavaScript: where everything lies in it, as rows of numbers. What is drawn comes as the document
//! of an atlas, and energies on its curves are asked of the module that has the atlas.

use bifdiag_plot::{CurveSource, LabelBoxes, PanelTicks, PlotError, StraightPanel, StraightShares};
use bifdiag_schema::AtlasDocument;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Who knows the curves: `Diagram` of the explorer's module.
    pub type Curves;

    /// The energies of a curve at rising momenta; none where there is no such curve.
    #[wasm_bindgen(method)]
    fn energies(this: &Curves, curve: &str, momenta: &[f64]) -> Vec<f64>;
}

struct Source<'a>(&'a Curves);

impl CurveSource for Source<'_> {
    fn polyline(&self, _curve: &str, _l: [f64; 2], _tolerance: f64) -> Option<Vec<[f64; 2]>> {
        None
    }

    fn energies(&self, curve: &str, momenta: &[f64]) -> Option<Vec<f64>> {
        let found = self.0.energies(curve, momenta);
        (found.len() == momenta.len()).then_some(found)
    }
}

/// A panel of the straightened plane, in pixels from its upper left corner.
#[wasm_bindgen]
pub struct Straight {
    shares: StraightShares,
    columns: Vec<f64>,
    curves: Vec<f64>,
    events: Vec<f64>,
    levels: Vec<f64>,
    ticks: [PanelTicks; 3],
    l_end: f64,
}

#[wasm_bindgen]
impl Straight {
    /// The plane of a document in so many pixels. `boxes`: for each region width and height of its label on two lines, on one, and
    /// of its id alone. `held`: the shares of another panel, or none, where as many labels as may be are fit into their regions.
    /// `momenta`: those at which there are columns beside those of the pixels.
    ///
    /// # Errors
    /// A document that is none, or one that does not tell which curves lie above each other.
    #[wasm_bindgen(constructor)]
    pub fn new(
        document: &str,
        curves: &Curves,
        width: f64,
        height: f64,
        boxes: &[f64],
        held: &[f64],
        momenta: &[f64],
    ) -> Result<Self, JsError> {
        let atlas: AtlasDocument = serde_json::from_str(document)?;
        let (boxes, _) = boxes.as_chunks::<6>();
        let boxes: Vec<LabelBoxes> =
            boxes.iter().map(|&[a, b, c, d, e, f]| [[[a, b], [c, d]], [[a, b], [c, d]], [[e, f]; 2]]).collect();
        let regions = boxes.len();
        let held = held
            .split_at_checked(regions)
            .map(|(high, wide)| StraightShares { high: high.to_vec(), wide: wide.to_vec() });
        let source = Source(curves);
        let panel = StraightPanel::new(&atlas, Some(&source), [width, height], &boxes, held.as_ref())?;
        Self::of(&atlas, &panel, momenta).map_err(JsError::from)
    }

    /// The shares of the height that the regions have, then those of the width between event momenta.
    #[must_use]
    pub fn shares(&self) -> Vec<f64> {
        self.shares.high.iter().chain(&self.shares.wide).copied().collect()
    }

    /// For each momentum x, l, the number of curves over it; of each its energy, its y and the number of the region above it,
    /// upwards; then the number of energies above the highest curve, and they: of equal steps towards the upper edge, which
    /// lies at infinity.
    #[must_use]
    pub fn columns(&self) -> Vec<f64> {
        self.columns.clone()
    }

    /// For each curve of the document the number of its points, then l, x, y of each.
    #[must_use]
    pub fn curves(&self) -> Vec<f64> {
        self.curves.clone()
    }

    /// x, y of each event of the document; NaN where it is not in view.
    #[must_use]
    pub fn events(&self) -> Vec<f64> {
        self.events.clone()
    }

    /// For each line of constant h the number of its points, then x, y of each.
    #[must_use]
    pub fn levels(&self) -> Vec<f64> {
        self.levels.clone()
    }

    /// Where round numbers stand on the axis of l (0), of h at l = 0 (1), and of h at the last l (2).
    #[must_use]
    pub fn ticks(&self, axis: usize) -> Vec<f64> {
        self.ticks[axis.min(2)].iter().map(|(at, _)| *at).collect()
    }

    /// Their texts.
    #[must_use]
    pub fn labels(&self, axis: usize) -> Vec<String> {
        self.ticks[axis.min(2)].iter().map(|(_, label)| label.clone()).collect()
    }

    /// The last l.
    #[must_use]
    pub fn l_end(&self) -> f64 {
        self.l_end
    }
}

impl Straight {
    fn of(atlas: &AtlasDocument, panel: &StraightPanel<'_>, momenta: &[f64]) -> Result<Self, PlotError> {
        let mut columns = Vec::new();
        for column in panel.columns(momenta)? {
            columns.extend([column.x, column.l, column.curves.len() as f64]);
            columns.extend(column.curves.iter().flat_map(|&([h, y], region)| [h, y, region as f64]));
            columns.push(column.above.len() as f64);
            columns.extend(column.above);
        }
        let curve = |number| {
            let points = panel.curve(number);
            std::iter::once(points.len() as f64).chain(points.into_iter().flat_map(|(l, [x, y])| [l, x, y]))
        };
        let level = |line: Vec<[f64; 2]>| std::iter::once(line.len() as f64).chain(line.into_iter().flatten());
        Ok(Self {
            shares: panel.shares().clone(),
            columns,
            curves: (0..atlas.curves.len()).flat_map(curve).collect(),
            events: panel.events().into_iter().flat_map(|at| at.unwrap_or([f64::NAN; 2])).collect(),
            levels: panel.levels().into_iter().flat_map(level).collect(),
            ticks: panel.ticks(),
            l_end: panel.l_end(),
        })
    }
}
