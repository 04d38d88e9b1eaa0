//! An orbit on the section: what is asked of it, and what was found.

use super::condition::SectionCondition;
use crate::field::{Dimension, Integrals, TopUnits, dot};
use crate::integrator::taylor::InstructionSet;
use crate::integrator::{DEFAULT_TOLERANCE, StepError};
use bifdiag_body::Body;
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};

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
pub enum OrbitEnd {
    /// It has the crossings that were asked for.
    Crossings,
    /// Its time is up.
    Time,
    /// Its verdict was found.
    Decided,
    /// S ≡ 0 along it, within rounding: a relative equilibrium or a regular precession of Lagrange's top.
    StaysOnSection,
    /// The integrator could not continue.
    Failed(StepError),
    /// The run was stopped.
    Interrupted,
}

/// What an orbit was like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitReport {
    /// Why it ended.
    pub end: OrbitEnd,
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
    pub(super) fn reduced(&self, units: TopUnits) -> Self {
        let max_time = units.reduce(self.max_time, Dimension::TIME);
        Self { max_time, ..*self }
    }
}

impl OrbitSection {
    /// That of a reduced top as that of the top as given.
    pub(super) fn restored(mut self, units: TopUnits, condition: SectionCondition) -> Self {
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
    pub(super) fn restored(mut self, units: TopUnits, condition: SectionCondition) -> Self {
        if let OrbitEnd::Failed(error) = &mut self.end {
            *error = error.restored(units);
        }
        self.time = units.restore(self.time, Dimension::TIME);
        self.residual = units.restore(self.residual, condition.dimension());
        self.drift = self.drift.restored(units);
        self
    }
}

/// What the families are called.
pub const FAMILIES: [&str; 4] = ["on the side of +r̂", "on the side of −r̂", "on both sides", "on a further component"];

/// The family of each orbit, a place in [`FAMILIES`]. On a section of several components the majority of the crossings
/// decides the side of a component; two components on one side are distinguished.
#[must_use]
pub fn families(body: &Body, h: f64, l: f64, orbits: &[OrbitSection]) -> Vec<usize> {
    let center = body.center_f64();
    let region = AccessibleRegion::new(body, h, l).ok();
    let partition = region.as_ref().and_then(|region| region.partition().ok().flatten());
    let parts = partition.as_ref().filter(|partition| partition.components().len() > 1);
    // Crossings with ⟨γ, r⟩ > 0, and all.
    let count = |orbit: &OrbitSection| {
        let above = orbit.points.iter().filter(|point| dot(point.gamma, center) > 0.0).count();
        [above, orbit.points.len()]
    };
    let Some(parts) = parts else {
        let side = |[above, all]: [usize; 2]| if above == all { 0 } else { 2 - usize::from(above == 0) };
        return orbits.iter().map(|orbit| side(count(orbit))).collect();
    };
    let component =
        |orbit: &OrbitSection| orbit.points.first().and_then(|point| component_of(parts, point.gamma)).unwrap_or(0);
    let components: Vec<usize> = orbits.iter().map(component).collect();
    let mut family: Vec<Option<usize>> = vec![None; parts.components().len()];
    for place in 0..family.len() {
        let own = orbits.iter().zip(&components).filter(|(_, component)| **component == place);
        let [above, all] = own.fold([0, 0], |[a, n], (orbit, _)| {
            let [above, all] = count(orbit);
            [a + above, n + all]
        });
        let side = usize::from(2 * above < all);
        family[place] = Some(if family.contains(&Some(side)) { FAMILIES.len() - 1 } else { side });
    }
    components.into_iter().map(|component| family[component].unwrap_or(0)).collect()
}
