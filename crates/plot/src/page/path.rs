//! SVG path data in canvas units: whole numbers, relative where that is shorter.

use super::canvas::Canvas;
use super::geometry::{Point, to_units};
use super::picture::escaped;
use std::fmt::Write;

/// Path data of polylines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Path {
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

    /// Puts the path on a canvas unless it is empty, with further attributes.
    pub fn draw(&self, canvas: &Canvas, attributes: &str) {
        if !self.data.is_empty() {
            canvas.element(&self.element(attributes));
        }
    }

    /// Puts the path on a canvas with further attributes, and a text for when one points at it.
    pub fn titled(&self, canvas: &Canvas, attributes: &str, title: &str) {
        if !self.data.is_empty() {
            let title = escaped(title);
            canvas.element(&format!("<path d=\"{}\" {attributes}><title>{title}</title></path>", self.data));
        }
    }

    fn element(&self, attributes: &str) -> String {
        format!("<path d=\"{}\" {attributes}/>", self.data)
    }

    /// The path as SVG writes it.
    #[cfg(test)]
    pub fn data(&self) -> &str {
        &self.data
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_are_short_and_relative() {
        let mut path = Path::default();
        path.line(&[[1.0, 2.0], [1.0, 2.01], [3.0, 1.0], [3.0, 4.0]], true);
        path.line(&[[0.0, 0.5], [0.2, 0.5]], false);
        assert_eq!(path.element("fill=\"none\""), "<path d=\"M10 20l20-10 0 30zM0 5l2 0\" fill=\"none\"/>");
        let mut dots = Path::default();
        dots.dot([1.0, 1.0]);
        dots.dot([0.5, 2.0]);
        assert_eq!(dots.element(""), "<path d=\"M10 10h0m-5 10h0\" />");
    }
}
