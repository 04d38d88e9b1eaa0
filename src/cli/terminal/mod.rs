//! What the terminal shows and says: answers on stdout, everything else on stderr; signals.

pub mod interrupt;
mod log;
mod progress;
mod report;
mod stderr;
mod stdout;
mod table;
mod timings;

pub use bifdiag_numbers::decimal::{bound, fixed, significant};
pub use log::log;
pub use progress::Progress;
pub use report::Report;
pub use stderr::{is_terminal, say, say_styled};
pub use stdout::{OutputError, print};
pub use table::Table;
pub use timings::Timings;
