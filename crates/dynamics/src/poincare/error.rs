//! Why there is no section.

use thiserror::Error;

use crate::section::SectionError;
use bifdiag_diagram::fast::FastError;
use bifdiag_diagram::topology::merge::MergeError;
use bifdiag_equilibria::critical::CriticalError;
use bifdiag_numbers::Number;

/// What a point is too near to in the bifurcation diagram.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Near {
    /// A curve.
    #[error(
        "(h, l) = ({h}, {l}) is too near to the curve {curve} of the bifurcation diagram for a section in double \
         precision (distance {distance:.1e} in h, error bound {error_bound:.1e}); choose h farther from it"
    )]
    Curve {
        /// h as given.
        h: String,
        /// l as given.
        l: String,
        /// Id of the curve.
        curve: String,
        /// Distance in h.
        distance: f64,
        /// Bound on its error.
        error_bound: f64,
    },
    /// An event, where curves end or cross, or curves whose order is not known.
    #[error(
        "near l = {l} the order of the curves of the bifurcation diagram is not certain in double precision, as beside an \
         event; choose another l"
    )]
    Order {
        /// l as given.
        l: String,
    },
}

/// What is said of a lowest energy that, rounded, is not above h.
fn rounding(h: &str, lowest: f64) -> &'static str {
    if h.parse::<Number>().is_ok_and(|h| h.to_f64() < lowest) { "" } else { ", rounded" }
}

/// The shortest decimal of a double, with an exponent where zeros would be written out.
fn shortest(x: f64) -> String {
    if x == 0.0 || (1e-4..1e7).contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

/// Why there is no section at a point, or why it could not be computed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PoincareError {
    /// r = 0.
    #[error(
        "r = 0: S = ⟨ω, r×γ⟩ vanishes identically, so that this section does not exist for a body without weight; \
         give a body with r ≠ 0"
    )]
    WeightlessBody,
    /// h is below the minimum of the effective potential.
    #[error(
        "(h, l) = ({h}, {l}) is forbidden: the lowest energy at l = {l} is {}{} (curve {branch}); choose h above it",
        shortest(*lowest),
        rounding(h, *lowest)
    )]
    Forbidden {
        /// h as given.
        h: String,
        /// l as given.
        l: String,
        /// The lowest energy at this l.
        lowest: f64,
        /// The branch of relative equilibria with this energy.
        branch: String,
    },
    /// (h, l) lies on a curve of the bifurcation diagram, where the section is no surface or its image changes.
    #[error(
        "(h, l) = ({h}, {l}) lies on the curve {curve} of the bifurcation diagram, where the topology changes; \
         choose h above or below"
    )]
    OnCurve {
        /// h as given.
        h: String,
        /// l as given.
        l: String,
        /// Id of the curve.
        curve: String,
    },
    /// (h, l) is nearer to a curve, or l to an event, than `f64` resolves, in which motions are computed.
    #[error("{near}, or ask bifdiag classify for the topology at (h, l)")]
    Undecided {
        /// What is near.
        near: Near,
    },
    /// The point could not be classified.
    #[error(transparent)]
    Classify(#[from] FastError),
    /// The relative equilibria could not be found.
    #[error(transparent)]
    Critical(#[from] CriticalError),
    /// The components could not be separated.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// The section itself.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// No start could be found in a component.
    #[error("no starting point was found in component {component} of the accessible region, which is too small")]
    NoStart {
        /// Its number, from 0.
        component: usize,
    },
}
