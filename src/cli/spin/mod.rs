//! States and spins: `bifdiag state`, `bifdiag critical-spin`, `bifdiag campbell`.

mod arguments;
mod campbell;
mod critical;
mod direction;
mod error;
mod rotation;
mod state;
mod steady;
mod tolerance;

pub use arguments::{
    CAMPBELL_EXAMPLES, CRITICAL_SPIN_EXAMPLES, CampbellArguments, CriticalSpinArguments, STATE_EXAMPLES, StateArguments,
};
pub use campbell::run as campbell;
pub use critical::run as critical_spin;
pub use state::run as state;
