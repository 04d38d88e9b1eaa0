//! Scans as documents, and read back from them.

mod design;
mod error;
mod row;
mod summary;

pub use design::{command, design, parameter, range, read_design};
pub use error::ReadScanError;
pub use row::{read_row, row};
pub use summary::{ScanFile, scan_summary};
