//! The place nearest to a body where functions of bodies have given values, by Newton's method.

use nalgebra::{DMatrix, DVector};

use crate::border::Vanishing;
use crate::space::{BodySet, TangentBasis};
use bifdiag_body::Body;

/// A function of bodies and a value of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level {
    pub function: Vanishing,
    pub value: f64,
}

/// A place this near to the body is the body itself, within rounding.
pub const HERE: f64 = 1e-13;

/// Bodies around one, as coordinates in its basis.
pub(super) struct Surroundings {
    pub basis: TangentBasis,
    pub set: BodySet,
}

impl Surroundings {
    /// The nearest place where all functions have their values, looked for from a place on. Each step leads to the nearest place where the
    /// functions would have these values if they were as linear as they are here. `None` where the steps leave the set or do
    /// not settle.
    pub fn foot(&self, from: &DVector<f64>, mut conditions: Vec<Level>) -> Option<DVector<f64>> {
        const STEPS: u32 = 16;
        const SETTLED: f64 = 1e-6;
        /// A smaller step is one of rounding.
        const ROUNDING: f64 = 5e-15;
        /// The part of the way to the end of the set to which a step is cut that leads beyond it, and how often that is done.
        const REACH: f64 = 0.5;
        const CUTS: u32 = 5;
        const TRUST: f64 = 0.5;
        let mut place = from.clone();
        let mut cuts = 0;
        for _ in 0..STEPS {
            let (slopes, missing) = self.linear(&place, &mut conditions)?;
            let wanted = &slopes * &place + missing;
            let next = slopes.tr_mul(&(&slopes * slopes.transpose()).lu().solve(&wanted)?);
            if next.norm() <= HERE {
                // Only the direction has a meaning.
                return Some(slopes.row(0).transpose().normalize() * (0.5 * HERE));
            }
            let moved = (&next - &place).norm();
            let line = self.basis.line(next.as_slice(), self.set)?;
            let reach = line.reach()[1] / next.norm();
            // From a place on, steps are no longer than a part of the way to it.
            let trust = if place.norm() > 0.0 { TRUST * place.norm() / moved } else { 1.0 };
            if reach.is_nan() || trust.is_nan() || (reach < 1.0 && cuts == CUTS) {
                return None;
            }
            cuts += u32::from(reach < 1.0);
            if reach >= 1.0 && moved <= (SETTLED * next.norm()).max(ROUNDING) {
                return Some(next);
            }
            place = if trust < 1.0 {
                &place + (next - &place) * trust
            } else {
                next * if reach < 1.0 { REACH * reach } else { 1.0 }
            };
        }
        None
    }

    /// The slopes of the functions at a place, a row for each, and what they lack; the events of the functions are followed.
    fn linear(&self, place: &DVector<f64>, conditions: &mut [Level]) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let step = self.basis.step(place.as_slice())?;
        let mut slopes = DMatrix::zeros(conditions.len(), place.len());
        let mut missing = DVector::zeros(conditions.len());
        for (row, condition) in conditions.iter_mut().enumerate() {
            let here;
            (here, condition.function) = self.value(condition.function, place)?;
            missing[row] = condition.value - here;
            for k in 0..place.len() {
                let mut beside = place.clone();
                beside[k] += step;
                slopes[(row, k)] = (self.value(condition.function, &beside)?.0 - here) / step;
            }
        }
        Some((slopes, missing))
    }

    /// The value of a function at a place, and the same with its event if present.
    pub fn value(&self, function: Vanishing, place: &DVector<f64>) -> Option<(f64, Vanishing)> {
        let [a, r] = self.basis.at(place.as_slice());
        let (gap, function) = function.measured(Body::from_f64(a, r).ok()?.frame())?;
        Some((gap.value, function))
    }
}
