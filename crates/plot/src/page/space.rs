//! What is taken on a panel, as shapes: boxes of text, marks and small frames, and lines that lead to boxes or frame insets.
//! Nothing new may meet what is there.

use super::geometry::{Point, Rect, distance, meets};

/// Boxes and lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Taken {
    boxes: Vec<Rect>,
    lines: Vec<[Point; 2]>,
}

impl Taken {
    /// Keeps everything else away from a box.
    pub(crate) fn take_box(&mut self, rect: Rect) {
        self.boxes.push(rect);
    }

    /// Keeps everything else away from a line.
    pub(crate) fn take_line(&mut self, line: [Point; 2]) {
        self.lines.push(line);
    }

    /// Keeps everything else away from the sides of a frame, but not from its inside.
    pub(crate) fn take_outline(&mut self, rect: &Rect) {
        let [a, b, c, d] = rect.corners();
        self.lines.extend([[a, b], [b, c], [c, d], [d, a]]);
    }

    /// Whether a box meets nothing.
    pub(crate) fn admits_box(&self, rect: &Rect) -> bool {
        !self.boxes.iter().any(|other| overlap(rect, other)) && !self.lines.iter().any(|line| passes(*line, rect))
    }

    /// Whether a line meets nothing but frames: those it may cross.
    pub(crate) fn admits_leader(&self, line: [Point; 2], leaders: &[[Point; 2]]) -> bool {
        !self.boxes.iter().any(|rect| passes(line, rect)) && !leaders.iter().any(|other| near(line, *other))
    }

    /// Whether a point lies in a box.
    pub(crate) fn holds(&self, point: Point) -> bool {
        self.boxes.iter().any(|rect| rect.contains(point))
    }
}

fn overlap(a: &Rect, b: &Rect) -> bool {
    a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom()
}

/// Whether a segment meets a rectangle.
fn passes(line: [Point; 2], rect: &Rect) -> bool {
    meets(line[0], line[1], rect)
}

/// Whether two leader lines cross or come so near that one could be taken for the other.
fn near(a: [Point; 2], b: [Point; 2]) -> bool {
    const APART: f64 = 3.0;
    let to = |point: Point, [from, to]: [Point; 2]| {
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0] * along[0] + along[1] * along[1];
        let t = ((point[0] - from[0]) * along[0] + (point[1] - from[1]) * along[1]) / length.max(1e-9);
        let t = t.clamp(0.0, 1.0);
        distance(point, [from[0] + t * along[0], from[1] + t * along[1]])
    };
    cross(a, b) || to(a[0], b) < APART || to(a[1], b) < APART || to(b[0], a) < APART || to(b[1], a) < APART
}

/// True when two segments cross.
fn cross(a: [Point; 2], b: [Point; 2]) -> bool {
    let side =
        |s: [Point; 2], p: Point| (s[1][0] - s[0][0]) * (p[1] - s[0][1]) - (s[1][1] - s[0][1]) * (p[0] - s[0][0]);
    side(a, b[0]) * side(a, b[1]) < 0.0 && side(b, a[0]) * side(b, a[1]) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_taken_stays_free() {
        let mut taken = Taken::default();
        taken.take_box(Rect { x: 10.0, y: 10.0, width: 10.0, height: 10.0 });
        taken.take_line([[0.0, 30.0], [30.0, 40.0]]);
        assert!(!taken.admits_box(&Rect { x: 15.0, y: 0.0, width: 2.0, height: 12.0 }));
        assert!(!taken.admits_box(&Rect { x: 10.0, y: 30.0, width: 4.0, height: 10.0 }), "the line passes through it");
        assert!(taken.admits_box(&Rect { x: 21.0, y: 10.0, width: 4.0, height: 10.0 }));
        assert!(!taken.admits_leader([[0.0, 15.0], [30.0, 15.0]], &[]), "it would run through the box");
        let leader = [[22.0, 0.0], [22.0, 20.0]];
        assert!(taken.admits_leader(leader, &[]));
        assert!(!taken.admits_leader(leader, &[[[21.0, 10.0], [40.0, 12.0]]]), "leaders would cross");
        assert!(!taken.admits_leader(leader, &[[[24.0, 0.0], [24.0, 20.0]]]), "one could be taken for the other");
    }
}
