//! Bifurcation diagrams, energy-surface topology and Poincaré sections of any heavy rigid body.
//!
//! A body is its principal moments A and its centre of mass r; everything about it at energy h and vertical angular
//! momentum l follows from exact numbers:
//!
//! ```
//! use bifdiag::{Accuracy, Body, atlas, classify};
//!
//! let body = Body::parse(&["2", "11/10", "1"], &["0.94868", "0", "0.61623"])?;
//! // One point: the components of U_hl with the energy surface and the section over each.
//! let found = classify(&body, &"3.8".parse()?, &"3.25".parse()?, Accuracy::Exact)?;
//! let sections: Vec<_> = found.components().unwrap().iter().map(|component| component.section().unwrap()).collect();
//! assert_eq!(sections, ["S2", "T2"]);
//! // The whole plane.
//! assert_eq!(atlas(&body, Accuracy::Exact)?.regions().len(), 9);
//! # Ok::<_, Box<dyn std::error::Error>>(())
//! ```
//!
//! These names are what one needs for a start. Each layer below is a package of its own and is re-exported whole, in the
//! order in which the data flows: [`numbers`], [`body`] (and [`body::part`], mass properties as engineers have them),
//! [`equilibria`], [`diagram`], [`exact`] (proofs), [`dynamics`] (motion in time), [`enclosure`] (the same with
//! proved bounds), [`chaos`] (its share), [`periodic`] (periodic orbits), [`survey`] (many bodies), [`schema`] and
//! [`documents`] (JSON), [`verify`], and `plot`.

#[cfg(feature = "cli")]
pub mod cli;

#[cfg(feature = "plot")]
pub mod pictures;

#[cfg(feature = "plot")]
pub use bifdiag_plot as plot;
#[cfg(feature = "plot")]
pub use pictures::Curves;
pub use {
    bifdiag_body as body, bifdiag_chaos as chaos, bifdiag_documents as documents, bifdiag_dynamics as dynamics,
    bifdiag_enclosure as enclosure, bifdiag_equilibria as equilibria, bifdiag_exact as exact,
    bifdiag_numbers as numbers, bifdiag_periodic as periodic, bifdiag_schema as schema, bifdiag_survey as survey,
    bifdiag_verify as verify,
};

/// Regions and their topology. The answers themselves are [`atlas`], [`classify`] and [`critical`].
pub mod diagram {
    pub use bifdiag_diagram::{accessible, arrangement, atlas, class, region_changes, topology};
}

pub use bifdiag_body::Body;
pub use bifdiag_diagram::atlas::{Atlas, Region};
pub use bifdiag_diagram::topology::{Answer, Classification, Component, Margin};
pub use bifdiag_dynamics::poincare::{PoincareSection, SectionSetting};
pub use bifdiag_equilibria::critical::Equilibria;
pub use bifdiag_equilibria::curves::CurveName;
pub use bifdiag_exact::{Accuracy, AnswerError, CertifiedAtlas, Solver, atlas, classify, critical};
pub use bifdiag_numbers::Number;

/// The Rust examples of the documentation are tests.
#[cfg(all(doctest, feature = "plot"))]
mod documentation {
    #[doc = include_str!("../README.md")]
    mod readme {}
    #[doc = include_str!("../docs/library.md")]
    mod library {}
}
