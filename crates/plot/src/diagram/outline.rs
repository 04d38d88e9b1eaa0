//! Regions as closed outlines, and the grounds that fill them.

use std::collections::BTreeMap;

use bifdiag_schema::RegionDocument;
use plotters::style::RGBColor;

use super::palette::{Parts, ground};
use crate::page::{Canvas, Path, Point, Rect, Stripes, to_pixels, to_units};

/// A corner in canvas units.
type Corner = [i32; 2];

/// The outline of the union of polygons that meet, if at all, along sides of equal height on the page: the sides that two
/// of them share drop out.
pub(super) fn outline(polygons: impl IntoIterator<Item = Vec<Point>>) -> Path {
    let mut sides: Vec<[Corner; 2]> = Vec::new();
    // What begins (+1) and ends (−1) along each height: how often it is passed to the right, less to the left.
    let mut level: BTreeMap<i32, BTreeMap<i32, i32>> = BTreeMap::new();
    for polygon in polygons {
        let corners: Vec<Corner> = polygon.iter().map(|point| point.map(to_units)).collect();
        for (place, &from) in corners.iter().enumerate() {
            let to = corners[(place + 1) % corners.len()];
            if from[1] != to[1] {
                sides.push([from, to]);
            } else if from != to {
                let ends = level.entry(from[1]).or_default();
                *ends.entry(from[0]).or_default() += 1;
                *ends.entry(to[0]).or_default() -= 1;
            }
        }
    }
    for (y, ends) in level {
        let mut passed = 0;
        let mut from = None;
        for (x, change) in ends {
            if let Some(from) = from {
                let side = if passed > 0 { [[from, y], [x, y]] } else { [[x, y], [from, y]] };
                sides.extend(std::iter::repeat_n(side, usize::try_from(i32::abs(passed)).unwrap_or(0)));
            }
            passed += change;
            from = Some(x);
        }
    }
    joined(sides)
}

/// Closed lines of directed sides: at every corner as many begin as end.
fn joined(sides: Vec<[Corner; 2]>) -> Path {
    let mut from: BTreeMap<Corner, Vec<Corner>> = BTreeMap::new();
    for [start, end] in sides.into_iter().rev() {
        from.entry(start).or_default().push(end);
    }
    let mut path = Path::default();
    while let Some((&start, _)) = from.first_key_value() {
        let mut line = vec![start];
        let mut at = start;
        while let Some(ends) = from.get_mut(&at) {
            let Some(next) = ends.pop() else { break };
            if ends.is_empty() {
                from.remove(&at);
            }
            at = next;
            line.push(at);
        }
        let points: Vec<Point> = line.iter().map(|corner| corner.map(to_pixels)).collect();
        path.line(&points, true);
    }
    path
}

/// What fills a region: one tint, or stripes in the tints of its components.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ground(Vec<RGBColor>);

impl Ground {
    pub(super) fn of(region: &RegionDocument) -> Self {
        Self(ground(&Parts::of(region)))
    }

    /// The attributes of an area.
    fn fill(&self, canvas: &Canvas) -> String {
        match &self.0[..] {
            [color] => canvas.fill(*color),
            colors => canvas.stripes(&Stripes { colors: colors.to_vec() }),
        }
    }

    /// Fills a path, which carries an id and a text for when one points at it.
    pub(super) fn paint(&self, canvas: &Canvas, path: &Path, id: &str, title: &str) {
        path.titled(canvas, &format!("id=\"{id}\" {} fill-rule=\"evenodd\"", self.fill(canvas)), title);
    }

    pub(super) fn paint_rect(&self, canvas: &Canvas, rect: &Rect) {
        let mut path = Path::default();
        path.line(&rect.corners(), true);
        path.draw(canvas, &self.fill(canvas));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(path: &Path) -> String {
        path.data().to_owned()
    }

    #[test]
    fn shared_sides_drop_out() {
        let lower = vec![[0.0, 2.0], [4.0, 2.0], [4.0, 1.0], [0.0, 1.0]];
        let upper = vec![[0.0, 1.0], [2.0, 1.0], [2.0, 0.0], [0.0, 0.0]];
        // One outline with six corners.
        let path = outline([lower.clone(), upper]);
        assert_eq!(area(&path).matches('z').count(), 1, "{}", area(&path));
        assert_eq!(area(&path).matches('M').count(), 1);
        // Apart, two.
        let apart = vec![[5.0, 1.0], [6.0, 1.0], [6.0, 0.0], [5.0, 0.0]];
        assert_eq!(area(&outline([lower, apart])).matches('z').count(), 2);
    }

    #[test]
    fn a_hole_is_left_by_what_lies_round_it() {
        let rect = |x: f64, y: f64, width: f64, height: f64| {
            vec![[x, y + height], [x + width, y + height], [x + width, y], [x, y]]
        };
        let path = outline([
            rect(0.0, 0.0, 3.0, 1.0),
            rect(0.0, 1.0, 1.0, 1.0),
            rect(2.0, 1.0, 1.0, 1.0),
            rect(0.0, 2.0, 3.0, 1.0),
        ]);
        assert_eq!(area(&path).matches('z').count(), 2, "{}", area(&path));
    }
}
