//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

pub mod body;
pub mod continuation;
pub mod document;
pub mod stability;
pub mod topology;
