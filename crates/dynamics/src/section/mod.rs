//! Poincaré sections: crossings of S = Ẇ = 0 and their 1:1 image on the PP-torus.

#![expect(clippy::inline_always, reason = "lanes must be inlined into the function compiled for their instructions")]

mod angle;
pub mod chaos;
mod condition;
mod error;
mod follow;
mod halley;
mod orbit;
mod portrait;
mod readings;
mod roots;
mod scan;
mod starts;
mod sweep;
mod torus;
mod workers;

pub use condition::SectionCondition;
pub use error::SectionError;
pub use orbit::{FAMILIES, OrbitEnd, OrbitReport, OrbitSection, SectionPoint, SweepOptions, families};
pub use portrait::{ChartArea, Portrait, PortraitOptions, PortraitReport, SectionChart, SectionLine};
pub use starts::{StartOptions, spread_starts, spread_starts_over, spread_starts_round};
pub use sweep::{sweep, sweep_on};
pub use torus::{PpTorus, TorusPoint};
pub use workers::{Monitor, OrbitCheckpoint, OrbitTask};
