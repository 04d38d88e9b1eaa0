//! How much of the width and of the height each part has.

use super::strata::{Slab, SlabSlice, Vertex, near};

/// The shares of the stretches between event momenta and of the regions, of any sum.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shares {
    /// Of the width.
    pub wide: Vec<f64>,
    /// Of the height.
    pub high: Vec<f64>,
}

impl Shares {
    /// The heights of the layers at a station, in any unit. Where a layer ends in a crossing, those beside it have its part,
    /// so that other curves pass by undisturbed.
    pub(super) fn heights(&self, slab: &Slab, station: &SlabSlice) -> Vec<f64> {
        let own = |layer: usize| self.high[slab.layers[layer].region] * station.size[layer];
        let mut heights: Vec<f64> = (0..slab.layers.len()).map(own).collect();
        for Vertex { layer, is_last, opposite } in &slab.points {
            let far = if *is_last { 1.0 - station.share } else { station.share };
            let whole = 0.5 * (self.high[slab.layers[*layer].region] + self.high[*opposite]);
            let free = whole * near(far) * (1.0 - station.size[*layer]).max(0.0);
            let beside = [layer.checked_sub(1), Some(layer + 1)];
            let count = beside.iter().flatten().count() as f64;
            beside.into_iter().flatten().for_each(|other| heights[other] += free / count);
        }
        heights
    }

    /// The ends of the slabs on the page.
    pub(super) fn ends(&self, x: f64, width: f64) -> Vec<f64> {
        let scale = width / self.wide.iter().sum::<f64>();
        let mut sum = 0.0;
        let ends = self.wide.iter().map(|own| {
            sum += own;
            x + scale * sum
        });
        std::iter::once(x).chain(ends).collect()
    }
}
