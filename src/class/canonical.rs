//! Numbers for vertices, edges and faces that depend on the map and its root alone.

use std::collections::VecDeque;

use super::planar_map::{PlanarMap, opposite};

/// The numbering: what stands where, in the order of discovery.
pub(super) struct Numbering {
    /// Canonical number of each edge.
    pub edge: Vec<usize>,
    /// Canonical number of each face; `None` outside the frame.
    pub face: Vec<Option<usize>>,
    /// For each canonical number of a face, the dart of it that was met first.
    pub first_dart: Vec<usize>,
}

/// Walks over the map breadth first from the root, around each vertex counter-clockwise from the dart by which it was
/// reached.
pub(super) fn number(map: &PlanarMap) -> Numbering {
    let mut edge: Vec<Option<usize>> = vec![None; map.edges.len()];
    let mut face: Vec<Option<usize>> = vec![None; map.faces.len()];
    let mut reached = vec![false; map.vertices.len()];
    let mut first_dart = Vec::with_capacity(map.faces.len());
    let mut queue = VecDeque::from([map.root]);
    reached[map.origin[map.root]] = true;
    let mut edges = 0;
    let outside = map.left[opposite(map.root)];
    while let Some(entry) = queue.pop_front() {
        let mut dart = entry;
        loop {
            edge[dart / 2].get_or_insert_with(|| {
                edges += 1;
                edges - 1
            });
            let left = map.left[dart];
            if face[left].is_none() && left != outside {
                face[left] = Some(first_dart.len());
                first_dart.push(dart);
            }
            let head = map.origin[opposite(dart)];
            if !reached[head] {
                reached[head] = true;
                queue.push_back(opposite(dart));
            }
            dart = map.next[dart];
            if dart == entry {
                break;
            }
        }
    }
    // The map is connected: each edge has been met.
    Numbering { edge: edge.into_iter().map(Option::unwrap_or_default).collect(), face, first_dart }
}
