//! Topology of the accessible region U_hl, found in two ways that share no code.

mod component;
pub mod latitude;
pub mod merge;
mod potential;

pub use component::{Component, Poles, signature, sort_components};
