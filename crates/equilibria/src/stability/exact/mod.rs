//! Stability decided in exact arithmetic: the conditions for a change of the linear type as integer polynomials in the
//! parameter of each family (Proposition 13.4 of docs/mathematics.md), their roots isolated without exception.

mod body;
mod forms;
mod points;
mod profile;
mod strand;

pub use body::ExactBody;
pub use forms::Forms;
pub use points::{ExactPoint, Touch};
pub use profile::{Profile, Station, StationKind};
pub use strand::{Family, Strand};
