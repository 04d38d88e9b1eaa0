//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.

#[cfg(feature = "cli")]
pub mod cli;

/// The Rust examples of the documentation are tests.
#[cfg(all(doctest, feature = "plot"))]
mod documentation {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../docs/library.md")]
    mod library {}
}
