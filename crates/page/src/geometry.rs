//! Points and rectangles of the page, in pixels where they are computed and in canvas units where they are written; sizes in
//! print.

/// Canvas units in a pixel.
pub const UNITS: f64 = 10.0;

/// Millimetres in print of a pixel: the smallest letters have 11 pixels, 6 pt.
pub const MILLIMETRES: f64 = 178.0 / 924.0;

/// Points in print of a pixel.
pub const POINTS: f32 = 0.546_07;

/// Pixels in an inch of print.
pub const PIXELS_PER_INCH: f64 = 25.4 / MILLIMETRES;

/// The greatest height of a picture, 230 mm in print: what a page or a column leaves beside a caption.
pub const HEIGHT: f64 = 1193.0;

/// The width of a picture in print, in millimetres: its smallest letters have 6 pt there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Width(f64);

impl Default for Width {
    fn default() -> Self {
        Self::PAGE
    }
}

impl Width {
    /// Both columns of a journal.
    pub const PAGE: Self = Self(178.0);
    /// One column of a journal.
    pub const COLUMN: Self = Self(86.0);
    /// Each of these.
    pub const ALL: [Self; 2] = [Self::PAGE, Self::COLUMN];
    /// The least and the greatest, in millimetres: axes and labels need room, and what is drawn of an area memory.
    pub const RANGE: [f64; 2] = [80.0, 500.0];
    /// From this width on, panels are side by side.
    const WIDE: f64 = 132.0;
    /// Height over width of a picture in a column at most: 120 mm at 86 mm.
    const SLENDER: f64 = 120.0 / 86.0;

    /// So many millimetres; `None` outside of [`Self::RANGE`].
    #[must_use]
    pub fn new(millimetres: f64) -> Option<Self> {
        let [least, most] = Self::RANGE;
        (least..=most).contains(&millimetres).then_some(Self(millimetres))
    }

    /// In print.
    #[must_use]
    pub fn millimetres(self) -> f64 {
        self.0
    }

    /// Whether panels are stacked, as in one column of a journal.
    #[must_use]
    pub fn is_column(self) -> bool {
        self.0 < Self::WIDE
    }

    /// The width in pixels at which the smallest letters, 11 pixels, are 6 pt in print.
    #[must_use]
    pub fn pixels(self) -> f64 {
        // Hundredths, so that lengths of figures are short numbers.
        (self.0 / MILLIMETRES * 100.0).round() / 100.0
    }

    /// How much wider than the journal's page, or its column, for which sizes are given.
    #[must_use]
    pub fn scale(self) -> f64 {
        self.pixels() / if self.is_column() { Self::COLUMN } else { Self::PAGE }.pixels()
    }

    /// The greatest height of a diagram, in pixels.
    #[must_use]
    pub fn height(self) -> f64 {
        if self.is_column() { Self::SLENDER * self.pixels() } else { HEIGHT * self.scale().max(1.0) }
    }
}

/// A position [x, y] in pixels, y downwards.
pub type Point = [f64; 2];

/// Canvas units of a pixel coordinate.
#[must_use]
pub fn to_units(pixels: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "clamped; a NaN becomes 0")]
    let units = (pixels * UNITS).round().clamp(-1e6, 1e6) as i32;
    units
}

/// The pixel coordinate of canvas units.
pub fn to_pixels(units: i32) -> f64 {
    f64::from(units) / UNITS
}

/// Canvas units of a length in pixels.
pub fn length_units(pixels: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of i32")]
    let units = (pixels * UNITS).round().clamp(0.0, f64::from(i32::MAX)) as u32;
    units
}

/// A rectangle in pixels, y downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Of the left edge.
    pub x: f64,
    /// Of the upper edge.
    pub y: f64,
    /// From left to right.
    pub width: f64,
    /// Downwards.
    pub height: f64,
}

impl Rect {
    /// The square of side 2·`half` around a point.
    #[must_use]
    pub fn around(center: Point, half: f64) -> Self {
        Self { x: center[0] - half, y: center[1] - half, width: 2.0 * half, height: 2.0 * half }
    }

    /// x of the right edge.
    #[must_use]
    pub fn right(&self) -> f64 {
        self.x + self.width
    }

    /// y of the lower edge.
    #[must_use]
    pub fn bottom(&self) -> f64 {
        self.y + self.height
    }

    /// From the upper left one, clockwise.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        let (right, bottom) = (self.right(), self.bottom());
        [[self.x, self.y], [right, self.y], [right, bottom], [self.x, bottom]]
    }

    /// The middle.
    #[must_use]
    pub fn center(&self) -> Point {
        [self.x + self.width / 2.0, self.y + self.height / 2.0]
    }

    /// Whether a point lies inside or on the edge.
    #[must_use]
    pub fn contains(&self, point: Point) -> bool {
        let inside = |value: f64, from: f64, length: f64| value >= from && value <= from + length;
        inside(point[0], self.x, self.width) && inside(point[1], self.y, self.height)
    }

    /// True where the whole of another rectangle lies inside.
    #[must_use]
    pub fn contains_rect(&self, other: &Self) -> bool {
        self.contains([other.x, other.y]) && self.contains([other.right(), other.bottom()])
    }

    /// True for two rectangles with a common inside.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        self.x < other.right() && other.x < self.right() && self.y < other.bottom() && other.y < self.bottom()
    }

    /// The point of the rectangle nearest to `point`.
    #[must_use]
    pub fn nearest(&self, point: Point) -> Point {
        [point[0].clamp(self.x, self.right()), point[1].clamp(self.y, self.bottom())]
    }

    /// Wider by `by` on each side.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        Self { x: self.x - by, y: self.y - by, width: self.width + 2.0 * by, height: self.height + 2.0 * by }
    }

    /// The signed distance of `point` inside of each side.
    fn depths(&self, point: Point) -> [f64; 4] {
        [point[0] - self.x, self.right() - point[0], point[1] - self.y, self.bottom() - point[1]]
    }
}

/// True for a range that is neither empty nor infinite.
#[must_use]
pub fn is_proper([from, to]: [f64; 2]) -> bool {
    from < to && (to - from).is_finite()
}

/// The Euclidean distance of two points.
#[must_use]
pub fn distance(a: Point, b: Point) -> f64 {
    let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
    (dx * dx + dy * dy).sqrt()
}

/// a + t (b − a).
#[must_use]
pub fn between(a: Point, b: Point, t: f64) -> Point {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}

/// The part of the segment inside `rect`, as parameters from `a` to `b` (Liang and Barsky).
fn clip_segment(a: Point, b: Point, rect: &Rect) -> Option<[f64; 2]> {
    let (at_a, at_b) = (rect.depths(a), rect.depths(b));
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for (da, db) in at_a.into_iter().zip(at_b) {
        if da < 0.0 && db < 0.0 {
            return None;
        }
        if da < 0.0 {
            from = from.max(da / (da - db));
        } else if db < 0.0 {
            to = to.min(da / (da - db));
        }
    }
    (from <= to).then_some([from, to])
}

/// Whether a segment meets a rectangle.
#[must_use]
pub fn meets(a: Point, b: Point, rect: &Rect) -> bool {
    clip_segment(a, b, rect).is_some()
}

/// The parts of a polyline inside `rect`.
#[must_use]
pub fn clip_polyline(points: &[Point], rect: &Rect) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    for pair in points.windows(2) {
        let Some([from, to]) = clip_segment(pair[0], pair[1], rect) else {
            open = false;
            continue;
        };
        let end = between(pair[0], pair[1], to);
        match parts.last_mut() {
            Some(part) if open && from == 0.0 => part.push(end),
            _ => parts.push(vec![between(pair[0], pair[1], from), end]),
        }
        open = to == 1.0;
    }
    parts
}

/// The part of a polygon inside `rect` (Sutherland and Hodgman).
#[must_use]
pub fn clip_polygon(points: &[Point], rect: &Rect) -> Vec<Point> {
    let mut polygon = points.to_vec();
    for side in 0..4 {
        let mut clipped = Vec::with_capacity(polygon.len() + 4);
        for index in 0..polygon.len() {
            let (a, b) = (polygon[index], polygon[(index + 1) % polygon.len()]);
            let (da, db) = (rect.depths(a)[side], rect.depths(b)[side]);
            if da >= 0.0 {
                clipped.push(a);
            }
            if (da < 0.0) != (db < 0.0) {
                clipped.push(between(a, b, da / (da - db)));
            }
        }
        polygon = clipped;
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Rect = Rect { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };

    #[test]
    fn a_polyline_that_leaves_and_returns_has_two_parts() {
        let parts = clip_polyline(&[[-1.0, 0.5], [0.5, 0.5], [2.0, 0.5], [2.0, 0.25], [0.5, 0.25]], &UNIT);
        assert_eq!(parts, [vec![[0.0, 0.5], [0.5, 0.5], [1.0, 0.5]], vec![[1.0, 0.25], [0.5, 0.25]]]);
    }

    #[test]
    fn a_polygon_around_the_rectangle_becomes_the_rectangle() {
        let area = clip_polygon(&[[-1.0, -1.0], [3.0, -1.0], [3.0, 3.0], [-1.0, 3.0]], &UNIT);
        assert!(area.iter().all(|p| UNIT.contains(*p)));
        for corner in UNIT.corners() {
            assert!(area.contains(&corner), "{corner:?} is missing");
        }
    }
}
