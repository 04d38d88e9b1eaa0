//! Pieces of curves between cusps.

use top::body::Frame;
use top::continuation::{PieceEnd, Start, VertexKind, track_piece};
use top::stability::RelativeEquilibrium;

use crate::closed_form::{Random, closed, cusp_points, frame, intervals, wide};

/// Points (i, δ) by rising l, and both ends.
type Piece = (Vec<(usize, f64)>, [PieceEnd; 2]);

/// The points of an interval between consecutive cusps, with the kind of end on either side.
fn pieces_of(frame: &Frame, interval: &[(usize, f64)], l_max: f64) -> Vec<Piece> {
    let mut pieces = vec![Vec::new()];
    for ends in interval.windows(2) {
        pieces.last_mut().unwrap().push(ends[0]);
        let (i, k) = (ends[0].0, ends[1].0);
        if (closed(frame, i, ends[0].1).turning > 0.0) != (closed(frame, k, ends[1].1).turning > 0.0) {
            pieces.push(Vec::new());
        }
    }
    let l_of = |&(i, delta): &(usize, f64)| closed(frame, i, delta).l;
    let count = pieces.len();
    let cusps = cusp_points(frame, interval);
    assert_eq!(cusps.len() + 1, count);
    let mut all = Vec::new();
    for (number, mut points) in pieces.into_iter().enumerate() {
        let mut ends = [number.checked_sub(1), (number + 1 < count).then_some(number)]
            .map(|cusp| cusp.map(|cusp| PieceEnd::Cusp(l_of(&cusps[cusp]))));
        if points.len() > 1 && l_of(&points[0]) > l_of(&points[points.len() - 1]) {
            points.reverse();
            ends.reverse();
        }
        points.retain(|point| l_of(point) < l_max);
        if points.len() < 2 {
            continue;
        }
        all.push((points, [ends[0].unwrap_or(PieceEnd::Momentum(0.0)), ends[1].unwrap_or(PieceEnd::Momentum(l_max))]));
    }
    all
}

#[test]
fn pieces_end_at_their_cusps() {
    let mut random = Random(77);
    let mut pieces = 0;
    for body in 0..150 {
        let mut r = random.direction();
        if body % 3 == 2 {
            r[body % 2] *= random.magnitude(-9..-2);
        }
        let frame = frame(random.moments(), r);
        let l_max = 1e3;
        for interval in intervals(&frame) {
            for (points, ends) in pieces_of(&frame, &interval, l_max) {
                let (i, delta) = points[points.len() / 2];
                let point = closed(&frame, i, delta);
                let start = Start::on(&frame, RelativeEquilibrium::new(&frame, point.gamma, point.omega));
                let piece = track_piece(&frame, &start, ends, &wide(l_max)).unwrap();
                pieces += 1;
                assert!(piece.complete, "{body} {ends:?} {:?} {frame:?}", piece.stops);
                assert!(piece.vertices.windows(2).all(|pair| pair[0].l < pair[1].l));
                let [low, high] = [piece.vertices[0], piece.vertices[piece.vertices.len() - 1]];
                for (end, vertex) in [(ends[0], low), (ends[1], high)] {
                    match end {
                        PieceEnd::Momentum(l) => assert_eq!(vertex.l, l),
                        PieceEnd::Cusp(l) => {
                            assert_eq!(vertex.kind, VertexKind::Cusp);
                            assert!((vertex.l - l).abs() < 1e-12 * l);
                        }
                        PieceEnd::Pitchfork(_) => unreachable!(),
                    }
                }
                for vertex in &piece.vertices {
                    assert!(vertex.index.is_none() || vertex.index == piece.index);
                }
            }
        }
    }
    assert!(pieces > 800);
}
