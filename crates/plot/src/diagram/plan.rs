//! How large the panels are, and how many are side by side.

use bifdiag_page::Width;

/// The sizes of a page.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    /// Plot area of the main panel and of an inset.
    pub main: [f64; 2],
    pub inset: [f64; 2],
    /// Insets beside the main panel; further ones are below in rows.
    pub beside: usize,
    pub in_a_row: usize,
    /// The most insets.
    pub insets: usize,
    /// The upper end of the main panel, and the base line of the remark, above it.
    pub top: f64,
    pub remark: f64,
    /// Whether the one panel is that of the straightened plane, with an axis on the right too, for which it leaves room.
    pub straight: bool,
    pub right: f64,
}

/// Space for the axis on the left, and at the right edge of the page.
pub(super) const LEFT: f64 = 56.0;
pub(super) const RIGHT: f64 = 16.0;
/// Above the main panel with the title, and without it.
const TOP: f64 = 62.0;
const TOP_BARE: f64 = 44.0;
/// Room for the axis on the right of the straightened plane.
const RIGHT_AXIS: f64 = 38.0;
/// Between the main panel and the insets beside it.
pub(super) const BETWEEN: f64 = LEFT + 8.0;

/// Insets beside the main panel, in a row, and in all; heights of the main panel and of an inset on a journal's page or in its
/// column.
type Insets = ([usize; 3], [f64; 2]);

/// The first is for few insets, the others for many: with fewer the more there is in the key.
const PAGES: [Insets; 3] = [([2, 3, 5], [484.0, 200.0]), ([3, 4, 11], [484.0, 112.0]), ([3, 4, 7], [484.0, 112.0])];
const COLUMNS: [Insets; 4] = [
    ([0, 1, 2], [336.0, 200.0]),
    ([0, 2, 6], [300.0, 110.0]),
    ([0, 2, 4], [300.0, 110.0]),
    ([0, 2, 2], [300.0, 110.0]),
];
/// Heights of one panel over the whole width, on a page and in a column.
const ALONE: [f64; 2] = [440.0, 336.0];

impl Plan {
    /// For one panel as wide as the page.
    fn alone(width: Width, has_title: bool) -> Self {
        let is_column = width.is_column();
        // Panels beside each other need their height in a narrow page too.
        let scale = if is_column { width.scale() } else { width.scale().max(1.0) };
        let height = ALONE[usize::from(is_column)] * scale;
        Self {
            main: [width.pixels() - LEFT - RIGHT, height],
            inset: [width.pixels() - LEFT - RIGHT, height],
            beside: 0,
            in_a_row: 1,
            insets: 0,
            top: if has_title { TOP } else { TOP_BARE },
            // In one column the remark is above the name of the axis, since both are too long for a line.
            remark: if is_column { 25.0 } else { 12.0 },
            straight: false,
            right: 0.0,
        }
    }

    /// That of one panel of a given size.
    pub(super) fn panel(size: [f64; 2]) -> Self {
        Self { main: size, ..Self::alone(Width::default(), false) }
    }

    /// That of the straightened plane.
    pub(super) fn straight(width: Width, has_title: bool) -> Self {
        let alone = Self::alone(width, has_title);
        let main = [alone.main[0] - RIGHT_AXIS, alone.main[1]];
        Self { main, remark: 27.0, straight: true, right: RIGHT_AXIS, ..alone }
    }

    /// Those of the plane; a single panel is as wide as the page.
    pub(super) fn of(width: Width, has_title: bool) -> impl Iterator<Item = Self> {
        let plans: &[Insets] = if width.is_column() { &COLUMNS } else { &PAGES };
        plans.iter().map(move |&([beside, in_a_row, insets], heights)| {
            let alone = Self::alone(width, has_title);
            let [high, low] = heights.map(|height| height * alone.main[1] / ALONE[usize::from(width.is_column())]);
            let wide = ((width.pixels() - RIGHT) / in_a_row as f64 - LEFT).floor().min(alone.main[0]);
            let main = alone.main[0] - if beside > 0 { BETWEEN + wide } else { 0.0 };
            Self { main: [main, high], inset: [wide, low], beside, in_a_row, insets, ..alone }
        })
    }

    /// The same without insets, over the whole width.
    pub(super) fn without_insets(self, width: Width) -> Self {
        let wide = width.pixels() - LEFT - RIGHT;
        Self { main: [wide, self.main[1]], inset: [wide, self.inset[1]], beside: 0, in_a_row: 1, insets: 0, ..self }
    }
}
