//! The return map R of the part P⁻ of the section where Ṡ < 0, the maxima of ⟨γ, r⟩ along motions, for many points at
//! once.

use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::{Monitor, OrbitSection, PpTorus, SectionError, SweepOptions, sweep};

use crate::chart::Surface;
use crate::flow::Phase as Point;

/// A point at which the motion from a start crosses P.
#[derive(Clone, Copy, Debug)]
pub struct Image {
    /// The point.
    pub point: Point,
    /// The time of the crossing.
    pub time: f64,
    /// It is in P⁻, a maximum of ⟨γ, r⟩.
    pub is_maximum: bool,
    /// The distance of the crossing just before or just after it, whichever is nearer: close to the line of tangency,
    /// twice the distance from that line.
    pub pair: f64,
}

/// The crossings of P by the motion through a point, nearest in time first.
#[derive(Clone, Debug, Default)]
pub struct BothWays {
    /// Forward in time.
    pub after: Vec<Image>,
    /// Backward in time; their times are positive as well.
    pub before: Vec<Image>,
}

impl BothWays {
    /// The m-th crossings forward and backward: on a periodic orbit with 2m crossings they coincide.
    #[must_use]
    pub fn ends(&self, m: usize) -> Option<[&Image; 2]> {
        Some([self.after.get(m - 1)?, self.before.get(m - 1)?])
    }
}

/// The return map.
#[derive(Debug)]
pub struct SectionMap<'a> {
    surface: &'a Surface,
    torus: &'a PpTorus,
    /// The longest time for which a motion is followed.
    longest: f64,
    monitor: &'a Monitor,
}

impl<'a> SectionMap<'a> {
    /// For a surface; no motion is followed for longer than `longest`.
    #[must_use]
    pub fn new(surface: &'a Surface, torus: &'a PpTorus, longest: f64, monitor: &'a Monitor) -> Self {
        Self { surface, torus, longest, monitor }
    }

    /// The surface.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        self.surface
    }

    /// R, R², … Rⁿ of each point, in this order; fewer where the motion takes too long.
    ///
    /// # Errors
    /// Those of [`sweep`], and [`SectionError::Interrupted`].
    pub fn images(&self, starts: &[Point], count: usize) -> Result<Vec<Vec<Image>>, SectionError> {
        self.images_within(self.longest, starts, count)
    }

    /// As [`images`](Self::images), with `count` times the longest time.
    ///
    /// # Errors
    /// Those of [`images`](Self::images).
    pub fn distant_images(&self, starts: &[Point], count: usize) -> Result<Vec<Vec<Image>>, SectionError> {
        self.images_within(self.longest * count.max(1) as f64, starts, count)
    }

    fn images_within(&self, max_time: f64, starts: &[Point], count: usize) -> Result<Vec<Vec<Image>>, SectionError> {
        let states: Vec<State> = starts.iter().map(|y| self.surface.state(y)).collect();
        // A motion from P⁻ crosses P⁺ and P⁻ in turn.
        let orbits = self.swept(&states, 2 * count + 1, max_time)?;
        let returns = |orbit: &OrbitSection| {
            crossings(self.surface, orbit).into_iter().filter(|image| image.is_maximum).take(count).collect()
        };
        Ok(orbits.iter().map(returns).collect())
    }

    /// The first crossings of P after each point and the last ones before it, alternating between P⁺ and P⁻; fewer
    /// where the motion takes too long.
    ///
    /// # Errors
    /// Those of [`images`](Self::images).
    pub fn both_ways(&self, starts: &[Point], count: usize) -> Result<Vec<BothWays>, SectionError> {
        // The motion through (γ, l) backward in time is that through (γ, −l), which has the momentum −l about the
        // vertical.
        let back = self.surface.reversed();
        let after = starts.iter().map(|y| self.surface.state(y));
        let before = starts.iter().map(|y| back.state(&reversed(y)));
        let states: Vec<State> = after.chain(before).collect();
        // One crossing more shows whether the last one was just born.
        let orbits = self.swept(&states, count + 1, self.longest)?;
        let (after, before) = orbits.split_at(starts.len());
        let ways = after.iter().zip(before).map(|(after, before)| {
            let [mut after, mut before] = [crossings(self.surface, after), crossings(&back, before)];
            after.truncate(count);
            before.truncate(count);
            for image in &mut before {
                image.point = reversed(&image.point);
            }
            BothWays { after, before }
        });
        Ok(ways.collect())
    }

    fn swept(&self, states: &[State], crossings: usize, max_time: f64) -> Result<Vec<OrbitSection>, SectionError> {
        let options = SweepOptions { crossings, max_time, ..SweepOptions::default() };
        let orbits = sweep(self.torus, states, &options, self.monitor)?;
        if self.monitor.is_stopped() {
            return Err(SectionError::Interrupted);
        }
        Ok(orbits)
    }
}

/// The point at −l whose motion is the same one run backward.
#[must_use]
pub fn reversed(y: &Point) -> Point {
    Point::new(y[0], y[1], y[2], -y[3], -y[4], -y[5])
}

/// The crossings of P after a start on P.
fn crossings(surface: &Surface, orbit: &OrbitSection) -> Vec<Image> {
    let mut images: Vec<Image> = Vec::with_capacity(orbit.points.len());
    for crossing in orbit.points.iter().filter(|point| point.index > 0) {
        let point = surface.point(&State { gamma: crossing.gamma, l: crossing.l });
        let mut pair = f64::INFINITY;
        if let Some(last) = images.last_mut() {
            pair = (point - last.point).norm();
            last.pair = last.pair.min(pair);
        }
        let (time, is_maximum) = (crossing.time + crossing.time_low, crossing.s_dot < 0.0);
        images.push(Image { point, time, is_maximum, pair });
    }
    images
}
