//! The canonical form as text.

use std::fmt::Write;

use super::canonical::Numbering;
use super::planar_map::{PlanarMap, opposite};

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
