//! An orbit on the section: what is asked of it, and what was found.

use super::condition::SectionCondition;
use crate::field::{Dimension, Integrals, Units};
use crate::integrator::taylor::InstructionSet;
use crate::integrator::{DEFAULT_TOLERANCE, StepError};

/// What to compute of each orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepOptions {
    /// Crossings of each orbit, the start not counted.
    pub crossings: usize,
    /// Stop an orbit at this time even if it has fewer.
    pub max_time: f64,
    /// Truncation error of a step, relative to the size of the energy surface; 1e-18 to 1e-2.
    pub tolerance: f64,
    /// The section.
    pub condition: SectionCondition,
    /// SIMD instructions; they do not change the results.
    pub instructions: InstructionSet,
}

impl Default for SweepOptions {
    fn default() -> Self {
        Self {
            crossings: 1000,
            max_time: f64::INFINITY,
            tolerance: DEFAULT_TOLERANCE,
            condition: SectionCondition::Height,
            instructions: InstructionSet::Best,
        }
    }
}

/// A crossing of the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPoint {
    /// Number of the orbit.
    pub orbit: u32,
    /// 0 is the start if it lies on the section; the crossings count from 1.
    pub index: u32,
    /// Time since the start.
    pub time: f64,
    /// What `time` leaves out: the time is `time` + `time_low`.
    pub time_low: f64,
    /// The vertical.
    pub gamma: [f64; 3],
    /// Angular momentum.
    pub l: [f64; 3],
    /// Sign of Δ.
    pub sheet: i8,
    /// Ṡ.
    pub s_dot: f64,
    /// ϑ'.
    pub theta: f64,
    /// ψ'.
    pub psi: f64,
}

/// Why an orbit ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// It has the crossings that were asked for.
    Crossings,
    /// Its time is up.
    Time,
    /// Its verdict was found.
    Decided,
    /// S ≡ 0 along it, within rounding: a relative equilibrium or a regular precession of Lagrange's top.
    StaysOnSection,
    /// The integrator could not go on.
    Failed(StepError),
    /// The run was stopped.
    Interrupted,
}

/// What an orbit was like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitReport {
    /// Why it ended.
    pub end: End,
    /// Crossings since the start, which is not counted.
    pub crossings: u32,
    /// Steps of the integrator.
    pub steps: u64,
    /// Time at the last step's end.
    pub time: f64,
    /// Extrema of S whose sign is within rounding: a pair of crossings may be missing or spurious there.
    pub tangencies: u32,
    /// The largest |deviation| of each first integral from its value at the start, over the crossings.
    pub drift: Integrals,
    /// The largest |S| at a crossing.
    pub residual: f64,
}

/// One orbit's crossings.
#[derive(Clone, Debug, PartialEq)]
pub struct OrbitSection {
    /// Crossings in the order of time.
    pub points: Vec<SectionPoint>,
    /// What the orbit was like.
    pub report: OrbitReport,
    /// Number of the orbit.
    pub orbit: u32,
}

impl SweepOptions {
    /// The same for a top in other units.
    pub(super) fn reduced(&self, units: Units) -> Self {
        let max_time = units.reduce(self.max_time, Dimension::TIME);
        Self { max_time, ..*self }
    }
}

impl OrbitSection {
    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(mut self, units: Units, condition: SectionCondition) -> Self {
        let value = condition.dimension();
        let given = |x: &mut f64, dimension| *x = units.restore(*x, dimension);
        for point in &mut self.points {
            given(&mut point.time, Dimension::TIME);
            given(&mut point.time_low, Dimension::TIME);
            given(&mut point.s_dot, value.rate());
            point.l.iter_mut().for_each(|x| given(x, Dimension::MOMENTUM));
        }
        self.report = self.report.restored(units, condition);
        self
    }
}

impl OrbitReport {
    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(mut self, units: Units, condition: SectionCondition) -> Self {
        if let End::Failed(error) = &mut self.end {
            *error = error.restored(units);
        }
        self.time = units.restore(self.time, Dimension::TIME);
        self.residual = units.restore(self.residual, condition.dimension());
        self.drift = self.drift.restored(units);
        self
    }
}
