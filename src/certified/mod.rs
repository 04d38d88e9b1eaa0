//! Certified mathematics.
mod curves;
mod enclosure;
mod estimate;
mod family;
mod model;
mod polynomial;
mod wide;
