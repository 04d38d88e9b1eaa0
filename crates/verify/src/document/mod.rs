//! Everything that a document says beside its certificate.

pub(crate) mod curves;
pub(crate) mod listing;
mod part;
pub(crate) mod samples;
pub(crate) mod totals;
