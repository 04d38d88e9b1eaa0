//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

pub mod arrangement;
pub mod atlas;
pub mod body;
pub mod classify;
pub mod critical;
pub mod document;
pub mod equilibria;
pub mod numerics;
#[cfg(feature = "plot")]
pub mod plot;
pub mod topology;
