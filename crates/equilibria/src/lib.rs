//! Relative equilibria of a heavy rigid body: the critical points of U_l on the Poisson sphere, in closed form.

pub mod critical;
pub mod curves;
pub mod nonlinear;
pub mod permanent;
pub mod stability;
