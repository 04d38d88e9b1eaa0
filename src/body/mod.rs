//! Bodies: exact input, validation, and the frame in which the rest of the crate computes.

mod frame;
mod number;
mod rigid_body;

pub use frame::Frame;
pub use number::{Number, ParseNumberError};
pub use rigid_body::{Body, BodyError, Flags};
