//! The labels of regions, and the marks of events and sample points.

use bifdiag_page::{Anchor, Canvas, FAINT_INK, INK, Ink, PAPER, Point, Rect, section_type, superscript, text_width};
use bifdiag_schema::{AtlasDocument, EventKind, RegionDocument};

/// The energy.
pub(super) const H: &str = "h";
/// The vertical angular momentum.
pub(super) const L: &str = "l";

/// Size of the id relative to the type, and the least size of both.
const ID_SCALE: f64 = 0.78;
pub(super) const SMALLEST: f64 = 11.0;
/// Height of a line relative to the font size.
const LINE: f64 = 1.2;
/// Between the text of a boxed label and its box.
const PADDING: f64 = 2.0;
/// Length of the arrow head at the region's end of a leader.
const ARROW: f64 = 5.0;

/// What labels say of a region.
#[derive(Clone, Debug)]
pub(super) struct Name {
    /// The type of the section.
    pub kind: String,
    pub id: String,
    /// U, where another region has a section of the same type over another U.
    pub accessible: Option<String>,
}

impl Name {
    /// All of it in a line.
    pub(super) fn sentence(&self) -> String {
        match &self.accessible {
            Some(accessible) => format!("{}, U = {accessible}", self.kind),
            None => self.kind.clone(),
        }
    }
}

/// How much of a name a label says; the key has the rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Everything.
    Full,
    /// Type and id.
    Short,
    /// The id alone.
    Id,
}

/// Width and height of a label, on two lines and on one, in each form.
pub type Boxes = [[[f64; 2]; 2]; 3];

/// The smallest labels of these names.
pub(super) fn boxes(names: &[Name]) -> Vec<Boxes> {
    let of = |name: &Name| {
        [Form::Full, Form::Short, Form::Id]
            .map(|form| [false, true].map(|one_line| Setting { form, size: SMALLEST, one_line }.extent(name)))
    };
    names.iter().map(of).collect()
}

/// How a label is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Setting {
    pub form: Form,
    /// Font size of the type.
    pub size: f64,
    /// Type and id share a line.
    pub one_line: bool,
}

/// A placed label of a region.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub region: usize,
    pub setting: Setting,
    pub rect: Rect,
    /// From the region to the label.
    pub leader: Option<[Point; 2]>,
}

impl Setting {
    /// The two texts; the second is smaller and may be empty.
    pub(super) fn texts(&self, name: &Name) -> [String; 2] {
        match (self.form, &name.accessible) {
            (Form::Full, Some(accessible)) => [name.kind.clone(), format!("{}, U = {accessible}", name.id)],
            (Form::Full | Form::Short, _) => [name.kind.clone(), name.id.clone()],
            (Form::Id, _) => [name.id.clone(), String::new()],
        }
    }

    /// Font sizes of the two texts.
    fn sizes(&self) -> [f64; 2] {
        [self.size, (self.size * ID_SCALE).max(SMALLEST)]
    }

    /// Size of a label.
    pub(super) fn extent(&self, name: &Name) -> [f64; 2] {
        let [first, second] = self.texts(name);
        let [size, small] = self.sizes();
        let (first, second) = (text_width(&first, size), text_width(&second, small));
        if second == 0.0 {
            [first, LINE * size]
        } else if self.one_line {
            [first + 0.4 * size + second, LINE * size]
        } else {
            [first.max(second), LINE * (size + small)]
        }
    }
}

/// A component of the accessible region: `D2` is D², `S2-3D2` is S²∖3D².
fn accessible_region(name: &str) -> String {
    match name.split_once('-') {
        Some((sphere, discs)) => {
            let count = discs.trim_end_matches("D2");
            format!("{}∖{count}D²", superscript(sphere))
        }
        None => superscript(name),
    }
}

/// The accessible region of a region of the diagram.
pub(super) fn accessible_regions(region: &RegionDocument) -> String {
    let parts: Vec<String> =
        region.components.iter().map(|component| accessible_region(&component.accessible_region)).collect();
    parts.join("+")
}

/// The type printed in a region: that of its section, or of its accessible region where no section exists.
pub(super) fn region_type(region: &RegionDocument) -> String {
    if let Some(signature) = &region.signature {
        return section_type(signature);
    }
    if region.components.is_empty() {
        return "undecided".to_owned();
    }
    format!("U: {}", accessible_regions(region))
}

/// The names of all regions.
pub(super) fn names(atlas: &AtlasDocument) -> Vec<Name> {
    let types: Vec<[String; 2]> =
        atlas.regions.iter().map(|region| [region_type(region), accessible_regions(region)]).collect();
    let name = |(region, [kind, own]): (&RegionDocument, &[String; 2])| {
        let ambiguous = region.signature.is_some() && types.iter().any(|[other, u]| other == kind && u != own);
        Name { kind: kind.clone(), id: region.id.clone(), accessible: ambiguous.then(|| own.clone()) }
    };
    atlas.regions.iter().zip(&types).map(name).collect()
}

/// The box that is drawn round a label with a leader.
pub(super) fn boxed(rect: &Rect) -> Rect {
    rect.grown(PADDING)
}

/// Draws a label as the group `id`.
pub(super) fn paint(canvas: &Canvas, label: &Label, name: &Name, id: &str) {
    if let Some(leader) = label.leader {
        canvas.group(&format!("{id}-leader"), "", || paint_leader(canvas, leader));
    }
    canvas.group(id, &format!("{}: {}", name.id, name.sentence()), || {
        if label.leader.is_some() {
            let frame = boxed(&label.rect).corners();
            canvas.polygon(&frame, PAPER);
            canvas.outline(&frame, Ink { color: FAINT_INK, width: 0.5 });
        }
        paint_texts(canvas, label, name);
    });
}

fn paint_texts(canvas: &Canvas, label: &Label, name: &Name) {
    let [first, second] = label.setting.texts(name);
    let Rect { x, y, width, .. } = label.rect;
    let [size, small] = label.setting.sizes();
    let (middle, base) = (x + width / 2.0, y + 0.95 * size);
    if second.is_empty() {
        canvas.text(&first, [middle, base], size, INK, Anchor::Middle);
    } else if label.setting.one_line {
        canvas.text(&first, [x, base], size, INK, Anchor::Start);
        canvas.text(&second, [x + width, base], small, FAINT_INK, Anchor::End);
    } else {
        canvas.text(&first, [middle, base], size, INK, Anchor::Middle);
        canvas.text(&second, [middle, y + LINE * size + 0.9 * small], small, FAINT_INK, Anchor::Middle);
    }
}

/// A line to the region, with an arrow head, since dots are sample points.
fn paint_leader(canvas: &Canvas, [tip, end]: [Point; 2]) {
    let ink = Ink { color: INK, width: 0.7 };
    canvas.path(&[tip, end], ink);
    let length = bifdiag_page::distance(tip, end).max(1e-9);
    let [x, y] = [(end[0] - tip[0]) / length, (end[1] - tip[1]) / length];
    let wing = |side: f64| [tip[0] + ARROW * (x - side * 0.35 * y), tip[1] + ARROW * (y + side * 0.35 * x)];
    canvas.polygon(&[tip, wing(1.0), wing(-1.0)], INK);
}

/// Half the size of a marker.
pub(super) const MARKER: f64 = 4.0;

/// Marks an event: a filled diamond at a cusp, a filled triangle at a pitchfork, a ring at a crossing.
pub(super) fn event_marker(canvas: &Canvas, kind: EventKind, at: Point) {
    let [x, y] = at;
    let shape = match kind {
        EventKind::Crossing => return canvas.ring(at, MARKER - 1.0, Ink { color: INK, width: 1.1 }),
        EventKind::Cusp => vec![[x, y - MARKER], [x + MARKER, y], [x, y + MARKER], [x - MARKER, y]],
        EventKind::Pitchfork => {
            vec![[x, y - MARKER], [x + 0.95 * MARKER, y + 0.7 * MARKER], [x - 0.95 * MARKER, y + 0.7 * MARKER]]
        }
    };
    canvas.polygon(&shape, INK);
    canvas.outline(&shape, Ink { color: PAPER, width: 0.8 });
}

/// Marks the sample point of a region.
pub(super) fn sample_dot(canvas: &Canvas, at: Point) {
    canvas.disc(at, 2.0, INK);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_printed_as_in_the_paper() {
        assert_eq!(accessible_region("S2-3D2"), "S²∖3D²");
    }
}
