//! Many bodies: what a scan notes about each, and what all of them have in common.
//!
//! A [`Design`](crate::Design) numbers its bodies; body n depends on n alone, so that a scan can be cut into shards,
//! stopped and taken up again. [`Row::of`] looks at one body, a [`Summary`] counts. Nothing here reads files or starts
//! threads.

mod known;
mod row;
mod shard;
mod summary;

pub use known::known_classes;
pub use row::{DiagramCounts, Room, Row, Status};
pub use shard::{ParseShardError, Shard};
pub use summary::{BodyRecord, ClassRecord, Record, Summary, class_text};
