//! How large the panels are, and how many stand beside each other.

use crate::page::Width;

/// The sizes of a page.
pub(super) struct Plan {
    /// Plot area of the main panel and of an inset.
    pub main: [f64; 2],
    pub inset: [f64; 2],
    /// Insets beside the main panel; further ones stand below in rows.
    pub beside: usize,
    pub in_a_row: usize,
    /// Whether the small motions are told in a table.
    pub motions: bool,
    /// The base line of the remark, above the upper end of the main panel.
    pub remark: f64,
}

const PAGE: Plan =
    Plan { main: [540.0, 484.0], inset: [246.0, 200.0], beside: 2, in_a_row: 3, motions: true, remark: 12.0 };
/// The table would be longer than a column; the remark stands above the name of the axis, since both are too long for a line.
const COLUMN: Plan =
    Plan { main: [374.0, 336.0], inset: [374.0, 200.0], beside: 0, in_a_row: 1, motions: false, remark: 25.0 };

impl Plan {
    pub(super) fn of(width: Width) -> &'static Self {
        match width {
            Width::Page => &PAGE,
            Width::Column => &COLUMN,
        }
    }
}
