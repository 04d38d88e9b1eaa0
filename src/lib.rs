//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

pub mod body;
pub mod document;
pub mod dynamics;
pub mod integrator;
pub mod section;
pub mod topology;
