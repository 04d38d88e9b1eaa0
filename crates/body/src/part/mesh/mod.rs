//! Closed surfaces of triangles and the exact mass properties of what they enclose.

mod crossing;
mod integrals;
mod orientation;
mod read;
mod surface;

pub use integrals::VolumeIntegrals;
pub use read::{MeshFormat, ReadError};
pub use surface::{Mesh, MeshError};

impl Mesh {
    /// The integrals over the enclosed volume: exact for the coordinates as they are.
    ///
    /// # Errors
    /// Every [`MeshError`].
    pub fn integrals(&self) -> Result<VolumeIntegrals, MeshError> {
        if let Some(&at) = self.corners().iter().find(|corner| !corner.iter().all(|x| x.is_finite())) {
            return Err(MeshError::NotFinite { at });
        }
        let surfaces = orientation::surfaces(self)?;
        crossing::check(self)?;
        orientation::check_sides(self, &surfaces)?;
        Ok(VolumeIntegrals::over(self, self.triangles()))
    }
}
