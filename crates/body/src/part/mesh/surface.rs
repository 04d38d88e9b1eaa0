//! Triangles over shared corners, and why they may enclose no part.

use bifdiag_numbers::decimal::counted;
use thiserror::Error;

/// Triangles over shared corners, counter-clockwise as seen from outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    corners: Vec<[f64; 3]>,
    triangles: Vec<[usize; 3]>,
}

impl Mesh {
    /// A mesh from triangles given by their corners; equal corners become one, triangles without area between different
    /// corners stay, those with a corner twice go.
    #[must_use]
    pub fn from_triangles(triangles: impl IntoIterator<Item = [[f64; 3]; 3]>) -> Self {
        let mut numbers = std::collections::HashMap::new();
        let mut mesh = Self { corners: Vec::new(), triangles: Vec::new() };
        for triangle in triangles {
            let [a, b, c] = triangle.map(|corner| {
                // −0 is 0.
                let corner = corner.map(|x| x + 0.0);
                *numbers.entry(corner.map(f64::to_bits)).or_insert_with(|| {
                    mesh.corners.push(corner);
                    mesh.corners.len() - 1
                })
            });
            if a != b && b != c && c != a {
                mesh.triangles.push([a, b, c]);
            }
        }
        mesh
    }

    /// The corners.
    #[must_use]
    pub fn corners(&self) -> &[[f64; 3]] {
        &self.corners
    }

    /// The largest extent along an axis.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let along = |i: usize| {
            let ends = self.corners.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], corner| {
                [low.min(corner[i]), high.max(corner[i])]
            });
            ends[1] - ends[0]
        };
        (0..3).map(along).fold(0.0, f64::max)
    }

    /// The triangles, by their corners' numbers.
    #[must_use]
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }
}

/// Why a mesh encloses no part.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    /// No triangle.
    #[error("the mesh is empty: it has no triangle with three different corners")]
    Empty,
    /// A coordinate that is no number.
    #[error("a corner of the mesh is not finite: {at:?}")]
    NotFinite {
        /// Its coordinates.
        at: [f64; 3],
    },
    /// Edges with one triangle only.
    #[error(
        "the mesh is open: {} with one triangle only, such as that from {from:?} to {to:?}; export a closed \
         solid (watertight, all faces, fine enough that corners of neighbours agree)",
        counted(*edges, "edge", "edges")
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
        "the mesh has mixed orientation: across {}, such as that from {from:?} to {to:?}, neighbouring triangles \
         do not agree on which side is outside; make the normals consistent in the program that wrote it",
        counted(*edges, "edge", "edges")
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
        "the mesh is no surface: at {}, such as that from {from:?} to {to:?}, more than two triangles meet between \
         which space would be counted twice or not at all; unite the bodies or remove faces inside",
        counted(*edges, "edge", "edges")
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
        "the mesh cuts itself: {} of triangles that pass through each other, such as at the edge from {from:?} to \
         {to:?}; space inside would be counted twice or not at all: unite the bodies in the program that wrote it",
        counted(*pairs, "pair", "pairs")
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
    #[error("{}", inverted(*triangles, *volume))]
    Inverted {
        /// Triangles of the surface.
        triangles: usize,
        /// Its volume, rounded, which is not positive.
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

fn inverted(triangles: usize, volume: f64) -> String {
    if volume == 0.0 {
        return format!(
            "the mesh encloses no volume: that of a closed surface of {triangles} triangles is 0; leave it out"
        );
    }
    format!(
        "the mesh is inverted: a closed surface of {triangles} triangles encloses the volume {volume}, but lies in no other one; \
         turn its normals outward"
    )
}
