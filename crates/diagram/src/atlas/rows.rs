//! Many points at one l: the heights of the curves are computed once.

use super::Atlas;
use super::locate::comparison_error;
use crate::arrangement::RegionId;
use bifdiag_body::Number;
use bifdiag_equilibria::curves::{MomentumError, abscissa};

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
        mut decide: impl FnMut(&Number, &Number) -> Spot,
    ) -> Result<Vec<Spot>, MomentumError> {
        let frame = &self.arrangement.set.frame;
        let x = abscissa(frame, l)?;
        let slab = self.slab_at(x);
        let near = self.slabs_near(slab, x, true);
        let clear = x > 0.0 && near.start() == near.end() && self.order_is_certain(slab, x);
        let points = if clear { self.points_in(slab, x) } else { Vec::new() };
        let region_above = &self.arrangement.slabs[slab].region_above;
        let mut ask = |h: f64| {
            let (Ok(h), Ok(l)) = (Number::from_f64(h), Number::from_f64(l)) else { return Spot::Undecided };
            decide(&h, &l)
        };
        let spots = h.iter().map(|&given| {
            let h = given / frame.energy_unit;
            let below = points.partition_point(|point| point.h() <= h);
            let far = |point: &_| (h - bifdiag_equilibria::curves::Point::h(point)).abs() > comparison_error(point, h);
            let sides = below.checked_sub(1).and_then(|k| points.get(k)).into_iter().chain(points.get(below));
            if !clear || !sides.into_iter().all(far) {
                return ask(given);
            }
            below.checked_sub(1).map_or(Spot::Forbidden, |k| Spot::Region(region_above[k]))
        });
        Ok(spots.collect())
    }
}
