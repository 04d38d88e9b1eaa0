//! Poincaré sections: crossings of S = Ẇ = 0 and their 1:1 image on the PP-torus.

#![expect(clippy::inline_always, reason = "lanes must be inlined into the function compiled for their instructions")]

mod angle;
pub mod chaos;
mod condition;
mod error;
mod families;
mod follow;
mod halley;
mod halt;
mod orbit;
mod polish;
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
pub use families::{FAMILIES, families};
pub use halt::{Halt, Task};
pub use orbit::{End, OrbitReport, OrbitSection, SectionPoint, SweepOptions};
pub use portrait::{Area, Chart, Line, Portrait, PortraitOptions, PortraitReport};
pub use starts::{StartOptions, spread_starts, spread_starts_over, spread_starts_round};
pub use sweep::{sweep, sweep_on};
pub use torus::{PpTorus, TorusPoint};
pub use workers::Monitor;
