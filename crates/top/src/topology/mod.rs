//! Topology of the accessible region U_hl, found in two ways that share no code.

mod component;
pub mod latitude;
pub mod merge;
mod occurring;
mod potential;
mod surface;

pub use component::{Component, Poles, signature, sort_components};
pub use occurring::{CIRCLES_MAX, accessible_regions};
pub use surface::{ParseSurfaceError, Surface};
