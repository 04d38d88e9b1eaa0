//! Where parameters lie on the page.

use crate::page::{Point, Rect};

/// Pixels that an area needs so that a mark points at it.
pub(super) const SEEN: f64 = 12.0;

/// Font sizes of texts and of notes.
pub(super) const SIZE: f64 = 11.5;
pub(super) const SMALL: f64 = 11.0;

/// The ranges of a map and its place on the page.
pub(super) struct View {
    pub x: [f64; 2],
    pub y: [f64; 2],
    pub rect: Rect,
}

impl View {
    /// A point of the map on the page.
    pub(super) fn at(&self, [x, y]: [f64; 2]) -> Point {
        let share = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let rect = &self.rect;
        [rect.x + share(x, self.x) * rect.width, rect.y + rect.height * (1.0 - share(y, self.y))]
    }
}

/// The area of a polygon on the page.
pub(super) fn area(corners: &[[f64; 2]], view: &View) -> f64 {
    let corners: Vec<Point> = corners.iter().map(|corner| view.at(*corner)).collect();
    let next = corners.iter().cycle().skip(1);
    0.5 * corners.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>().abs()
}
