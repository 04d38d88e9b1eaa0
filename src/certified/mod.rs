//! Certified mathematics.
mod arrange;
mod curves;
mod enclosure;
mod estimate;
mod family;
mod model;
mod pair;
mod point;
mod polar;
mod polynomial;
mod wide;
