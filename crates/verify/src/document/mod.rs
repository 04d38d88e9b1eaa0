//! What a document says beside its certificate.

mod command;
pub(crate) mod courses;
pub(crate) mod listing;
pub(crate) mod measures;
mod part;
pub(crate) mod samples;
pub(crate) mod totals;
