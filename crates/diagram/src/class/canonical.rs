//! Numbers for vertices, edges and faces that depend on the map and its root alone.
//!
//! The canonical form as text.

use std::collections::VecDeque;
use std::fmt::Write;

use super::planar_map::{PlanarMap, opposite};

/// The numbering, in the order of discovery.
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

/// First line of each text. It changes whenever texts change, since names of classes are kept in files.
const HEAD: &str = "map 1";

/// One line for each region: its type, then its boundary with the region on the left.
pub(super) fn write(map: &PlanarMap, numbering: &Numbering) -> String {
    let mut out = String::with_capacity(64 * map.faces.len());
    out.push_str(HEAD);
    out.push('\n');
    for (number, &first) in numbering.first_dart.iter().enumerate() {
        // Writing to a String cannot fail.
        let _always = write!(out, "R{number} {}:", map.faces[map.left[first]]);
        let mut dart = first;
        loop {
            let _always = write!(out, " {} {}", numbering.edge[dart / 2], map.edges[dart / 2]);
            if let Some(beyond) = numbering.face[map.left[opposite(dart)]] {
                let _always = write!(out, " R{beyond}");
            }
            out.push(' ');
            out.push(map.vertices[map.origin[opposite(dart)]].mark());
            dart = map.along_face(dart);
            if dart == first {
                break;
            }
        }
        out.push('\n');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::kinds::FaceKind;
    use super::super::{Class, MapError, PlanarMap};
    use bifdiag_body::Preset;
    use proptest::prelude::*;

    /// A permutation of 0 … n − 1 from any numbers.
    fn permutation(n: usize, keys: &[u64]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by_key(|&k| keys[k % keys.len()].wrapping_mul(2 * k as u64 + 1));
        order
    }

    /// The same map with other numbers; edges may change their direction. The outside stays first.
    fn renumbered(map: &PlanarMap, keys: &[u64]) -> PlanarMap {
        let edge = permutation(map.edges.len(), keys);
        let vertex = permutation(map.vertices.len(), &keys[1..]);
        let face = permutation(map.faces.len(), &keys[2..]);
        let dart = |d: usize| 2 * edge[d / 2] + ((d % 2) ^ usize::from(keys[3] >> (d / 2 % 64) & 1 == 1));
        let mut new = map.clone();
        for d in 0..map.left.len() {
            new.origin[dart(d)] = vertex[map.origin[d]];
            new.next[dart(d)] = dart(map.next[d]);
            new.previous[dart(d)] = dart(map.previous[d]);
            new.left[dart(d)] = face[map.left[d]];
            new.edges[edge[d / 2]] = map.edges[d / 2];
        }
        for (old, kind) in map.vertices.iter().enumerate() {
            new.vertices[vertex[old]] = *kind;
        }
        for (old, kind) in map.faces.iter().enumerate() {
            new.faces[face[old]] = kind.clone();
        }
        new.root = dart(map.root);
        new
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        #[test]
        fn numbers_of_vertices_edges_and_faces_do_not_matter(
            preset in 0..Preset::all().len(), keys in prop::collection::vec(any::<u64>(), 8)
        ) {
            let atlas = crate::fast::atlas(&Preset::all()[preset].body()).unwrap();
            let map = PlanarMap::of(&atlas).unwrap();
            let new = renumbered(&map, &keys);
            prop_assert!(new.check().is_ok());
            prop_assert_eq!(Class::of_map(&new), Class::of_map(&map));
        }

        #[test]
        fn one_changed_face_is_another_class(preset in 0..Preset::all().len(), face in 1_usize..100) {
            let atlas = crate::fast::atlas(&Preset::all()[preset].body()).unwrap();
            let map = PlanarMap::of(&atlas).unwrap();
            let mut new = map.clone();
            let face = 1 + face % (map.faces.len() - 1);
            new.faces[face] = FaceKind::Region(Vec::new());
            prop_assert_ne!(Class::of_map(&new), Class::of_map(&map));
        }
    }

    /// Each of the three conditions fails alone.
    #[test]
    fn a_map_that_is_none_is_refused() {
        let atlas = crate::fast::atlas(&Preset::find("paper").unwrap().body()).unwrap();
        let refused = |map: &PlanarMap| matches!(map.check(), Err(MapError::NotPlanar { .. }));
        let mut map = PlanarMap::of(&atlas).unwrap();
        map.left[0] = (map.left[0] + 1) % map.faces.len();
        assert!(refused(&map), "two faces along one cycle");
        let mut map = PlanarMap::of(&atlas).unwrap();
        map.vertices.push(map.vertices[0]);
        assert!(refused(&map), "a vertex too many");
        let mut map = PlanarMap::of(&atlas).unwrap();
        let (p, q) = (map.next[0], map.next[2]);
        map.next[0] = q;
        map.next[2] = p;
        map.previous[q] = 0;
        map.previous[p] = 2;
        assert!(refused(&map), "a dart in the wrong place: {:?}", map.check());
    }
}
