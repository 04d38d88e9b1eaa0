//! Bodies: exact input, validation, and the frame in which the rest of the crate computes.

mod axis;
mod error;
mod frame;
mod presets;
mod principal;
mod rigid_body;
mod tensor;

pub use axis::{Axis, BodyAxis};
pub use error::BodyError;
pub use frame::{Frame, SymmetricSums};
pub use numbers::{Number, ParseNumberError};
pub use presets::Preset;
pub use principal::PrincipalForm;
pub use rigid_body::{Body, Flags};
pub use tensor::{Tensor, TensorError};
