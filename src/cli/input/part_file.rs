//! A part from a file.

use std::path::Path;

use part::link::{LinkError, read_link};
use part::mesh::{Mesh, MeshError, MeshFormat, ReadError};
use part::{MassError, MassProperties, Units};
use thiserror::Error;
use top::body::Number;

/// What the options say beside the file.
pub struct FileOptions<'a> {
    pub link: Option<&'a str>,
    pub density: Option<&'a Number>,
    pub mass: Option<&'a Number>,
}

/// Mass properties from a file, in the file's frame.
pub struct FilePart {
    pub properties: MassProperties,
    /// The file's own units, where it has any.
    pub units: Option<Units>,
}

/// A file gives no part.
#[derive(Debug, Error)]
pub enum PartFileError {
    #[error("{0}")]
    Io(#[from] std::io::Error),
    #[error("the name ends in none of .stl, .obj, .ply (meshes), .urdf, .xml (inertial blocks)")]
    Suffix,
    #[error("the file is no text in UTF-8")]
    Text(#[from] std::string::FromUtf8Error),
    #[error(transparent)]
    Link(#[from] LinkError),
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error(transparent)]
    Mesh(#[from] MeshError),
    #[error("a mesh has no mass: give --density (in the units of mass and length of --units) or --mass")]
    NoDensity,
    #[error("--density and --mass both say how heavy the mesh is; give one")]
    DensityAndMass,
    #[error("{option} does nothing with {kind}")]
    Useless { option: &'static str, kind: &'static str },
    #[error(transparent)]
    Mass(#[from] MassError),
}

enum Kind {
    Mesh(MeshFormat),
    Link,
}

fn kind(path: &Path) -> Result<Kind, PartFileError> {
    let suffix = path.extension().and_then(|suffix| suffix.to_str()).map(str::to_ascii_lowercase);
    match suffix.as_deref() {
        Some("stl") => Ok(Kind::Mesh(MeshFormat::Stl)),
        Some("obj") => Ok(Kind::Mesh(MeshFormat::Obj)),
        Some("ply") => Ok(Kind::Mesh(MeshFormat::Ply)),
        Some("urdf" | "xml") => Ok(Kind::Link),
        _ => Err(PartFileError::Suffix),
    }
}

pub fn read(path: &Path, options: &FileOptions<'_>) -> Result<FilePart, PartFileError> {
    match kind(path)? {
        Kind::Link => {
            let useless = [("--density", options.density.is_some()), ("--mass", options.mass.is_some())];
            if let Some((option, _)) = useless.into_iter().find(|(_, given)| *given) {
                return Err(PartFileError::Useless { option, kind: "an inertial block, which has its own mass" });
            }
            let text = String::from_utf8(std::fs::read(path)?)?;
            Ok(FilePart { properties: read_link(&text, options.link)?, units: Some(Units::default()) })
        }
        Kind::Mesh(format) => {
            if options.link.is_some() {
                return Err(PartFileError::Useless { option: "--link", kind: "a mesh, which has no links" });
            }
            let integrals = Mesh::read(&std::fs::read(path)?, format)?.integrals()?;
            let properties = match (options.density, options.mass) {
                (Some(_), Some(_)) => return Err(PartFileError::DensityAndMass),
                (Some(density), None) => integrals.with_density(density.value())?,
                (None, Some(mass)) => integrals.with_mass(mass.value())?,
                (None, None) => return Err(PartFileError::NoDensity),
            };
            Ok(FilePart { properties, units: None })
        }
    }
}

/// The edges of a mesh, from a point, as far as they can be told apart in a picture; none of another file.
pub fn edges(path: &Path, pivot: [f64; 3]) -> Vec<[[f64; 3]; 2]> {
    /// More would be a grey surface.
    const MOST: usize = 20_000;
    let Ok(Kind::Mesh(format)) = kind(path) else { return Vec::new() };
    let Some(mesh) = std::fs::read(path).ok().and_then(|bytes| Mesh::read(&bytes, format).ok()) else {
        return Vec::new();
    };
    let corner = |k: usize| std::array::from_fn(|i| mesh.corners()[k][i] - pivot[i]);
    let sides = mesh.triangles().iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    sides.filter(|[a, b]| a < b).take(MOST).map(|ends| ends.map(corner)).collect()
}
