//! Rows of a legend.

use super::geometry::Point;

/// Entries in rows.
pub(crate) struct Rows {
    /// Top left corner of each entry, relative to that of the first.
    pub corners: Vec<Point>,
    /// Height of all rows.
    pub height: f64,
}

impl Rows {
    /// Entries of the given widths with `between` pixels between neighbours, as many in each row as `width` holds; a row
    /// is `row` pixels high.
    pub(crate) fn new(widths: impl IntoIterator<Item = f64>, between: f64, width: f64, row: f64) -> Self {
        let [mut x, mut y] = [0.0, 0.0];
        let mut corners = Vec::new();
        for entry in widths {
            if x > 0.0 && x + entry > width {
                (x, y) = (0.0, y + row);
            }
            corners.push([x, y]);
            x += entry + between;
        }
        Self { corners, height: y + row }
    }
}
