//! Topology of the accessible region U_hl, found in two ways that share no code.

mod answer;
mod component;
pub mod latitude;
pub mod merge;
mod occurring;
mod potential;

pub use answer::{Answer, Classification, Components, Margin};
pub use component::{Component, Poles, signature, sort_components, whole_sphere};
pub use component::{ParseSurfaceError, Surface};
pub(crate) use occurring::is_excluded;
pub use occurring::{CIRCLES_MAX, accessible_regions};
