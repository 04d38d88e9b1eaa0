//! Where the labels of one panel go: inside their regions where they fit, else beside them with a leader line. What is
//! placed meets nothing that is there; beside its region a label keeps off every curve, too.

use super::grid::{Grid, NOTHING};
use super::labels::{Form, Label, Name, SMALLEST, Setting, boxed};
use super::panel::Panel;
use crate::page::{Point, Rect, Taken, distance};

/// Font sizes that are tried inside a region, best first.
const SIZES: [f64; 3] = [14.0, 12.0, SMALLEST];
/// Font sizes of a label with a leader line, and of an id alone.
const LEADER_SIZE: f64 = SMALLEST;
const ID_SIZE: f64 = SMALLEST;
/// Free pixels around a label inside its region, and around a box.
const CLEARANCE: f64 = 3.0;
const BOX_CLEARANCE: f64 = 1.5;
/// Grid of places tried for a label with a leader line, in pixels.
const STEP: usize = 4;
/// Lengths of leader lines.
const LEADER_MIN: f64 = 10.0;
const LEADER_MAX: f64 = 150.0;
/// Points of a region to which a leader may go: so deep in it, compared to the deepest, and so many.
const DEEP: f64 = 0.55;
const TIPS: usize = 40;
/// Tips tried for each place, the nearest first.
const TIPS_TRIED: usize = 6;

/// A panel with what is taken on it.
pub(super) struct Room<'a> {
    panel: &'a Panel,
    /// Deepest point and depth of every region.
    deepest: Vec<Option<(Point, f64)>>,
    /// Pixels on curves and of regions.
    lines: Sums,
    regions: Sums,
    pub taken: Taken,
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

impl<'a> Room<'a> {
    pub(super) fn new(panel: &'a Panel, regions: usize, taken: Taken) -> Self {
        let grid = &panel.grid;
        Self {
            panel,
            deepest: grid.deepest(regions),
            lines: Sums::new(grid, |at| grid.depth[at] == 0.0),
            regions: Sums::new(grid, |at| grid.regions[at] != NOTHING),
            taken,
            leaders: Vec::new(),
            labels: Vec::new(),
        }
    }

    pub(super) fn into_labels(self) -> Vec<Label> {
        self.labels
    }

    /// Depth of a region here, 0 where it has no pixel.
    pub(super) fn depth(&self, region: usize) -> f64 {
        self.deepest[region].map_or(0.0, |(_, depth)| depth)
    }

    pub(super) fn has_label(&self, region: usize) -> bool {
        self.labels.iter().any(|label| label.region == region)
    }

    /// Labels a region inside of it, in one of these forms, the first that fits.
    pub(super) fn label_inside(&mut self, region: usize, name: &Name, forms: &[Form]) -> bool {
        let Ok(own) = i32::try_from(region) else { return false };
        let grid = &self.panel.grid;
        let other = Sums::new(grid, |at| grid.regions[at] != own);
        let settings = forms.iter().flat_map(|&form| {
            let sizes = SIZES.iter().filter(move |size| form != Form::Id || **size == SIZES[2]);
            sizes.flat_map(move |&size| [false, true].map(|one_line| Setting { form, size, one_line }))
        });
        let found = settings.into_iter().find_map(|setting| {
            let rect = self.inside(own, &other, setting.extent(name))?;
            Some(Label { region, setting, rect, leader: None })
        });
        let Some(label) = found else { return false };
        self.taken.take_box(label.rect);
        self.labels.push(label);
        true
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
                let fits = self.on_panel(&needed) && other.count(grid, &needed) == 0.0;
                if fits && self.taken.admits_box(&needed) {
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

    /// Labels a region beside it, with a line to one of its deeper points; false where the region or room is missing.
    pub(super) fn label_beside(&mut self, region: usize, name: &Name, form: Form) -> bool {
        let tips = self.tips(region);
        let setting = Setting { form, size: if form == Form::Id { ID_SIZE } else { LEADER_SIZE }, one_line: false };
        let extent = setting.extent(name);
        let grid = &self.panel.grid;
        let near = |rect: &Rect| {
            let to = |tip: &Point| distance(*tip, boxed(rect).nearest(*tip));
            let length = tips.iter().map(to).fold(f64::INFINITY, f64::min);
            (length <= LEADER_MAX).then_some(length)
        };
        let mut best: Option<(f64, Rect, [Point; 2])> = None;
        for (cost, rect) in self.places(extent, &near) {
            if best.as_ref().is_some_and(|(least, ..)| cost >= *least) {
                break;
            }
            let frame = boxed(&rect);
            if !self.taken.admits_box(&frame.grown(BOX_CLEARANCE)) {
                continue;
            }
            let mut leaders: Vec<[Point; 2]> = tips.iter().map(|tip| [*tip, frame.nearest(*tip)]).collect();
            leaders.sort_by(|a, b| distance(a[0], a[1]).total_cmp(&distance(b[0], b[1])));
            leaders.retain(|leader| (LEADER_MIN..=LEADER_MAX).contains(&distance(leader[0], leader[1])));
            for leader in leaders.into_iter().take(TIPS_TRIED) {
                let total = cost + crossings(grid, leader);
                let better = best.as_ref().is_none_or(|(least, ..)| total < *least);
                if better && self.taken.admits_leader(leader, &self.leaders) {
                    best = Some((total, rect, leader));
                }
            }
        }
        let Some((_, rect, leader)) = best else { return false };
        self.taken.take_box(boxed(&rect));
        self.taken.take_line(leader);
        self.leaders.push(leader);
        self.labels.push(Label { region, setting, rect, leader: Some(leader) });
        true
    }

    /// Deep points of a region that no box hides.
    fn tips(&self, region: usize) -> Vec<Point> {
        let (Some((_, deepest)), Ok(own)) = (self.deepest[region], i32::try_from(region)) else { return Vec::new() };
        let grid = &self.panel.grid;
        let is_tip = |at: &usize| grid.regions[*at] == own && grid.depth[*at] >= DEEP * deepest;
        let mut tips: Vec<Point> = (0..grid.regions.len())
            .filter(is_tip)
            .map(|at| grid.position(at % grid.width, at / grid.width))
            .filter(|tip| !self.taken.holds(*tip))
            .collect();
        let every = tips.len().div_ceil(TIPS).max(1);
        tips = tips.into_iter().step_by(every).collect();
        tips
    }

    /// A place for a text of the given extent that touches `frame`.
    pub(super) fn beside(&mut self, frame: &Rect, extent: [f64; 2]) -> Option<Rect> {
        let gap = |rect: &Rect| {
            let close = frame.grown(2.0).nearest(rect.center());
            let gap = distance(rect.nearest(close), close);
            (gap <= LEADER_MIN).then_some(3.0 * gap)
        };
        let mut places = self.places_anywhere(extent, &gap);
        let place = places.find(|(_, rect)| self.taken.admits_box(&rect.grown(1.0))).map(|(_, rect)| rect)?;
        self.taken.take_box(place);
        Some(place)
    }

    /// Places off the curves, those with the least sum of `near` (none: not there) and of what they would cover first.
    fn places(
        &self,
        extent: [f64; 2],
        near: &dyn Fn(&Rect) -> Option<f64>,
    ) -> impl Iterator<Item = (f64, Rect)> + use<> {
        let grid = &self.panel.grid;
        let off_curves =
            |rect: &Rect| (self.lines.count(grid, &boxed(rect).grown(BOX_CLEARANCE)) == 0.0).then_some(0.0);
        self.sorted(extent, &|rect| Some(off_curves(rect)? + near(rect)?))
    }

    /// Places anywhere; curves are better not covered.
    fn places_anywhere(
        &self,
        extent: [f64; 2],
        near: &dyn Fn(&Rect) -> Option<f64>,
    ) -> impl Iterator<Item = (f64, Rect)> + use<> {
        self.sorted(extent, &|rect| Some(2.0 * self.lines.count(&self.panel.grid, rect) + near(rect)?))
    }

    fn sorted(
        &self,
        [width, height]: [f64; 2],
        cost: &dyn Fn(&Rect) -> Option<f64>,
    ) -> impl Iterator<Item = (f64, Rect)> + use<> {
        let grid = &self.panel.grid;
        let mut places: Vec<(f64, Rect)> = Vec::new();
        for y in (0..grid.height).step_by(STEP) {
            for x in (0..grid.width).step_by(STEP) {
                let [x, y] = grid.position(x, y);
                let rect = Rect { x, y, width, height };
                if !self.on_panel(&boxed(&rect).grown(1.0)) {
                    continue;
                }
                let Some(cost) = cost(&rect) else { continue };
                // On the ground of no region a label hides least.
                places.push((cost + 25.0 * self.regions.count(grid, &rect) / (width * height), rect));
            }
        }
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        places.into_iter()
    }
}

/// What it costs that a leader crosses curves.
fn crossings(grid: &Grid, [from, to]: [Point; 2]) -> f64 {
    let length = distance(from, to);
    let mut cost = 0.0;
    let mut walked = 0.0;
    while walked < length {
        let at = [from[0] + (to[0] - from[0]) * walked / length, from[1] + (to[1] - from[1]) * walked / length];
        cost += grid.index(at).map_or(0.0, |index| if grid.depth[index] == 0.0 { 4.0 } else { 0.0 });
        walked += 1.0;
    }
    cost
}
