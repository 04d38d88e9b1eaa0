//! Borders between classes: where the class changes on the way from one body to another, and what happens there.
//!
//! [`find`] bisects on the class. The difference of the two diagrams that are left determines the event ([`BorderEvent`]),
//! and with it a function of the parameter that vanishes there; its zero gives the border to the last digits.

mod bisection;
mod difference;
mod event;
mod group;
mod segment;
mod special;
mod vanishing;

pub(crate) use bisection::find_between;
pub use bisection::{Border, BorderError, BorderOptions, NoClass, all, class_of, classes_of, find};
pub(crate) use difference::between;
pub use event::{BorderEvent, BorderEventKind, Encounter, EventLabel, EventLocation, NamedEvent, named_events};
pub use segment::BodySegment;
pub(crate) use special::special;
pub(crate) use vanishing::{EventOfBranches, Neighbourhood, Vanishing};
