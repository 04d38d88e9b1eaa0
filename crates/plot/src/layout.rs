//! Where the panels lie on the page, and where each shows the windows of others.

use super::canvas::Point;
use super::geometry::Rect;
use super::panel::Panel;

/// Space for the axis on the left, for the title above, for the axis below and at the right edge of the page.
pub(super) const LEFT: f64 = 58.0;
pub(super) const TOP: f64 = 62.0;
pub(super) const BELOW: f64 = 46.0;
pub(super) const RIGHT: f64 = 16.0;
/// Plot area of the main panel and of an inset.
pub(super) const MAIN: [f64; 2] = [600.0, 536.0];
pub(super) const INSET: [f64; 2] = [290.0, 231.0];
/// Space above an inset for its letter, and its part of the page.
const INSET_TOP: f64 = 28.0;
const INSET_PITCH: [f64; 2] = [INSET[0] + LEFT, INSET[1] + INSET_TOP + BELOW];
/// Insets beside the main panel; further ones stand below in rows of three.
const BESIDE: usize = 2;
const IN_A_ROW: usize = 3;
/// Frames of insets are drawn at least this large.
const FRAME_MIN: f64 = 9.0;

/// Top left corner of the plot area of an inset.
pub(super) fn inset_place(index: usize) -> Point {
    if index < BESIDE {
        let x = LEFT + MAIN[0] + LEFT + 8.0;
        // The two together are as high as the main panel.
        return [x, TOP + index as f64 * (MAIN[1] - INSET[1])];
    }
    let (row, column) = ((index - BESIDE) / IN_A_ROW, (index - BESIDE) % IN_A_ROW);
    let top = TOP + MAIN[1] + BELOW + INSET_TOP;
    [LEFT + column as f64 * INSET_PITCH[0], top + row as f64 * INSET_PITCH[1]]
}

/// The letter of an inset: a … z, then aa, ab, …
pub(super) fn letter(index: usize) -> String {
    let own = char::from(b'a' + u8::try_from(index % 26).unwrap_or(0));
    match index / 26 {
        0 => own.to_string(),
        round => format!("{}{own}", letter(round - 1)),
    }
}

/// Where the window of an inset is shown.
pub(super) struct Frame {
    /// Index of the inset.
    pub inset: usize,
    /// Index of the panel that shows it.
    pub parent: usize,
    pub rect: Rect,
}

/// The frame of every inset in the smallest panel that contains it. What no panel contains, such as an overview, has no
/// frame.
pub(super) fn frames(panels: &[Panel]) -> Vec<Frame> {
    let area = |panel: &Panel| {
        let window = &panel.view.window;
        (window.h[1] - window.h[0]) * (window.l[1] - window.l[0])
    };
    let parent_of = |index: usize| {
        let larger = (0..panels.len())
            .filter(|&outer| area(&panels[outer]) > area(&panels[index]) && contains(&panels[outer], &panels[index]));
        larger.min_by(|&a, &b| area(&panels[a]).total_cmp(&area(&panels[b])))
    };
    (1..panels.len())
        .filter_map(|index| {
            let parent = parent_of(index)?;
            Some(Frame { inset: index - 1, parent, rect: frame(&panels[index], &panels[parent]) })
        })
        .collect()
}

/// Does one panel's window hold the other's?
pub(super) fn contains(outer: &Panel, inner: &Panel) -> bool {
    let within = |inner: [f64; 2], outer: [f64; 2]| inner[0] >= outer[0] && inner[1] <= outer[1];
    let (outer, inner) = (&outer.view.window, &inner.view.window);
    within(inner.h, outer.h) && within(inner.l, outer.l)
}

/// Where a panel's window lies in another panel, drawn large enough to be seen.
pub(super) fn frame(panel: &Panel, parent: &Panel) -> Rect {
    let exact = parent.view.frame(&panel.view.window);
    let (dx, dy) = ((FRAME_MIN - exact.width).max(0.0), (FRAME_MIN - exact.height).max(0.0));
    let wide =
        Rect { x: exact.x - dx / 2.0, y: exact.y - dy / 2.0, width: exact.width + dx, height: exact.height + dy };
    within(&wide, &parent.view.rect)
}

/// The part of a rectangle inside another.
fn within(rect: &Rect, outer: &Rect) -> Rect {
    let [x, y] = outer.nearest([rect.x, rect.y]);
    let [right, bottom] = outer.nearest([rect.x + rect.width, rect.y + rect.height]);
    Rect { x, y, width: right - x, height: bottom - y }
}
