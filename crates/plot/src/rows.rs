//! Rows of a legend.

use super::geometry::Point;

/// Top left corners, relative to that of the first, of entries of the given widths: in rows of `row` pixels height with
/// `between` pixels between neighbours, as many in each as `width` holds.
pub(super) fn rows(widths: impl IntoIterator<Item = f64>, between: f64, width: f64, row: f64) -> Vec<Point> {
    let [mut x, mut y] = [0.0, 0.0];
    let mut corners = Vec::new();
    for entry in widths {
        if x > 0.0 && x + entry > width {
            (x, y) = (0.0, y + row);
        }
        corners.push([x, y]);
        x += entry + between;
    }
    corners
}

/// Height of the rows.
pub(super) fn height(corners: &[Point], row: f64) -> f64 {
    corners.last().map_or(0.0, |corner| corner[1] + row)
}
