//! Certified mathematics.
mod curves;
mod enclosure;
mod estimate;
mod family;
mod model;
mod pair;
mod point;
mod polynomial;
mod wide;
