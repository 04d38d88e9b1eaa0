//! The document of a section.

use crate::document::{
    ClassificationDocument, ConditionName, DriftDocument, EndName, IntegratorDocument, IntegratorName, OrbitDocument,
    SCHEMA_VERSION, SectionDocument, SectionSummaryDocument, SectionsDocument, SkippedDocument, StartsDocument,
};
use crate::dynamics::Integrals;
use crate::integrator::Method;
use crate::section::{End, OrbitSection, SectionCondition, SweepOptions, TorusPoint};

/// Puts together what is known; orbits that are missing were not begun.
pub(super) fn document(
    classification: &ClassificationDocument,
    starts: StartsDocument,
    options: &SweepOptions,
    orbits: Vec<OrbitDocument>,
) -> SectionDocument {
    let complete = orbits.len() == starts.orbits && orbits.iter().all(|orbit| orbit.end != EndName::Interrupted);
    let summary = SectionSummaryDocument::new(&orbits);
    SectionDocument {
        schema_version: SCHEMA_VERSION.to_owned(),
        moments: classification.moments.clone(),
        center: classification.center.clone(),
        h: classification.h.clone(),
        l: classification.l.clone(),
        region: None,
        components: classification.components.clone().unwrap_or_default(),
        signature: classification.signature.clone(),
        condition: options.condition.into(),
        integrator: options.method.into(),
        starts,
        crossings: options.crossings,
        max_time: options.max_time.is_finite().then_some(options.max_time),
        complete,
        summary,
        notes: notes(complete, &summary, &orbits),
        orbits,
        inertia: None,
    }
}

/// What a reader of the result should know.
fn notes(complete: bool, summary: &SectionSummaryDocument, orbits: &[OrbitDocument]) -> Vec<String> {
    let numbers = |end: EndName| {
        let found: Vec<String> =
            orbits.iter().filter(|orbit| orbit.end == end).map(|orbit| orbit.orbit.to_string()).collect();
        format!("{} {}", if found.len() == 1 { "orbit" } else { "orbits" }, found.join(", "))
    };
    let mut notes = Vec::new();
    if !complete {
        notes.push("the run was interrupted: orbits are missing or shorter than asked for".to_owned());
    }
    if summary.stay_on_section > 0 {
        notes.push(format!(
            "{}: S = 0 at all times (a relative equilibrium, or a regular precession of Lagrange's top); only the \
            start is recorded",
            numbers(EndName::StaysOnSection)
        ));
    }
    if summary.failed > 0 {
        notes.push(format!("{}: the integrator could not go on", numbers(EndName::Failed)));
    }
    if summary.tangencies > 0 {
        notes.push(format!(
            "{} times S touched 0 within rounding: a pair of crossings may be missing or spurious there",
            summary.tangencies
        ));
    }
    notes
}

impl From<SectionCondition> for ConditionName {
    fn from(condition: SectionCondition) -> Self {
        match condition {
            SectionCondition::Height => Self::Height,
            SectionCondition::AngularMomentum => Self::AngularMomentum,
        }
    }
}

impl From<Method> for IntegratorDocument {
    fn from(method: Method) -> Self {
        let (name, tol, step) = match method {
            Method::Taylor { tolerance } => (IntegratorName::Taylor, Some(tolerance), None),
            Method::Dop853 { tolerance } => (IntegratorName::Dop853, Some(tolerance), None),
            Method::RungeKutta4 { step } => (IntegratorName::Rk4, None, Some(step)),
            Method::Splitting { step } => (IntegratorName::Splitting, None, Some(step)),
        };
        Self { name, tol, step }
    }
}

impl From<Integrals> for DriftDocument {
    fn from(drift: Integrals) -> Self {
        Self { h: drift.energy, l: drift.vertical_momentum, gamma: drift.gamma_squared }
    }
}

impl From<End> for EndName {
    fn from(end: End) -> Self {
        match end {
            End::Crossings => Self::Crossings,
            End::Time => Self::Time,
            End::StaysOnSection => Self::StaysOnSection,
            End::Failed(_) => Self::Failed,
            End::Interrupted => Self::Interrupted,
        }
    }
}

impl SectionsDocument {
    /// Of finished sections; `complete` says whether all regions had their turn.
    #[must_use]
    pub fn new(sections: Vec<SectionDocument>, skipped: Vec<SkippedDocument>, complete: bool) -> Self {
        let complete = complete && sections.iter().all(|section| section.complete);
        Self { schema_version: SCHEMA_VERSION.to_owned(), complete, sections, skipped }
    }
}

impl SectionDocument {
    /// Orbits that were not cut short by an interrupt.
    #[must_use]
    pub fn whole_orbits(&self) -> usize {
        self.orbits.iter().filter(|orbit| orbit.end != EndName::Interrupted).count()
    }
}

impl OrbitDocument {
    /// Of an orbit that started at a point of the torus, in a component.
    #[must_use]
    pub fn new(orbit: &OrbitSection, start: TorusPoint, component: Option<usize>) -> Self {
        let report = &orbit.report;
        let failure = if let End::Failed(error) = report.end { Some(error.to_string()) } else { None };
        Self {
            orbit: orbit.orbit,
            component,
            theta: start.theta,
            psi: start.psi,
            sheet: start.sheet,
            crossings: orbit.points.iter().filter(|point| point.index > 0).count(),
            end: report.end.into(),
            failure,
            time: report.time,
            steps: report.steps,
            tangencies: report.tangencies,
            drift: report.drift.into(),
            residual: report.residual,
            chaos: None,
        }
    }
}

impl SectionSummaryDocument {
    /// Of all orbits.
    #[must_use]
    pub fn new(orbits: &[OrbitDocument]) -> Self {
        let largest = |value: &dyn Fn(&OrbitDocument) -> f64| orbits.iter().map(value).fold(0.0, f64::max);
        let ending = |end: EndName| orbits.iter().filter(|orbit| orbit.end == end).count();
        Self {
            orbits: orbits.len(),
            crossings: orbits.iter().map(|orbit| orbit.crossings).sum(),
            stay_on_section: ending(EndName::StaysOnSection),
            failed: ending(EndName::Failed),
            tangencies: orbits.iter().map(|orbit| u64::from(orbit.tangencies)).sum(),
            drift: DriftDocument {
                h: largest(&|orbit| orbit.drift.h),
                l: largest(&|orbit| orbit.drift.l),
                gamma: largest(&|orbit| orbit.drift.gamma),
            },
            residual: largest(&|orbit| orbit.residual),
        }
    }
}
