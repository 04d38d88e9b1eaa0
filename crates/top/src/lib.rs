//! One heavy rigid body: its relative equilibria, its diagram in the (h, l) plane, and the topology on its regions.

pub mod accessible;
pub mod atlas;
pub mod body;
pub mod class;
pub mod classify;
pub mod continuation;
pub mod critical;
pub mod curves;
pub mod diagram;
pub mod permanent;
pub mod stability;
pub mod table;
pub mod topology;
