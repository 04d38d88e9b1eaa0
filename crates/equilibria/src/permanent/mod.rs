//! Rotation about a principal axis through the centre of mass, which is permanent at every spin.
//!
//! With the vertical along the axis k, ρ = ⟨γ, r⟩ (positive: hanging), C = A_k, the other moments A and B, and s = Ω²:
//! h = sC/2 − ρ, l = CΩ, and by Theorem 13.1 of docs/mathematics.md the eigenvalues of the linearised flow satisfy
//! λ⁴ + bλ² + c = 0 with
//!
//! - c = K_A K_B / (AB), K_A = ρ + s(C − A), K_B = ρ + s(C − B),
//! - b = [s(A + B − C)² + A K_A + B K_B] / (AB).
//!
//! All are polynomials in s with rational coefficients: where the type changes is a root of K_A, K_B or of the quadratic
//! (AB)²(b² − 4c), isolated exactly.

mod axis;
mod certain;
mod cone;
mod fast;
mod judged;
mod near;
mod one_spin;
mod path;
mod rotation;
mod square;
mod steady;
mod stretches;
mod tolerance;

pub use axis::{AxisKind, FOLLOWED, MEANT, permanent_axes, permanent_multiplicity, principal_at};
pub use bifdiag_schema::{AxisEnd, SpinType};
pub use cone::{
    NearestAxis, PermanentAxis, angle_between, equally_near, is_axis_of_circular_cone, nearest_permanent,
    permanent_axis,
};
pub use fast::fastest_along;
pub use judged::Judged;
pub use near::{
    Near, SettledTypes, sampled_parts, sampled_shares, settled_types, settled_types_of_part, settled_types_of_shares,
};
pub use one_spin::OneSpin;
pub use path::NominalRotation;
pub use rotation::{AxisRotation, SpinChange};
pub use square::{BoxedBody, Vector};
pub use steady::{SteadyRotation, nearest_steady};
pub use stretches::SpinStretch;
pub use tolerance::{INPUTS, SAMPLES, SpinRange, sampled_bodies, spin_ranges};
