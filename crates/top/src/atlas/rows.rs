//! Many points at one l: the heights of the curves are computed once.

use super::Atlas;
use super::locate::{MomentumError, abscissa, comparison_error};
use crate::body::Number;
use crate::diagram::{RegionId, SlabId};
use crate::table::Id;
use crate::topology::Answer;

/// Where a point of a row lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// Inside this region.
    Region(RegionId),
    /// Below the lowest critical value.
    Forbidden,
    /// Exactly on a curve.
    Critical,
    /// Not known.
    Undecided,
}

impl Atlas {
    /// Where each (h, l) of a row lies. The curves decide where they are farther than their error bounds; nearer points, and
    /// rows at l = 0 or within rounding of an event, are asked of `decide`: each double stands for its shortest decimal.
    ///
    /// # Errors
    /// [`MomentumError`] when l is out of range.
    pub fn row(
        &self,
        l: f64,
        h: &[f64],
        mut decide: impl FnMut(&Number, &Number) -> Answer,
    ) -> Result<Vec<Spot>, MomentumError> {
        let frame = &self.arrangement.set.frame;
        let x = abscissa(frame, l)?;
        let slabs = &self.arrangement.slabs;
        let slab = SlabId::at(slabs.as_slice().partition_point(|slab| slab.x[1] < x).min(slabs.len() - 1));
        let near = self.slabs_near(slab, x, true);
        let clear = x > 0.0 && near.start() == near.end() && self.order_is_certain(slab, x);
        let points = if clear { self.points_in(slab, x) } else { Vec::new() };
        let region_above = &slabs[slab].region_above;
        let mut ask = |h: f64| {
            let (Ok(h), Ok(l)) = (Number::from_f64(h), Number::from_f64(l)) else { return Spot::Undecided };
            self.spot(&h, &l, &decide(&h, &l))
        };
        let spots = h.iter().map(|&given| {
            let h = given / frame.energy_unit;
            let below = points.partition_point(|point| point.h() <= h);
            let far = |point: &_| (h - crate::curves::Point::h(point)).abs() > comparison_error(point, h);
            let sides = below.checked_sub(1).and_then(|k| points.get(k)).into_iter().chain(points.get(below));
            if !clear || !sides.into_iter().all(far) {
                return ask(given);
            }
            below.checked_sub(1).map_or(Spot::Forbidden, |k| Spot::Region(region_above[k]))
        });
        Ok(spots.collect())
    }

    /// Where a point of known type lies.
    #[must_use]
    pub fn spot(&self, h: &Number, l: &Number, answer: &Answer) -> Spot {
        match answer {
            Answer::Critical(_) => Spot::Critical,
            Answer::Undecided(_) => Spot::Undecided,
            Answer::Forbidden => Spot::Forbidden,
            Answer::Regular(_) => match self.places(h, l, answer).as_deref() {
                Some([Some(region)]) => Spot::Region(*region),
                _ => Spot::Undecided,
            },
        }
    }
}
