//! States and spins: `bifdiag state`, `bifdiag critical-spin`, `bifdiag campbell`, `bifdiag spin-down`.

mod all;
mod axis;
mod campbell;
mod changes;
mod critical;
mod down;
mod given;
mod state;
mod steady;
mod tolerance;

pub use campbell::{CAMPBELL_EXAMPLES, CampbellArguments, run as campbell};
pub use critical::{CRITICAL_SPIN_EXAMPLES, CriticalSpinArguments, run as critical_spin};
pub use down::{SPIN_DOWN_EXAMPLES, SpinDownArguments, run as spin_down};
pub use given::{SPIN_DIGITS, as_given, that_can_be_given};
pub use state::{STATE_EXAMPLES, StateArguments, run as state};
