//! Sections as documents.

use bifdiag_diagram::topology::signature;
use bifdiag_dynamics::field::{Integrals, State};
use bifdiag_dynamics::integrator::DEFAULT_TOLERANCE;
use bifdiag_dynamics::poincare::{Further, PoincareSection};
use bifdiag_dynamics::section::chaos::{
    ChaosMeasure, Evidence, Judgement, OpenReason, OrbitVerdict, RotationAngle, RotationNumber,
};
use bifdiag_dynamics::section::{OrbitEnd, OrbitSection, SectionCondition, SectionPoint, TorusPoint};
use bifdiag_numbers::decimal::counted;
use bifdiag_schema::{
    ChaosDocument, CommandLine, ConditionName, DecidedDocument, DriftDocument, EndName, EvidenceDocument,
    IntegratorDocument, IntegratorName, LyapunovDocument, OrbitDocument, RotationAngleName, RotationDocument,
    SectionDocument, SectionSummaryDocument, SectionsDocument, SkippedDocument, StartsDocument, VerdictName,
    VerdictsName,
};

use crate::body::{given, head};
use crate::classification::components;
use crate::integrals::further_integrals;
use crate::subject::Subject;

/// Where a section is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SectionPlace<'a> {
    /// At a point (h, l).
    Point,
    /// At the sample of a region of the body's atlas as `section` makes it.
    OwnSample(&'a str),
    /// At the sample of a region of another atlas of the body: its regions are the same, its samples may not be.
    OtherSample(&'a str),
}

/// Puts together what is known; orbits that are missing were not begun.
#[must_use]
pub fn section(subject: &Subject, section: &PoincareSection, place: SectionPlace<'_>) -> SectionDocument {
    let mut orbits: Vec<OrbitDocument> = section
        .orbits
        .iter()
        .map(|found| {
            let number = found.orbit as usize;
            orbit(found, section.starts[number], section.component_of_start[number])
        })
        .collect();
    for (orbit, measure) in orbits.iter_mut().zip(&section.chaos) {
        judge(orbit, &measure.judgement);
        orbit.chaos = Some(chaos(measure));
    }
    for (orbit, judgement) in orbits.iter_mut().zip(&section.verdicts) {
        judge(orbit, judgement);
    }
    let followed = orbits.len() == section.starts.len() && section.whole_orbits() == orbits.len();
    let summary = summary(&orbits);
    let mut notes = notes(followed, &summary, &orbits);
    if let Some(Further { orbits: open, crossings }) = &section.further {
        let numbers = open.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        let left = orbits.iter().filter(|orbit| open.contains(&orbit.orbit) && orbit.verdict == VerdictName::Open);
        notes.push(format!(
            "without a verdict after {}, followed for it alone over up to {crossings}: {} {numbers}; {}",
            counted(section.options.crossings, "crossing", "crossings"),
            if open.len() == 1 { "orbit" } else { "orbits" },
            match left.count() {
                0 => "none stays open".to_owned(),
                1 => "one stays open".to_owned(),
                many => format!("{many} stay open"),
            }
        ));
    }
    if followed && section.chaos_interrupted {
        notes.push("the run was interrupted: verdicts or Lyapunov exponents are missing".to_owned());
    }
    let options = &section.options;
    let state = |point: &SectionPoint| State { gamma: point.gamma, l: point.l };
    let motions = section.orbits.iter().filter_map(|orbit| {
        let (start, others) = orbit.points.split_first()?;
        Some((orbit.orbit, state(start), others.iter().map(state)))
    });
    let integrals = match motions.clone().next() {
        Some(_) => further_integrals(&section.body, &motions),
        None => Vec::new(),
    };
    let mut document = SectionDocument {
        head: head(String::new()),
        body: given(&section.body),
        h: section.h.text().to_owned(),
        l: section.l.text().to_owned(),
        region: match place {
            SectionPlace::Point => None,
            SectionPlace::OwnSample(region) | SectionPlace::OtherSample(region) => Some(region.to_owned()),
        },
        components: components(&section.components),
        // The theorem is about the section S = d⟨γ,r⟩/dt = 0.
        signature: match options.condition {
            SectionCondition::Height => signature(&section.components),
            SectionCondition::AngularMomentum => None,
        },
        condition: condition(options.condition),
        integrator: integrator(options.tolerance),
        starts: StartsDocument { orbits: section.starts.len(), seed: section.seed },
        crossings: options.crossings,
        max_time: options.max_time.is_finite().then_some(options.max_time),
        verdicts: match (section.early, section.chaos.is_empty(), section.verdicts.is_empty()) {
            (true, ..) => VerdictsName::Early,
            (_, false, _) => VerdictsName::Whole,
            (.., false) => VerdictsName::Only,
            _ => VerdictsName::None,
        },
        complete: section.complete(),
        summary,
        notes,
        integrals,
        orbits,
        part: subject.part.clone(),
    };
    let at = subject.command("section");
    let at = match place {
        SectionPlace::OwnSample(region) => at.option("region", region),
        SectionPlace::Point | SectionPlace::OtherSample(_) => at.option("h", &document.h).option("l", &document.l),
    };
    document.head.command = as_asked(at, &document).json();
    document
}

/// Adds a verdict.
fn judge(orbit: &mut OrbitDocument, judgement: &Judgement) {
    orbit.verdict = match judgement.verdict {
        OrbitVerdict::Regular => VerdictName::Regular,
        OrbitVerdict::Chaotic => VerdictName::Chaotic,
        OrbitVerdict::Open(_) => VerdictName::Open,
    };
    orbit.reason = judgement.to_string();
    orbit.decided = judgement.decided.map(|(time, crossing)| DecidedDocument { time, crossing });
}

/// Adds the options that made a section, apart from its body and place.
fn as_asked(line: CommandLine, document: &SectionDocument) -> CommandLine {
    /// A file whose points are those of the document's orbits.
    const STARTS: &str = "starts.csv";
    let condition = (document.condition == ConditionName::AngularMomentum).then_some("angular-momentum");
    let line = match document.starts.seed {
        Some(seed) => line.option("orbits", document.starts.orbits).option("seed", seed),
        None => line.option("starts", STARTS),
    };
    let line = line
        .option("crossings", document.crossings)
        .option_if("max-time", document.max_time)
        .option_if("condition", condition);
    let verdicts = match document.verdicts {
        VerdictsName::Whole => None,
        VerdictsName::Early => Some("early"),
        VerdictsName::Only => Some("only"),
        VerdictsName::None => Some("none"),
    };
    tolerance_option(line, document.integrator.tol).option_if("verdict", verdicts)
}

/// Adds the tolerance, unless it is the usual one.
#[must_use]
pub fn tolerance_option(line: CommandLine, tolerance: f64) -> CommandLine {
    line.option_if("tol", (tolerance != DEFAULT_TOLERANCE).then_some(tolerance))
}

/// Sections of several regions, those that `wanted` names, or `all`, at the samples of the atlas that the command `atlas` prints, or
/// of the body's own; `complete` says whether all of them had their turn.
#[must_use]
pub fn sections(
    subject: &Subject,
    atlas: Option<&str>,
    wanted: &str,
    sections: Vec<SectionDocument>,
    skipped: Vec<SkippedDocument>,
    complete: bool,
) -> SectionsDocument {
    let all = match atlas {
        Some(_) => CommandLine::new("section").option("atlas", "-"),
        None => subject.command("section"),
    };
    let all = all.option("region", wanted);
    let all = sections.first().map_or(all.clone(), |first| as_asked(all, first)).json();
    let command = atlas.map_or_else(|| all.clone(), |atlas| format!("{atlas} | {all}"));
    let complete = complete && sections.iter().all(|section| section.complete);
    SectionsDocument { head: head(command), complete, sections, skipped }
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

fn condition(condition: SectionCondition) -> ConditionName {
    match condition {
        SectionCondition::Height => ConditionName::Height,
        SectionCondition::AngularMomentum => ConditionName::AngularMomentum,
    }
}

/// The integrator and how fine it was.
#[must_use]
pub fn integrator(tolerance: f64) -> IntegratorDocument {
    IntegratorDocument { name: IntegratorName::Taylor, tol: tolerance }
}

/// Deviations of the first integrals.
#[must_use]
pub fn drift(drift: Integrals) -> DriftDocument {
    DriftDocument { h: drift.energy, l: drift.vertical_momentum, gamma: drift.gamma_squared }
}

fn end(end: OrbitEnd) -> EndName {
    match end {
        OrbitEnd::Crossings => EndName::Crossings,
        OrbitEnd::Time => EndName::Time,
        OrbitEnd::Decided => EndName::Decided,
        OrbitEnd::StaysOnSection => EndName::StaysOnSection,
        OrbitEnd::Failed(_) => EndName::Failed,
        OrbitEnd::Interrupted => EndName::Interrupted,
    }
}

fn orbit(orbit: &OrbitSection, start: TorusPoint, component: Option<usize>) -> OrbitDocument {
    let report = &orbit.report;
    OrbitDocument {
        orbit: orbit.orbit,
        component,
        theta: start.theta,
        psi: start.psi,
        sheet: start.sheet,
        crossings: report.crossings as usize,
        end: end(report.end),
        failure: if let OrbitEnd::Failed(error) = report.end { Some(error.to_string()) } else { None },
        time: report.time,
        steps: report.steps,
        tangencies: report.tangencies,
        drift: drift(report.drift),
        residual: report.residual,
        verdict: VerdictName::Open,
        reason: OpenReason::NotAsked.to_string(),
        decided: None,
        chaos: None,
    }
}

fn summary(orbits: &[OrbitDocument]) -> SectionSummaryDocument {
    let largest = |value: &dyn Fn(&OrbitDocument) -> f64| orbits.iter().map(value).fold(0.0, f64::max);
    let ending = |end: EndName| orbits.iter().filter(|orbit| orbit.end == end).count();
    SectionSummaryDocument {
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

/// How regular an orbit is.
#[must_use]
pub fn chaos(measure: &ChaosMeasure) -> ChaosDocument {
    let lyapunov = measure.lyapunov.map(|found| LyapunovDocument {
        exponent: found.exponent,
        exponent_half: found.exponent_half,
        mean_rate: found.mean_rate,
        mean_rate_half: found.mean_rate_half,
        time: found.time,
    });
    let found = measure.rotation.as_ref();
    ChaosDocument {
        lyapunov,
        rotation: found.ok().map(rotation),
        no_rotation: found.err().map(ToString::to_string),
        evidence: measure.judgement.evidence.iter().map(evidence).collect(),
    }
}

fn evidence(look: &Evidence) -> EvidenceDocument {
    EvidenceDocument { time: look.time, apart: look.apart, growth: look.growth, log: look.log }
}

fn rotation(rotation: &RotationNumber) -> RotationDocument {
    let (angle, islands) = match rotation.angle {
        RotationAngle::Axis => (RotationAngleName::Axis, None),
        RotationAngle::Mean => (RotationAngleName::Mean, None),
        RotationAngle::Curve => (RotationAngleName::Curve, None),
        RotationAngle::Islands(count) => (RotationAngleName::Islands, Some(count)),
    };
    RotationDocument { number: rotation.number, error: rotation.error, angle, islands, returns: rotation.returns }
}
