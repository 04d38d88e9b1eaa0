//! A part from a file: a mesh or an inertial block, by the name's suffix.

use std::path::Path;

use bifdiag_numbers::Number;
use dashu_ratio::RBig;
use thiserror::Error;

use crate::part::link::{LinkError, read_link};
use crate::part::mesh::{Mesh, MeshError, MeshFormat, ReadError};
use crate::part::{MassError, MassProperties, Units};

/// What the file itself does not say.
#[derive(Clone, Copy, Debug, Default)]
pub struct FileOptions<'a> {
    /// Which link of an inertial block.
    pub link: Option<&'a str>,
    /// Density of a mesh, in its own units.
    pub density: Option<&'a Number>,
    /// Mass of a mesh.
    pub mass: Option<&'a Number>,
}

/// Mass properties from a file, in the file's frame.
#[derive(Clone, Debug)]
pub struct FilePart {
    /// In the file's own units, or in those of the mesh.
    pub properties: MassProperties,
    /// The file's own units, where it has any.
    pub units: Option<Units>,
    /// How large it is; of a mesh only.
    pub mesh: Option<MeshSize>,
}

/// How large a mesh is, in its own unit of length, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshSize {
    /// Its largest extent along an axis.
    pub extent: f64,
    /// Its volume.
    pub volume: f64,
}

/// Why a file gives no part.
#[derive(Debug, Error)]
pub enum FileError {
    /// It cannot be read.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// Solids of a CAD program.
    #[error(
        "{format} files are not read; export the solid from the CAD program as STL (binary, fine enough, with its unit of \
         length) and give that file with --units, such as kg,mm,s; or give the mass properties that the program prints: \
         --inertia-com, --com and --mass"
    )]
    Cad {
        /// Of which format.
        format: &'static str,
    },
    /// The format is unknown.
    #[error("the name ends in none of .stl, .obj, .ply (meshes), .urdf, .xml (inertial blocks)")]
    Suffix,
    /// XML must be text.
    #[error("the file is no text in UTF-8")]
    Text(#[from] std::string::FromUtf8Error),
    /// No inertial block.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// No mesh.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A mesh that bounds no volume.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Nothing says how heavy a mesh is.
    #[error("a mesh has no mass: its density or its mass, in the units of the part or with their own, must be given")]
    NoDensity,
    /// Two things say how heavy a mesh is.
    #[error("density and mass both say how heavy the mesh is; one of them is enough")]
    DensityAndMass,
    /// Something that the file says itself, or has not.
    #[error("{option} does nothing with {kind}; leave it out")]
    Useless {
        /// What was given.
        option: &'static str,
        /// What the file is.
        kind: &'static str,
    },
    /// The mass is not positive.
    #[error(transparent)]
    Mass(#[from] MassError),
}

impl FilePart {
    /// The mass properties relative to a point of the file's frame, and their units: a mesh is in the units that are given
    /// for it, an inertial block is brought to them, in which the point is, too.
    #[must_use]
    pub fn seen_from(self, pivot: &[RBig; 3], units: Option<Units>) -> (MassProperties, Units) {
        let (properties, units) = match (units, self.units) {
            (Some(units), Some(own)) => (self.properties.in_units(&own, &units), units),
            (units, own) => (self.properties, units.or(own).unwrap_or_default()),
        };
        (properties.seen_from(pivot), units)
    }
}

enum Kind {
    Mesh(MeshFormat),
    Link,
}

fn kind(path: &Path) -> Result<Kind, FileError> {
    let suffix = path.extension().and_then(|suffix| suffix.to_str()).map(str::to_ascii_lowercase);
    match suffix.as_deref() {
        Some("stl") => Ok(Kind::Mesh(MeshFormat::Stl)),
        Some("obj") => Ok(Kind::Mesh(MeshFormat::Obj)),
        Some("ply") => Ok(Kind::Mesh(MeshFormat::Ply)),
        Some("urdf" | "xml") => Ok(Kind::Link),
        Some("step" | "stp" | "stpz") => Err(FileError::Cad { format: "STEP" }),
        Some("iges" | "igs") => Err(FileError::Cad { format: "IGES" }),
        Some(
            "sldprt" | "sldasm" | "ipt" | "iam" | "f3d" | "fcstd" | "prt" | "x_t" | "x_b" | "3dm" | "3mf" | "brep",
        ) => Err(FileError::Cad { format: "such CAD" }),
        _ => Err(FileError::Suffix),
    }
}

/// Reads a part from a file.
///
/// # Errors
/// [`FileError`].
pub fn read(path: &Path, options: &FileOptions<'_>) -> Result<FilePart, FileError> {
    kind(path)?;
    of_bytes(path, std::fs::read(path)?, options)
}

/// Reads a part from the contents of a file, in the format that the suffix of its name says.
///
/// # Errors
/// [`FileError`].
pub fn of_bytes(name: &Path, bytes: Vec<u8>, options: &FileOptions<'_>) -> Result<FilePart, FileError> {
    match kind(name)? {
        Kind::Link => {
            let useless = [("density", options.density.is_some()), ("mass", options.mass.is_some())];
            if let Some((option, _)) = useless.into_iter().find(|(_, given)| *given) {
                return Err(FileError::Useless { option, kind: "an inertial block, which has its own mass" });
            }
            let text = String::from_utf8(bytes)?;
            Ok(FilePart { properties: read_link(&text, options.link)?, units: Some(Units::default()), mesh: None })
        }
        Kind::Mesh(format) => {
            if options.link.is_some() {
                return Err(FileError::Useless { option: "link", kind: "a mesh, which has no links" });
            }
            let mesh = Mesh::read(&bytes, format)?;
            let integrals = mesh.integrals()?;
            let size = MeshSize { extent: mesh.extent(), volume: integrals.volume.to_f64().value() };
            let properties = match (options.density, options.mass) {
                (Some(_), Some(_)) => return Err(FileError::DensityAndMass),
                (Some(density), None) => integrals.with_density(density.value())?,
                (None, Some(mass)) => integrals.with_mass(mass.value())?,
                (None, None) => return Err(FileError::NoDensity),
            };
            Ok(FilePart { properties, units: None, mesh: Some(size) })
        }
    }
}

/// The edges of a mesh relative to a point, at most as many as a picture can show; none of any other file.
#[must_use]
pub fn edges(path: &Path, pivot: [f64; 3]) -> Vec<[[f64; 3]; 2]> {
    /// With more edges the picture is a grey surface.
    const MOST: usize = 20_000;
    let Ok(Kind::Mesh(format)) = kind(path) else { return Vec::new() };
    let Some(mesh) = std::fs::read(path).ok().and_then(|bytes| Mesh::read(&bytes, format).ok()) else {
        return Vec::new();
    };
    let corner = |k: usize| std::array::from_fn(|i| mesh.corners()[k][i] - pivot[i]);
    let sides = mesh.triangles().iter().flat_map(|[a, b, c]| [[*a, *b], [*b, *c], [*c, *a]]);
    sides.filter(|[a, b]| a < b).take(MOST).map(|ends| ends.map(corner)).collect()
}
