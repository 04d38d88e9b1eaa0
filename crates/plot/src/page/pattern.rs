//! Dashed lines: one path for each colour, which SVG dashes.

use plotters::style::RGBColor;

use super::canvas::Canvas;
use super::geometry::{Point, UNITS};
use super::ink::Ink;
use super::path::Path;

/// A length in pixels with its colour, or empty.
pub(crate) type Dash = (Option<RGBColor>, f64);

/// A repeating sequence of dashes.
pub(crate) type Pattern = Vec<Dash>;

/// Draws a polyline in a pattern.
pub(crate) fn draw(canvas: &Canvas, points: &[Point], pattern: &[Dash], width: f64) {
    let mut path = Path::default();
    path.line(points, false);
    draw_path(canvas, &path, pattern, width);
}

/// Draws a path in a pattern, which begins anew with each of its lines.
pub(crate) fn draw_path(canvas: &Canvas, path: &Path, pattern: &[Dash], width: f64) {
    for color in colors(pattern) {
        let dashes = match &intervals(pattern, color)[..] {
            // Solid.
            [_] => String::new(),
            [offset, lengths @ ..] => {
                let lengths: Vec<String> = lengths.iter().map(f64::to_string).collect();
                let shift = if *offset > 0.0 { format!(" stroke-dashoffset=\"-{offset}\"") } else { String::new() };
                format!(" stroke-dasharray=\"{}\"{shift}", lengths.join(" "))
            }
            [] => continue,
        };
        path.draw(canvas, &format!("{}{dashes}", canvas.stroke(Ink { color, width })));
    }
}

/// The colours of a pattern, each once.
fn colors(pattern: &[Dash]) -> Vec<RGBColor> {
    let mut colors: Vec<RGBColor> = Vec::new();
    for color in pattern.iter().filter_map(|(color, _)| *color) {
        if !colors.contains(&color) {
            colors.push(color);
        }
    }
    colors
}

/// Where in the pattern a colour begins, and from there in turn how long it is drawn and how long not, in canvas units;
/// the beginning alone for a colour that is always drawn.
fn intervals(pattern: &[Dash], color: RGBColor) -> Vec<f64> {
    let is_own = |dash: &Dash| dash.0 == Some(color);
    let Some(first) = pattern.iter().position(is_own) else { return Vec::new() };
    let offset: f64 = pattern[..first].iter().map(|dash| dash.1).sum();
    let mut intervals: Vec<f64> = vec![(offset * UNITS).round()];
    let mut drawn = None;
    for dash in pattern[first..].iter().chain(&pattern[..first]) {
        let length = (dash.1 * UNITS).round();
        match intervals.last_mut() {
            Some(last) if drawn == Some(is_own(dash)) => *last += length,
            _ => intervals.push(length),
        }
        drawn = Some(is_own(dash));
    }
    if intervals.len() == 2 {
        intervals.truncate(1);
    }
    intervals
}

#[cfg(test)]
mod tests {
    use super::super::ink::{INK, POLE};
    use super::*;

    #[test]
    fn every_colour_is_drawn_where_it_is_its_turn() {
        assert_eq!(intervals(&[(Some(POLE), 1.0)], POLE), [0.0]);
        assert_eq!(intervals(&[(Some(POLE), 4.0), (None, 2.0)], POLE), [0.0, 40.0, 20.0]);
        let both = [(Some(INK), 9.0), (Some(POLE), 5.0), (None, 1.5)];
        assert_eq!(intervals(&both, INK), [0.0, 90.0, 65.0]);
        assert_eq!(intervals(&both, POLE), [90.0, 50.0, 105.0]);
        let dots = [(Some(POLE), 9.0), (None, 2.0), (Some(POLE), 2.0), (None, 2.0)];
        assert_eq!(intervals(&dots, POLE), [0.0, 90.0, 20.0, 20.0, 20.0]);
    }
}
