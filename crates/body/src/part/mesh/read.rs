//! Meshes from files: STL (ASCII and binary), OBJ, PLY (ASCII and binary).

use std::collections::HashMap;
use std::io::Cursor;

use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use thiserror::Error;

use super::surface::Mesh;

/// The file formats that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// STL.
    Stl,
    /// Wavefront OBJ.
    Obj,
    /// PLY.
    Ply,
}

/// Why a file cannot be read as a mesh.
#[derive(Debug, Error)]
pub enum ReadError {
    /// What the reader of STL or PLY says.
    #[error("not readable as {format}: {source}")]
    Read {
        /// The format's name.
        format: &'static str,
        /// What is wrong.
        source: std::io::Error,
    },
    /// What the reader of OBJ says.
    #[error("not readable as OBJ: {0}")]
    Obj(#[from] tobj::LoadError),
    /// Elements are missing.
    #[error("the PLY file has no {what}")]
    Ply {
        /// Which.
        what: &'static str,
    },
    /// A face refers to a corner that does not exist.
    #[error("a face names corner {index} (the first one is 0), but there {}", are(*count))]
    NoCorner {
        /// From 0.
        index: i64,
        /// How many there are.
        count: usize,
    },
}

/// So many corners are there.
fn are(count: usize) -> String {
    match count {
        0 => "is none".to_owned(),
        1 => "is only one".to_owned(),
        count => format!("are {count}"),
    }
}

impl Mesh {
    /// The mesh of a file's contents.
    ///
    /// Coordinates are what the format says: single precision in STL, decimals rounded to double precision in OBJ, the
    /// declared type in PLY. Faces with more than three corners are cut into triangles.
    ///
    /// # Errors
    /// [`ReadError`].
    pub fn read(bytes: &[u8], format: MeshFormat) -> Result<Self, ReadError> {
        match format {
            MeshFormat::Stl => stl(bytes),
            MeshFormat::Obj => obj(bytes),
            MeshFormat::Ply => ply(bytes),
        }
    }
}

fn stl(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let failed = |source| ReadError::Read { format: "STL", source };
    let mut reader = Cursor::new(bytes);
    let triangles = stl_io::create_stl_reader(&mut reader).map_err(failed)?;
    let triangles: Result<Vec<_>, _> =
        triangles.map(|triangle| triangle.map(|found| found.vertices.map(|corner| corner.0.map(f64::from)))).collect();
    Ok(Mesh::from_triangles(triangles.map_err(failed)?))
}

fn obj(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let options = tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() };
    // Materials say nothing about shapes.
    let materials = |_: &std::path::Path| Ok((Vec::new(), HashMap::default()));
    let (models, _) = tobj::load_obj_buf(&mut Cursor::new(bytes), &options, materials)?;
    let mut triangles = Vec::new();
    for model in &models {
        let mesh = &model.mesh;
        let count = mesh.positions.len() / 3;
        let corner = |index: &u32| {
            let at = 3 * *index as usize;
            let place = mesh.positions.get(at..at + 3);
            place.map(|p| [p[0], p[1], p[2]]).ok_or(ReadError::NoCorner { index: i64::from(*index), count })
        };
        for face in mesh.indices.chunks_exact(3) {
            triangles.push([corner(&face[0])?, corner(&face[1])?, corner(&face[2])?]);
        }
    }
    Ok(Mesh::from_triangles(triangles))
}

fn ply(bytes: &[u8]) -> Result<Mesh, ReadError> {
    let failed = |source| ReadError::Read { format: "PLY", source };
    let found = Parser::<DefaultElement>::new()
        .read_ply(&mut Cursor::new(bytes))
        .map_err(|error| failed(std::io::Error::other(error)))?;
    let vertices = found.payload.get("vertex").ok_or(ReadError::Ply { what: "element vertex" })?;
    let faces = found.payload.get("face").ok_or(ReadError::Ply { what: "element face" })?;
    let mut corners = Vec::with_capacity(vertices.len());
    for vertex in vertices {
        let coordinate = |name: &str| vertex.get(name).and_then(scalar);
        let place = coordinate("x").zip(coordinate("y")).zip(coordinate("z"));
        let ((x, y), z) = place.ok_or(ReadError::Ply { what: "coordinates x, y and z of a vertex" })?;
        corners.push([x, y, z]);
    }
    let mut triangles = Vec::new();
    for face in faces {
        let list = face.get("vertex_indices").or_else(|| face.get("vertex_index")).and_then(indices);
        let list = list.ok_or(ReadError::Ply { what: "vertex_indices of a face" })?;
        let corner = |index: i64| {
            let place = usize::try_from(index).ok().and_then(|at| corners.get(at));
            place.copied().ok_or(ReadError::NoCorner { index, count: corners.len() })
        };
        for pair in list.get(1..).unwrap_or_default().windows(2) {
            triangles.push([corner(list[0])?, corner(pair[0])?, corner(pair[1])?]);
        }
    }
    Ok(Mesh::from_triangles(triangles))
}

fn scalar(property: &Property) -> Option<f64> {
    match property {
        Property::Float(x) => Some(f64::from(*x)),
        Property::Double(x) => Some(*x),
        Property::Char(x) => Some(f64::from(*x)),
        Property::UChar(x) => Some(f64::from(*x)),
        Property::Short(x) => Some(f64::from(*x)),
        Property::UShort(x) => Some(f64::from(*x)),
        Property::Int(x) => Some(f64::from(*x)),
        Property::UInt(x) => Some(f64::from(*x)),
        _ => None,
    }
}

fn indices(property: &Property) -> Option<Vec<i64>> {
    fn all<T: Copy + Into<i64>>(list: &[T]) -> Vec<i64> {
        list.iter().map(|x| (*x).into()).collect()
    }
    Some(match property {
        Property::ListChar(list) => all(list),
        Property::ListUChar(list) => all(list),
        Property::ListShort(list) => all(list),
        Property::ListUShort(list) => all(list),
        Property::ListInt(list) => all(list),
        Property::ListUInt(list) => all(list),
        _ => return None,
    })
}
