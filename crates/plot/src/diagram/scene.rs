//! An atlas with its ids resolved to indices.

use std::collections::BTreeMap;

use super::ranges::l_range;
use crate::page::PlotError;
use schema::AtlasDocument;

/// Where polylines denser than those of the document come from.
pub trait CurveSource {
    /// Points [h, l] of the curve by rising l that cover the common part of its range and `l`, such that the straight
    /// line between neighbours is off by at most `tolerance` in h. `None`: the document's polyline is used.
    fn polyline(&self, curve: &str, l: [f64; 2], tolerance: f64) -> Option<Vec<[f64; 2]>>;
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

/// What is drawn.
pub(super) struct Scene<'a> {
    pub atlas: &'a AtlasDocument,
    pub source: Option<&'a dyn CurveSource>,
    /// The cells of every region, in the order of the regions.
    pub cells: Vec<Vec<Cell>>,
}

impl<'a> Scene<'a> {
    pub(super) fn new(atlas: &'a AtlasDocument, source: Option<&'a dyn CurveSource>) -> Result<Self, PlotError> {
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
        Ok(Self { atlas, source, cells: cells.collect::<Result<_, _>>()? })
    }
}
