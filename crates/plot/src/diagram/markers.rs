//! Marks of events and sample points.

use crate::page::{Canvas, INK, Ink, PAPER, Point};
use bifdiag_schema::EventKind;

/// Half the size of a marker.
pub(super) const MARKER: f64 = 4.0;

/// Marks an event: a filled diamond at a cusp, a filled triangle at a pitchfork, a ring at a crossing.
pub(super) fn event_marker(canvas: &Canvas, kind: EventKind, at: Point) {
    let [x, y] = at;
    let shape = match kind {
        EventKind::Crossing => return canvas.ring(at, MARKER - 1.0, Ink { color: INK, width: 1.1 }),
        EventKind::Cusp => vec![[x, y - MARKER], [x + MARKER, y], [x, y + MARKER], [x - MARKER, y]],
        EventKind::Pitchfork => {
            vec![[x, y - MARKER], [x + 0.95 * MARKER, y + 0.7 * MARKER], [x - 0.95 * MARKER, y + 0.7 * MARKER]]
        }
    };
    canvas.polygon(&shape, INK);
    canvas.outline(&shape, Ink { color: PAPER, width: 0.8 });
}

/// Marks the sample point of a region.
pub(super) fn sample_dot(canvas: &Canvas, at: Point) {
    canvas.disc(at, 2.0, INK);
}
