//! Where text goes: inside its region where it fits, else beside it with a leader line.

use super::grid::{Grid, LEGIBLE, NOTHING};
use super::labels::{Label, Name, extent};
use super::panel::Panel;
use crate::page::{Point, Rect, distance};

/// Font sizes of a region's type that are tried inside the region, best first.
const SIZES: [f64; 3] = [14.0, 12.0, 10.5];
/// Font size of a label with a leader line.
const LEADER_SIZE: f64 = 11.0;
/// Free pixels around a label.
const CLEARANCE: f64 = 3.0;
/// Grid of places tried for a label with a leader line, in pixels.
const STEP: usize = 4;
/// Shortest leader line.
const LEADER_MIN: f64 = 9.0;

/// What is taken on a panel.
pub(super) struct Space<'a> {
    panel: &'a Panel,
    /// Deepest point and depth of every region.
    deepest: Vec<Option<(Point, f64)>>,
    taken: Vec<bool>,
    leaders: Vec<[Point; 2]>,
    labels: Vec<Label>,
}

/// Sums over rectangles of pixels.
struct Sums {
    width: usize,
    sums: Vec<u32>,
}

impl Sums {
    fn new(grid: &Grid, counts: impl Fn(usize) -> bool) -> Self {
        let width = grid.width + 1;
        let mut sums = vec![0; width * (grid.height + 1)];
        for y in 0..grid.height {
            let mut row = 0;
            for x in 0..grid.width {
                row += u32::from(counts(y * grid.width + x));
                sums[(y + 1) * width + x + 1] = sums[y * width + x + 1] + row;
            }
        }
        Self { width, sums }
    }

    fn count(&self, grid: &Grid, rect: &Rect) -> f64 {
        let [columns, rows] = grid.span(rect);
        let at = |x: usize, y: usize| f64::from(self.sums[y * self.width + x]);
        at(columns.end, rows.end) - at(columns.start, rows.end) - at(columns.end, rows.start)
            + at(columns.start, rows.start)
    }
}

impl<'a> Space<'a> {
    pub(super) fn new(panel: &'a Panel, regions: usize) -> Self {
        Self {
            panel,
            deepest: panel.grid.deepest(regions),
            taken: vec![false; panel.grid.regions.len()],
            leaders: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// Keeps text away from `rect`.
    pub(super) fn take(&mut self, rect: &Rect) {
        let [columns, rows] = self.panel.grid.span(rect);
        for y in rows {
            self.taken[y * self.panel.grid.width..][columns.clone()].fill(true);
        }
    }

    /// Keeps text away from the sides of `rect`.
    pub(super) fn take_outline(&mut self, rect: &Rect) {
        let bar = |x, y, width, height| Rect { x, y, width, height }.grown(1.5);
        self.take(&bar(rect.x, rect.y, rect.width, 0.0));
        self.take(&bar(rect.x, rect.bottom(), rect.width, 0.0));
        self.take(&bar(rect.x, rect.y, 0.0, rect.height));
        self.take(&bar(rect.right(), rect.y, 0.0, rect.height));
    }

    pub(super) fn into_labels(self) -> Vec<Label> {
        self.labels
    }

    /// Labels every region that has room for its label inside; tells `labelled` which.
    pub(super) fn label_inside(&mut self, names: &[Name], labelled: &mut [bool]) {
        for (region, name) in names.iter().enumerate() {
            if self.depth(region) < LEGIBLE {
                continue;
            }
            let Ok(own) = i32::try_from(region) else { continue };
            let grid = &self.panel.grid;
            let other = Sums::new(grid, |at| grid.regions[at] != own || self.taken[at]);
            let found = SIZES.iter().flat_map(|&size| [(size, false), (size, true)]).find_map(|(size, one_line)| {
                let rect = self.inside(own, &other, extent(name, size, one_line))?;
                Some(Label { region, rect, size, one_line, leader: None })
            });
            if let Some(label) = found {
                self.take(&label.rect.grown(CLEARANCE));
                self.labels.push(label);
                labelled[region] = true;
            }
        }
    }

    /// The place deepest inside a region at which a label fits, given what is not free for it.
    fn inside(&self, label: i32, other: &Sums, [width, height]: [f64; 2]) -> Option<Rect> {
        let grid = &self.panel.grid;
        let mut best: Option<(f64, Rect)> = None;
        for y in (0..grid.height).step_by(2) {
            for x in (0..grid.width).step_by(2) {
                let depth = grid.depth[y * grid.width + x];
                if grid.regions[y * grid.width + x] != label || best.is_some_and(|(deepest, _)| depth <= deepest) {
                    continue;
                }
                let [cx, cy] = grid.position(x, y);
                let rect = Rect { x: cx - width / 2.0, y: cy - height / 2.0, width, height };
                let needed = rect.grown(CLEARANCE);
                if self.on_panel(&needed) && other.count(grid, &needed) == 0.0 {
                    best = Some((depth, rect));
                }
            }
        }
        best.map(|(_, rect)| rect)
    }

    fn on_panel(&self, rect: &Rect) -> bool {
        let panel = &self.panel.view.rect;
        panel.contains([rect.x, rect.y]) && panel.contains([rect.right(), rect.bottom()])
    }

    /// Depth of a region here, 0 where it has no pixel.
    pub(super) fn depth(&self, region: usize) -> f64 {
        self.deepest[region].map_or(0.0, |(_, depth)| depth)
    }

    pub(super) fn has_label(&self, region: usize) -> bool {
        self.labels.iter().any(|label| label.region == region)
    }

    /// Labels a region beside it, with a line to its deepest point, or to its sample point where that lies almost as
    /// deep; false where the region or room is missing.
    pub(super) fn label_beside(&mut self, region: usize, name: &Name, sample: Point) -> bool {
        let grid = &self.panel.grid;
        let Some((deepest, depth)) = self.deepest[region] else { return false };
        let at_sample = grid.index(sample).map_or(0.0, |index| grid.depth[index]);
        let anchor = if at_sample >= 0.5 * depth && depth > 0.0 { sample } else { deepest };
        let size = LEADER_SIZE;
        let length_to = |rect: &Rect| distance(anchor, rect.grown(1.0).nearest(anchor));
        let Some(rect) = self.free_place(
            extent(name, size, false),
            &|rect| Some(length_to(rect)).filter(|length| *length >= LEADER_MIN),
            &|rect| self.leader_cost(anchor, rect.grown(1.0).nearest(anchor)),
        ) else {
            return false;
        };
        let leader = [anchor, rect.grown(1.0).nearest(anchor)];
        self.take(&rect.grown(CLEARANCE));
        self.take(&Rect::around(anchor, CLEARANCE));
        self.leaders.push(leader);
        self.labels.push(Label { region, rect, size, one_line: false, leader: Some(leader) });
        true
    }

    /// A place for a text of the given extent that touches `frame`.
    pub(super) fn beside(&mut self, frame: &Rect, extent: [f64; 2]) -> Option<Rect> {
        let gap = |rect: &Rect| {
            let near = frame.grown(2.0).nearest(rect.center());
            let overlaps =
                rect.x < frame.right() && frame.x < rect.right() && rect.y < frame.bottom() && frame.y < rect.bottom();
            (!overlaps).then_some(3.0 * distance(rect.nearest(near), near))
        };
        let place = self.free_place(extent, &gap, &|_| 0.0)?;
        self.take(&place.grown(CLEARANCE));
        Some(place)
    }

    /// The place for a text with the least sum of `near` (none: not there), of what it would cover, and of `far`, which
    /// is costly to know and asked for only where it can matter.
    fn free_place(
        &self,
        [width, height]: [f64; 2],
        near: &dyn Fn(&Rect) -> Option<f64>,
        far: &dyn Fn(&Rect) -> f64,
    ) -> Option<Rect> {
        let grid = &self.panel.grid;
        let taken = Sums::new(grid, |at| self.taken[at]);
        let lines = Sums::new(grid, |at| grid.depth[at] == 0.0);
        let regions = Sums::new(grid, |at| grid.regions[at] != NOTHING);
        let mut places: Vec<(f64, Rect)> = Vec::new();
        for y in (0..grid.height).step_by(STEP) {
            for x in (0..grid.width).step_by(STEP) {
                let [x, y] = grid.position(x, y);
                let rect = Rect { x, y, width, height };
                let needed = rect.grown(CLEARANCE - 1.0);
                if !self.on_panel(&needed) {
                    continue;
                }
                let Some(near) = near(&rect) else { continue };
                let covered = 4.0 * taken.count(grid, &needed)
                    + 2.0 * lines.count(grid, &needed)
                    + 25.0 * regions.count(grid, &rect) / (width * height);
                places.push((near + covered, rect));
            }
        }
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best: Option<(f64, Rect)> = None;
        for (cost, rect) in places {
            if best.is_some_and(|(least, _)| cost >= least) {
                break;
            }
            let total = cost + far(&rect);
            if best.is_none_or(|(least, _)| total < least) {
                best = Some((total, rect));
            }
        }
        best.map(|(_, rect)| rect)
    }

    /// What a leader line would cross.
    fn leader_cost(&self, from: Point, to: Point) -> f64 {
        let grid = &self.panel.grid;
        let length = distance(from, to);
        let mut cost = 0.0;
        let mut walked = 0.0;
        while walked < length {
            let at = [from[0] + (to[0] - from[0]) * walked / length, from[1] + (to[1] - from[1]) * walked / length];
            if let Some(index) = grid.index(at) {
                cost += if self.taken[index] { 16.0 } else { 0.0 };
                cost += if grid.depth[index] == 0.0 { 4.0 } else { 0.0 };
            }
            walked += 1.0;
        }
        cost + 150.0 * self.leaders.iter().filter(|leader| cross(**leader, [from, to])).count() as f64
    }
}

/// True when two segments cross.
fn cross(a: [Point; 2], b: [Point; 2]) -> bool {
    let side =
        |s: [Point; 2], p: Point| (s[1][0] - s[0][0]) * (p[1] - s[0][1]) - (s[1][1] - s[0][1]) * (p[0] - s[0][0]);
    side(a, b[0]) * side(a, b[1]) < 0.0 && side(b, a[0]) * side(b, a[1]) < 0.0
}
