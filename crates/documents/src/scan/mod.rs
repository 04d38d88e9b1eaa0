//! Scans as documents, and read back from them.

mod design;
mod error;
mod row;
mod summary;

pub use design::{command, design, range, read_design};
pub use error::ReadScanError;
pub use row::{read_row, row};
pub use summary::scan_summary;
