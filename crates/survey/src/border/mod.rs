//! Borders between classes: where the class changes on the way from one body to another, and what happens there.
//!
//! [`find`] bisects on the class. The difference of the two diagrams that are left tells the event ([`BorderEvent`]), and
//! with it a function of the parameter that vanishes there; its zero gives the border to the last digits.

mod bisection;
mod creation;
mod difference;
mod event;
mod exchange;
mod group;
mod label;
mod segment;
mod side;
mod special;
mod vanishing;

pub use bisection::{Border, BorderError, BorderOptions, all, find};
pub use event::{BorderEvent, BorderEventKind, Encounter, Place};
pub use label::{EventLabel, named_events};
pub use segment::Segment;
pub use side::{End, NoClass, class_of, classes_of};
