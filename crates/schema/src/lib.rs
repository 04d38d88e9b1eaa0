//! The JSON documents that others build on: plain data, versioned, written and read by serde.
//!
//! Computed values are JSON numbers in shortest round-trip form, inputs are echoed as the strings that were given,
//! and an infinite end of a range is `null`. No document carries timings: same input, same bytes.

mod atlas;
mod border;
mod certificate;
mod checksum;
mod classification;
mod critical;
mod find;
mod inertia;
mod listing;
mod motion;
mod scan;
mod section;

pub use atlas::{
    AtlasDocument, BodyDocument, CellDocument, CurveDocument, CurveKind, EnclosureDocument, EventDocument, EventKind,
    Flags, NeighbourDocument, RegionDocument, SampleDocument, StabilitySpan, SummaryDocument, TailDocument,
    UndecidedDocument, WindowDocument,
};
pub use border::{BorderDocument, BorderEventDocument, BorderEventName, BorderValueDocument};
pub use certificate::{
    CertificateDocument, CertificateUnits, CertifiedCusp, CertifiedEvent, CertifiedHeight, CertifiedMeeting,
    CertifiedNode, CertifiedPair, CertifiedSample, CertifiedSlab, CertifiedStretch, PlaceDocument,
};
pub use checksum::checksum;
pub use classification::{ClassificationDocument, ComponentDocument, MarginDocument, Status};
pub use critical::{CriticalDocument, Multiplicity, RelativeEquilibriumDocument, Stability};
pub use find::{FindDocument, NearestDocument, WitnessDocument};
pub use inertia::{InertiaDocument, UnitsDocument};
pub use listing::{BatchErrorDocument, BodiesDocument, PresetDocument};
pub use motion::{MotionDocument, MotionSampleDocument, MotionSummaryDocument};
pub use scan::{
    BodyRecordDocument, ClassRecordDocument, DesignDocument, FamilyDocument, ParameterName, RangeDocument,
    RecordDocument, RowDocument, RowStatus, ScanIdentityDocument, ScanSummaryDocument,
};
pub use section::{
    ChaosDocument, ConditionName, DriftDocument, EndName, IntegratorDocument, IntegratorName, LyapunovDocument,
    OrbitDocument, RotationAngleName, RotationDocument, SectionDocument, SectionSummaryDocument, SectionsDocument,
    SkippedDocument, StartsDocument,
};

/// Version of every document in this module.
pub const SCHEMA_VERSION: &str = "1";

/// How much is spent on an answer, and what it is worth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Accuracy {
    /// Coarser and more often undecided, never wrong.
    Draft,
    /// f64 with error bounds; undecided where they do not suffice.
    #[default]
    Standard,
    /// Proved.
    Certified,
}
