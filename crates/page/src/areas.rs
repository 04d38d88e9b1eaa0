//! The pixels of a part of the page: which area each belongs to, how deep inside it lies, where a text fits into an area, and
//! where a leader to it may end.

use std::ops::Range;

use super::geometry::{Point, Rect};
use super::places::Taken;

/// A pixel of no area.
pub const NOTHING: i32 = -1;

/// Points of an area to which a leader may go: the least depth relative to the deepest, and their number.
const DEEP: f64 = 0.55;
const TIPS: usize = 40;

/// Pixels, row by row from the top.
pub struct Areas {
    /// In pixels.
    pub width: usize,
    /// In pixels.
    pub height: usize,
    /// Top left corner on the page.
    origin: Point,
    /// The area of each pixel, or [`NOTHING`].
    pub of: Vec<i32>,
    /// Distance of each pixel to the nearest pixel on a border between areas or on the edge.
    pub depth: Vec<f64>,
}

/// The whole number below a value, from 0 to a limit.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0 ..= limit")]
#[must_use]
pub fn pixel(value: f64, limit: usize) -> usize {
    value.clamp(0.0, limit as f64) as usize
}

impl Areas {
    /// The areas of the pixels of a rectangle, its size rounded to whole pixels. `fill` is given width and height, and sets
    /// the areas.
    pub fn new(rect: &Rect, fill: impl FnOnce([usize; 2], &mut [i32])) -> Self {
        let [width, height] = [rect.width, rect.height].map(|side| pixel(side.round(), 10_000));
        let mut of = vec![NOTHING; width * height];
        fill([width, height], &mut of);
        let mut areas = Self { width, height, origin: [rect.x, rect.y], of, depth: Vec::new() };
        areas.depth = areas.distances();
        areas
    }

    /// Exact Euclidean distances to the border pixels: columns first, then rows by lower envelopes of parabolas
    /// (Felzenszwalb and Huttenlocher, Distance Transforms of Sampled Functions, 2012).
    fn distances(&self) -> Vec<f64> {
        let (width, height) = (self.width, self.height);
        let far = (width + height) as f64;
        let mut column_distance = vec![far; width * height];
        for x in 0..width {
            let mut since = far;
            for y in 0..height {
                since = if self.on_border(x, y) { 0.0 } else { since + 1.0 };
                column_distance[y * width + x] = since;
            }
            let mut since = far;
            for y in (0..height).rev() {
                since = (since + 1.0).min(column_distance[y * width + x]);
                column_distance[y * width + x] = since;
            }
        }
        let mut depth = vec![0.0; width * height];
        for y in 0..height {
            let row = y * width..(y + 1) * width;
            lower_envelope(&column_distance[row.clone()], &mut depth[row]);
        }
        depth
    }

    fn on_border(&self, x: usize, y: usize) -> bool {
        let at = y * self.width + x;
        let on_edge = x == 0 || y == 0 || x + 1 == self.width || y + 1 == self.height;
        on_edge || [at - 1, at + 1, at - self.width, at + self.width].iter().any(|&next| self.of[next] != self.of[at])
    }

    /// The deepest pixel of each of `count` areas and its depth; `None` for those without a pixel.
    #[must_use]
    pub fn deepest(&self, count: usize) -> Vec<Option<(Point, f64)>> {
        let mut best: Vec<Option<(usize, f64)>> = vec![None; count];
        for (at, (area, &depth)) in self.of.iter().zip(&self.depth).enumerate() {
            let Some(best) = usize::try_from(*area).ok().and_then(|area| best.get_mut(area)) else { continue };
            if best.is_none_or(|(_, deepest)| depth > deepest) {
                *best = Some((at, depth));
            }
        }
        best.into_iter().map(|best| best.map(|(at, depth)| (self.position(at), depth))).collect()
    }

    /// Depth of each of `count` areas, 0 for those without a pixel.
    #[must_use]
    pub fn depths(&self, count: usize) -> Vec<f64> {
        self.deepest(count).into_iter().map(|deepest| deepest.map_or(0.0, |(_, depth)| depth)).collect()
    }

    /// Position on the page of a pixel's middle.
    #[must_use]
    pub fn position(&self, at: usize) -> Point {
        [self.origin[0] + (at % self.width) as f64 + 0.5, self.origin[1] + (at / self.width) as f64 + 0.5]
    }

    /// Columns and rows of the pixels of a rectangle on the page.
    #[must_use]
    pub fn span(&self, rect: &Rect) -> [Range<usize>; 2] {
        let range = |from: f64, to: f64, limit: usize| pixel(from.floor(), limit)..pixel(to.ceil(), limit);
        [
            range(rect.x - self.origin[0], rect.right() - self.origin[0], self.width),
            range(rect.y - self.origin[1], rect.bottom() - self.origin[1], self.height),
        ]
    }

    /// Index of the pixel at a position on the page.
    #[must_use]
    pub fn index(&self, at: Point) -> Option<usize> {
        let (x, y) = ((at[0] - self.origin[0]).floor(), (at[1] - self.origin[1]).floor());
        let inside = x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < self.height as f64;
        inside.then(|| pixel(y, self.height) * self.width + pixel(x, self.width))
    }

    /// The place deepest inside an area where a box with some free space round it meets nothing that is taken. `others`
    /// counts the pixels that are not of the area.
    #[must_use]
    pub fn inside(
        &self,
        area: usize,
        others: &Sums,
        [width, height]: [f64; 2],
        clearance: f64,
        taken: &Taken,
    ) -> Option<Rect> {
        let own = i32::try_from(area).ok()?;
        let [left, top] = self.origin;
        let page = Rect { x: left, y: top, width: self.width as f64, height: self.height as f64 };
        let mut best: Option<(f64, Rect)> = None;
        for at in (0..self.height).step_by(2).flat_map(|y| (0..self.width).step_by(2).map(move |x| (y, x))) {
            let at = at.0 * self.width + at.1;
            let depth = self.depth[at];
            if self.of[at] != own || best.is_some_and(|(deepest, _)| depth <= deepest) {
                continue;
            }
            let [x, y] = self.position(at);
            let rect = Rect { x: x - width / 2.0, y: y - height / 2.0, width, height };
            let needed = rect.grown(clearance);
            let fits = page.contains_rect(&needed) && others.count(self, &needed) == 0.0;
            if fits && taken.admits_box(&needed) {
                best = Some((depth, rect));
            }
        }
        best.map(|(_, rect)| rect)
    }

    /// Deep points of an area that no box hides, spread over it.
    pub fn tips(&self, area: usize, taken: &Taken) -> Vec<Point> {
        let Ok(own) = i32::try_from(area) else { return Vec::new() };
        let pixels = || (0..self.of.len()).filter(|at| self.of[*at] == own);
        let deepest = pixels().map(|at| self.depth[at]).fold(0.0, f64::max);
        let deep = pixels().filter(|at| self.depth[*at] >= DEEP * deepest).map(|at| self.position(at));
        let tips: Vec<Point> = deep.filter(|tip| !taken.holds(*tip)).collect();
        let every = tips.len().div_ceil(TIPS).max(1);
        tips.into_iter().step_by(every).collect()
    }
}

/// Numbers of pixels in rectangles.
pub struct Sums {
    width: usize,
    sums: Vec<u32>,
}

impl Sums {
    /// Counts the pixels for which `counts` holds, given their indices.
    pub fn new(areas: &Areas, counts: impl Fn(usize) -> bool) -> Self {
        let width = areas.width + 1;
        let mut sums = vec![0; width * (areas.height + 1)];
        for y in 0..areas.height {
            let mut row = 0;
            for x in 0..areas.width {
                row += u32::from(counts(y * areas.width + x));
                sums[(y + 1) * width + x + 1] = sums[y * width + x + 1] + row;
            }
        }
        Self { width, sums }
    }

    /// The number in a rectangle on the page.
    #[must_use]
    pub fn count(&self, areas: &Areas, rect: &Rect) -> f64 {
        let [columns, rows] = areas.span(rect);
        let at = |x: usize, y: usize| f64::from(self.sums[y * self.width + x]);
        at(columns.end, rows.end) - at(columns.start, rows.end) - at(columns.end, rows.start)
            + at(columns.start, rows.start)
    }
}

/// min over i of √((x − i)² + distance(i)²) for every x.
fn lower_envelope(distance: &[f64], depth: &mut [f64]) {
    let height = |i: usize| distance[i] * distance[i] + (i * i) as f64;
    // Abscissa at which parabola j passes below parabola i < j.
    let meeting = |i: usize, j: usize| (height(j) - height(i)) / (2.0 * (j - i) as f64);
    let mut envelope: Vec<usize> = Vec::with_capacity(distance.len());
    for j in 0..distance.len() {
        while let [.., before, last] = envelope[..] {
            if meeting(last, j) > meeting(before, last) {
                break;
            }
            envelope.pop();
        }
        envelope.push(j);
    }
    let mut piece = 0;
    for (x, value) in depth.iter_mut().enumerate() {
        while piece + 1 < envelope.len() && meeting(envelope[piece], envelope[piece + 1]) < x as f64 {
            piece += 1;
        }
        let offset = x as f64 - envelope[piece] as f64;
        *value = (offset * offset + distance[envelope[piece]] * distance[envelope[piece]]).sqrt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_euclidean() {
        let rect = Rect { x: 0.0, y: 0.0, width: 23.0, height: 17.0 };
        let areas = Areas::new(&rect, |[width, _], of| {
            of.fill(0);
            for (x, y) in [(5, 4), (17, 11), (16, 3)] {
                of[y * width + x] = 1;
            }
        });
        for y in 0..areas.height {
            for x in 0..areas.width {
                let mut nearest = f64::INFINITY;
                for v in 0..areas.height {
                    for u in (0..areas.width).filter(|&u| areas.on_border(u, v)) {
                        let (dx, dy) = (u as f64 - x as f64, v as f64 - y as f64);
                        nearest = nearest.min((dx * dx + dy * dy).sqrt());
                    }
                }
                assert_eq!(areas.depth[y * areas.width + x], nearest, "at {x}, {y}");
            }
        }
    }
}
