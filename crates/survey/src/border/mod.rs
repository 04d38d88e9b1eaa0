//! Borders between classes: where the class changes on the way from one body to another, and what happens there.

mod bisection;
mod document;
mod event;
mod refine;
mod segment;

pub use bisection::{Border, BorderError, BorderOptions, find};
pub use document::{BorderDocument, BorderValue};
pub use event::{BorderEvent, BorderEventKind, named_events};
pub use segment::Segment;
