//! Which curve lies above which, where curves meet, and the faces between them.

pub(crate) mod events;
mod gap;
pub(crate) mod gluing;
mod mirror;
mod node;
pub(crate) mod orders;
pub(crate) mod pairs;
pub(crate) mod regions;
mod rules;
pub(crate) mod slabs;
