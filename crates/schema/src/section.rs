//! `section`: what a Poincaré section was made of, and how well each orbit went.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{ComponentDocument, FurtherIntegralDocument, GivenBody, Head, Number, PartDocument};

/// Which function of the state vanishes on the section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ConditionName {
    /// S = ⟨ω, r×γ⟩, the rate of W = ⟨γ,r⟩: the centre of mass is at a turning point of its height.
    Height,
    /// S = ⟨l, γ×r⟩, the rate of W = −⟨l,l⟩/2.
    AngularMomentum,
}

/// Integrators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum IntegratorName {
    /// Taylor series of adaptive step.
    Taylor,
}

/// An integrator and how fine it was.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct IntegratorDocument {
    /// Which one.
    pub name: IntegratorName,
    /// Truncation error of a step, relative to the size of the energy surface.
    pub tol: f64,
}

/// Where the orbits started.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct StartsDocument {
    /// How many orbits were requested.
    pub orbits: usize,
    /// The seed of the spread starts; absent when the user gave the points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
}

/// The largest deviation of each first integral from its value at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DriftDocument {
    /// Of H.
    pub h: f64,
    /// Of ⟨γ,l⟩.
    pub l: f64,
    /// Of ⟨γ,γ⟩.
    pub gamma: f64,
}

/// Why an orbit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum EndName {
    /// It has the requested number of crossings.
    Crossings,
    /// Its time was up.
    Time,
    /// Its verdict was found, and no more was requested.
    Decided,
    /// S ≡ 0 along it: a relative equilibrium, or a regular precession of Lagrange's top.
    StaysOnSection,
    /// The integrator could not continue.
    Failed,
    /// The run was interrupted; the points until then were kept.
    Interrupted,
}

/// The largest Lyapunov exponent of an orbit over a finite time T, per unit of time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LyapunovDocument {
    /// λ(T) = ln(|δ(T)|/|δ(0)|)/T; of regular orbits it falls like ln(T)/T.
    pub exponent: f64,
    /// λ(T/2), to show how much it still changes.
    pub exponent_half: f64,
    /// The weighted mean of d ln|δ|/dt, which converges faster for regular orbits.
    pub mean_rate: f64,
    /// The same over [0, T/2].
    pub mean_rate_half: f64,
    /// T.
    pub time: f64,
}

/// The rotation number of an orbit's return map.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RotationDocument {
    /// Turns per return, in [0, 1/2].
    pub number: f64,
    /// How far the two halves of the returns disagree; 0 for a chain of islands.
    pub error: f64,
    /// The angle that was averaged: ψ′, the angle about the mean, the curve's own parameter, or none for islands.
    pub angle: RotationAngleName,
    /// Length of the chain of islands (or of the periodic orbit).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub islands: Option<usize>,
    /// Number of returns.
    pub returns: usize,
}

/// Which angle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RotationAngleName {
    /// ψ′, about the axis r̂.
    Axis,
    /// The angle about the mean of the crossings.
    Mean,
    /// The parameter of the curve that the crossings follow.
    Curve,
    /// None: the crossings visit islands in turn.
    Islands,
}

/// Whether an orbit is regular or chaotic. Chaotic is not unstable: an unstable periodic orbit is not chaotic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum VerdictName {
    /// A tangent vector grows no faster than linearly, and averages over the orbit settle.
    Regular,
    /// A tangent vector grows exponentially and steadily, and averages over the orbit do not settle.
    Chaotic,
    /// Not decided, or not requested.
    Open,
}

/// How orbits were judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum VerdictsName {
    /// Over the whole of each orbit.
    Whole,
    /// Each orbit ended where its verdict was found.
    Early,
    /// The verdicts alone, without exponents and rotation numbers.
    Only,
    /// Not at all.
    None,
}

/// Where a verdict was decided: the time of the deciding test, and the last crossing before it. An orbit that is
/// followed
/// further keeps it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DecidedDocument {
    /// Time since the start.
    pub time: f64,
    /// Number of the last crossing before it.
    pub crossing: u32,
}

/// A test of an orbit at one time T: means over the windows [T/4, 5T/8] and [5T/8, T] with the weight (u(1−u))⁸.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EvidenceDocument {
    /// T.
    pub time: f64,
    /// How far the means of γ over the two windows are apart, in units of the spread of γ.
    pub apart: f64,
    /// How much ln|δ| grows in each of them: the mean of d ln|δ|/dt times its length; about 0.87 and 0.46 where |δ| grows linearly.
    pub growth: [f64; 2],
    /// ln(|δ(T)|/|δ(0)|).
    pub log: f64,
}

/// How regular an orbit is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChaosDocument {
    /// The largest Lyapunov exponent; null for an orbit of no duration, with fewer than 24 returns, or that was not finished.
    pub lyapunov: Option<LyapunovDocument>,
    /// The rotation number; null if undefined.
    pub rotation: Option<RotationDocument>,
    /// Why there is no rotation number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub no_rotation: Option<String>,
    /// The evidence for the verdict: the three tests that decided it; where it is open, the last three. Empty for an
    /// orbit that was too short
    /// or not finished.
    pub evidence: Vec<EvidenceDocument>,
}

/// One orbit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OrbitDocument {
    /// Its number, as in the data.
    pub orbit: u32,
    /// Number in `components`, from 0, of the component that holds its start; null if it is not known.
    pub component: Option<usize>,
    /// ϑ' of its start.
    pub theta: f64,
    /// ψ' of its start.
    pub psi: f64,
    /// Sheet of its start, ±1.
    pub sheet: i8,
    /// Crossings; the start is not counted.
    pub crossings: usize,
    /// Why it ended.
    pub end: EndName,
    /// What stopped the integrator.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// Time until which it was followed.
    pub time: f64,
    /// Steps of the integrator.
    pub steps: u64,
    /// Extrema of S whose sign is within rounding: a pair of crossings may be missing or spurious there.
    pub tangencies: u32,
    /// The largest deviations of the first integrals, over the crossings.
    pub drift: DriftDocument,
    /// The largest |S| at a crossing.
    pub residual: f64,
    /// Regular, chaotic, or open.
    pub verdict: VerdictName,
    /// Why, in words.
    pub reason: String,
    /// Where it was decided; absent where it is open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub decided: Option<DecidedDocument>,
    /// How regular it is, if requested.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chaos: Option<ChaosDocument>,
}

/// Totals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SectionSummaryDocument {
    /// Orbits that were begun.
    pub orbits: usize,
    /// Crossings of all orbits.
    pub crossings: usize,
    /// Orbits on which S ≡ 0.
    pub stay_on_section: usize,
    /// Orbits on which the integrator failed.
    pub failed: usize,
    /// Extrema of S whose sign is within rounding.
    pub tangencies: u64,
    /// The largest deviations of the first integrals.
    pub drift: DriftDocument,
    /// The largest |S| at a crossing.
    pub residual: f64,
}

/// A Poincaré section at one (h, l).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SectionDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// The body.
    #[serde(flatten)]
    pub body: GivenBody,
    /// Energy as given.
    #[schemars(with = "Number")]
    pub h: String,
    /// Vertical angular momentum as given.
    #[schemars(with = "Number")]
    pub l: String,
    /// The region of the atlas whose sample this is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub region: Option<String>,
    /// The components of U_hl at this point.
    pub components: Vec<ComponentDocument>,
    /// The sections' names joined by `+`; null for the condition `angular-momentum`, whose surface is another.
    pub signature: Option<String>,
    /// What the section is.
    pub condition: ConditionName,
    /// How the orbits were integrated.
    pub integrator: IntegratorDocument,
    /// Where they started.
    pub starts: StartsDocument,
    /// Crossings requested of each orbit.
    pub crossings: usize,
    /// Time after which each orbit was stopped; absent: none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_time: Option<f64>,
    /// How the orbits were judged.
    pub verdicts: VerdictsName,
    /// False when the run was interrupted: orbits are then missing or shorter than requested.
    pub complete: bool,
    /// Totals.
    pub summary: SectionSummaryDocument,
    /// The further integrals of an integrable body along the orbits; absent where the crossings were written as they came.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub integrals: Vec<FurtherIntegralDocument>,
    /// Every orbit that was begun.
    pub orbits: Vec<OrbitDocument>,
    /// Remarks on the result, in words.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// The part from which A and r were computed, when one was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<PartDocument>,
}

/// A region without a section.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct SkippedDocument {
    /// Id of the region.
    pub region: String,
    /// Why there is none.
    pub reason: String,
}

/// The sections at the samples of an atlas.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SectionsDocument {
    /// Where it comes from.
    #[serde(flatten)]
    pub head: Head,
    /// False when the run was interrupted: sections are then missing or incomplete.
    pub complete: bool,
    /// A section for each region, in the order of the atlas.
    pub sections: Vec<SectionDocument>,
    /// Regions at whose samples no section could be made.
    pub skipped: Vec<SkippedDocument>,
}
