//! Pictures of a document, point by point: polylines lie on their curves.

use schema::AtlasDocument;

use super::Refused;
use super::plane::{POINT, Plane};

/// Every point of a polyline is on its curve; l rises, but for rounding, from its beginning to its end, or on.
pub(super) fn polylines(document: &AtlasDocument, plane: &Plane) -> Result<(), Refused> {
    let refuse = || Refused::Field { field: "curves.polyline" };
    if document.curves.iter().all(|curve| curve.polyline.is_empty()) {
        return Ok(());
    }
    for curve in &document.curves {
        let line = &curve.polyline;
        let rises = line.windows(2).all(|pair| pair[0][1] <= pair[1][1] * (1.0 + POINT));
        let (Some(first), Some(last)) = (line.first(), line.last()) else { return Err(refuse()) };
        let near = |l: f64, end: f64| (l - end).abs() <= POINT * end.abs();
        let begins = near(first[1], curve.l_range[0].unwrap_or(0.0));
        if !rises || !begins || !curve.l_range[1].is_none_or(|end| near(last[1], end)) {
            return Err(refuse());
        }
        for [h, l] in line {
            let [height, room] = plane.height(&curve.id, *l).ok_or_else(refuse)?;
            let near = (h - height).abs() <= room;
            if !near {
                return Err(refuse());
            }
        }
    }
    Ok(())
}
