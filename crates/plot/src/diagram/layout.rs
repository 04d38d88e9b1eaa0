//! Where the panels lie on the page, and where each shows the windows of others.

use super::panel::Panel;
use super::plan::{BETWEEN, LEFT, Plan, RIGHT};
use super::windows::{area, contains};
use bifdiag_page::{Point, Rect, letter};

/// Space for the axis below.
pub(super) const BELOW: f64 = 46.0;
/// Space above an inset for its letter.
const INSET_TOP: f64 = 34.0;
/// Font size of the insets' letters.
pub(super) const LETTER_SIZE: f64 = 11.0;
/// In frames smaller than this is no room for markers and labels.
pub(super) const CROWDED: f64 = 30.0;
/// Frames of insets are drawn at least this large.
const FRAME_MIN: f64 = 9.0;

/// An inset's part of the page.
fn pitch(plan: &Plan) -> [f64; 2] {
    [plan.inset[0] + LEFT, plan.inset[1] + INSET_TOP + BELOW]
}

/// Top left corner of the plot area of an inset.
pub(super) fn inset_place(plan: &Plan, index: usize) -> Point {
    let Plan { main, inset, beside, in_a_row, .. } = *plan;
    if index < beside {
        let x = LEFT + main[0] + BETWEEN;
        // All of them together are as high as the main panel.
        return [x, plan.top + index as f64 * (main[1] - inset[1]) / (beside - 1).max(1) as f64];
    }
    let (row, column) = ((index - beside) / in_a_row, (index - beside) % in_a_row);
    let top = plan.top + main[1] + BELOW + INSET_TOP;
    let [wide, high] = pitch(plan);
    [LEFT + column as f64 * wide, top + row as f64 * high]
}

/// Where the legend goes for this number of insets, and how wide it may be: into the places that the last row leaves
/// free, else below everything.
pub(super) fn legend_place(plan: &Plan, insets: usize) -> (Point, f64) {
    let Plan { main, inset, beside, in_a_row, .. } = *plan;
    if insets == 0 {
        return ([LEFT, plan.top + main[1] + BELOW + 6.0], main[0]);
    }
    if insets < beside {
        return (inset_place(plan, insets), inset[0]);
    }
    match (in_a_row - (insets - beside) % in_a_row) % in_a_row {
        0 => below_all(plan, insets),
        free => (inset_place(plan, insets), free as f64 * pitch(plan)[0] - LEFT),
    }
}

/// The place below everything, over the whole width.
pub(super) fn below_all(plan: &Plan, insets: usize) -> (Point, f64) {
    let last = insets.checked_sub(1).map_or(0.0, |last| inset_place(plan, last)[1] + plan.inset[1]);
    ([LEFT, last.max(plan.top + plan.main[1]) + BELOW + 6.0], page_width(plan, insets) - LEFT - RIGHT)
}

/// The width of a page with this number of insets.
pub(super) fn page_width(plan: &Plan, insets: usize) -> f64 {
    let right = |inset| inset_place(plan, inset)[0] + plan.inset[0];
    (0..insets).map(right).fold(LEFT + plan.main[0], f64::max) + plan.right + RIGHT
}

/// Where the windows of insets are shown in another panel: one, or several whose own frames would meet.
pub(super) struct Frame {
    /// Indices of the insets.
    pub insets: Vec<usize>,
    pub rect: Rect,
}

impl Frame {
    /// The letters of the insets.
    pub(super) fn letters(&self) -> Vec<String> {
        self.insets.iter().map(|inset| letter(*inset)).collect()
    }
}

/// For each panel the frames of the insets for which it is the smallest panel that contains them. What no panel
/// contains, such as an overview, has no frame.
pub(super) fn frames(panels: &[Panel]) -> Vec<Vec<Frame>> {
    let mut frames: Vec<Vec<Frame>> = panels.iter().map(|_| Vec::new()).collect();
    for (inset, panel) in panels.iter().skip(1).enumerate() {
        let window = &panel.view.window;
        let size = |parent: usize| area(&panels[parent].view.window);
        let larger = (0..panels.len())
            .filter(|&parent| size(parent) > area(window) && contains(&panels[parent].view.window, window));
        if let Some(parent) = larger.min_by(|&a, &b| size(a).total_cmp(&size(b))) {
            frames[parent].push(Frame { insets: vec![inset], rect: frame(panel, &panels[parent]) });
        }
    }
    frames.iter_mut().for_each(unite);
    frames
}

/// Unites frames as long as two of them meet.
fn unite(frames: &mut Vec<Frame>) {
    let pair = |frames: &[Frame]| {
        let pairs = (0..frames.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.into_iter().find(|&(i, j)| frames[i].rect.overlaps(&frames[j].rect))
    };
    while let Some((i, j)) = pair(frames) {
        let other = frames.remove(j);
        let own = &mut frames[i];
        own.insets.extend(other.insets);
        own.insets.sort_unstable();
        let [x, y] = [own.rect.x.min(other.rect.x), own.rect.y.min(other.rect.y)];
        let [right, bottom] = [own.rect.right().max(other.rect.right()), own.rect.bottom().max(other.rect.bottom())];
        own.rect = Rect { x, y, width: right - x, height: bottom - y };
    }
}

/// Is a point of the page marked in a panel? Those in a small frame are left to its inset.
pub(super) fn is_marked(point: Point, panel: &Panel, frames: &[Frame]) -> bool {
    let left_to_inset =
        |frame: &Frame| frame.rect.width < CROWDED && frame.rect.height < CROWDED && frame.rect.contains(point);
    panel.view.rect.contains(point) && !frames.iter().any(left_to_inset)
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
    let [right, bottom] = outer.nearest([rect.right(), rect.bottom()]);
    Rect { x, y, width: right - x, height: bottom - y }
}
