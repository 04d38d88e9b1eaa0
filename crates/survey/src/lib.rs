//! Many bodies: scans, the borders between classes, the search for types.

pub mod border;
mod design;
pub mod katok;
pub mod mosaic;
mod parameter;
mod range;
pub mod scan;
pub mod search;
mod signature;

pub use design::{Design, DesignError, Family};
pub use parameter::{Parameter, ParseParameterError};
pub use range::{ParseRangeError, Range};
pub use signature::{ComponentType, ParseComponentTypeError, Signature};
