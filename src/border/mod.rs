//! Borders between classes: where the class changes on the way from one body to another, and what happens there.

mod bisection;
mod event;
mod segment;

pub use bisection::{Border, BorderError, BorderOptions, find};
pub use event::{BorderEvent, BorderEventKind};
pub use segment::Segment;
