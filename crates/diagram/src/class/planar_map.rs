//! The planar map of an arrangement: vertices, directed edges in cyclic order, faces.
//!
//! Edge e consists of two *darts*: 2e runs with rising l (on the frame: counter-clockwise), 2e + 1 back. Each dart knows
//! the face on its left.

use super::kinds::{EdgeKind, FaceKind, Side, VertexKind};
use super::name::{MapError, Unclassified};
use crate::arrangement::{Arrangement, Change, Event, RegionId, Slab, SlabId};
use crate::atlas::Atlas;
use bifdiag_equilibria::curves::CurveId;
use bifdiag_numbers::table::{Id, Table};

/// A map on the disc with one dart marked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanarMap {
    /// Kind of each edge.
    pub(super) edges: Vec<EdgeKind>,
    /// Kind of each vertex.
    pub(super) vertices: Vec<VertexKind>,
    /// Vertex from which each dart leaves.
    pub(super) origin: Vec<usize>,
    /// Next dart counter-clockwise around the same vertex.
    pub(super) next: Vec<usize>,
    /// Previous dart around the same vertex.
    pub(super) previous: Vec<usize>,
    /// Face on the left of each dart.
    pub(super) left: Vec<usize>,
    /// Kind of each face; the first is outside the frame, the second forbidden.
    pub(super) faces: Vec<FaceKind>,
    /// The marked dart: the lower edge of the frame, from l = 0 on.
    pub(super) root: usize,
}

const OUTSIDE: usize = 0;
const FORBIDDEN: usize = 1;
/// The face of a region: regions follow the other two.
fn face_of(region: RegionId) -> usize {
    2 + region.index()
}

/// The other dart of the same edge.
pub(super) fn opposite(dart: usize) -> usize {
    dart ^ 1
}

impl PlanarMap {
    /// The map of an atlas.
    ///
    /// # Errors
    /// [`Unclassified::Region`] when a region's type is unknown, [`Unclassified::Map`] when the pieces do not fit.
    pub fn of(atlas: &Atlas) -> Result<Self, Unclassified> {
        let mut faces = vec![FaceKind::Outside, FaceKind::Forbidden];
        for (region, known) in atlas.regions().pairs() {
            match &known.components {
                Ok(components) => faces.push(FaceKind::Region(components.clone())),
                Err(source) => return Err(Unclassified::Region { region, source: *source }),
            }
        }
        let map = Builder::new(atlas.arrangement()).build(faces)?;
        map.check()?;
        Ok(map)
    }

    /// The next dart around the face on the left.
    pub(super) fn along_face(&self, dart: usize) -> usize {
        self.previous[opposite(dart)]
    }

    /// Euler's formula for the sphere, and one cycle of darts, of one face only, around each face.
    ///
    /// # Errors
    /// [`MapError::NotPlanar`].
    pub fn check(&self) -> Result<(), MapError> {
        let mut seen = vec![false; self.left.len()];
        let mut cycles = 0;
        let mut consistent = true;
        for start in 0..seen.len() {
            if seen[start] {
                continue;
            }
            cycles += 1;
            let mut dart = start;
            while !seen[dart] {
                seen[dart] = true;
                consistent &= self.left[dart] == self.left[start];
                dart = self.along_face(dart);
            }
        }
        let (vertices, edges, faces) = (self.vertices.len(), self.edges.len(), self.faces.len());
        if consistent && cycles == faces && vertices + faces == edges + 2 {
            Ok(())
        } else {
            Err(MapError::NotPlanar { vertices, edges, faces, cycles })
        }
    }
}

/// An edge of a curve in the making.
#[derive(Clone, Copy)]
struct Piece {
    edge: usize,
}

struct Builder<'a> {
    arrangement: &'a Arrangement,
    edges: Vec<EdgeKind>,
    /// Faces on the left of dart 2e and of dart 2e + 1.
    sides: Vec<[usize; 2]>,
    /// Darts around each vertex, counter-clockwise.
    around: Vec<Vec<usize>>,
    vertices: Vec<VertexKind>,
}

impl<'a> Builder<'a> {
    fn new(arrangement: &'a Arrangement) -> Self {
        Self { arrangement, edges: Vec::new(), sides: Vec::new(), around: Vec::new(), vertices: Vec::new() }
    }

    fn build(mut self, faces: Vec<FaceKind>) -> Result<PlanarMap, MapError> {
        let slabs = &self.arrangement.slabs;
        let (Some(first), Some(last)) = (slabs.first(), slabs.last()) else { return Err(MapError::Empty) };
        if slabs.len() != self.arrangement.events.len() + 1 {
            return Err(MapError::Coincident);
        }
        if first.order.is_empty() || last.order.is_empty() {
            return Err(MapError::Empty);
        }
        let curves = self.arrangement.set.curves.len();
        // The edge of each curve in the slab that is being passed.
        let mut running = Table::filled(None, curves);
        for (position, &curve) in first.order.iter().enumerate() {
            running[curve] = Some(self.begin(first, position));
        }
        let starts: Vec<usize> = first.order.iter().filter_map(|&c| running[c]).map(|p| 2 * p.edge).collect();
        for (number, event) in self.arrangement.events.pairs() {
            self.pass(event, &slabs[SlabId::ending_at(number)], &slabs[SlabId::starting_at(number)], &mut running)?;
        }
        let mut ends = Vec::with_capacity(last.order.len());
        for &curve in &last.order {
            let piece = running[curve].take().ok_or(MapError::LooseEnd { curve })?;
            ends.push(2 * piece.edge + 1);
        }
        if let Some((curve, _)) = running.pairs().find(|(_, piece)| piece.is_some()) {
            return Err(MapError::LooseEnd { curve });
        }
        let root = self.frame(&starts, &ends, first, last);
        Ok(self.finish(faces, root))
    }

    /// A new edge of the curve at this position of a slab.
    fn begin(&mut self, slab: &Slab, position: usize) -> Piece {
        let curve = &self.arrangement.set.curves[slab.order[position]];
        let above = face_of(slab.region_above[position]);
        let below = position.checked_sub(1).map_or(FORBIDDEN, |lower| face_of(slab.region_above[lower]));
        self.edge(EdgeKind::of(curve), [above, below])
    }

    fn edge(&mut self, kind: EdgeKind, sides: [usize; 2]) -> Piece {
        self.edges.push(kind);
        self.sides.push(sides);
        Piece { edge: self.edges.len() - 1 }
    }

    fn vertex(&mut self, kind: VertexKind, darts: Vec<usize>) {
        self.vertices.push(kind);
        self.around.push(darts);
    }

    /// Ends and begins edges at an event.
    fn pass(
        &mut self,
        event: &Event,
        before: &Slab,
        after: &Slab,
        running: &mut Table<CurveId, Option<Piece>>,
    ) -> Result<(), MapError> {
        let mut meeting = event.change.curves();
        meeting.sort_unstable();
        meeting.dedup();
        let in_order = |slab: &Slab| {
            let mut positions: Vec<usize> =
                meeting.iter().filter_map(|curve| slab.order.iter().position(|c| c == curve)).collect();
            positions.sort_unstable();
            positions
        };
        let mut darts = Vec::with_capacity(4);
        // Counter-clockwise: to the right from below to above, then to the left from above to below.
        let mut arriving = Vec::with_capacity(2);
        for position in in_order(before).into_iter().rev() {
            let curve = before.order[position];
            let piece = running[curve].take().ok_or(MapError::LooseEnd { curve })?;
            arriving.push(2 * piece.edge + 1);
        }
        for position in in_order(after) {
            let piece = self.begin(after, position);
            running[after.order[position]] = Some(piece);
            darts.push(2 * piece.edge);
        }
        darts.extend(arriving);
        let kind = match event.change {
            Change::Birth(_) | Change::Death(_) => VertexKind::Cusp,
            Change::Open { .. } | Change::Close { .. } => VertexKind::Pitchfork,
            Change::Swap(_) => VertexKind::Crossing,
        };
        self.vertex(kind, darts);
        Ok(())
    }

    /// The frame, counter-clockwise from the lower end at l = 0; gives the root.
    fn frame(&mut self, starts: &[usize], ends: &[usize], first: &Slab, last: &Slab) -> usize {
        let region = |slab: &Slab, position: usize| face_of(slab.region_above[position]);
        let root = 2 * self.edge(EdgeKind::Frame(Side::Bottom), [FORBIDDEN, OUTSIDE]).edge;
        let mut incoming = root;
        for (position, &curve) in ends.iter().enumerate() {
            let side = if position + 1 == ends.len() { Side::Top } else { Side::Fast };
            let outgoing = 2 * self.edge(EdgeKind::Frame(side), [region(last, position), OUTSIDE]).edge;
            self.vertex(VertexKind::End, vec![outgoing, curve, opposite(incoming)]);
            incoming = outgoing;
        }
        for (position, &curve) in starts.iter().enumerate().rev() {
            let outgoing = match position.checked_sub(1) {
                Some(lower) => 2 * self.edge(EdgeKind::Frame(Side::Rest), [region(first, lower), OUTSIDE]).edge,
                None => root,
            };
            self.vertex(VertexKind::End, vec![curve, opposite(incoming), outgoing]);
            incoming = outgoing;
        }
        root
    }

    fn finish(self, faces: Vec<FaceKind>, root: usize) -> PlanarMap {
        let darts = 2 * self.edges.len();
        let (mut origin, mut next, mut previous) = (vec![0; darts], vec![0; darts], vec![0; darts]);
        for (vertex, around) in self.around.iter().enumerate() {
            for (place, &dart) in around.iter().enumerate() {
                let following = around[(place + 1) % around.len()];
                origin[dart] = vertex;
                next[dart] = following;
                previous[following] = dart;
            }
        }
        let left = self.sides.into_iter().flatten().collect();
        PlanarMap { edges: self.edges, vertices: self.vertices, origin, next, previous, left, faces, root }
    }
}
