//! The (h, l) diagram of one body as numbers to draw, for any part of the plane.

use bifdiag::diagram::atlas::Place;
use bifdiag::documents::words;
use bifdiag::equilibria::curves::CurveName;
use bifdiag::numbers::table::Id;
use bifdiag::schema::AtlasDocument;
use bifdiag::{Accuracy, Atlas, atlas};
use wasm_bindgen::prelude::*;

use crate::body::{Refused, body};
use crate::texts;

/// The regions of one body, ready to draw and to answer points.
#[wasm_bindgen]
pub struct Diagram {
    atlas: Atlas,
    document: AtlasDocument,
}

#[wasm_bindgen]
impl Diagram {
    /// Of a body.
    ///
    /// # Errors
    /// A body that is none, or one whose regions `f64` cannot tell apart.
    #[wasm_bindgen(constructor)]
    pub fn new(text: &str) -> Result<Self, JsError> {
        let atlas = atlas(&body(text)?, Accuracy::Fast).map_err(Refused::from)?;
        let document = texts::sketch(&atlas);
        Ok(Self { atlas, document })
    }

    /// The document of the atlas, as the fast accuracy gives it.
    ///
    /// # Errors
    /// None that a user could cause.
    pub fn document(&self) -> Result<String, JsError> {
        Ok(texts::text(&self.document)?)
    }

    /// Curves within l ∈ [from, to], off by at most `tolerance` in h: for each name its number of points, then h, l of each.
    #[must_use]
    pub fn curves(&self, names: Vec<String>, from: f64, to: f64, tolerance: f64) -> Vec<f64> {
        let mut numbers = Vec::new();
        for name in names {
            let points =
                name.parse::<CurveName>().ok().and_then(|name| self.atlas.polyline(name, [from, to], tolerance));
            let points = points.unwrap_or_default();
            numbers.push(points.len() as f64);
            numbers.extend(points.into_iter().flatten());
        }
        numbers
    }

    /// The energies of a curve at rising momenta within its range; none where there is no such curve.
    #[must_use]
    pub fn energies(&self, curve: &str, momenta: &[f64]) -> Vec<f64> {
        let name = curve.parse::<CurveName>().ok();
        name.and_then(|name| self.atlas.energies(name, momenta)).unwrap_or_default()
    }

    /// The regions met at `count` momenta in the middles of equal parts of [from, to]: for each the number of curves over
    /// it, then h of each curve and the number of the region above it, rising.
    #[must_use]
    pub fn columns(&self, from: f64, to: f64, count: u32) -> Vec<f64> {
        let arrangement = self.atlas.arrangement();
        let (set, slabs) = (&arrangement.set, arrangement.slabs.as_slice());
        let mut numbers = Vec::new();
        if slabs.is_empty() {
            return numbers;
        }
        for column in 0..count {
            let l = from + (to - from) * (f64::from(column) + 0.5) / f64::from(count);
            let scaled = l / set.frame.momentum_unit;
            let x = 0.5 * scaled * scaled;
            let slab = &slabs[slabs.partition_point(|slab| slab.x[1] < x).min(slabs.len() - 1)];
            numbers.push(slab.order.len() as f64);
            for (&curve, region) in slab.order.iter().zip(&slab.region_above) {
                numbers.push(self.atlas.energy(set.curves[curve].point(&set.frame, x).h()));
                numbers.push(region.index() as f64);
            }
        }
        numbers
    }

    /// What lies at (h, l): the number of the region (−1 forbidden, −2 undecided), the distance in h to the nearest
    /// curve, the bound on its error.
    ///
    /// # Errors
    /// l out of range.
    pub fn locate(&self, h: f64, l: f64) -> Result<Vec<f64>, JsError> {
        let found = self.atlas.locate(h, l)?;
        let region = match found.place {
            Place::Region(region) => region.index() as f64,
            Place::Forbidden => -1.0,
            Place::Undecided(_) => -2.0,
        };
        Ok(vec![region, found.distance, found.error_bound])
    }

    /// What happens on the straight way from one point to another: a sentence for each curve that it goes over.
    ///
    /// # Errors
    /// l out of range.
    pub fn surgeries(&self, from: &[f64], to: &[f64]) -> Result<Vec<String>, JsError> {
        let point = |numbers: &[f64]| <[f64; 2]>::try_from(numbers).map_err(|_| JsError::new("a point is [h, l]"));
        let passages = self.atlas.passages(point(from)?, point(to)?)?;
        Ok(passages.iter().map(|passage| words::passage(&self.atlas, &self.document, passage)).collect())
    }

    /// The id of the curve nearest to (h, l) in h.
    ///
    /// # Errors
    /// l out of range.
    pub fn nearest(&self, h: f64, l: f64) -> Result<String, JsError> {
        Ok(CurveName::of(&self.atlas.arrangement().set, self.atlas.locate(h, l)?.nearest).to_string())
    }
}
