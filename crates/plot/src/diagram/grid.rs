//! The pixels of a panel: which region each belongs to, and how deep inside it lies.

use super::scene::Scene;
use super::trace::Trace;
use super::view::View;
use crate::page::{Point, Rect};

/// A region whose inscribed circle has at least this radius in pixels can be seen and pointed at.
pub(super) const LEGIBLE: f64 = 4.5;

/// A pixel of the forbidden region, or of no region at all.
pub(super) const NOTHING: i32 = -1;

/// The pixels of a panel, row by row from the top.
pub(super) struct Grid {
    pub width: usize,
    pub height: usize,
    /// Top left corner on the page.
    pub origin: Point,
    /// Index of the region of each pixel, or [`NOTHING`].
    pub regions: Vec<i32>,
    /// Distance of each pixel to the nearest pixel on a border between regions or on the panel's edge.
    pub depth: Vec<f64>,
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0 ..= limit")]
fn pixel(value: f64, limit: usize) -> usize {
    value.clamp(0.0, limit as f64) as usize
}

impl Grid {
    /// The pixels of some regions in `view`, its size rounded to whole pixels.
    pub(super) fn new(
        scene: &Scene<'_>,
        view: &View,
        traces: &[Trace],
        regions: impl IntoIterator<Item = usize>,
    ) -> Self {
        let (width, height) = (pixel(view.rect.width.round(), 10_000), pixel(view.rect.height.round(), 10_000));
        let mut grid = Self {
            width,
            height,
            origin: [view.rect.x, view.rect.y],
            regions: vec![NOTHING; width * height],
            depth: Vec::new(),
        };
        for region in regions {
            grid.fill(scene, view, traces, region);
        }
        grid.depth = grid.distances();
        grid
    }

    fn fill(&mut self, scene: &Scene<'_>, view: &View, traces: &[Trace], region: usize) {
        let label = i32::try_from(region).unwrap_or(NOTHING);
        let l_top = view.window.l[1];
        for cell in &scene.cells[region] {
            // Row y holds l_top − (y + ½)·(l per pixel).
            let row_of = |l: f64| (l_top - l) / view.l_per_pixel() - 0.5;
            let (top, bottom) = (row_of(cell.l[1]).ceil(), row_of(cell.l[0]).floor() + 1.0);
            for y in pixel(top, self.height)..pixel(bottom, self.height) {
                let l = l_top - (y as f64 + 0.5) * view.l_per_pixel();
                let column_of = |h: f64| ((h - view.window.h[0]) / view.h_per_pixel() - 0.5).ceil();
                let Some(lower) = traces[cell.lower].h_at(l) else { continue };
                let Some(upper) = cell.upper.map_or(Some(f64::INFINITY), |upper| traces[upper].h_at(l)) else {
                    continue;
                };
                let (left, right) = (pixel(column_of(lower), self.width), pixel(column_of(upper), self.width));
                if left < right {
                    self.regions[y * self.width + left..y * self.width + right].fill(label);
                }
            }
        }
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
        let label = self.regions[at];
        let on_edge = x == 0 || y == 0 || x + 1 == self.width || y + 1 == self.height;
        on_edge || [at - 1, at + 1, at - self.width, at + self.width].iter().any(|&next| self.regions[next] != label)
    }

    /// The deepest pixel of every region of the scene and its depth; `None` for those without a pixel.
    pub(super) fn deepest(&self, regions: usize) -> Vec<Option<(Point, f64)>> {
        let mut best: Vec<Option<(usize, f64)>> = vec![None; regions];
        for (at, (label, &depth)) in self.regions.iter().zip(&self.depth).enumerate() {
            let Some(best) = usize::try_from(*label).ok().and_then(|region| best.get_mut(region)) else { continue };
            if best.is_none_or(|(_, deepest)| depth > deepest) {
                *best = Some((at, depth));
            }
        }
        let located = |(at, depth): (usize, f64)| (self.position(at % self.width, at / self.width), depth);
        best.into_iter().map(|best| best.map(located)).collect()
    }

    /// Depth of every region of the scene, 0 for those without a pixel.
    pub(super) fn depths(&self, regions: usize) -> Vec<f64> {
        self.deepest(regions).into_iter().map(|deepest| deepest.map_or(0.0, |(_, depth)| depth)).collect()
    }

    /// Position on the page of a pixel's middle.
    pub(super) fn position(&self, x: usize, y: usize) -> Point {
        [self.origin[0] + x as f64 + 0.5, self.origin[1] + y as f64 + 0.5]
    }

    /// Columns and rows of the pixels of a rectangle on the page.
    pub(super) fn span(&self, rect: &Rect) -> [std::ops::Range<usize>; 2] {
        let columns = pixel((rect.x - self.origin[0]).floor(), self.width)
            ..pixel((rect.right() - self.origin[0]).ceil(), self.width);
        let rows = pixel((rect.y - self.origin[1]).floor(), self.height)
            ..pixel((rect.bottom() - self.origin[1]).ceil(), self.height);
        [columns, rows]
    }

    /// Index of the pixel at a position on the page.
    pub(super) fn index(&self, at: Point) -> Option<usize> {
        let (x, y) = ((at[0] - self.origin[0]).floor(), (at[1] - self.origin[1]).floor());
        let inside = x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < self.height as f64;
        inside.then(|| pixel(y, self.height) * self.width + pixel(x, self.width))
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
        let (width, height) = (23, 17);
        let mut regions = vec![0; width * height];
        for (x, y) in [(5, 4), (17, 11), (16, 3)] {
            regions[y * width + x] = 1;
        }
        let grid = Grid { width, height, origin: [0.0, 0.0], regions, depth: Vec::new() };
        let depth = grid.distances();
        for y in 0..height {
            for x in 0..width {
                let mut nearest = f64::INFINITY;
                for v in 0..height {
                    for u in (0..width).filter(|&u| grid.on_border(u, v)) {
                        let (dx, dy) = (u as f64 - x as f64, v as f64 - y as f64);
                        nearest = nearest.min((dx * dx + dy * dy).sqrt());
                    }
                }
                assert_eq!(depth[y * width + x], nearest, "at {x}, {y}");
            }
        }
    }
}
