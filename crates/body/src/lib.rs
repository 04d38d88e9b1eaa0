//! Heavy rigid bodies: exact input, validation, and the frame in which everything else computes; real parts as engineers
//! have them.

mod axis;
mod coincidence;
mod frame;
mod integrable;
pub mod part;
mod presets;
mod principal;
mod rigid_body;

pub use axis::{Axis, BodyAxis};
pub use bifdiag_numbers::{Number, ParseNumberError};
pub use bifdiag_schema::Flags;
pub use frame::{Frame, SymmetricSums};
pub use integrable::{Holds, IntegrableCase};
pub use presets::Preset;
pub use principal::PrincipalForm;
pub use rigid_body::{Body, BodyError, Tensor, TensorError};
