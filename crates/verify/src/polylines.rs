//! The polylines of curves: each point is one of its curve, and no chord leaves it further than docs/formats.md says.

use schema::{AtlasDocument, CurveDocument};

use super::Refused;
use super::chords::Chords;
use super::orders::Orders;
use super::plane::{POINT, Plane};

/// A chord leaves its curve by at most this share of the heights and widths of the whole diagram.
const CHORD: f64 = 1.25e-3;

/// Every polyline runs with rising l, but for rounding, from one end of its curve to the other; one without end runs as far as
/// all events, half as far again and more.
pub(super) fn check(document: &AtlasDocument, orders: &Orders, plane: &Plane) -> Result<(), Refused> {
    if document.curves.iter().all(|curve| curve.polyline.is_empty()) {
        return Ok(());
    }
    let extent = plane.extent(document);
    let chords = Chords::new(plane, orders);
    let is_right = |curve: &CurveDocument| {
        let line = &curve.polyline;
        let (Some(first), Some(last)) = (line.first(), line.last()) else { return false };
        let near = |l: f64, end: f64| (l - end).abs() <= POINT * end.abs();
        near(first[1], curve.l_range[0].unwrap_or(0.0))
            && curve.l_range[1].map_or(last[1] >= extent[1] * (1.0 - POINT), |end| near(last[1], end))
            && line.iter().all(|[h, l]| plane.height(&curve.id, *l).is_some_and(|[on, room]| (h - on).abs() <= room))
            && line.windows(2).all(|pair| is_chord(plane, &chords, &curve.id, pair, extent, line.len() == 2))
    };
    if document.curves.iter().all(is_right) { Ok(()) } else { Err(Refused::Field { field: "curves.polyline" }) }
}

/// l rises along a chord, and the curve leaves it by at most its share of the diagram: in h, or across the chord in units of
/// height and width.
fn is_chord(
    plane: &Plane,
    chords: &Chords,
    id: &str,
    pair: &[[f64; 2]],
    [height, width]: [f64; 2],
    is_short: bool,
) -> bool {
    let [[h, l], [h_to, l_to]] = [pair[0], pair[1]];
    if l_to <= l {
        // Beside a cusp or pitchfork neighbours may be one l to rounding, and so may both ends of a curve.
        return (pair[0] != pair[1] || is_short) && l <= l_to * (1.0 + POINT);
    }
    let steepness = (h_to - h) / (l_to - l) * width / height;
    let most = CHORD * height * (1.0 + steepness * steepness).sqrt();
    plane.curve(id, 0.5 * (l + l_to)).is_some_and(|curve| chords.hold(curve, [l, l_to], [0.0; 2], most))
}
