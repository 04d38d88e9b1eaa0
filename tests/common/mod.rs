//! What several tests share: random bodies in every stratum and a flood fill as an independent method.
#![allow(dead_code)]

pub mod bodies;
pub mod extremes;
pub mod flood_fill;
pub mod random;
