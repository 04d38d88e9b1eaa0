//! The section and its return map, forward and backward in time.

use bifdiag_dynamics::integrator::Taylor;
use bifdiag_dynamics::section::SectionError;
use bifdiag_schema::ManifoldKind;

use crate::chart::Surface;
use crate::flow::Phase;
use crate::section_map::{Image, SectionMap, reversed};

/// The section and its map, at l or, reversed, at −l.
pub struct World<'a> {
    /// The return map there.
    pub map: SectionMap<'a>,
    /// It is at −l.
    pub is_reversed: bool,
    /// The equilibria at this energy whose manifolds are followed.
    pub rests: Vec<Phase>,
    /// A return that takes less time passes none of them.
    pub long: f64,
}

/// The returns of a motion.
pub struct Course {
    /// The first ones.
    pub images: Vec<Image>,
    /// After these it comes within [`REST`] of an equilibrium.
    pub came: bool,
}

/// A motion that comes this close to an equilibrium is followed no further: rounding would decide where it goes.
pub const REST: f64 = 1e-5;
/// How long a motion without a further return is checked for equilibria, in units of `long`.
const WAIT: f64 = 6.0;
/// Points of a step at which the distance is checked.
const SAMPLES: u32 = 4;
/// Truncation error where only distances from equilibria are needed.
const TOLERANCE: f64 = 1e-12;

impl World<'_> {
    /// The section.
    pub fn surface(&self) -> &Surface {
        self.map.surface()
    }

    /// The kind of manifold, at l, of motions that leave an orbit in this world.
    pub fn kind(&self) -> ManifoldKind {
        if self.is_reversed { ManifoldKind::Stable } else { ManifoldKind::Unstable }
    }

    /// A point of this world as a point at l, and back: the map is its own inverse.
    pub fn mirrored(&self, y: &Phase) -> Phase {
        if self.is_reversed { reversed(y) } else { *y }
    }

    /// As [`SectionMap::distant_images`], but only up to where an equilibrium is near.
    pub fn courses(&self, starts: &[Phase], count: usize) -> Result<Vec<Course>, SectionError> {
        let images = self.map.distant_images(starts, count)?;
        Ok(starts.iter().zip(images).map(|(start, images)| self.course(start, images, count)).collect())
    }

    fn course(&self, start: &Phase, mut images: Vec<Image>, count: usize) -> Course {
        if self.rests.is_empty() {
            return Course { images, came: false };
        }
        let (mut last, mut since) = (*start, 0.0);
        for k in 0..images.len() {
            let Image { point, time, .. } = images[k];
            if self.is_near(&point, REST) || self.passes(&last, time - since, REST) {
                images.truncate(k);
                return Course { images, came: true };
            }
            (last, since) = (point, time);
        }
        let came = images.len() < count && self.passes(&last, WAIT * self.long, REST);
        Course { images, came }
    }

    fn is_near(&self, y: &Phase, distance: f64) -> bool {
        self.rests.iter().any(|rest| (y - rest).norm() < distance)
    }

    /// Whether a motion comes within a distance of an equilibrium in the given time.
    pub fn passes(&self, start: &Phase, time: f64, distance: f64) -> bool {
        if time < self.long {
            return false;
        }
        let surface = self.surface();
        let Ok(mut taylor) = Taylor::new(surface.top(), &surface.state(start), TOLERANCE) else { return false };
        while let Ok(step) = taylor.step() {
            let mut parts = (1..=SAMPLES).map(|k| f64::from(k) / f64::from(SAMPLES));
            let near = |x: f64| {
                let is_within = step.start().seconds() + x * step.length() <= time;
                is_within && self.is_near(&surface.point(&step.state(x)), distance)
            };
            if parts.any(near) {
                return true;
            }
            if step.end().seconds() >= time {
                break;
            }
        }
        false
    }
}
