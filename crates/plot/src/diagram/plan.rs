//! How large the panels are, and how many stand beside each other.

use crate::page::Width;

/// The sizes of a page.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    /// Plot area of the main panel and of an inset.
    pub main: [f64; 2],
    pub inset: [f64; 2],
    /// Insets beside the main panel; further ones stand below in rows.
    pub beside: usize,
    pub in_a_row: usize,
    /// The most insets.
    pub insets: usize,
    /// Whether there is a table of small motions.
    pub motions: bool,
    /// The base line of the remark, above the upper end of the main panel.
    pub remark: f64,
    /// Whether the one panel is that of the straightened plane, with an axis on the right too, for which it leaves room.
    pub straight: bool,
    pub right: f64,
}

pub(super) const PAGE: Plan = Plan {
    main: [540.0, 484.0],
    inset: [246.0, 200.0],
    beside: 2,
    in_a_row: 3,
    insets: 5,
    motions: true,
    remark: 12.0,
    straight: false,
    right: 0.0,
};
const DENSE_PAGE: Plan =
    Plan { main: [617.0, 484.0], inset: [171.0, 112.0], beside: 3, in_a_row: 4, insets: 11, ..PAGE };
const PAGES: [Plan; 3] = [PAGE, DENSE_PAGE, Plan { insets: 7, ..DENSE_PAGE }];

/// The table would be longer than a column; the remark stands above the name of the axis, since both are too long for a line.
const COLUMN: Plan = Plan {
    main: [374.43, 336.0],
    inset: [374.43, 200.0],
    beside: 0,
    in_a_row: 1,
    insets: 2,
    motions: false,
    remark: 25.0,
    ..PAGE
};
const DENSE_COLUMN: Plan = Plan { main: [374.43, 300.0], inset: [159.0, 110.0], in_a_row: 2, insets: 6, ..COLUMN };
const COLUMNS: [Plan; 4] =
    [COLUMN, DENSE_COLUMN, Plan { insets: 4, ..DENSE_COLUMN }, Plan { insets: 2, ..DENSE_COLUMN }];

const STRAIGHT_PAGE: Plan =
    Plan { main: [814.0, 440.0], beside: 0, insets: 0, remark: 27.0, straight: true, right: 38.0, ..PAGE };
const STRAIGHT_COLUMN: Plan = Plan { main: [336.43, 336.0], motions: false, ..STRAIGHT_PAGE };

impl Plan {
    /// The one of the straightened plane.
    pub(super) fn straight(width: Width) -> &'static Self {
        match width {
            Width::Page => &STRAIGHT_PAGE,
            Width::Column => &STRAIGHT_COLUMN,
        }
    }

    /// The first for few insets, and those for many: with fewer the more there is in the key.
    pub(super) fn of(width: Width) -> &'static [Self] {
        match width {
            Width::Page => &PAGES,
            Width::Column => &COLUMNS,
        }
    }
}
