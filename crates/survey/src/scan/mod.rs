//! Many bodies: which bodies a scan looks at, what it notes about each, and what all of them have in common.
//!
//! A [`Design`] numbers its bodies; body n depends on n alone, so that a scan can be cut into shards, stopped and taken
//! up again. [`Row::of`] looks at one body, a [`Summary`] counts. Nothing here reads files or starts threads.

mod design;
mod parameter;
mod row;
mod summary;

pub use design::{Design, DesignError, Family, Range};
pub use numbers::sequence::point;
pub use parameter::{Parameter, ParseParameterError, ParseRangeError};
pub use row::{Row, Status};
pub use summary::{BodyRecord, ClassRecord, Record, Summary, SummaryDocument};
