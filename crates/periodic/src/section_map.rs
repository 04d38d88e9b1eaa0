//! The return map R of the part P⁻ of the section where Ṡ < 0, the maxima of ⟨γ, r⟩ along motions, for many points at once.

use bifdiag_dynamics::field::State;
use bifdiag_dynamics::section::{Monitor, PpTorus, SectionError, SectionPoint, SweepOptions, sweep};

use crate::chart::Surface;
use crate::flow::Phase as Point;

/// A point in which the motion from a start crosses P⁻.
#[derive(Clone, Copy, Debug)]
pub struct Image {
    /// The point.
    pub point: Point,
    /// When.
    pub time: f64,
    /// Crossings of P until then, this one counted.
    pub crossings: u32,
    /// How far the crossing of P⁺ just before or just after it is: twice the distance from the line of tangency, near it.
    pub pair: f64,
}

/// The return map.
#[derive(Debug)]
pub struct SectionMap<'a> {
    surface: &'a Surface,
    torus: &'a PpTorus,
    /// A time after which nobody waits for a return.
    longest: f64,
    monitor: &'a Monitor,
}

impl<'a> SectionMap<'a> {
    /// Of a surface; `longest` bounds the time of a motion.
    #[must_use]
    pub fn new(surface: &'a Surface, torus: &'a PpTorus, longest: f64, monitor: &'a Monitor) -> Self {
        Self { surface, torus, longest, monitor }
    }

    /// The surface.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        self.surface
    }

    /// R, R², … Rⁿ of each point, in this order; fewer where the motion ends before.
    ///
    /// # Errors
    /// Those of [`sweep`], and [`SectionError::Interrupted`].
    pub fn images(&self, starts: &[Point], count: usize) -> Result<Vec<Vec<Image>>, SectionError> {
        self.images_within(self.longest, starts, count)
    }

    /// As [`images`](Self::images), but each return may take as long as a whole motion may there.
    ///
    /// # Errors
    /// Those of [`images`](Self::images).
    pub fn distant_images(&self, starts: &[Point], count: usize) -> Result<Vec<Vec<Image>>, SectionError> {
        self.images_within(self.longest * count.max(1) as f64, starts, count)
    }

    fn images_within(&self, max_time: f64, starts: &[Point], count: usize) -> Result<Vec<Vec<Image>>, SectionError> {
        let states: Vec<State> = starts.iter().map(|y| self.surface.state(y)).collect();
        // A motion from P⁻ crosses P⁺ and P⁻ in turn.
        let options = SweepOptions { crossings: 2 * count + 1, max_time, ..SweepOptions::default() };
        let orbits = sweep(self.torus, &states, &options, self.monitor)?;
        if self.monitor.is_stopped() {
            return Err(SectionError::Interrupted);
        }
        Ok(orbits.iter().map(|orbit| self.returns(&orbit.points, count)).collect())
    }

    fn returns(&self, points: &[SectionPoint], count: usize) -> Vec<Image> {
        let place = |point: &SectionPoint| self.surface.point(&State { gamma: point.gamma, l: point.l });
        let mut images: Vec<Image> = Vec::with_capacity(count);
        // The crossing of P⁺ before.
        let mut before: Option<Point> = None;
        for crossing in points.iter().filter(|point| point.index > 0) {
            let here = place(crossing);
            if crossing.s_dot < 0.0 {
                if images.len() == count {
                    break;
                }
                let pair = before.map_or(f64::INFINITY, |other| (here - other).norm());
                let time = crossing.time + crossing.time_low;
                images.push(Image { point: here, time, crossings: crossing.index, pair });
            } else {
                if let Some(last) = images.last_mut() {
                    last.pair = last.pair.min((here - last.point).norm());
                }
                before = Some(here);
            }
        }
        images
    }
}
