//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

pub mod accessible;
pub mod arrangement;
pub mod atlas;
pub mod body;
pub mod border;
pub mod certified;
pub mod class;
pub mod classify;
pub mod continuation;
pub mod critical;
pub mod digest;
pub mod document;
pub mod dynamics;
pub mod equilibria;
pub mod integrator;
pub mod motion;
pub mod numerics;
#[cfg(feature = "plot")]
pub mod plot;
pub mod poincare;
pub mod scan;
pub mod search;
pub mod section;
pub mod stability;
pub mod topology;
pub mod verify;

/// The Rust examples of the documentation are tests.
#[cfg(all(doctest, feature = "plot"))]
mod documentation {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../docs/library.md")]
    mod library {}
}
