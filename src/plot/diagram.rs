//! The bifurcation diagram of an atlas.

use plotters::chart::ChartBuilder;

use super::canvas::{Anchor, Canvas, Ink, Point, render, style, text_style, to_units};
use super::font::{self, text_width};
use super::geometry::{Rect, distance};
use super::insets::{LEGIBLE, Magnifications, magnifications};
use super::labels::{Label, Name, Space, base_lines};
use super::legend::{Legend, event_marker, sample_dot};
use super::notation::{H, L};
use super::palette::{FAINT_INK, INK, PAPER, branch_styles, tint};
use super::panel::{Panel, View};
use super::scene::Scene;
use super::stroke::{self, Stroke};
use super::ticks::{Axis, ticks};
use super::trace::CurveSource;
use super::window::main_window;
use super::{DiagramOptions, Picture, PlotError, notation};
use crate::document::{AtlasDocument, EventKind, RegionDocument};

/// Space for the axis on the left, for the title above, for the axis below and at the right edge of the page.
const LEFT: f64 = 58.0;
const TOP: f64 = 62.0;
const BELOW: f64 = 46.0;
const RIGHT: f64 = 16.0;
/// Plot area of the main panel and of an inset.
const MAIN: [f64; 2] = [600.0, 536.0];
const INSET: [f64; 2] = [290.0, 231.0];
/// Space above an inset for its letter, and its part of the page.
const INSET_TOP: f64 = 28.0;
const INSET_PITCH: [f64; 2] = [INSET[0] + LEFT, INSET[1] + INSET_TOP + BELOW];
/// Insets beside the main panel; further ones stand below in rows of three.
const BESIDE: usize = 2;
const IN_A_ROW: usize = 3;
/// Frames of insets are drawn at least this large.
const FRAME_MIN: f64 = 9.0;
/// Inside frames smaller than this, markers are left to the inset.
const CROWDED: f64 = 30.0;
const TITLE_SIZE: f64 = 14.0;
const AXIS_SIZE: f64 = 11.0;
const NOTE_SIZE: f64 = 11.0;

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
        .map(|region| Name { kind: notation::region_type(region), id: region.id.clone() })
        .collect();
    let view = |window, x, y, size: [f64; 2]| View { window, rect: Rect { x, y, width: size[0], height: size[1] } };
    let main = Panel::new(&scene, view(main_window(&scene, options.window)?, LEFT, TOP, MAIN))?;
    let magnified = magnifications(&scene, &main, INSET)?;
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
            for label in &labels[index] {
                paint_label(canvas, label, &names[label.region])?;
            }
            paint_axes(canvas, panel, index)?;
        }
        if let [main, insets @ ..] = &panels[..] {
            for (index, inset) in insets.iter().enumerate() {
                let rect = inset.view.rect;
                let h = main.view.h_per_pixel() / inset.view.h_per_pixel();
                let l = main.view.l_per_pixel() / inset.view.l_per_pixel();
                let text = format!("({})  {H} ×{}, {L} ×{}", letter(index), short(h), short(l));
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

/// The body in a line.
fn title(atlas: &AtlasDocument) -> String {
    let list = |numbers: &[crate::body::Number; 3]| {
        numbers.iter().map(|number| number.text().replace('-', "−")).collect::<Vec<_>>().join(", ")
    };
    let mut title = format!("A = ({}),  r = ({})", list(&atlas.body.moments), list(&atlas.body.center));
    if atlas.body.flags.unphysical {
        title.push_str("   (unphysical: the triangle inequality is violated)");
    }
    title
}

/// Top left corner of the plot area of an inset.
fn inset_place(index: usize) -> Point {
    if index < BESIDE {
        let x = LEFT + MAIN[0] + LEFT + 8.0;
        // The two together are as high as the main panel.
        return [x, TOP + index as f64 * (MAIN[1] - INSET[1])];
    }
    let (row, column) = ((index - BESIDE) / IN_A_ROW, (index - BESIDE) % IN_A_ROW);
    let top = TOP + MAIN[1] + BELOW + INSET_TOP;
    [LEFT + column as f64 * INSET_PITCH[0], top + row as f64 * INSET_PITCH[1]]
}

/// The letter of an inset: a … z, then aa, ab, …
fn letter(index: usize) -> String {
    let own = char::from(b'a' + u8::try_from(index % 26).unwrap_or(0));
    match index / 26 {
        0 => own.to_string(),
        round => format!("{}{own}", letter(round - 1)),
    }
}

/// A positive number with two significant digits.
fn short(value: f64) -> String {
    let text = format!("{value:.1e}");
    match text.split_once('e').map(|(digits, exponent)| (digits, exponent.parse::<i32>())) {
        Some((_, Ok(exponent))) if (-1..4).contains(&exponent) => {
            if value < 10.0 {
                format!("{value:.1}")
            } else {
                format!("{value:.0}")
            }
        }
        Some((digits, Ok(exponent))) => format!("{digits}·10{}", notation::superscript(exponent)),
        _ => text,
    }
}

/// Where the window of an inset is shown.
struct Frame {
    /// Index of the inset.
    inset: usize,
    /// Index of the panel that shows it.
    parent: usize,
    rect: Rect,
}

/// The frame of every inset in the smallest panel that contains it.
fn frames(panels: &[Panel]) -> Vec<Frame> {
    let area = |panel: &Panel| {
        let window = &panel.view.window;
        (window.h[1] - window.h[0]) * (window.l[1] - window.l[0])
    };
    (1..panels.len())
        .map(|index| {
            let window = &panels[index].view.window;
            let contains = |outer: &Panel| {
                let within = |inner: [f64; 2], outer: [f64; 2]| inner[0] >= outer[0] && inner[1] <= outer[1];
                within(window.h, outer.view.window.h) && within(window.l, outer.view.window.l)
            };
            let parent = (1..index)
                .filter(|&outer| contains(&panels[outer]))
                .min_by(|&a, &b| area(&panels[a]).total_cmp(&area(&panels[b])))
                .unwrap_or(0);
            let exact = panels[parent].view.frame(window);
            let (dx, dy) = ((FRAME_MIN - exact.width).max(0.0), (FRAME_MIN - exact.height).max(0.0));
            let wide = Rect {
                x: exact.x - dx / 2.0,
                y: exact.y - dy / 2.0,
                width: exact.width + dx,
                height: exact.height + dy,
            };
            Frame { inset: index - 1, parent, rect: within(&wide, &panels[parent].view.rect) }
        })
        .collect()
}

/// The part of a rectangle inside another.
fn within(rect: &Rect, outer: &Rect) -> Rect {
    let [x, y] = outer.nearest([rect.x, rect.y]);
    let [right, bottom] = outer.nearest([rect.x + rect.width, rect.y + rect.height]);
    Rect { x, y, width: right - x, height: bottom - y }
}

/// Labels of every panel, places of the insets' letters, and the regions that found no place.
fn place_text(
    scene: &Scene<'_>,
    panels: &[Panel],
    frames: &[Frame],
    names: &[Name],
) -> (Vec<Vec<Label>>, Vec<Option<Rect>>, Vec<usize>) {
    let mut spaces: Vec<Space<'_>> = panels.iter().map(|panel| Space::new(panel, names.len())).collect();
    let mut letters = vec![None; frames.len()];
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
    // What can be seen in the main panel is named there too.
    if let (Some(space), Some(panel)) = (spaces.first_mut(), panels.first()) {
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
        let color = tint(&tint_key(region));
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

fn paint_axes(canvas: &Canvas<'_>, panel: &Panel, index: usize) -> Result<(), PlotError> {
    let View { window, rect } = panel.view;
    let spacing = if index == 0 { 70.0 } else { 58.0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few dozen at most")]
    let count = |length: f64, spacing: f64| (length / spacing).floor() as usize;
    let h_ticks = ticks(H, window.h[0], window.h[1], count(rect.width, spacing));
    let l_ticks = ticks(L, window.l[0], window.l[1], count(rect.height, 0.7 * spacing));
    let area = canvas.area().clone().shrink(
        (to_units(rect.x - LEFT), to_units(rect.y)),
        (to_units(rect.width + LEFT), to_units(rect.height + BELOW)),
    );
    let frame = style(Ink { color: INK, width: 0.9 });
    let mut chart = ChartBuilder::on(&area)
        .x_label_area_size(to_units(BELOW))
        .y_label_area_size(to_units(LEFT))
        .build_cartesian_2d(
            Axis { range: window.h, ticks: h_ticks.clone() },
            Axis { range: window.l, ticks: l_ticks.clone() },
        )?;
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(frame)
        .set_all_tick_mark_size(to_units(4.0))
        .label_style(text_style(AXIS_SIZE, INK))
        .draw()?;
    canvas.outline(&rect.corners(), Ink { color: INK, width: 0.9 })?;
    // In full where the labels are not scaled, in the main panel.
    let name = |quantity: &str, meaning: &str| match quantity {
        H | L if index == 0 => format!("{meaning} {quantity}"),
        scaled => scaled.to_owned(),
    };
    let (h_name, l_name) = (name(&h_ticks.quantity, "energy"), name(&l_ticks.quantity, "vertical angular momentum"));
    let h_at = [rect.x + rect.width / 2.0, rect.y + rect.height + 36.0];
    canvas.text(&h_name, h_at, AXIS_SIZE + 1.0, INK, Anchor::Middle)?;
    let l_at = [(rect.x - 12.0 - text_width(&l_name, AXIS_SIZE + 1.0)).max(rect.x - LEFT + 14.0), rect.y - 12.0];
    canvas.text(&l_name, l_at, AXIS_SIZE + 1.0, INK, Anchor::Start)
}

/// What the picture cannot show, in lines of at most `width` pixels.
fn notes(atlas: &AtlasDocument, magnified: &Magnifications, unlabelled: &[usize], width: f64) -> Vec<String> {
    let known: Vec<usize> = magnified.invisible.iter().chain(&magnified.outside).copied().collect();
    let crowded: Vec<usize> = unlabelled.iter().filter(|region| !known.contains(region)).copied().collect();
    let mut lines = Vec::new();
    for (heading, regions) in [
        ("Too small for the resolution of f64:", &magnified.invisible),
        ("Outside the window:", &magnified.outside),
        ("Without room for a label:", &crowded),
    ] {
        if regions.is_empty() {
            continue;
        }
        let items = regions.iter().map(|&index| {
            let region = &atlas.regions[index];
            let kind = notation::region_type(region);
            let wide = region.h_width.map_or_else(String::new, |wide| format!(", {wide:.1e} wide"));
            format!("{} ({kind}) at {H} = {}, {L} = {}{wide}", region.id, region.sample.h, region.sample.l)
        });
        wrap(heading, items, width, &mut lines);
    }
    let undecided = atlas.summary.undecided.len();
    if undecided > 0 {
        let items =
            atlas.summary.undecided.iter().map(|what| format!("{} near {H} = {}, {L} = {}", what.what, what.h, what.l));
        wrap(&format!("Undecided in f64 ({undecided}):"), items, width, &mut lines);
    }
    lines
}

/// Adds a heading and items to lines of at most `width` pixels.
fn wrap(heading: &str, items: impl Iterator<Item = String>, width: f64, lines: &mut Vec<String>) {
    let mut line = heading.to_owned();
    for (place, item) in items.enumerate() {
        let separator = if place == 0 { " " } else { "; " };
        if text_width(&line, NOTE_SIZE) + text_width(&item, NOTE_SIZE) > width - 2.0 * NOTE_SIZE {
            line.push_str(separator.trim_end());
            lines.push(std::mem::replace(&mut line, item));
        } else {
            line.push_str(separator);
            line.push_str(&item);
        }
    }
    line.push('.');
    lines.push(line);
}
