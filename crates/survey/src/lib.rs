//! Many bodies: scans, the borders between classes, the search for types.

pub mod border;
mod design;
pub mod events;
pub mod nearest;
mod parallel;
mod parameter;
pub mod path;
pub mod scan;
pub mod search;
mod signature;
pub mod space;
pub mod strata;
pub mod subdivision;
pub mod tolerance;

pub use design::{BodyFamily, BodyList, Design, DesignError};
pub use parameter::{ParameterRange, ParseRangeError, parameter, with_values};
pub use signature::{ComponentType, ParseComponentTypeError, Signature};
