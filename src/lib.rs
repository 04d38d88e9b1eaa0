//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

pub mod body;
pub mod document;
#[cfg(feature = "plot")]
pub mod plot;
pub mod topology;
