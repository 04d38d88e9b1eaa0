//! The bifurcation diagram of an atlas.

use super::canvas::{Anchor, Canvas, Ink, Point, render};
use super::font::{self, text_width};
use super::geometry::{Rect, distance};
use super::insets::{LEGIBLE, magnifications};
use super::labels::{Label, Name, Space, base_lines};
use super::layout::{BELOW, Frame, INSET, LEFT, MAIN, RIGHT, TOP, contains, frame, frames, inset_place, letter};
use super::legend::{Legend, event_marker, sample_dot};
use super::notation::{H, L};
use super::notes::{NOTE_SIZE, notes, title};
use super::palette::{FAINT_INK, INK, PAPER, branch_styles, tint};
use super::panel::{Panel, View};
use super::scene::Scene;
use super::stroke::{self, Stroke};
use super::trace::CurveSource;
use super::window::{Windows, windows};
use super::{DiagramOptions, Picture, PlotError, axes, notation};
use schema::{AtlasDocument, EventKind, RegionDocument};

/// Inside frames smaller than this, markers are left to the inset.
const CROWDED: f64 = 30.0;
const TITLE_SIZE: f64 = 14.0;
/// Font size of the insets' letters and scales.
const AXIS_SIZE: f64 = 11.0;

/// Draws the bifurcation diagram: h to the right, l upwards, each region tinted and labelled with the type of its
/// section, and magnified insets for what the main panel is too coarse for.
///
/// `source` gives polylines fit for strong magnification; without it the document's own are used, and insets are as
/// sharp as they are. Equal arguments give equal bytes.
///
/// # Errors
/// [`PlotError`]: a document whose parts do not fit together, an empty window, or a failure of the drawing library.
pub fn draw(
    atlas: &AtlasDocument,
    source: Option<&dyn CurveSource>,
    options: &DiagramOptions,
) -> Result<Picture, PlotError> {
    font::register()?;
    let scene = Scene::new(atlas, source)?;
    let styles = branch_styles(atlas);
    let strokes = stroke::strokes(atlas, &styles);
    let names: Vec<Name> = atlas
        .regions
        .iter()
        .map(|region| Name { kind: notation::region_type(region), id: label_id(atlas, region) })
        .collect();
    let view = |window, x, y, size: [f64; 2]| View { window, rect: Rect { x, y, width: size[0], height: size[1] } };
    let Windows { main, everything } = windows(&scene, options.window)?;
    let main = Panel::new(&scene, view(main, LEFT, TOP, MAIN))?;
    let mut magnified = magnifications(&scene, &main, &everything, INSET)?;
    if everything != main.view.window {
        // It takes the first place, so that what lies far out is seen in its frame.
        magnified.windows.insert(0, everything);
    }
    let mut panels = vec![main];
    for (index, window) in magnified.windows.iter().enumerate() {
        let [x, y] = inset_place(index);
        panels.push(Panel::new(&scene, view(*window, x, y, INSET))?);
    }
    let frames = frames(&panels);
    let (labels, letters, unlabelled) = place_text(&scene, &panels, &frames, &names);

    let right = |panel: &Panel| panel.view.rect.x + panel.view.rect.width;
    let bottom = |panel: &Panel| panel.view.rect.y + panel.view.rect.height;
    let width = panels.iter().map(right).fold(0.0, f64::max) + RIGHT;
    let below = panels.iter().map(bottom).fold(0.0, f64::max) + BELOW + 6.0;
    let legend = Legend::new(atlas, &styles, width - LEFT - RIGHT);
    let notes = notes(atlas, &magnified, &unlabelled, width - LEFT - RIGHT);
    let height = below + legend.height() + notes.len() as f64 * NOTE_SIZE * 1.4 + 14.0;
    let title = title(atlas);

    render([width, height.ceil()], &title, |canvas| {
        canvas.text(&title, [LEFT, TOP - 34.0], TITLE_SIZE, INK, Anchor::Start)?;
        for (index, panel) in panels.iter().enumerate() {
            let own: Vec<&Frame> = frames.iter().filter(|frame| frame.parent == index).collect();
            paint_panel(canvas, &scene, panel, &strokes, &own)?;
            for frame in own {
                canvas.outline(&frame.rect.corners(), Ink { color: INK, width: 0.9 })?;
                if let Some(place) = letters[frame.inset] {
                    let base = [place.x + place.width / 2.0, place.y + 0.82 * place.height];
                    canvas.text(&letter(frame.inset), base, AXIS_SIZE, INK, Anchor::Middle)?;
                }
            }
            if index > 0 && contains(panel, &panels[0]) {
                canvas.outline(&frame(&panels[0], panel).corners(), Ink { color: INK, width: 0.9 })?;
            }
            for label in &labels[index] {
                paint_label(canvas, label, &names[label.region])?;
            }
            axes::draw(canvas, panel, index)?;
        }
        if let [main, insets @ ..] = &panels[..] {
            let overview = insets.first().filter(|inset| contains(inset, main));
            for (index, inset) in insets.iter().enumerate() {
                let rect = inset.view.rect;
                let (reference, of) = match overview {
                    Some(overview) if !contains(main, inset) => (overview, " of (a)"),
                    _ => (main, ""),
                };
                let h = reference.view.h_per_pixel() / inset.view.h_per_pixel();
                let l = reference.view.l_per_pixel() / inset.view.l_per_pixel();
                let scales = format!("{H} ×{}, {L} ×{}", notation::short(h), notation::short(l));
                let text = if contains(inset, main) {
                    format!("({})  overview with the frame of the main panel", letter(index))
                } else {
                    format!("({}){of}  {scales}", letter(index))
                };
                canvas.text(&text, [rect.x + rect.width, rect.y - 8.0], AXIS_SIZE, INK, Anchor::End)?;
            }
        }
        legend.draw(canvas, [LEFT, below])?;
        for (row, note) in notes.iter().enumerate() {
            let base = below + legend.height() + (row as f64 + 1.0) * NOTE_SIZE * 1.4;
            canvas.text(note, [LEFT, base], NOTE_SIZE, FAINT_INK, Anchor::Start)?;
        }
        Ok(())
    })
}

/// Labels of every panel, places of the insets' letters, and the regions that found no place.
fn place_text(
    scene: &Scene<'_>,
    panels: &[Panel],
    frames: &[Frame],
    names: &[Name],
) -> (Vec<Vec<Label>>, Vec<Option<Rect>>, Vec<usize>) {
    let mut spaces: Vec<Space<'_>> = panels.iter().map(|panel| Space::new(panel, names.len())).collect();
    let mut letters = vec![None; panels.len()];
    for (index, space) in spaces.iter_mut().enumerate() {
        let own: Vec<&Frame> = frames.iter().filter(|frame| frame.parent == index).collect();
        for point in marked_points(scene, &panels[index], &own) {
            space.take(&Rect { x: point[0], y: point[1], width: 0.0, height: 0.0 }.grown(4.5));
        }
        for frame in &own {
            space.take_outline(&frame.rect);
            if frame.rect.width < CROWDED || frame.rect.height < CROWDED {
                space.take(&frame.rect);
            }
        }
        for frame in &own {
            let text = letter(frame.inset);
            letters[frame.inset] = space.beside(&frame.rect, [text_width(&text, AXIS_SIZE), AXIS_SIZE]);
        }
    }
    let sample = |region: usize| {
        let sample = &scene.atlas.regions[region].sample;
        [sample.h, sample.l]
    };
    let mut labelled = vec![false; names.len()];
    for space in &mut spaces {
        space.label_inside(names, &mut labelled);
    }
    let mut unlabelled = Vec::new();
    for region in 0..names.len() {
        if labelled[region] {
            continue;
        }
        // The first panel that shows it well, else the one that shows it best.
        let depths: Vec<f64> = spaces.iter().map(|space| space.depth(region)).collect();
        let deepest = (0..depths.len()).max_by(|&a, &b| depths[a].total_cmp(&depths[b]).then(b.cmp(&a)));
        let best = depths.iter().position(|depth| *depth >= LEGIBLE).or(deepest);
        let placed = best.is_some_and(|best| {
            let sample = panels[best].view.position(sample(region));
            spaces[best].label_beside(region, &names[region], sample)
        });
        if !placed {
            unlabelled.push(region);
        }
    }
    // What can be seen in a panel is named there too.
    for (space, panel) in spaces.iter_mut().zip(panels) {
        for region in (0..names.len()).filter(|&region| labelled[region]) {
            if space.depth(region) >= LEGIBLE && !space.has_label(region) {
                space.label_beside(region, &names[region], panel.view.position(sample(region)));
            }
        }
    }
    (spaces.into_iter().map(Space::into_labels).collect(), letters, unlabelled)
}

/// Positions of the events and samples drawn in a panel: not those that a small frame leaves to its inset.
fn marked_points(scene: &Scene<'_>, panel: &Panel, frames: &[&Frame]) -> Vec<Point> {
    let events = scene.atlas.events.iter().map(|event| [event.h, event.l]);
    let samples = scene.atlas.regions.iter().map(|region| [region.sample.h, region.sample.l]);
    let positions = events.chain(samples).map(|point| panel.view.position(point));
    positions.filter(|point| is_marked(*point, panel, frames)).collect()
}

fn is_marked(point: Point, panel: &Panel, frames: &[&Frame]) -> bool {
    let crowded = |frame: &&&Frame| frame.rect.width < CROWDED && frame.rect.height < CROWDED;
    panel.view.rect.contains(point) && !frames.iter().filter(crowded).any(|frame| frame.rect.contains(point))
}

/// The id of a region as it is printed: with U where another region has a section of the same type over another U.
fn label_id(atlas: &AtlasDocument, region: &RegionDocument) -> String {
    let own = notation::accessible_regions(region);
    let ambiguous = region.signature.is_some()
        && atlas.regions.iter().any(|other| {
            notation::region_type(other) == notation::region_type(region) && notation::accessible_regions(other) != own
        });
    if ambiguous { format!("{}, U = {own}", region.id) } else { region.id.clone() }
}

/// The type that decides a region's tint.
fn tint_key(region: &RegionDocument) -> String {
    region.signature.clone().unwrap_or_else(|| {
        let parts: Vec<&str> = region.components.iter().map(|part| part.accessible_region.as_str()).collect();
        parts.join("+")
    })
}

fn paint_panel(
    canvas: &Canvas<'_>,
    scene: &Scene<'_>,
    panel: &Panel,
    strokes: &[Stroke],
    frames: &[&Frame],
) -> Result<(), PlotError> {
    for (region, cells) in scene.atlas.regions.iter().zip(&scene.cells) {
        let circles = region.components.iter().map(|part| part.boundary_circles).sum();
        let color = tint(&tint_key(region), circles);
        for cell in cells {
            canvas.polygon(&panel.cell_polygon(cell), color)?;
        }
    }
    for stroke in strokes {
        stroke::draw(canvas, panel, stroke)?;
    }
    for region in &scene.atlas.regions {
        let point = panel.view.position([region.sample.h, region.sample.l]);
        if is_marked(point, panel, frames) {
            sample_dot(canvas, point)?;
        }
    }
    // Markers of one kind on top of each other say no more than one.
    let mut marked: Vec<(EventKind, Point)> = Vec::new();
    for event in &scene.atlas.events {
        let point = panel.view.position([event.h, event.l]);
        let hidden = marked.iter().any(|(kind, other)| *kind == event.kind && distance(*other, point) < 5.0);
        if is_marked(point, panel, frames) && !hidden {
            event_marker(canvas, event.kind, point)?;
            marked.push((event.kind, point));
        }
    }
    Ok(())
}

fn paint_label(canvas: &Canvas<'_>, label: &Label, name: &Name) -> Result<(), PlotError> {
    if let Some([anchor, end]) = label.leader {
        canvas.path(&[anchor, end], Ink { color: INK, width: 0.7 })?;
        canvas.disc(anchor, 1.3, INK)?;
        canvas.polygon(&label.rect.grown(1.5).corners(), PAPER)?;
        canvas.outline(&label.rect.grown(1.5).corners(), Ink { color: FAINT_INK, width: 0.5 })?;
    }
    let [(kind_at, kind_size), (id_at, id_size)] = base_lines(label, name);
    canvas.text(&name.kind, kind_at, kind_size, INK, Anchor::Middle)?;
    canvas.text(&name.id, id_at, id_size, FAINT_INK, Anchor::Middle)
}
