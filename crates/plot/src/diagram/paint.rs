//! A diagram on its canvas.

use super::labels::{self, H, L};
use super::layout::{BELOW, Frame, LEFT, LETTER_SIZE, RIGHT, frame, is_marked, letter};
use super::markers::{event_marker, sample_dot};
use super::outline::{Ground, outline};
use super::panel::Panel;
use super::placement::Texts;
use super::ranges::contains;
use super::scene::Scene;
use super::stroke::{self, Line, Stroke, Verdict};
use super::view::View;
use crate::page::{
    Anchor, Axis, Canvas, INK, Ink, Point, TICK_SIZE, Ticks, distance, draw_axes, short, text_width, ticks,
};
use schema::EventKind;

const FRAME: Ink = Ink { color: INK, width: 0.9 };

/// Everything that is drawn in and at the panels, the main panel first.
pub(super) struct Diagram<'a> {
    pub scene: Scene<'a>,
    pub strokes: Vec<Stroke>,
    pub panels: Vec<Panel>,
    /// The frames in each panel.
    pub frames: Vec<Vec<Frame>>,
    pub texts: Texts,
    /// Units of h and l, empty where there are none.
    pub units: [String; 2],
}

impl Diagram<'_> {
    pub(super) fn paint(&self, canvas: &Canvas) {
        for (index, panel) in self.panels.iter().enumerate() {
            let (name, told) = match index {
                0 => ("main".to_owned(), "the main panel".to_owned()),
                inset => (letter(inset - 1), format!("inset ({})", letter(inset - 1))),
            };
            canvas.group(&name, &told, || self.paint_panel(canvas, index, panel, &name));
        }
        self.tell_scales(canvas);
    }

    fn paint_panel(&self, canvas: &Canvas, index: usize, panel: &Panel, name: &str) {
        let frames = &self.frames[index];
        canvas.group(&format!("{name}-regions"), "", || self.paint_regions(canvas, panel, name));
        canvas.group(&format!("{name}-curves"), "", || self.paint_curves(canvas, panel, name));
        canvas.group(&format!("{name}-points"), "", || self.mark_points(canvas, panel, frames, name));
        self.paint_frames(canvas, panel, frames, name);
        for label in &self.texts.labels[index] {
            let region = &self.texts.names[label.region];
            labels::paint(canvas, label, region, &format!("{name}-label-{}", region.id));
        }
        canvas.group(&format!("{name}-axes"), "", || paint_axes(canvas, panel, index == 0, &self.units));
    }

    fn paint_regions(&self, canvas: &Canvas, panel: &Panel, name: &str) {
        let names = &self.texts.names;
        for ((region, cells), told) in self.scene.atlas.regions.iter().zip(&self.scene.cells).zip(names) {
            let path = outline(cells.iter().map(|cell| panel.cell_polygon(cell)));
            let title = format!("{}: {}", told.id, told.sentence());
            Ground::of(region).paint(canvas, &path, &format!("{name}-{}", region.id), &title);
        }
    }

    /// Each stretch of a curve as a group, since curves upon each other are several paths.
    fn paint_curves(&self, canvas: &Canvas, panel: &Panel, name: &str) {
        for (number, stroke) in self.strokes.iter().enumerate() {
            if !stroke::is_drawn(stroke, std::slice::from_ref(panel)) {
                continue;
            }
            let told: Vec<String> = stroke.lines.iter().map(|line| self.tell_line(line)).collect();
            let id = format!("{name}-curve-{}-{}", self.scene.atlas.curves[stroke.curve].id, number + 1);
            canvas.group(&id, &told.join("; "), || stroke::draw(canvas, panel, stroke));
        }
    }

    fn tell_line(&self, line: &Line) -> String {
        let curve = &self.scene.atlas.curves[line.curve];
        let stability = match line.verdict {
            Some(Verdict::Stable) => ", eigenvalues imaginary",
            Some(Verdict::Unstable) => ", unstable",
            Some(Verdict::Open) => ", an eigenvalue zero",
            None => "",
        };
        format!("{}: {}{stability}", curve.id, curve.branch_name)
    }

    fn mark_points(&self, canvas: &Canvas, panel: &Panel, frames: &[Frame], name: &str) {
        for dot in &self.scene.dots {
            let point = panel.view.position(dot.at);
            if is_marked(point, panel, frames) {
                canvas.group(&format!("{name}-sample-{}", dot.id), &dot.title, || sample_dot(canvas, point));
            }
        }
        // Markers of one kind on top of each other say no more than one.
        let mut marked: Vec<(EventKind, Point)> = Vec::new();
        for (number, event) in self.scene.atlas.events.iter().enumerate() {
            let point = panel.view.position([event.h, event.l]);
            let hidden = marked.iter().any(|(kind, other)| *kind == event.kind && distance(*other, point) < 5.0);
            if is_marked(point, panel, frames) && !hidden {
                let kind = format!("{:?}", event.kind).to_lowercase();
                let title = format!("{kind}: h = {}, l = {}", event.h, event.l);
                let id = format!("{name}-event-{}", number + 1);
                canvas.group(&id, &title, || event_marker(canvas, event.kind, point));
                marked.push((event.kind, point));
            }
        }
    }

    /// The frames of insets with their letters, and that of the main panel in an overview.
    fn paint_frames(&self, canvas: &Canvas, panel: &Panel, frames: &[Frame], name: &str) {
        for frame in frames {
            let letters = frame.letters();
            let told = format!("inset ({})", letters.join("), ("));
            canvas.group(&format!("{name}-frame-{}", letters.join("-")), &told, || {
                canvas.outline(&frame.rect.corners(), FRAME);
            });
            if let Some(place) = self.texts.letters[frame.insets[0]] {
                let base = [place.x + place.width / 2.0, place.y + 0.82 * place.height];
                canvas.text(&letters.join(", "), base, LETTER_SIZE, INK, Anchor::Middle);
            }
        }
        let main = &self.panels[0];
        if panel.view != main.view && shows(panel, main) {
            canvas.outline(&frame(main, panel).corners(), FRAME);
        }
    }

    /// Above each inset, how much it is magnified.
    fn tell_scales(&self, canvas: &Canvas) {
        let [main, insets @ ..] = &self.panels[..] else { return };
        let overview = insets.first().filter(|inset| shows(inset, main));
        for (index, inset) in insets.iter().enumerate() {
            let (reference, of) = match overview {
                Some(overview) if !shows(main, inset) => (overview, " of (a)"),
                _ => (main, ""),
            };
            let text = if shows(inset, main) {
                format!("({})  overview, main panel framed", letter(index))
            } else {
                let h = short(reference.view.h_per_pixel() / inset.view.h_per_pixel());
                let l = short(reference.view.l_per_pixel() / inset.view.l_per_pixel());
                format!("({}){of}  {H} ×{h}, {L} ×{l}", letter(index))
            };
            let rect = inset.view.rect;
            // Above the name of the axis where there is no room beside it.
            let name = &axis_ticks(inset, false)[1].quantity;
            let is_free = l_name_at(inset, name)[0] + text_width(name, AXIS_SIZE) + 4.0
                < rect.right() - text_width(&text, LETTER_SIZE);
            let up = if is_free { 8.0 } else { 25.0 };
            canvas.text(&text, [rect.right(), rect.y - up], LETTER_SIZE, INK, Anchor::End);
        }
    }
}

/// Does one panel's window hold the other's?
fn shows(outer: &Panel, inner: &Panel) -> bool {
    contains(&outer.view.window, &inner.view.window)
}

/// The height of insets that are small.
const SMALL: f64 = 150.0;
const AXIS_SIZE: f64 = TICK_SIZE + 1.0;

/// The ticks of h and l; none whose label would leave the page.
fn axis_ticks(panel: &Panel, is_main: bool) -> [Ticks; 2] {
    let View { window, rect } = panel.view;
    let [across, up] = match is_main {
        true => [70.0, 49.0],
        // Small insets have two ticks where that can be.
        false if rect.height < SMALL => [48.0, 28.0],
        false => [58.0, 41.0],
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few dozen at most")]
    let count = |length: f64, spacing: f64| (length / spacing).floor() as usize;
    let mut h = ticks(H, window.h[0], window.h[1], count(rect.width, across));
    let l = ticks(L, window.l[0], window.l[1], count(rect.height, up));
    let ends_at =
        |value: f64, label: &str| panel.view.position([value, window.l[0]])[0] + text_width(label, TICK_SIZE) / 2.0;
    let fits: Vec<bool> = h
        .values
        .iter()
        .zip(&h.labels)
        .map(|(value, label)| ends_at(*value, label) < rect.right() + RIGHT - 1.0)
        .collect();
    let mut keep = fits.iter();
    h.values.retain(|_| keep.next().is_none_or(|fits| *fits));
    let mut keep = fits.iter();
    h.labels.retain(|_| keep.next().is_none_or(|fits| *fits));
    [h, l]
}

/// Where the name of the l axis begins.
fn l_name_at(panel: &Panel, name: &str) -> Point {
    let rect = panel.view.rect;
    [(rect.x - 12.0 - text_width(name, AXIS_SIZE)).max(rect.x - LEFT + 14.0), rect.y - 12.0]
}

/// The axes of a panel and its frame; those of the main panel tell what h and l are.
fn paint_axes(canvas: &Canvas, panel: &Panel, is_main: bool, units: &[String; 2]) {
    let View { window, rect } = panel.view;
    let [h_ticks, l_ticks] = axis_ticks(panel, is_main);
    let [h, l] = [(window.h, &h_ticks), (window.l, &l_ticks)].map(|(range, ticks)| Axis { range, ticks });
    draw_axes(canvas, &rect, [BELOW, LEFT], [h, l]);
    // In full where the labels are not scaled, in the main panel.
    let name = |quantity: &str, meaning: &str, unit: &str| {
        let unit = if unit.is_empty() { String::new() } else { format!(" in {unit}") };
        match quantity {
            H | L if is_main => format!("{meaning} {quantity}{unit}"),
            scaled => format!("{scaled}{}", if is_main { &unit } else { "" }),
        }
    };
    let h_name = name(&h_ticks.quantity, "energy", &units[0]);
    let l_name = name(&l_ticks.quantity, "vertical angular momentum", &units[1]);
    canvas.text(&h_name, [rect.x + rect.width / 2.0, rect.bottom() + 36.0], AXIS_SIZE, INK, Anchor::Middle);
    canvas.text(&l_name, l_name_at(panel, &l_name), AXIS_SIZE, INK, Anchor::Start);
}
