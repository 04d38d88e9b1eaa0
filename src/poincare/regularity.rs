//! How regular the orbits of a section are.

use super::{PoincareSection, Setting};
use crate::document::{ChaosDocument, LyapunovDocument, RotationAngleName, RotationDocument};
use crate::section::chaos::{ChaosMeasure, ChaosOptions, Rotation, RotationAngle, chaos_measures};
use crate::section::{Monitor, SectionError};

impl Setting {
    /// Adds Lyapunov exponents and rotation numbers to the orbits of a document. The orbits are integrated once more;
    /// where `monitor` stops that, they have no exponent and the document is not complete.
    ///
    /// # Errors
    /// Those of [`chaos_measures`].
    pub fn measure(
        &self,
        section: &mut PoincareSection,
        options: &ChaosOptions,
        monitor: &Monitor,
    ) -> Result<(), SectionError> {
        let measures = chaos_measures(&self.torus, &section.orbits, options, monitor)?;
        for (orbit, measure) in section.document.orbits.iter_mut().zip(&measures) {
            orbit.chaos = Some(measure.into());
        }
        if monitor.stop.load(std::sync::atomic::Ordering::Relaxed) && section.document.complete {
            section.document.complete = false;
            section.document.notes.push("the run was interrupted: Lyapunov exponents are missing".to_owned());
        }
        Ok(())
    }
}

impl From<&ChaosMeasure> for ChaosDocument {
    fn from(measure: &ChaosMeasure) -> Self {
        let lyapunov = measure.lyapunov.map(|found| LyapunovDocument {
            exponent: found.exponent,
            exponent_half: found.exponent_half,
            mean_rate: found.mean_rate,
            mean_rate_half: found.mean_rate_half,
            time: found.time,
        });
        let rotation = measure.rotation.as_ref();
        Self {
            lyapunov,
            rotation: rotation.ok().map(RotationDocument::from),
            no_rotation: rotation.err().map(ToString::to_string),
        }
    }
}

impl From<&Rotation> for RotationDocument {
    fn from(rotation: &Rotation) -> Self {
        let (angle, islands) = match rotation.angle {
            RotationAngle::Axis => (RotationAngleName::Axis, None),
            RotationAngle::Mean => (RotationAngleName::Mean, None),
            RotationAngle::Curve => (RotationAngleName::Curve, None),
            RotationAngle::Islands(count) => (RotationAngleName::Islands, Some(count)),
        };
        Self { number: rotation.number, error: rotation.error, angle, islands, returns: rotation.returns }
    }
}
