//! Periodic orbits: their families from the relative equilibria, and all short ones at a point of the (h, l) plane.

pub mod catalogue;
pub mod chain;
pub mod chart;
pub mod family;
pub mod flow;
pub mod list;
pub mod manifold;
pub mod orbit;
pub mod proof;
pub mod reversor;
pub mod section_map;
pub mod shooting;
pub mod walk;
