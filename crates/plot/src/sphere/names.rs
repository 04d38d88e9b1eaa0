//! Places for the names of what a view shows: beside their marks, off ∂U and the rim, and off each other.

use plotters::style::RGBColor;

use super::view::View;
use crate::page::{Anchor, Canvas, PAPER, Point, Rect, Taken, distance, meets, text_width};

/// From a mark to its name, for the nearest places.
const NEAR: f64 = 9.0;
/// The directions of places, best first, x to the right for a mark on the right half of a view.
const DIRECTIONS: [[f64; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [0.8, -0.8], [0.8, 0.8], [-0.8, -0.8], [-0.8, 0.8]];
/// What may not be: to cover something, or for a number to stand beside the sphere.
const FORBIDDEN: f64 = 1000.0;
/// What it costs to cross ∂U or the rim, and a level line; to be one place further down the list costs 1.
const CROSSED: [f64; 2] = [60.0, 4.0];

/// The room of a view.
pub(super) struct Names<'a> {
    pub view: &'a View,
    /// ∂U with the rim, and other levels.
    lines: [Vec<Vec<Point>>; 2],
    taken: Taken,
}

impl<'a> Names<'a> {
    /// A view on a page on which something is taken.
    pub(super) fn new(view: &'a View, lines: [Vec<Vec<Point>>; 2], taken: Taken) -> Self {
        Self { view, lines, taken }
    }

    /// What is taken on the page.
    pub(super) fn into_taken(self) -> Taken {
        self.taken
    }

    /// Keeps names away from a box.
    pub(super) fn take(&mut self, rect: Rect) {
        self.taken.take_box(rect);
    }

    /// Writes a name beside a mark, with a rim of paper; what is no name of a mark stands inside of the view.
    pub(super) fn write(
        &mut self,
        canvas: &Canvas,
        at: Point,
        name: &str,
        (size, color): (f64, RGBColor),
        inside: bool,
    ) {
        let [wide, high] = [text_width(name, size), 0.8 * size];
        let outward = if at[0] < self.view.center[0] { -1.0 } else { 1.0 };
        let places = [NEAR, 1.7 * NEAR].into_iter().flat_map(|away| {
            DIRECTIONS.map(|[x, y]| {
                let middle = [at[0] + outward * x * (away + wide / 2.0), at[1] + y * (away + high / 2.0)];
                Rect { x: middle[0] - wide / 2.0, y: middle[1] - high / 2.0, width: wide, height: high }
            })
        });
        let costs = places.enumerate().map(|(order, rect)| (order as f64 + self.cost(&rect.grown(1.5), inside), rect));
        let Some((_, rect)) = costs.min_by(|a, b| a.0.total_cmp(&b.0)) else { return };
        self.take(rect);
        let base = [rect.x, rect.bottom() - 0.03 * size];
        for [dx, dy] in [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
            canvas.text(name, [base[0] + dx, base[1] + dy], size, PAPER, Anchor::Start);
        }
        canvas.text(name, base, size, color, Anchor::Start);
    }

    fn cost(&self, rect: &Rect, inside: bool) -> f64 {
        let View { center, radius, .. } = *self.view;
        let leaves = inside && rect.corners().iter().any(|corner| distance(*corner, center) > radius);
        let met =
            |lines: &[Vec<Point>]| lines.iter().any(|line| line.windows(2).any(|ends| meets(ends[0], ends[1], rect)));
        let crossed: f64 =
            self.lines.iter().zip(CROSSED).map(|(lines, cost)| if met(lines) { cost } else { 0.0 }).sum();
        let allowed = self.taken.admits_box(rect) && !leaves;
        if allowed { crossed } else { crossed + FORBIDDEN }
    }
}
