//! A diagram on its canvas.

use super::axes::{AXIS_SIZE, axis_ticks, l_name_at, paint_axes};
use super::labels::{self, H, L, event_marker, sample_dot};
use super::layout::{Frame, LETTER_SIZE, frame, is_marked};
use super::palette::ground_of;
use super::panel::Panel;
use super::placement::Texts;
use super::scene::{Scene, Step};
use super::stroke::{self, Line, Stroke, Verdict};
use super::windows::contains;
use bifdiag_page::{Anchor, Canvas, INK, Ink, Point, clip_polyline, distance, letter, rgb, short, text_width};
use bifdiag_schema::EventKind;

const FRAME: Ink = Ink { color: INK, width: 0.9 };
/// A way, which shows on both sides of the curve that it follows.
pub(super) const WAY: Ink = Ink { color: rgb(0xf2_c1_2e), width: 7.0 };

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
            let (name, title) = match index {
                0 => ("main".to_owned(), "the main panel".to_owned()),
                inset => (letter(inset - 1), format!("inset ({})", letter(inset - 1))),
            };
            canvas.group(&name, &title, || self.paint_panel(canvas, index, panel, &name));
        }
        self.paint_scales(canvas);
    }

    fn paint_panel(&self, canvas: &Canvas, index: usize, panel: &Panel, name: &str) {
        let frames = &self.frames[index];
        canvas.group(&format!("{name}-regions"), "", || self.paint_regions(canvas, panel, name));
        if let Some(straight) = &panel.straight {
            canvas.group(&format!("{name}-levels"), "curves of constant h", || straight.paint_levels(canvas));
        }
        if !self.scene.way.is_empty() {
            canvas.group(&format!("{name}-way"), "the path", || self.paint_way(canvas, panel));
        }
        canvas.group(&format!("{name}-curves"), "", || self.paint_curves(canvas, panel, name));
        canvas.group(&format!("{name}-points"), "", || self.mark_points(canvas, panel, frames, name));
        self.paint_frames(canvas, panel, frames, name);
        for label in &self.texts.labels[index] {
            let region = &self.texts.names[label.region];
            labels::paint(canvas, label, region, &format!("{name}-label-{}", region.id));
        }
        canvas.group(&format!("{name}-axes"), "", || match &panel.straight {
            Some(straight) => straight.paint_axes(canvas, &self.units),
            None => paint_axes(canvas, panel, index == 0, &self.units),
        });
    }

    fn paint_regions(&self, canvas: &Canvas, panel: &Panel, name: &str) {
        let names = &self.texts.names;
        for ((region, cells), own) in self.scene.atlas.regions.iter().zip(&self.scene.cells).zip(names) {
            let path = panel.region(cells);
            let fill = canvas.fill_striped(&ground_of(region));
            let attributes = format!("id=\"{name}-{}\" {fill} fill-rule=\"evenodd\"", region.id);
            canvas.draw_titled(&path, &attributes, &format!("{}: {}", own.id, own.sentence()));
        }
    }

    /// Each stretch of a curve as a group, since coincident curves are several paths.
    fn paint_curves(&self, canvas: &Canvas, panel: &Panel, name: &str) {
        for (number, stroke) in self.strokes.iter().enumerate() {
            if !stroke::is_drawn(stroke, std::slice::from_ref(panel)) {
                continue;
            }
            let titles: Vec<String> = stroke.lines.iter().map(|line| self.line_title(line)).collect();
            let id = format!("{name}-curve-{}-{}", self.scene.atlas.curves[stroke.curve].id, number + 1);
            canvas.group(&id, &titles.join("; "), || stroke::draw(canvas, panel, stroke));
        }
    }

    fn paint_way(&self, canvas: &Canvas, panel: &Panel) {
        for step in &self.scene.way {
            let parts = match step {
                Step::Along(curve, range) => panel.curve(*curve, *range),
                Step::Fall(ends) if panel.straight.is_none() => {
                    clip_polyline(&panel.view.positions(ends), &panel.view.rect)
                }
                Step::Fall(ends) => vec![ends.iter().filter_map(|&end| panel.position(end)).collect()],
            };
            for part in parts.into_iter().filter(|part| part.len() > 1) {
                canvas.path(&part, WAY);
            }
        }
    }

    fn line_title(&self, line: &Line) -> String {
        let curve = &self.scene.atlas.curves[line.curve];
        let stability = match line.verdict {
            Some(Verdict::Lasting) => ", stable, with friction too",
            Some(Verdict::Frictionless) => ", stable without friction",
            Some(Verdict::Unstable) => ", unstable",
            Some(Verdict::Open) => ", stability open",
            None => "",
        };
        format!("{}: {}{stability}", curve.id, curve.branch_name)
    }

    fn mark_points(&self, canvas: &Canvas, panel: &Panel, frames: &[Frame], name: &str) {
        for dot in &self.scene.dots {
            let Some(point) = panel.position(dot.at) else { continue };
            if is_marked(point, panel, frames) {
                canvas.group(&format!("{name}-sample-{}", dot.id), &dot.title, || sample_dot(canvas, point));
            }
        }
        // Markers of one kind on top of each other say no more than one.
        let mut marked: Vec<(EventKind, Point)> = Vec::new();
        for (number, event) in self.scene.atlas.events.iter().enumerate() {
            let Some(point) = panel.event(&self.scene, event) else { continue };
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
            let title = format!("inset ({})", letters.join("), ("));
            canvas.group(&format!("{name}-frame-{}", letters.join("-")), &title, || {
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
    fn paint_scales(&self, canvas: &Canvas) {
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
