//! The JSON documents that others build on: plain data, versioned, written and read by serde.
//!
//! Computed values are JSON numbers in shortest round-trip form, inputs are echoed as the strings that were given,
//! and an infinite end of a range is `null`. No document carries timings: same input, same bytes.

mod atlas;
mod border;
mod certificate;
mod chaos;
mod classes;
mod classification;
mod command;
mod comparison;
mod critical;
mod find;
mod grid;
mod head;
mod integrable;
mod json;
mod listing;
mod motion;
mod nonlinear;
mod part;
mod periodic;
mod point_proof;
mod rotation;
mod scan;
mod section;
mod shown;
mod spin;
mod spin_down;
mod state;
mod steady;
mod term;
mod tolerance;

pub use atlas::{
    AtlasDocument, BodyDocument, CellDocument, CurveDocument, CurveDrawing, CurveKind, DrawingDocument,
    EnclosureDocument, EventDocument, EventKind, Failing, Flags, NeighbourDocument, RegionDocument, RegionDrawing,
    SampleDocument, StabilityChangeDocument, StabilityChangeKind, StabilitySpan, SummaryDocument, TailDocument,
    UndecidedDocument, VerdictChangeDocument, ViewDocument, WindowDocument,
};
pub use border::{
    BorderDocument, BorderEventDocument, BorderEventName, BorderValueDocument, EventTrackDocument, EventTracksDocument,
    FoundBorderDocument,
};
pub use certificate::{
    CertificateDocument, CertificateUnits, CertifiedCusp, CertifiedEvent, CertifiedHeight, CertifiedMeeting,
    CertifiedNode, CertifiedPair, CertifiedSample, CertifiedSlab, CertifiedStretch, PlaceDocument,
};
pub use chaos::{ChaosCellDocument, ChaosMapDocument, ChaosPointDocument, ChaosShareDocument};
pub use classes::{
    ClassBesideDocument, ClassBorderDocument, ClassDocument, ClassNeighbourDocument, ClassWitnessDocument,
    ClassesDocument, StandingDocument,
};
pub use classification::{CandidateDocument, ClassificationDocument, ComponentDocument, MarginDocument, Status};
pub use command::{CommandLine, is_plain, quoted};
pub use comparison::{
    ComparedBodyDocument, ComparedEventDocument, ComparedRegionsDocument, ComparedStabilityDocument,
    ComparisonDocument, CrossedBorderDocument, PathDocument,
};
pub use critical::{
    CriticalDocument, Multiplicity, RelativeEquilibriumDocument, Stability, Verdict, eigenvalues_in_words,
    small_motions,
};
pub use find::{FindDocument, NearestDocument, WitnessDocument};
pub use grid::{GridAxisDocument, GridDocument};
pub use head::{GivenBody, Head, Number};
pub use integrable::{FurtherIntegralDocument, IntegrableCaseName, IntegrableDocument};
pub use json::{json, write_json};
pub use listing::{BatchErrorDocument, BodiesDocument, ExplainedTermDocument, ExplanationDocument, PresetDocument};
pub use motion::{
    EnclosuresDocument, Ends, ExactStartDocument, MotionDocument, MotionSampleDocument, MotionSummaryDocument,
    ProvedMotionDocument,
};
pub use nonlinear::{Damped, FrictionDocument, NonlinearDocument, NonlinearVerdict, Reason, ResonancesDocument};
pub use part::{PartAnswerDocument, PartDocument, PrincipalDocument};
pub use periodic::{
    ConnectionDocument, ContactDocument, FamilyEnd, FamilyEndingDocument, ListedFamilyDocument, ListedOrbitDocument,
    ManifoldCurveDocument, ManifoldDocument, ManifoldEnd, ManifoldKind, ManifoldsDocument, OrbitEnclosureDocument,
    OrbitEventDocument, OrbitEventKind, OrbitStability, PeriodicBranchDocument, PeriodicDocument,
    PeriodicFamiliesDocument, PeriodicFamilyDocument, PeriodicListDocument, PeriodicOrbitDocument,
};
pub use point_proof::{PointProofDocument, checksum};
pub use rotation::{AxisEnd, SpinType};
pub use scan::{
    BodyParameter, BodyRecordDocument, ClassRecordDocument, DesignDocument, FamilyDocument, RangeDocument,
    RecordDocument, RowDocument, RowStatus, ScanIdentityDocument, ScanSummaryDocument,
};
pub use section::{
    ChaosDocument, ConditionName, DecidedDocument, DriftDocument, EndName, EvidenceDocument, IntegratorDocument,
    IntegratorName, LyapunovDocument, OrbitDocument, RotationAngleName, RotationDocument, SectionDocument,
    SectionSummaryDocument, SectionsDocument, SkippedDocument, StartsDocument, VerdictName, VerdictsName,
};
pub use shown::{harmless, one_line, shown};
pub use spin::{
    CriticalSpinDocument, IsolatedSpinDocument, NearestAxisDocument, SpinChangeDocument, SpinDocument,
    SpinStretchDocument, SteadyAxesDocument, SteadyAxisDocument, SteadyFamilyDocument, SteadyPlaceDocument,
    SteadySpinDocument, SteadyStart, SteadyStretchDocument,
};
pub use spin_down::{SlowdownDocument, SlowdownEvent, SpinDownDocument};
pub use state::{StateDocument, SteadyDocument};
pub use steady::{AxisCountDocument, PermanentAxisDocument, SteadySpinsDocument};
pub use tolerance::{MeasuredDocument, SampledClassDocument, SpinRangeDocument, ToleranceDocument};

/// Version of every document in this module.
pub const SCHEMA_VERSION: &str = "3";

/// The requested level of accuracy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Accuracy {
    /// Never undecided: `f64` where its error bounds suffice, exact arithmetic elsewhere.
    #[default]
    Exact,
    /// `f64` with error bounds; undecided where they do not suffice.
    Fast,
}
