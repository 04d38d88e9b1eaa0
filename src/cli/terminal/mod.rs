//! What the terminal shows and says: answers on stdout, everything else on stderr; signals.

pub mod interrupt;
mod progress;
mod report;
mod stderr;

pub use bifdiag_numbers::decimal::{all_apart, bound, bound_below, counted, fixed, significant, told_apart};
pub use progress::{Progress, Timings};
pub use report::{Report, Table, print, wrapped};
pub use stderr::{is_terminal, log, say, say_styled};
