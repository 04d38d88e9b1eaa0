//! The JSON documents made from results: names, units and words; nothing is decided here.

pub mod atlas;
mod body;
mod certified;
mod classification;
mod critical;
mod find;
pub mod layout;
mod section;

pub use atlas::DocumentOptions;
pub use body::{all_bodies, flags, part, texts};
pub use certified::{certified_atlas, seal};
pub use classification::{candidate, classification, component, margin};
pub use critical::critical;
pub use find::witness;
pub use section::{chaos, drift, integrator, section, sections};
