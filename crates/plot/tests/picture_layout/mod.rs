//! Where boxes, leaders, frames and texts of a diagram lie, read from its SVG by the ids of its groups, and what meets.

use bifdiag_plot::Picture;
use resvg::tiny_skia::PathSegment;
use resvg::usvg::{Group, Node, Path, Rect};

use super::picture_svg::{content, tree};

/// How far things may reach into each other: half a pixel of rounding, in units of the page.
const SLACK: f32 = 0.6;

/// What a picture holds.
#[derive(Default)]
pub struct Layout {
    pub size: [f32; 2],
    /// Text, its box, and the id of the label that it belongs to.
    pub texts: Vec<(String, Rect, String)>,
    /// Panels with their axes, the legend and the table below, by their ids.
    pub blocks: Vec<(String, Rect)>,
    /// Boxes of labels with leaders, with their ids.
    pub boxes: Vec<(String, Rect)>,
    /// Leader lines with the ids of their labels, the region's end first.
    pub leaders: Vec<(String, [[f32; 2]; 2])>,
    /// Frames of insets with their ids.
    pub frames: Vec<(String, Rect)>,
    /// Marks of events and samples with their ids.
    pub marks: Vec<(String, Rect)>,
    /// Regions with the ids of their panel and their own.
    pub regions: Vec<(String, Rect)>,
}

impl Layout {
    pub fn of(picture: &Picture) -> Self {
        let tree = tree(picture);
        let mut layout = Self { size: [tree.size().width(), tree.size().height()], ..Self::default() };
        layout.collect(tree.root(), "");
        layout
    }

    fn collect(&mut self, group: &Group, label: &str) {
        let id = group.id();
        let label = if id.contains("-label-") { id } else { label };
        if id.contains("-event-") || id.contains("-sample-") {
            self.marks.push((id.to_owned(), group.abs_bounding_box()));
        }
        if id.ends_with("-axes") || id == "legend" || id == "motions" {
            self.blocks.push((id.to_owned(), group.abs_bounding_box()));
        }
        for node in group.children() {
            match node {
                Node::Group(inner) => self.collect(inner, label),
                Node::Text(text) => {
                    self.texts.push((content(text), text.abs_bounding_box(), label.to_owned()));
                }
                Node::Path(path) if id.ends_with("-leader") && path.stroke().is_some() => {
                    let label = id.trim_end_matches("-leader").to_owned();
                    self.leaders.push((label, ends(path)));
                }
                Node::Path(path) if id.contains("-label-") && path.stroke().is_some() && !id.ends_with("-leader") => {
                    self.boxes.push((id.to_owned(), path.abs_bounding_box()));
                }
                Node::Path(path) if id.ends_with("-regions") => {
                    self.regions.push((path.id().to_owned(), path.abs_bounding_box()));
                }
                Node::Path(path) if id.contains("-frame-") => {
                    self.frames.push((id.to_owned(), path.abs_bounding_box()));
                }
                Node::Path(_) | Node::Image(_) => {}
            }
        }
    }

    /// Frames of insets that reach into each other, and those without a letter.
    fn frames_at_odds(&self) -> Vec<String> {
        let mut found = Vec::new();
        for (i, (id, frame)) in self.frames.iter().enumerate() {
            let Some((panel, letter)) = id.split_once("-frame-") else { continue };
            if !self.texts.iter().any(|(text, _, _)| *text == letter.replace('-', ", ")) {
                found.push(format!("{id} has no letter"));
            }
            let beside = self.frames[..i].iter().filter(|(other, _)| other.split_once("-frame-").unwrap().0 == panel);
            found.extend(beside.filter(|(_, other)| meet(frame, other)).map(|(other, _)| format!("{id} and {other}")));
        }
        found
    }

    /// Everything that meets what it should not.
    pub fn collisions(&self) -> Vec<String> {
        let mut found = self.frames_at_odds();
        for (i, (id, block)) in self.blocks.iter().enumerate() {
            // The boxes of two panels' axes reach into each other at the corners, where nothing stands.
            let is_axes = |id: &String| id.ends_with("-axes");
            let others =
                self.blocks[..i].iter().filter(|(name, other)| meet(block, other) && !(is_axes(id) && is_axes(name)));
            found.extend(others.map(|(other, _)| format!("{id} on {other}")));
        }
        let mut tell = |what: String| found.push(what);
        for (i, (text, area, label)) in self.texts.iter().enumerate() {
            if area.left() < 0.0 || area.top() < 0.0 || area.right() > self.size[0] || area.bottom() > self.size[1] {
                tell(format!("text `{text}` leaves the page"));
            }
            for (other, other_area, other_label) in &self.texts[..i] {
                // Boxes of text reach from ascender to descender; lines of one label share that space.
                let own = !label.is_empty() && label == other_label;
                if !own && meet(&inner(area), &inner(other_area)) {
                    tell(format!("texts `{text}` and `{other}` of {label} and {other_label}"));
                }
            }
            for (id, frame) in &self.frames {
                if sides(frame).iter().any(|side| crosses(*side, &inner(area))) {
                    tell(format!("text `{text}` on {id}"));
                }
            }
            for (id, mark) in self.marks.iter().filter(|_| !label.is_empty()) {
                if meet(&inner(area), mark) {
                    tell(format!("text `{text}` on {id}"));
                }
            }
            for (id, leader) in self.leaders.iter().filter(|(id, _)| id != label) {
                if crosses(*leader, &inner(area)) {
                    tell(format!("leader of {id} through `{text}` of {label}"));
                }
            }
            for (id, area_of_box) in self.boxes.iter().filter(|(id, _)| id != label) {
                if meet(&inner(area), area_of_box) {
                    tell(format!("box {id} on text `{text}`"));
                }
            }
        }
        for (i, (id, area)) in self.boxes.iter().enumerate() {
            for (other, other_area) in &self.boxes[..i] {
                if meet(area, other_area) {
                    tell(format!("boxes {id} and {other}"));
                }
            }
            for (mark, mark_area) in &self.marks {
                if meet(area, mark_area) {
                    tell(format!("box {id} on {mark}"));
                }
            }
            for (frame, rect) in &self.frames {
                if sides(rect).iter().any(|side| crosses(*side, area)) {
                    tell(format!("box {id} on {frame}"));
                }
            }
        }
        for (i, (id, leader)) in self.leaders.iter().enumerate() {
            for (other, area) in self.boxes.iter().filter(|(other, _)| other != id) {
                if crosses(*leader, area) {
                    tell(format!("leader of {id} through box {other}"));
                }
            }
            for (mark, area) in &self.marks {
                if crosses(*leader, area) {
                    tell(format!("leader of {id} through {mark}"));
                }
            }
            for (other, other_leader) in &self.leaders[..i] {
                if cross(*leader, *other_leader) {
                    tell(format!("leaders of {id} and {other}"));
                }
            }
        }
        found
    }
}

fn ends(path: &Path) -> [[f32; 2]; 2] {
    let mut points = path.data().segments().filter_map(|segment| match segment {
        PathSegment::MoveTo(point) | PathSegment::LineTo(point) => Some(point),
        _ => None,
    });
    [points.next(), points.last()].map(|point| {
        let mut point = point.expect("a leader has two ends");
        path.abs_transform().map_point(&mut point);
        [point.x, point.y]
    })
}

/// The part of a text's box that has ink: between the height of capitals and the base line.
fn inner(area: &Rect) -> Rect {
    let height = area.height();
    Rect::from_ltrb(area.left(), area.top() + 0.2 * height, area.right(), area.bottom() - 0.2 * height).unwrap()
}

fn meet(a: &Rect, b: &Rect) -> bool {
    a.left() + SLACK < b.right()
        && b.left() + SLACK < a.right()
        && a.top() + SLACK < b.bottom()
        && b.top() + SLACK < a.bottom()
}

fn sides(rect: &Rect) -> [[[f32; 2]; 2]; 4] {
    let (left, top, right, bottom) = (rect.left(), rect.top(), rect.right(), rect.bottom());
    [
        [[left, top], [right, top]],
        [[right, top], [right, bottom]],
        [[right, bottom], [left, bottom]],
        [[left, bottom], [left, top]],
    ]
}

/// Whether a segment passes through a box, its rim apart.
fn crosses(line: [[f32; 2]; 2], area: &Rect) -> bool {
    let inside = |[x, y]: [f32; 2]| {
        x > area.left() + SLACK && x < area.right() - SLACK && y > area.top() + SLACK && y < area.bottom() - SLACK
    };
    (0..=200_u8).any(|k| {
        let t = f32::from(k) / 200.0;
        inside([line[0][0] + t * (line[1][0] - line[0][0]), line[0][1] + t * (line[1][1] - line[0][1])])
    })
}

fn cross(a: [[f32; 2]; 2], b: [[f32; 2]; 2]) -> bool {
    let side =
        |s: [[f32; 2]; 2], p: [f32; 2]| (s[1][0] - s[0][0]) * (p[1] - s[0][1]) - (s[1][1] - s[0][1]) * (p[0] - s[0][0]);
    side(a, b[0]) * side(a, b[1]) < 0.0 && side(b, a[0]) * side(b, a[1]) < 0.0
}
