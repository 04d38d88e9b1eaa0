//! Why a mesh encloses no part.

use thiserror::Error;

/// Why a mesh encloses no part.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    /// No triangle.
    #[error("the mesh is empty: it has no triangle with three different corners")]
    Empty,
    /// A coordinate that is no number.
    #[error("corner {corner} of the mesh is not finite")]
    NotFinite {
        /// Its number, from 1.
        corner: usize,
    },
    /// Edges with one triangle only.
    #[error(
        "the mesh is open: {edges} edges belong to one triangle only, such as that from {from:?} to {to:?}; export a closed \
         solid (watertight, all faces, fine enough that corners of neighbours agree)"
    )]
    Open {
        /// How many.
        edges: usize,
        /// One end of one of them.
        from: [f64; 3],
        /// Its other end.
        to: [f64; 3],
    },
    /// Neighbours that disagree about inside and outside.
    #[error(
        "the mesh has mixed orientation: across {edges} edges, such as that from {from:?} to {to:?}, neighbouring triangles \
         do not agree on which side is outside; make the normals consistent in the program that wrote it"
    )]
    Mixed {
        /// How many.
        edges: usize,
        /// One end of one of them.
        from: [f64; 3],
        /// Its other end.
        to: [f64; 3],
    },
    /// More than two triangles at an edge.
    #[error(
        "the mesh is no surface: {edges} edges belong to more than two triangles, such as that from {from:?} to {to:?}; \
         unite the bodies or remove faces inside"
    )]
    Branched {
        /// How many.
        edges: usize,
        /// One end of one of them.
        from: [f64; 3],
        /// Its other end.
        to: [f64; 3],
    },
    /// Triangles that pass through one another.
    #[error(
        "the mesh cuts itself: {pairs} pairs of triangles pass through each other, such as at the edge from {from:?} to \
         {to:?}; space inside would be counted twice or not at all: unite the bodies in the program that wrote it"
    )]
    Crossing {
        /// How many.
        pairs: usize,
        /// One end of an edge that passes through a triangle.
        from: [f64; 3],
        /// Its other end.
        to: [f64; 3],
    },
    /// A surface that is inside out.
    #[error(
        "the mesh is inverted: a closed surface of {triangles} triangles encloses the volume {volume}, but lies in no other \
         one; turn its normals outward"
    )]
    Inverted {
        /// Triangles of the surface.
        triangles: usize,
        /// Its negative volume, rounded.
        volume: f64,
    },
    /// A surface inside another one with the same orientation.
    #[error(
        "the mesh counts space twice: a closed surface of {triangles} triangles lies inside another one; unite the bodies, \
         or turn the normals of a cavity inward"
    )]
    Nested {
        /// Triangles of the inner surface.
        triangles: usize,
    },
}
