//! Root finding, interval arithmetic, partitions, low-discrepancy sequences; knows nothing of rigid bodies.

pub mod bernstein;
pub mod interval;
pub mod partition;
pub mod root;
pub mod sequence;

/// Unit roundoff of `f64`: half the distance from 1 to the next double.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;
