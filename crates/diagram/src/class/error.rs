//! Why a diagram has no class.

use thiserror::Error;

use crate::arrangement::RegionId;
use crate::topology::merge::MergeError;
use bifdiag_equilibria::curves::CurveId;

/// Why an atlas has no class.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Unclassified {
    /// Something in the arrangement is undecided: the diagram is one of several.
    #[error("{count} things about the arrangement are undecided at this accuracy, so its class is open")]
    Undecided {
        /// How many.
        count: usize,
    },
    /// The type of a region is not known.
    #[error("the type of region {region} is undecided at this accuracy: {source}")]
    Region {
        /// The region.
        region: RegionId,
        /// Why.
        source: MergeError,
    },
    /// The pieces of the arrangement do not make a planar map: a defect of this program.
    #[error(transparent)]
    Map(#[from] MapError),
}

/// The pieces do not fit together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum MapError {
    /// There are no slabs or no curves.
    #[error("the arrangement is empty")]
    Empty,
    /// Several events are proved to lie at one l, so that the orders between them are not told one by one.
    #[error("several events lie exactly at one l")]
    Coincident,
    /// A curve begins or ends in the middle of the plane without an event.
    #[error("{curve:?} begins or ends where no event is")]
    LooseEnd {
        /// The curve.
        curve: CurveId,
    },
    /// Euler's formula fails or a face is not bounded by one cycle.
    #[error("{vertices} vertices, {edges} edges and {faces} faces with {cycles} boundaries are no map on the sphere")]
    NotPlanar {
        /// Vertices, those of the frame included.
        vertices: usize,
        /// Edges, those of the frame included.
        edges: usize,
        /// Faces, the outside included.
        faces: usize,
        /// Cycles of darts around faces.
        cycles: usize,
    },
}
