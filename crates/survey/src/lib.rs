//! Many bodies: scans, borders between classes, the search for types.

pub mod border;
pub mod scan;
pub mod search;
