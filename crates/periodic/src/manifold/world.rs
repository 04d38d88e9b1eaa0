//! The section and its return map, forward and backward in time.

use bifdiag_dynamics::integrator::Taylor;
use bifdiag_dynamics::section::SectionError;
use bifdiag_schema::ManifoldKind;

use crate::chart::Surface;
use crate::flow::Phase;
use crate::section_map::{Image, SectionMap, reversed};

/// The section and its map, at l or, reversed, at −l.
pub struct World<'a> {
    /// Of the section there.
    pub map: SectionMap<'a>,
    /// At −l.
    pub is_reversed: bool,
    /// The equilibria at this energy whose manifolds are wanted.
    pub rests: Vec<Phase>,
    /// A return that takes no longer passes none of them.
    pub long: f64,
}

/// The returns of a motion.
pub struct Course {
    /// The first ones.
    pub images: Vec<Image>,
    /// Then it comes to within [`REST`] of an equilibrium.
    pub came: bool,
}

/// A motion that comes so near to an equilibrium is not followed beyond: what was rounded would decide where it goes.
pub const REST: f64 = 1e-5;
/// Times that a motion without a further return is looked after.
const WAIT: f64 = 6.0;
/// Looks at a step.
const LOOKS: u32 = 4;
/// Truncation error of a motion of which only the distance is asked.
const TOLERANCE: f64 = 1e-12;

impl World<'_> {
    /// The section.
    pub fn surface(&self) -> &Surface {
        self.map.surface()
    }

    /// Which manifolds the motions that leave fill here, at l.
    pub fn kind(&self) -> ManifoldKind {
        if self.is_reversed { ManifoldKind::Stable } else { ManifoldKind::Unstable }
    }

    /// A point of this world in the other one: the way back is the same.
    pub fn seen(&self, y: &Phase) -> Phase {
        if self.is_reversed { reversed(y) } else { *y }
    }

    /// As [`SectionMap::distant_images`], as far as no equilibrium is near.
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

    /// Whether a motion comes so near to an equilibrium in a time.
    pub fn passes(&self, start: &Phase, time: f64, distance: f64) -> bool {
        if time < self.long {
            return false;
        }
        let surface = self.surface();
        let Ok(mut taylor) = Taylor::new(surface.top(), &surface.state(start), TOLERANCE) else { return false };
        while let Ok(step) = taylor.step() {
            let mut parts = (1..=LOOKS).map(|k| f64::from(k) / f64::from(LOOKS));
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
