//! The drawing.

use plotters::chart::ChartBuilder;

use super::colors::{UNKNOWN, color};
use super::places::widest;
use super::{Map, MapBodies, MapLine, MapNote};
use crate::canvas::{Anchor, Canvas, Ink, Point, render, style, text_style, to_units};
use crate::font::{self, text_width};
use crate::geometry::Rect;
use crate::palette::{FAINT_INK, INK, PAPER};
use crate::ticks::{Axis, ticks};
use crate::{Picture, PlotError};

const SIDE: f64 = 560.0;
const LEFT: f64 = 64.0;
const TOP: f64 = 64.0;
const BELOW: f64 = 56.0;
/// Between map and legend, and behind the legend.
const GAP: f64 = 26.0;
const ROW: f64 = 19.0;
const SIZE: f64 = 11.5;
const SMALL: f64 = 10.0;
const SWATCH: f64 = 14.0;
/// Entries that the legend lists; the rest is counted.
const LISTED: usize = 27;
/// A mark needs so many pixels of room on each side.
const ROOM: f64 = 8.0;
const DASH: [f64; 2] = [6.0, 4.0];

/// Where parameters lie on the page.
struct View {
    x: [f64; 2],
    y: [f64; 2],
    rect: Rect,
}

impl View {
    fn at(&self, [x, y]: [f64; 2]) -> Point {
        let share = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let rect = &self.rect;
        [rect.x + share(x, self.x) * rect.width, rect.y + rect.height * (1.0 - share(y, self.y))]
    }
}

pub(super) fn draw(map: &Map) -> Result<Picture, PlotError> {
    let good = |range: [f64; 2]| range[0] < range[1] && (range[1] - range[0]).is_finite();
    if !good(map.x.range) || !good(map.y.range) {
        return Err(PlotError::EmptyWindow { h: map.x.range, l: map.y.range });
    }
    // Text is measured before anything is drawn.
    font::register()?;
    let legend = legend(map);
    let legend_width = legend.iter().map(Line::width).fold(120.0, f64::max);
    let width = LEFT + SIDE + GAP + legend_width + GAP;
    let height = TOP + (SIDE + BELOW).max(ROW * (legend.len() as f64 + 0.5) + 10.0);
    let rect = Rect { x: LEFT, y: TOP, width: SIDE, height: SIDE };
    let view = View { x: map.x.range, y: map.y.range, rect };
    render([width.ceil(), height.ceil()], &map.title, |canvas| {
        canvas.text(&map.title, [LEFT, 24.0], 15.0, INK, Anchor::Start)?;
        canvas.text(&map.subtitle, [LEFT, 41.0], SIZE, FAINT_INK, Anchor::Start)?;
        bodies(canvas, map, &view)?;
        for line in &map.lines {
            draw_line(canvas, line, &view)?;
        }
        marks(canvas, map, &view)?;
        axes(canvas, map, &view)?;
        for (number, line) in legend.iter().enumerate() {
            line.draw(canvas, [LEFT + SIDE + GAP, TOP + ROW * number as f64])?;
        }
        Ok(())
    })
}

fn fill(entry: Option<usize>) -> plotters::style::RGBColor {
    entry.map_or(UNKNOWN, color)
}

fn bodies(canvas: &Canvas<'_>, map: &Map, view: &View) -> Result<(), PlotError> {
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
                    let bottom = view.rect.y + view.rect.height - row as f64 * high;
                    let top = bottom - high - more(row + 1 == rows);
                    let corners = [[left, bottom], [right, bottom], [right, top], [left, top]];
                    canvas.polygon(&corners, fill(line[from]))?;
                    from = to;
                }
            }
        }
        MapBodies::Points(points) => {
            let radius = (0.4 * SIDE / (points.len().max(1) as f64).sqrt()).clamp(0.8, 6.0);
            for (at, entry) in points {
                canvas.disc(view.at(*at), radius, fill(*entry))?;
            }
        }
    }
    Ok(())
}

fn draw_line(canvas: &Canvas<'_>, line: &MapLine, view: &View) -> Result<(), PlotError> {
    let ink = Ink { color: INK, width: 1.2 };
    let mut run: Vec<Point> = Vec::new();
    let inside = |p: Point| view.rect.nearest(p) == p;
    for point in &line.points {
        let at = view.at(*point);
        if inside(at) {
            run.push(at);
        } else if !run.is_empty() {
            stroke(canvas, &run, line.dashed, ink)?;
            run.clear();
        }
    }
    stroke(canvas, &run, line.dashed, ink)
}

/// A polyline, dashed or not.
fn stroke(canvas: &Canvas<'_>, points: &[Point], dashed: bool, ink: Ink) -> Result<(), PlotError> {
    if !dashed {
        return canvas.path(points, ink);
    }
    let (mut dash, mut left): (Vec<Point>, f64) = (points.first().copied().into_iter().collect(), DASH[0]);
    let mut drawn = true;
    for pair in points.windows(2) {
        let mut from = pair[0];
        let to = pair[1];
        loop {
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            let length = (dx * dx + dy * dy).sqrt();
            if length <= left {
                left -= length;
                dash.push(to);
                break;
            }
            let share = left / length;
            from = [from[0] + share * dx, from[1] + share * dy];
            dash.push(from);
            if drawn {
                canvas.path(&dash, ink)?;
            }
            drawn = !drawn;
            left = DASH[usize::from(!drawn)];
            dash = vec![from];
        }
    }
    if drawn { canvas.path(&dash, ink) } else { Ok(()) }
}

/// The marks of the entries where there is room, and the notes.
fn marks(canvas: &Canvas<'_>, map: &Map, view: &View) -> Result<(), PlotError> {
    if let MapBodies::Grid { columns, entries } = &map.bodies {
        let rows = (entries.len() / (*columns).max(1)).max(1);
        let (wide, high) = (view.rect.width / *columns as f64, view.rect.height / rows as f64);
        for (entry, place) in map.entries.iter().zip(widest(*columns, entries, map.entries.len())) {
            let Some((column, row, half)) = place else { continue };
            let needed = (0.5 * text_width(&entry.mark, SIZE) + 2.0).max(ROOM);
            if half * wide >= needed && half * high >= ROOM {
                let at = [view.rect.x + column * wide, view.rect.y + view.rect.height - row * high];
                canvas.text(&entry.mark, [at[0], at[1] + 0.36 * SIZE], SIZE, INK, Anchor::Middle)?;
            }
        }
    }
    for note in &map.notes {
        draw_note(canvas, note, view)?;
    }
    Ok(())
}

fn draw_note(canvas: &Canvas<'_>, note: &MapNote, view: &View) -> Result<(), PlotError> {
    const RING: f64 = 4.5;
    let place = view.at(note.at);
    let half = 0.5 * text_width(&note.text, SMALL) + 3.0;
    let [left, right] = [view.rect.x, view.rect.x + view.rect.width];
    let wanted = match note.ring {
        false => place[0],
        true if place[0] + 2.0 * RING + 2.0 * half <= right => place[0] + 2.0 * RING + half,
        true => place[0] - 2.0 * RING - half,
    };
    // Inside of the map, as far as the text fits.
    let at = [wanted.min(right - half).max(left + half), place[1]];
    let (top, bottom) = (at[1] - 0.5 * SMALL - 2.0, at[1] + 0.5 * SMALL + 2.0);
    let box_of_text = [[at[0] - half, top], [at[0] + half, top], [at[0] + half, bottom], [at[0] - half, bottom]];
    canvas.polygon(&box_of_text, PAPER)?;
    canvas.text(&note.text, [at[0], at[1] + 0.36 * SMALL], SMALL, INK, Anchor::Middle)?;
    if note.ring {
        canvas.disc(place, RING, PAPER)?;
        canvas.circle(place, RING, Ink { color: INK, width: 1.4 })?;
    }
    Ok(())
}

fn axes(canvas: &Canvas<'_>, map: &Map, view: &View) -> Result<(), PlotError> {
    let rect = &view.rect;
    let x_ticks = ticks(&map.x.name, view.x[0], view.x[1], 8);
    let y_ticks = ticks(&map.y.name, view.y[0], view.y[1], 10);
    let area = canvas.area().clone().shrink(
        (to_units(rect.x - LEFT), to_units(rect.y)),
        (to_units(rect.width + LEFT), to_units(rect.height + BELOW - 10.0)),
    );
    let mut chart = ChartBuilder::on(&area)
        .x_label_area_size(to_units(BELOW - 10.0))
        .y_label_area_size(to_units(LEFT))
        .build_cartesian_2d(
            Axis { range: view.x, ticks: x_ticks.clone() },
            Axis { range: view.y, ticks: y_ticks.clone() },
        )?;
    let frame = Ink { color: INK, width: 0.9 };
    chart
        .configure_mesh()
        .disable_mesh()
        .axis_style(style(frame))
        .set_all_tick_mark_size(to_units(4.0))
        .label_style(text_style(11.0, INK))
        .draw()?;
    canvas.outline(&rect.corners(), frame)?;
    let below = [rect.x + 0.5 * rect.width, rect.y + rect.height + 38.0];
    canvas.text(&x_ticks.quantity, below, 12.5, INK, Anchor::Middle)?;
    let beside = (rect.x - 10.0 - text_width(&y_ticks.quantity, 12.5)).max(6.0);
    canvas.text(&y_ticks.quantity, [beside, rect.y - 9.0], 12.5, INK, Anchor::Start)
}

/// A line of the legend.
enum Line {
    Entry { fill: plotters::style::RGBColor, text: String, note: String },
    Stroke { dashed: bool, text: String },
    Text(String),
}

impl Line {
    fn width(&self) -> f64 {
        match self {
            Self::Entry { text, note, .. } => {
                let note = if note.is_empty() { 0.0 } else { 8.0 + text_width(note, SMALL) };
                SWATCH + 8.0 + text_width(text, SIZE) + note
            }
            Self::Stroke { text, .. } => 2.0 * SWATCH + 8.0 + text_width(text, SIZE),
            Self::Text(text) => text_width(text, SIZE),
        }
    }

    fn draw(&self, canvas: &Canvas<'_>, at: Point) -> Result<(), PlotError> {
        let base = at[1] + 0.5 * ROW + 0.36 * SIZE;
        match self {
            Self::Entry { fill, text, note } => {
                let top = at[1] + 0.5 * (ROW - SWATCH);
                let rect = Rect { x: at[0], y: top, width: SWATCH, height: SWATCH };
                canvas.polygon(&rect.corners(), *fill)?;
                canvas.outline(&rect.corners(), Ink { color: FAINT_INK, width: 0.6 })?;
                let x = at[0] + SWATCH + 8.0;
                canvas.text(text, [x, base], SIZE, INK, Anchor::Start)?;
                canvas.text(note, [x + text_width(text, SIZE) + 8.0, base], SMALL, FAINT_INK, Anchor::Start)
            }
            Self::Stroke { dashed, text } => {
                let middle = at[1] + 0.5 * ROW;
                let ends = [[at[0], middle], [at[0] + 2.0 * SWATCH, middle]];
                stroke(canvas, &ends, *dashed, Ink { color: INK, width: 1.2 })?;
                canvas.text(text, [at[0] + 2.0 * SWATCH + 8.0, base], SIZE, INK, Anchor::Start)
            }
            Self::Text(text) => canvas.text(text, [at[0], base], SIZE, FAINT_INK, Anchor::Start),
        }
    }
}

fn legend(map: &Map) -> Vec<Line> {
    let mut lines: Vec<Line> = map
        .entries
        .iter()
        .enumerate()
        .take(LISTED)
        .map(|(number, entry)| Line::Entry {
            fill: color(number),
            text: if entry.mark == entry.name { entry.name.clone() } else { format!("{}  {}", entry.mark, entry.name) },
            note: entry.note.clone(),
        })
        .collect();
    if map.entries.len() > LISTED {
        lines.push(Line::Text(format!("and {} more", map.entries.len() - LISTED)));
    }
    let unknown = match &map.bodies {
        MapBodies::Grid { entries, .. } => entries.iter().any(Option::is_none),
        MapBodies::Points(points) => points.iter().any(|(_, entry)| entry.is_none()),
    };
    if unknown {
        lines.push(Line::Entry { fill: UNKNOWN, text: map.unknown.clone(), note: String::new() });
    }
    let mut told: Vec<&str> = Vec::new();
    for line in &map.lines {
        if !line.text.is_empty() && !told.contains(&line.text.as_str()) {
            told.push(&line.text);
            lines.push(Line::Stroke { dashed: line.dashed, text: line.text.clone() });
        }
    }
    lines
}
