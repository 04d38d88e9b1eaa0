//! The body's motion in space: from γ(t) and l(t) to the attitude, as a quaternion and as Euler's angles.
//!
//! γ is the vertical seen from the body. What it leaves open, the rotation about the vertical, is found in two ways
//! that share nothing but the motion of γ and l:
//!
//! - the **attitude** by the linear equation q̇ = ½ q ω, integrated by power series; it has no singular point;
//! - the **angle φ** by quadrature of φ̇ = (ω₁γ₁ + ω₂γ₂)/(γ₁² + γ₂²). Near γ = ±e₃, where φ̇ is singular, the sum
//!   φ + ψ (near e₃) or the difference φ − ψ (near −e₃) is integrated, which is smooth there, and ψ follows from γ.
//!
//! Every sample says how far apart the two are. (Proposition 12.4 and Proposition 12.5 of docs/algorithms.md.)
//!
//! **Angles.** R = R_z(φ) R_x(ϑ) R_z(ψ) takes vectors of the body to space; its third row is
//! γ = (sinψ sinϑ, cosψ sinϑ, cosϑ).

mod attitude;
mod azimuth;
mod follow;
mod piece;

pub use attitude::Quaternion;
pub use azimuth::azimuth_rate;
pub use follow::{Motion, MotionError, MotionOptions, MotionReport, MotionSample, follow};
