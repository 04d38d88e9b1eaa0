//! Dashed lines.

use plotters::style::RGBColor;

use super::canvas::Canvas;
use super::geometry::{Point, between, distance};
use super::ink::Ink;

/// A length in pixels with its colour, or empty.
pub(crate) type Dash = (Option<RGBColor>, f64);

/// A repeating sequence of dashes.
pub(crate) type Pattern = Vec<Dash>;

/// Draws a polyline in a pattern.
pub(crate) fn draw(canvas: &Canvas<'_>, points: &[Point], pattern: &[Dash], width: f64) {
    for (color, dash) in dashes(points, pattern) {
        canvas.path(&dash, Ink { color, width });
    }
}

/// Cuts a polyline into the coloured pieces of a pattern.
fn dashes(points: &[Point], pattern: &[Dash]) -> Vec<(RGBColor, Vec<Point>)> {
    if let [(Some(color), _)] = *pattern {
        return vec![(color, points.to_vec())];
    }
    let mut pieces = Vec::new();
    let Some(&start) = points.first() else { return pieces };
    let mut phase = pattern.iter().cycle();
    let Some(&(mut color, mut left)) = phase.next() else { return pieces };
    let mut piece = vec![start];
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        let mut done = 0.0;
        while done + left < length {
            done += left;
            let end = between(pair[0], pair[1], done / length);
            piece.push(end);
            if let Some(color) = color {
                pieces.push((color, std::mem::take(&mut piece)));
            }
            piece = vec![end];
            if let Some(next) = phase.next() {
                (color, left) = *next;
            }
        }
        left -= length - done;
        piece.push(pair[1]);
    }
    if let Some(color) = color {
        pieces.push((color, piece));
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::super::ink::POLE;
    use super::*;

    #[test]
    fn dashes_fill_the_line_in_turn() {
        let pattern = [(Some(POLE), 4.0), (None, 2.0)];
        let pieces = dashes(&[[0.0, 0.0], [3.0, 0.0], [3.0, 10.0]], &pattern);
        let lengths: Vec<f64> =
            pieces.iter().map(|(_, piece)| piece.windows(2).map(|pair| distance(pair[0], pair[1])).sum()).collect();
        assert_eq!(lengths, [4.0, 4.0, 1.0]);
        assert_eq!(pieces[0].1, [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0]]);
    }
}
