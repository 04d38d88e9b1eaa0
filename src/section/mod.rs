//! Poincaré sections: crossings of S = Ẇ = 0 and their 1:1 image on the PP-torus.

#![expect(clippy::inline_always, reason = "lanes must be inlined into the function compiled for their instructions")]

mod angle;
pub mod chaos;
mod condition;
mod error;
mod follow;
mod newton;
mod readings;
mod roots;
mod scan;
mod starts;
mod sweep;
mod torus;

pub use condition::SectionCondition;
pub use error::SectionError;
pub use starts::{StartOptions, spread_starts, spread_starts_over};
pub use sweep::{End, Monitor, OrbitReport, OrbitSection, SectionPoint, SweepOptions, sweep};
pub use torus::{PpTorus, TorusPoint};
