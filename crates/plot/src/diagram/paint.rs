//! A diagram on its canvas.

use super::labels::{self, H, L};
use super::layout::{BELOW, Frame, LEFT, LETTER_SIZE, frame, is_marked, letter};
use super::markers::{event_marker, sample_dot};
use super::palette::tint;
use super::panel::Panel;
use super::placement::Texts;
use super::ranges::contains;
use super::scene::Scene;
use super::stroke::{self, Stroke};
use super::view::View;
use crate::page::{Anchor, Axis, Canvas, INK, Ink, Point, TICK_SIZE, distance, draw_axes, short, text_width, ticks};
use schema::{EventKind, RegionDocument};

const FRAME: Ink = Ink { color: INK, width: 0.9 };

/// Everything that is drawn in and at the panels, the main panel first.
pub(super) struct Diagram<'a> {
    pub scene: Scene<'a>,
    pub strokes: Vec<Stroke>,
    pub panels: Vec<Panel>,
    /// The frames in each panel.
    pub frames: Vec<Vec<Frame>>,
    pub texts: Texts,
}

impl Diagram<'_> {
    pub(super) fn paint(&self, canvas: &Canvas<'_>) {
        for (index, (panel, frames)) in self.panels.iter().zip(&self.frames).enumerate() {
            self.paint_regions(canvas, panel);
            for stroke in &self.strokes {
                stroke::draw(canvas, panel, stroke);
            }
            self.mark_points(canvas, panel, frames);
            self.paint_frames(canvas, panel, frames);
            for label in &self.texts.labels[index] {
                labels::paint(canvas, label, &self.texts.names[label.region]);
            }
            paint_axes(canvas, panel, index == 0);
        }
        self.tell_scales(canvas);
    }

    fn paint_regions(&self, canvas: &Canvas<'_>, panel: &Panel) {
        for (region, cells) in self.scene.atlas.regions.iter().zip(&self.scene.cells) {
            let circles = region.components.iter().map(|part| part.boundary_circles).sum();
            let color = tint(&tint_key(region), circles);
            for cell in cells {
                canvas.polygon(&panel.cell_polygon(cell), color);
            }
        }
    }

    fn mark_points(&self, canvas: &Canvas<'_>, panel: &Panel, frames: &[Frame]) {
        for region in &self.scene.atlas.regions {
            let point = panel.view.position([region.sample.h, region.sample.l]);
            if is_marked(point, panel, frames) {
                sample_dot(canvas, point);
            }
        }
        // Markers of one kind on top of each other say no more than one.
        let mut marked: Vec<(EventKind, Point)> = Vec::new();
        for event in &self.scene.atlas.events {
            let point = panel.view.position([event.h, event.l]);
            let hidden = marked.iter().any(|(kind, other)| *kind == event.kind && distance(*other, point) < 5.0);
            if is_marked(point, panel, frames) && !hidden {
                event_marker(canvas, event.kind, point);
                marked.push((event.kind, point));
            }
        }
    }

    /// The frames of insets with their letters, and that of the main panel in an overview.
    fn paint_frames(&self, canvas: &Canvas<'_>, panel: &Panel, frames: &[Frame]) {
        for frame in frames {
            canvas.outline(&frame.rect.corners(), FRAME);
            if let Some(place) = self.texts.letters[frame.inset] {
                let base = [place.x + place.width / 2.0, place.y + 0.82 * place.height];
                canvas.text(&letter(frame.inset), base, LETTER_SIZE, INK, Anchor::Middle);
            }
        }
        let main = &self.panels[0];
        if panel.view != main.view && shows(panel, main) {
            canvas.outline(&frame(main, panel).corners(), FRAME);
        }
    }

    /// Above each inset, how much it is magnified.
    fn tell_scales(&self, canvas: &Canvas<'_>) {
        let [main, insets @ ..] = &self.panels[..] else { return };
        let overview = insets.first().filter(|inset| shows(inset, main));
        for (index, inset) in insets.iter().enumerate() {
            let (reference, of) = match overview {
                Some(overview) if !shows(main, inset) => (overview, " of (a)"),
                _ => (main, ""),
            };
            let text = if shows(inset, main) {
                format!("({})  overview with the frame of the main panel", letter(index))
            } else {
                let h = short(reference.view.h_per_pixel() / inset.view.h_per_pixel());
                let l = short(reference.view.l_per_pixel() / inset.view.l_per_pixel());
                format!("({}){of}  {H} ×{h}, {L} ×{l}", letter(index))
            };
            let rect = inset.view.rect;
            canvas.text(&text, [rect.right(), rect.y - 8.0], LETTER_SIZE, INK, Anchor::End);
        }
    }
}

/// Does one panel's window hold the other's?
fn shows(outer: &Panel, inner: &Panel) -> bool {
    contains(&outer.view.window, &inner.view.window)
}

/// The type that decides a region's tint.
fn tint_key(region: &RegionDocument) -> String {
    region.signature.clone().unwrap_or_else(|| {
        let parts: Vec<&str> = region.components.iter().map(|part| part.accessible_region.as_str()).collect();
        parts.join("+")
    })
}

/// The axes of a panel and its frame; those of the main panel tell what h and l are.
fn paint_axes(canvas: &Canvas<'_>, panel: &Panel, is_main: bool) {
    const SIZE: f64 = TICK_SIZE + 1.0;
    let View { window, rect } = panel.view;
    let spacing = if is_main { 70.0 } else { 58.0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few dozen at most")]
    let count = |length: f64, spacing: f64| (length / spacing).floor() as usize;
    let h_ticks = ticks(H, window.h[0], window.h[1], count(rect.width, spacing));
    let l_ticks = ticks(L, window.l[0], window.l[1], count(rect.height, 0.7 * spacing));
    let [h, l] = [(window.h, &h_ticks), (window.l, &l_ticks)].map(|(range, ticks)| Axis { range, ticks });
    draw_axes(canvas, &rect, [BELOW, LEFT], [h, l]);
    // In full where the labels are not scaled, in the main panel.
    let name = |quantity: &str, meaning: &str| match quantity {
        H | L if is_main => format!("{meaning} {quantity}"),
        scaled => scaled.to_owned(),
    };
    let (h_name, l_name) = (name(&h_ticks.quantity, "energy"), name(&l_ticks.quantity, "vertical angular momentum"));
    canvas.text(&h_name, [rect.x + rect.width / 2.0, rect.bottom() + 36.0], SIZE, INK, Anchor::Middle);
    let l_at = [(rect.x - 12.0 - text_width(&l_name, SIZE)).max(rect.x - LEFT + 14.0), rect.y - 12.0];
    canvas.text(&l_name, l_at, SIZE, INK, Anchor::Start);
}
