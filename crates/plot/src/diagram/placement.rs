//! The places of all text in all panels of a diagram: labels are inside their regions if they fit, else beside them
//! with a leader. Nothing placed overlaps what is already there; a label beside its region also avoids every curve.

use super::labels::{Form, Label, MARKER, Name, SMALLEST, Setting, boxed, names};
use super::layout::{CROWDED, Frame, LETTER_SIZE, is_marked};
use super::panel::{LEGIBLE, Panel};
use super::scene::Scene;
use bifdiag_page::{Areas, Labelled, NOTHING, Point, Rect, Sums, Taken, all_over, distance, text_width};

/// Font sizes that are tried inside a region, best first; the last is that of a label beside its region.
const SIZES: [f64; 3] = [14.0, 12.0, SMALLEST];
/// Free pixels around a label inside its region, and around a box.
const CLEARANCE: f64 = 3.0;
const BOX_CLEARANCE: f64 = 1.5;
/// Distance of the places tried beside a region, in pixels.
const STEP: f64 = 4.0;
/// Lengths of leaders.
const LEADER: [f64; 2] = [10.0, 150.0];
/// What it costs to cover the ground of regions, where a label hides more than elsewhere, and a pixel of a curve.
const ON_GROUND: f64 = 25.0;
const ON_CURVE: f64 = 2.0;
/// What it costs a leader to run a pixel along a curve.
const CROSSED: f64 = 4.0;

/// The text of a diagram.
pub(super) struct Texts {
    /// The name of each region.
    pub names: Vec<Name>,
    /// The labels of each panel.
    pub labels: Vec<Vec<Label>>,
    /// The place of the letters at the frame that starts with this inset.
    pub letters: Vec<Option<Rect>>,
    /// Regions for the key, since no label names them in full, and whether they have a label at all.
    pub key: Vec<(usize, bool)>,
}

/// How a region is labelled: where, and in which form; the best first.
const TRIES: [(bool, Form); 6] = [
    (true, Form::Full),
    (true, Form::Short),
    (false, Form::Full),
    (true, Form::Id),
    (false, Form::Short),
    (false, Form::Id),
];

/// Finds the places: inside the regions first, in every panel, then beside those that are left.
pub(super) fn place(scene: &Scene<'_>, panels: &[Panel], frames: &[Vec<Frame>]) -> Texts {
    let names = names(scene.atlas);
    let mut letters = vec![None; panels.len()];
    let room = |(panel, frames): (_, &Vec<Frame>)| free_room(scene, panel, frames, &mut letters);
    let mut rooms: Vec<Room<'_>> = panels.iter().zip(frames).map(room).collect();
    for room in &mut rooms {
        for (region, name) in names.iter().enumerate() {
            if room.depth(region) >= LEGIBLE {
                room.label_inside(region, name, &[Form::Full]);
            }
        }
    }
    for (region, name) in names.iter().enumerate() {
        if !rooms.iter().any(|room| room.has_label(region)) {
            label(&mut rooms, region, name);
        }
    }
    // What can be seen in a panel is named there too.
    for room in &mut rooms {
        for (region, name) in names.iter().enumerate() {
            if room.depth(region) >= LEGIBLE && !room.has_label(region) {
                let _no_room = room.label_inside(region, name, &[Form::Short, Form::Id])
                    || room.label_beside(region, name, Form::Id);
            }
        }
    }
    let labels: Vec<Vec<Label>> = rooms.into_iter().map(|room| room.labels).collect();
    let key = names.iter().enumerate().filter_map(|(region, name)| {
        let own = || labels.iter().flatten().filter(|label| label.region == region);
        let is_full = |label: &Label| match label.setting.form {
            Form::Full => true,
            Form::Short => name.accessible.is_none(),
            Form::Id => false,
        };
        (!own().any(is_full)).then(|| (region, own().next().is_some()))
    });
    let key = key.collect();
    Texts { names, labels, letters, key }
}

/// Labels a region once, in the best way for which there is room: in the first panel that shows it well, else in the one
/// that shows it best.
fn label(rooms: &mut [Room<'_>], region: usize, name: &Name) {
    let mut order: Vec<usize> = (0..rooms.len()).filter(|&room| rooms[room].depth(region) > 0.0).collect();
    order.sort_by(|&a, &b| {
        let depth = |room: usize| rooms[room].depth(region).min(LEGIBLE);
        depth(b).total_cmp(&depth(a)).then(a.cmp(&b))
    });
    for (inside, form) in TRIES {
        for &room in &order {
            let room = &mut rooms[room];
            let placed = if inside {
                room.depth(region) >= LEGIBLE && room.label_inside(region, name, &[form])
            } else {
                room.label_beside(region, name, form)
            };
            if placed {
                return;
            }
        }
    }
}

/// The room of a panel that markers, frames and their letters leave to labels, whose places go into `letters`.
fn free_room<'a>(scene: &Scene<'_>, panel: &'a Panel, frames: &[Frame], letters: &mut [Option<Rect>]) -> Room<'a> {
    let mut taken = Taken::default();
    let events = scene.atlas.events.iter().filter_map(|event| panel.event(scene, event));
    let dots = scene.dots.iter().filter_map(|dot| panel.position(dot.at));
    for point in events.chain(dots).filter(|point: &Point| is_marked(*point, panel, frames)) {
        taken.take_box(Rect::around(point, MARKER + 0.5));
    }
    for frame in frames {
        if frame.rect.width < CROWDED || frame.rect.height < CROWDED {
            taken.take_box(frame.rect);
        } else {
            taken.take_outline(&frame.rect);
        }
    }
    let mut room = Room::new(panel, scene.cells.len(), taken);
    for frame in frames {
        let text = frame.letters().join(", ");
        letters[frame.insets[0]] = room.beside(&frame.rect, [text_width(&text, LETTER_SIZE), LETTER_SIZE]);
    }
    room
}

/// A panel with what is taken on it.
struct Room<'a> {
    panel: &'a Panel,
    /// Deepest point and depth of every region.
    deepest: Vec<Option<(Point, f64)>>,
    /// Pixels on curves and of regions.
    lines: Sums,
    ground: Sums,
    taken: Taken,
    labels: Vec<Label>,
}

impl<'a> Room<'a> {
    fn new(panel: &'a Panel, regions: usize, taken: Taken) -> Self {
        let areas = &panel.areas;
        Self {
            panel,
            deepest: areas.deepest(regions),
            lines: Sums::new(areas, |at| areas.depth[at] == 0.0),
            ground: Sums::new(areas, |at| areas.of[at] != NOTHING),
            taken,
            labels: Vec::new(),
        }
    }

    /// Depth of a region here, 0 where it has no pixel.
    fn depth(&self, region: usize) -> f64 {
        self.deepest[region].map_or(0.0, |(_, depth)| depth)
    }

    fn has_label(&self, region: usize) -> bool {
        self.labels.iter().any(|label| label.region == region)
    }

    /// Labels a region inside of it, in one of these forms, the first that fits.
    fn label_inside(&mut self, region: usize, name: &Name, forms: &[Form]) -> bool {
        let areas = &self.panel.areas;
        let others = Sums::new(areas, |at| usize::try_from(areas.of[at]) != Ok(region));
        let settings = forms.iter().flat_map(|&form| {
            let sizes = SIZES.iter().filter(move |size| form != Form::Id || **size == SIZES[2]);
            sizes.flat_map(move |&size| [false, true].map(|one_line| Setting { form, size, one_line }))
        });
        let found = settings.into_iter().find_map(|setting| {
            let rect = areas.inside(region, &others, setting.extent(name), CLEARANCE, &self.taken)?;
            Some(Label { region, setting, rect, leader: None })
        });
        let Some(label) = found else { return false };
        self.taken.take_box(label.rect);
        self.labels.push(label);
        true
    }

    /// Labels a region beside it, with a line to one of its deeper points; false where the region or room is missing.
    fn label_beside(&mut self, region: usize, name: &Name, form: Form) -> bool {
        let setting = Setting { form, size: SMALLEST, one_line: false };
        let Self { panel, lines, ground, taken, labels, .. } = self;
        let areas = &panel.areas;
        let tips = areas.tips(region, taken);
        let labelled = Labelled { tips: &tips, lengths: LEADER, clearance: BOX_CLEARANCE };
        let [width, height] = setting.extent(name);
        let size = boxed(&Rect { x: 0.0, y: 0.0, width, height });
        let places = all_over(panel.view.rect.grown(-1.0), [size.width, size.height], STEP)
            .filter(|rect| lines.count(areas, &rect.grown(BOX_CLEARANCE)) == 0.0)
            .map(|rect| (covered(areas, ground, &rect), rect));
        let Some((frame, leader)) = taken.place_with_leader(&labelled, places, |leader| crossed(areas, leader)) else {
            return false;
        };
        let rect = Rect { x: frame.x - size.x, y: frame.y - size.y, width, height };
        labels.push(Label { region, setting, rect, leader: Some(leader) });
        true
    }

    /// A place for a text of the given extent that touches `frame`.
    fn beside(&mut self, frame: &Rect, extent: [f64; 2]) -> Option<Rect> {
        let Self { panel, lines, ground, taken, .. } = self;
        let areas = &panel.areas;
        let places = all_over(panel.view.rect.grown(-3.0), extent, STEP).filter_map(|rect| {
            let close = frame.grown(2.0).nearest(rect.center());
            let gap = distance(rect.nearest(close), close);
            let cost = ON_CURVE * lines.count(areas, &rect) + 3.0 * gap + covered(areas, ground, &rect);
            (gap <= LEADER[0]).then_some((cost, rect))
        });
        taken.place(places, 1.0)
    }
}

/// What it costs to cover the ground of regions.
fn covered(areas: &Areas, ground: &Sums, rect: &Rect) -> f64 {
    ON_GROUND * ground.count(areas, rect) / (rect.width * rect.height)
}

/// What it costs that a leader crosses curves.
fn crossed(areas: &Areas, [from, to]: [Point; 2]) -> f64 {
    let length = distance(from, to);
    let mut cost = 0.0;
    let mut walked = 0.0;
    while walked < length {
        let at = bifdiag_page::between(from, to, walked / length);
        cost += areas.index(at).map_or(0.0, |index| if areas.depth[index] == 0.0 { CROSSED } else { 0.0 });
        walked += 1.0;
    }
    cost
}
