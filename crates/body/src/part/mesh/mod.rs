//! Closed surfaces of triangles and the exact mass properties of what they enclose.

mod closed;
mod crossing;
mod error;
mod integrals;
mod read;
mod surface;

pub use error::MeshError;
pub use integrals::VolumeIntegrals;
pub use read::{MeshFormat, ReadError};
pub use surface::Mesh;

impl Mesh {
    /// The integrals over the enclosed volume: exact for the coordinates as they are.
    ///
    /// # Errors
    /// Every [`MeshError`].
    pub fn integrals(&self) -> Result<VolumeIntegrals, MeshError> {
        if let Some(at) = self.corners().iter().position(|corner| !corner.iter().all(|x| x.is_finite())) {
            return Err(MeshError::NotFinite { corner: at + 1 });
        }
        closed::check_edges(self)?;
        crossing::check(self)?;
        closed::check_sides(self)?;
        Ok(VolumeIntegrals::over(self, self.triangles()))
    }
}
