//! The drawing.

use super::colors::{fill, line as line_color};
use super::legend::{BORDER, LINE, MapLegend, NO_BODY, Places, line_pattern};
use super::marks::{MapMark, Marked, RING, marked, note_box};
use super::model::{Map, MapBodies, MapLine, MapNote, MapView, SIZE, SMALL};
use std::collections::BTreeSet;

use plotters::style::RGBColor;

use bifdiag_page::{
    Anchor, Axis, Canvas, FAINT_INK, HEIGHT, INK, Ink, PAPER, Path, Picture, PlotError, Rect, Theme, Width, draw_axes,
    is_proper, lines, render, text_width, ticks, widest,
};

/// The side of a map on a page.
const SIDE: f64 = 540.0;
const LEFT: f64 = 64.0;
const BELOW: f64 = 56.0;
/// Base line of the title, and between its lines; then those of the subtitle, and the map below.
const TITLE: f64 = 24.0;
const TITLE_SIZE: f64 = 15.0;
const TITLE_LINE: f64 = 19.0;
const SUBTITLE: f64 = 17.0;
const SUBTITLE_LINE: f64 = 15.0;
const MAP: f64 = 23.0;
/// Between map and legend, and at the edges of the page.
const GAP: f64 = 20.0;
const EDGE: f64 = 12.0;

/// Draws a map: on a page with its legend beside it if there is room, in a column with all of it below.
///
/// # Errors
/// [`PlotError::EmptyWindow`] when a range is empty, else what the drawing library reports.
pub fn draw_map(map: &Map, theme: Theme, width: Width) -> Result<Picture, PlotError> {
    if !is_proper(map.x.range) || !is_proper(map.y.range) {
        return Err(PlotError::EmptyWindow { h: map.x.range, l: map.y.range });
    }
    let paper = width.pixels();
    let side = if width.is_column() { paper - LEFT - EDGE } else { SIDE * width.scale() };
    let heading = Heading::new(map, paper - LEFT - EDGE);
    let rect = Rect { x: LEFT, y: heading.height, width: side, height: side };
    let view = MapView { x: map.x.range, y: map.y.range, rect };
    let marked = marked(map, &view);
    let beside = rect.right() + GAP;
    let room = if width.is_column() { [0.0; 2] } else { [paper - beside - EDGE, side] };
    let below = rect.bottom() + BELOW;
    let places = Places { beside: room, below: [paper - 2.0 * EDGE, HEIGHT - below - EDGE] };
    let legend = MapLegend::new(map, &view, &marked.marks, places);
    let needed = (beside + legend.width_beside()).max(LEFT + heading.width) + EDGE;
    let width = if legend.height_below() > 0.0 { paper } else { needed.min(paper) };
    let height = below + legend.height_below() + EDGE;
    render([width, height.ceil()], map.title.as_str(), theme, |canvas| {
        heading.draw(canvas);
        bodies(canvas, map, &view);
        let mut none = Path::default();
        for corners in &map.impossible {
            none.line(&corners.iter().map(|corner| view.at(*corner)).collect::<Vec<_>>(), true);
        }
        canvas.draw_titled(&none, &format!("id=\"impossible\" {}", canvas.fill_hatched()), NO_BODY);
        for line in &map.lines {
            draw_line(canvas, line, &view);
        }
        draw_marks(canvas, map, &view, &marked);
        axes(canvas, map, &view);
        legend.draw(canvas, [beside, rect.y], [EDGE, below]);
    })
}

/// Title and subtitle in lines.
struct Heading {
    title: Vec<String>,
    subtitle: Vec<String>,
    width: f64,
    height: f64,
}

impl Heading {
    fn new(map: &Map, room: f64) -> Self {
        let [title, subtitle] =
            [(&map.title, TITLE_SIZE), (&map.subtitle, SIZE)].map(|(text, size)| lines(text, size, room));
        let width = widest(&title, TITLE_SIZE).max(widest(&subtitle, SIZE));
        let more = |texts: &[String], line| (texts.len().max(1) - 1) as f64 * line;
        let height = TITLE + SUBTITLE + MAP + more(&title, TITLE_LINE) + more(&subtitle, SUBTITLE_LINE);
        Self { title, subtitle, width, height }
    }

    fn draw(&self, canvas: &Canvas) {
        let mut base = TITLE;
        for line in &self.title {
            canvas.text(line, [LEFT, base], TITLE_SIZE, INK, Anchor::Start);
            base += TITLE_LINE;
        }
        base += SUBTITLE - TITLE_LINE;
        for line in &self.subtitle {
            canvas.text(line, [LEFT, base], SIZE, FAINT_INK, Anchor::Start);
            base += SUBTITLE_LINE;
        }
    }
}

fn bodies(canvas: &Canvas, map: &Map, view: &MapView) {
    match &map.bodies {
        MapBodies::Grid { columns, entries } => {
            let rows = entries.len() / (*columns).max(1);
            let (wide, high) = (view.rect.width / *columns as f64, view.rect.height / rows.max(1) as f64);
            for row in 0..rows {
                let line = &entries[row * columns..(row + 1) * columns];
                let mut from = 0;
                while from < *columns {
                    let to = from + line[from..].iter().take_while(|entry| **entry == line[from]).count();
                    // A little over the edge, so that no seam shows.
                    let more = |edge: bool| if edge { 0.0 } else { 1.0 };
                    let left = view.rect.x + from as f64 * wide;
                    let right = view.rect.x + to as f64 * wide + more(to == *columns);
                    let bottom = view.rect.bottom() - row as f64 * high;
                    let top = bottom - high - more(row + 1 == rows);
                    let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
                    canvas.patch(&corners, fill(map, line[from]));
                    from = to;
                }
            }
        }
        MapBodies::Areas { pieces, borders, .. } => {
            for entry in pieces.iter().map(|(entry, _)| *entry).collect::<BTreeSet<_>>() {
                let mut path = Path::default();
                for (_, corners) in pieces.iter().filter(|(other, _)| *other == entry) {
                    path.line(&corners.iter().map(|corner| view.at(*corner)).collect::<Vec<_>>(), true);
                }
                let (id, title) = match entry.and_then(|entry| map.entries.get(entry)) {
                    Some(entry) => {
                        let id = if entry.mark.is_empty() { "rest" } else { &entry.mark };
                        let texts = [&entry.key, &entry.name, &entry.note].map(String::as_str);
                        (format!("area-{id}"), texts.join(" ").trim().to_owned())
                    }
                    None => ("area-unknown".to_owned(), map.unknown.clone()),
                };
                canvas.draw_titled(&path, &format!("id=\"{id}\" {}", canvas.fill(fill(map, entry))), &title);
            }
            let mut path = Path::default();
            for border in borders {
                path.line(&border.map(|end| view.at(end)), false);
            }
            let ink = canvas.stroke(Ink { color: INK, width: BORDER });
            canvas.draw(&path, &format!("id=\"borders\" stroke-linecap=\"round\" {ink}"));
        }
        MapBodies::Points(points) => {
            let radius = (0.4 * view.rect.width / (points.len().max(1) as f64).sqrt()).clamp(0.8, 6.0);
            for (at, entry) in points {
                canvas.spot(view.at(*at), radius, fill(map, *entry));
            }
        }
    }
}

/// The part of a line inside the map.
fn draw_line(canvas: &Canvas, line: &MapLine, view: &MapView) {
    for part in view.parts(line) {
        canvas.dashed(&part, &line_pattern(line.dashed, line_color(line.hue)), LINE);
    }
}

/// The names of lines, the marks of the entries, and the notes.
fn draw_marks(canvas: &Canvas, map: &Map, view: &MapView, Marked { marks, names }: &Marked) {
    for name in names {
        let line = &map.lines[name.of];
        draw_text(canvas, &line.name, name, line_color(line.hue));
    }
    for mark in marks {
        draw_text(canvas, &map.entries[mark.of].mark, mark, INK);
    }
    for note in &map.notes {
        draw_note(canvas, note, view);
    }
}

/// A mark or a name; one with a leader has a box.
fn draw_text(canvas: &Canvas, text: &str, mark: &MapMark, color: RGBColor) {
    if let Some([tip, end]) = mark.leader {
        canvas.path(&[tip, end], Ink { color, width: 0.7 });
        canvas.disc(tip, 1.5, color);
        canvas.polygon(&mark.rect.corners(), PAPER);
        canvas.outline(&mark.rect.corners(), Ink { color: FAINT_INK, width: 0.5 });
    }
    let [x, y] = mark.rect.center();
    canvas.text(text, [x, y + 0.36 * mark.size], mark.size, color, Anchor::Middle);
}

fn draw_note(canvas: &Canvas, note: &MapNote, view: &MapView) {
    let rect = note_box(note, view);
    canvas.polygon(&rect.corners(), PAPER);
    let [x, y] = rect.center();
    canvas.text(&note.text, [x, y + 0.36 * SMALL], SMALL, line_color(note.hue), Anchor::Middle);
    if note.ring {
        canvas.ring(view.at(note.at), RING, Ink { color: INK, width: 1.4 });
    }
}

fn axes(canvas: &Canvas, map: &Map, view: &MapView) {
    let rect = &view.rect;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a handful")]
    let count = |on_page: f64| (on_page * rect.width / SIDE).round() as usize;
    let x_ticks = ticks(&map.x.name, view.x[0], view.x[1], count(8.0));
    let y_ticks = ticks(&map.y.name, view.y[0], view.y[1], count(10.0));
    let [x, y] = [(view.x, &x_ticks), (view.y, &y_ticks)].map(|(range, ticks)| Axis { range, ticks });
    draw_axes(canvas, rect, [BELOW - 10.0, LEFT], [x, y]);
    let below = [rect.x + 0.5 * rect.width, rect.bottom() + 38.0];
    canvas.text(&x_ticks.quantity, below, 12.5, INK, Anchor::Middle);
    let beside = (rect.x - 10.0 - text_width(&y_ticks.quantity, 12.5)).max(6.0);
    canvas.text(&y_ticks.quantity, [beside, rect.y - 9.0], 12.5, INK, Anchor::Start);
}
