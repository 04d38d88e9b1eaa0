//! Everything that a document says beside its certificate.

pub(crate) mod curves;
mod integrable;
pub(crate) mod listing;
mod part;
pub(crate) mod point_claim;
pub(crate) mod samples;
mod tensor;
pub(crate) mod totals;
