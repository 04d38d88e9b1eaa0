//! Bodies: exact input, validation, and the frame in which the rest of the crate computes.

mod frame;
mod inertia;
mod presets;
mod rigid_body;

pub use frame::{Frame, SymmetricSums};
pub use inertia::{InertiaError, MassProperties, PrincipalBody, Realizability};
pub use numbers::{Number, ParseNumberError};
pub use presets::Preset;
pub use rigid_body::{Body, BodyError, Flags};
