//! The JSON documents made from results: names, units and words; nothing is decided here.

pub mod atlas;
mod body;
mod border;
mod certified;
mod classification;
mod critical;
mod find;
pub mod layout;
pub mod scan;
mod section;
mod witnesses;

pub use atlas::DocumentOptions;
pub use body::{all_bodies, flags, part, texts};
pub use border::border;
pub use certified::{certified_atlas, seal};
pub use classification::{candidate, classification, component, margin};
pub use critical::critical;
pub use find::{find, witness};
pub use section::{chaos, drift, integrator, section, sections};
pub use witnesses::{ReadWitnessError, read_witness, shipped_witnesses};
