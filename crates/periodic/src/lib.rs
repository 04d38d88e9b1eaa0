//! Periodic orbits: their families from the relative equilibria, and all short ones at a point of the (h, l) plane.

pub mod family;
pub mod flow;
pub mod orbit;
pub mod reversor;
pub mod shooting;
pub mod walk;
