//! SVG path data in canvas units: whole numbers, relative where that is shorter. A dashed line is one path for each of its
//! colours, which SVG dashes.

use std::fmt::Write;

use plotters::style::RGBColor;

use super::geometry::{Point, UNITS, to_units};

/// Path data of polylines.
#[derive(Clone, Debug, Default)]
pub struct Path {
    data: String,
    last: [i32; 2],
}

impl Path {
    /// A polyline through points in pixels, closed or open. Vertices that coincide on the canvas are drawn once.
    pub fn line(&mut self, points: &[Point], closed: bool) {
        let mut units = points.iter().map(|p| p.map(to_units));
        let Some(first) = units.next() else { return };
        self.start(first);
        let mut drawn = 0;
        for point in units {
            let step = [point[0] - self.last[0], point[1] - self.last[1]];
            if step != [0, 0] {
                self.data.push(if drawn == 0 { 'l' } else { ' ' });
                self.pair(step);
                self.last = point;
                drawn += 1;
            }
        }
        if closed {
            self.data.push('z');
            self.last = first;
        } else if drawn == 0 {
            self.data.push_str("h0");
        }
    }

    /// A dot: a line of no length, which round caps make visible.
    pub fn dot(&mut self, at: Point) {
        let at = at.map(to_units);
        if self.data.is_empty() {
            self.start(at);
        } else {
            self.data.push('m');
            self.pair([at[0] - self.last[0], at[1] - self.last[1]]);
            self.last = at;
        }
        self.data.push_str("h0");
    }

    fn start(&mut self, at: [i32; 2]) {
        self.data.push('M');
        self.pair(at);
        self.last = at;
    }

    fn pair(&mut self, [x, y]: [i32; 2]) {
        let separator = if y < 0 { "" } else { " " };
        // Writing to a string does not fail.
        let _always_ok = write!(self.data, "{x}{separator}{y}");
    }

    /// The path as SVG writes it; empty if nothing is drawn.
    #[must_use]
    pub fn data(&self) -> &str {
        &self.data
    }
}

/// A length in pixels with its colour, or empty.
pub type Dash = (Option<RGBColor>, f64);

/// The colours of a pattern, each once.
pub fn colors(pattern: &[Dash]) -> Vec<RGBColor> {
    let mut colors: Vec<RGBColor> = Vec::new();
    for color in pattern.iter().filter_map(|(color, _)| *color) {
        if !colors.contains(&color) {
            colors.push(color);
        }
    }
    colors
}

/// Where in the pattern a colour begins, and from there the alternating lengths of dashes and gaps, in canvas units;
/// the beginning alone for a colour that is always drawn.
pub fn intervals(pattern: &[Dash], color: RGBColor) -> Vec<f64> {
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
    use super::super::color::{INK, POLE};
    use super::*;

    #[test]
    fn data_are_short_and_relative() {
        let mut path = Path::default();
        path.line(&[[1.0, 2.0], [1.0, 2.01], [3.0, 1.0], [3.0, 4.0]], true);
        path.line(&[[0.0, 0.5], [0.2, 0.5]], false);
        assert_eq!(path.data(), "M10 20l20-10 0 30zM0 5l2 0");
        let mut dots = Path::default();
        dots.dot([1.0, 1.0]);
        dots.dot([0.5, 2.0]);
        assert_eq!(dots.data(), "M10 10h0m-5 10h0");
    }

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
