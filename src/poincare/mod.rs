//! The Poincaré section of one body at one (h, l), from the question to the document: is there one, where do its orbits
//! start, how did they go.

mod error;
mod regularity;
mod report;
mod starts;

pub use error::PoincareError;

use crate::accessible::{AccessibleRegion, component_of};
use crate::body::{Body, Number};
use crate::classify::classify;
use crate::critical::critical;
use crate::document::{ClassificationDocument, OrbitDocument, SectionDocument, StartsDocument, Status};
use crate::dynamics::{HeavyTop, State};
use crate::section::{Monitor, OrbitSection, PpTorus, SectionError, SweepOptions, TorusPoint, sweep};

/// A body and a point (h, l) that have a section: r ≠ 0, and (h, l) is accessible and on no curve.
#[derive(Clone, Debug)]
pub struct Setting {
    torus: PpTorus,
    classification: ClassificationDocument,
    region: AccessibleRegion,
    h: f64,
    l: f64,
}

/// A section that was computed.
#[derive(Clone, Debug, PartialEq)]
pub struct PoincareSection {
    /// What it was made of, and how well each orbit went.
    pub document: SectionDocument,
    /// The points.
    pub orbits: Vec<OrbitSection>,
}

impl Setting {
    /// Looks whether there is a section.
    ///
    /// # Errors
    /// [`PoincareError::WeightlessBody`] for r = 0; [`PoincareError::Forbidden`] names the lowest energy;
    /// [`PoincareError::OnCurve`] and [`PoincareError::Undecided`] name the curve; others when the body or l leave the
    /// range of `f64`.
    pub fn new(body: &Body, h: &Number, l: &Number) -> Result<Self, PoincareError> {
        if body.flags().euler {
            return Err(PoincareError::WeightlessBody);
        }
        let classification = classify(body, h, l)?;
        let margin = &classification.margin;
        let (h_text, l_text) = (h.text().to_owned(), l.text().to_owned());
        match classification.status {
            Status::Regular => {}
            Status::Forbidden => {
                let lowest = critical(body, l)?.critical.into_iter().next();
                return Err(PoincareError::Forbidden {
                    h: h_text,
                    l: l_text,
                    lowest: lowest.as_ref().map_or(f64::NAN, |point| point.h),
                    branch: lowest.map_or_else(String::new, |point| point.branch),
                });
            }
            Status::Critical => {
                return Err(PoincareError::OnCurve { h: h_text, l: l_text, curve: margin.nearest.clone() });
            }
            Status::Undecided => {
                return Err(PoincareError::Undecided {
                    h: h_text,
                    l: l_text,
                    curve: margin.nearest.clone(),
                    distance: margin.h,
                    error_bound: margin.error_bound,
                });
            }
        }
        let torus = PpTorus::new(&HeavyTop::new(body))?;
        let (h, l) = (h.to_f64(), l.to_f64());
        Ok(Self { torus, region: AccessibleRegion::new(body, h, l)?, classification, h, l })
    }

    /// The PP-torus.
    #[must_use]
    pub fn torus(&self) -> &PpTorus {
        &self.torus
    }

    /// The type of U, E and P here.
    #[must_use]
    pub fn classification(&self) -> &ClassificationDocument {
        &self.classification
    }

    /// Energy.
    #[must_use]
    pub fn h(&self) -> f64 {
        self.h
    }

    /// Vertical angular momentum.
    #[must_use]
    pub fn l(&self) -> f64 {
        self.l
    }

    /// The state over a point of the torus.
    ///
    /// # Errors
    /// As [`PpTorus::state`].
    pub fn state(&self, point: TorusPoint) -> Result<State, SectionError> {
        self.torus.state(point, self.h, self.l)
    }

    /// Follows an orbit from each point. `monitor` counts and can stop; the document then says that it is not complete.
    ///
    /// # Errors
    /// [`PoincareError::Section`] for inaccessible points and options out of range.
    pub fn run(
        &self,
        starts: &[TorusPoint],
        rng_seed: Option<u64>,
        options: &SweepOptions,
        monitor: &Monitor,
    ) -> Result<PoincareSection, PoincareError> {
        let mut states = Vec::with_capacity(starts.len());
        for start in starts {
            states.push(self.state(*start)?);
        }
        let orbits = sweep(&self.torus, &states, options, monitor)?;
        let gammas: Vec<[f64; 3]> = states.iter().map(|state| state.gamma).collect();
        let components = self.components_at(&gammas);
        let documents = orbits.iter().map(|orbit| {
            let number = orbit.orbit as usize;
            OrbitDocument::new(orbit, starts[number], components[number])
        });
        let starts = StartsDocument { orbits: starts.len(), rng_seed };
        let document = report::document(&self.classification, starts, options, documents.collect());
        Ok(PoincareSection { document, orbits })
    }

    /// The number of the component in which each accessible γ (in the body's axes) lies; None where that could not be
    /// proved.
    #[must_use]
    pub fn components_at(&self, gammas: &[[f64; 3]]) -> Vec<Option<usize>> {
        if self.component_count() == 1 {
            return vec![Some(0); gammas.len()];
        }
        match self.region.partition() {
            Ok(Some(partition)) => gammas.iter().map(|gamma| component_of(&partition, *gamma)).collect(),
            _ => vec![None; gammas.len()],
        }
    }

    /// How many components U_hl has.
    fn component_count(&self) -> usize {
        self.classification.components.as_ref().map_or(0, Vec::len)
    }
}
