//! The Euler–Poisson equations in the body's own principal coordinates: γ̇ = γ×ω, l̇ = l×ω − γ×r, ω = A⁻¹l.

mod heavy_top;
mod integrals;
mod units;
mod vector;

pub use heavy_top::{HeavyTop, State};
pub use integrals::{Integrals, kovalevskaya};
pub use units::{Dimension, Units};
pub use vector::{add, cross, dot, norm, scale, sub, unit};
