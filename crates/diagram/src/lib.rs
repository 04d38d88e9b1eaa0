//! The diagram of a heavy rigid body in the (h, l) plane: the arrangement of its critical curves, and the topology on its
//! regions.

pub mod accessible;
pub mod arrangement;
pub mod atlas;
pub mod class;
pub mod fast;
pub mod region_changes;
pub mod spin_down;
pub mod topology;
