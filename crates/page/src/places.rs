//! The one placer of labels: what is taken on a page, and the best free place for a text beside what it names.

use super::geometry::{Point, Rect, distance, meets};

/// Boxes of texts, marks and small frames, lines that nothing may cover, and leaders from texts to what they name.
#[derive(Clone, Debug, Default)]
pub struct Taken {
    boxes: Vec<Rect>,
    lines: Vec<[Point; 2]>,
    leaders: Vec<[Point; 2]>,
}

/// A text that needs a place with a leader.
pub struct Labelled<'a> {
    /// Where the leader may end, in or on what the text names.
    pub tips: &'a [Point],
    /// The shortest and the longest leader.
    pub lengths: [f64; 2],
    /// Free space round the box.
    pub clearance: f64,
}

impl Taken {
    /// Keeps everything else away from a box.
    pub fn take_box(&mut self, rect: Rect) {
        self.boxes.push(rect);
    }

    /// Keeps boxes away from a line.
    pub fn take_line(&mut self, line: [Point; 2]) {
        self.lines.push(line);
    }

    /// Keeps boxes away from the sides of a frame, but not from its inside.
    pub fn take_outline(&mut self, rect: &Rect) {
        let [a, b, c, d] = rect.corners();
        self.lines.extend([[a, b], [b, c], [c, d], [d, a]]);
    }

    /// Keeps boxes and other leaders away from a leader.
    pub fn take_leader(&mut self, leader: [Point; 2]) {
        self.leaders.push(leader);
    }

    /// True for a box that meets nothing.
    #[must_use]
    pub fn admits_box(&self, rect: &Rect) -> bool {
        !self.boxes.iter().any(|other| rect.overlaps(other))
            && !self.lines.iter().chain(&self.leaders).any(|[from, to]| meets(*from, *to, rect))
    }

    /// True for a leader that meets no box and comes near no other leader; lines it may cross.
    #[must_use]
    pub fn admits_leader(&self, leader: [Point; 2]) -> bool {
        !self.boxes.iter().any(|rect| meets(leader[0], leader[1], rect))
            && !self.leaders.iter().any(|other| near(leader, *other))
    }

    /// True for a point inside a box.
    #[must_use]
    pub fn holds(&self, point: Point) -> bool {
        self.boxes.iter().any(|rect| rect.contains(point))
    }

    /// The best of some places for a box, by cost, and the best leader from it to a tip, whose cost is its length and what
    /// it crosses. Both are taken.
    pub fn place_with_leader(
        &mut self,
        labelled: &Labelled<'_>,
        places: impl Iterator<Item = (f64, Rect)>,
        crossed: impl Fn([Point; 2]) -> f64,
    ) -> Option<(Rect, [Point; 2])> {
        let Labelled { tips, lengths: [shortest, longest], clearance, .. } = *labelled;
        let length = |rect: &Rect| {
            let lengths = tips.iter().map(|tip| distance(*tip, rect.nearest(*tip)));
            lengths.filter(|length| (shortest..=longest).contains(length)).fold(f64::INFINITY, f64::min)
        };
        let mut sorted: Vec<(f64, Rect)> = places.map(|(cost, rect)| (cost + length(&rect), rect)).collect();
        sorted.retain(|(cost, _)| cost.is_finite());
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best: Option<(f64, Rect, [Point; 2])> = None;
        for (least, rect) in sorted {
            if best.as_ref().is_some_and(|(cost, ..)| least >= *cost) {
                break;
            }
            if !self.admits_box(&rect.grown(clearance)) {
                continue;
            }
            let own = least - length(&rect);
            for leader in tips.iter().map(|tip| [*tip, rect.nearest(*tip)]) {
                let length = distance(leader[0], leader[1]);
                let is_better = |cost: f64| best.as_ref().is_none_or(|(least, ..)| cost < *least);
                if (shortest..=longest).contains(&length) && is_better(own + length) {
                    let cost = own + length + crossed(leader);
                    if is_better(cost) && self.admits_leader(leader) {
                        best = Some((cost, rect, leader));
                    }
                }
            }
        }
        let (_, rect, leader) = best?;
        self.take_box(rect);
        self.take_leader(leader);
        Some((rect, leader))
    }

    /// The place of least cost where a box meets nothing, which is taken.
    pub fn place(&mut self, places: impl Iterator<Item = (f64, Rect)>, clearance: f64) -> Option<Rect> {
        let mut sorted: Vec<(f64, Rect)> = places.collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (_, rect) = sorted.into_iter().find(|(_, rect)| self.admits_box(&rect.grown(clearance)))?;
        self.take_box(rect);
        Some(rect)
    }

    /// The place of least cost, overlapping something only if every place does; it is then occupied. The places are not
    /// empty.
    pub fn place_anyhow(&mut self, places: impl Iterator<Item = (f64, Rect)>, clearance: f64) -> Option<Rect> {
        /// More than the cost of any single place.
        const MET: f64 = 1000.0;
        let cost = |(cost, rect): &(f64, Rect)| cost + if self.admits_box(&rect.grown(clearance)) { 0.0 } else { MET };
        let (_, rect) = places.min_by(|a, b| cost(a).total_cmp(&cost(b)))?;
        self.take_box(rect);
        Some(rect)
    }
}

/// The directions of places round a point, best first.
const DIRECTIONS: [Point; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [0.8, -0.8], [0.8, 0.8], [-0.8, -0.8], [-0.8, 0.8]];

/// Boxes round a point at some distances, the best first: on the right where `outward` is 1, on the left where it is −1.
pub fn round_point(at: Point, size: [f64; 2], distances: &[f64], outward: f64) -> impl Iterator<Item = Rect> {
    let [width, height] = size;
    distances.iter().flat_map(move |away| {
        DIRECTIONS.map(|[x, y]| {
            let middle = [at[0] + outward * x * (away + width / 2.0), at[1] + y * (away + height / 2.0)];
            Rect { x: middle[0] - width / 2.0, y: middle[1] - height / 2.0, width, height }
        })
    })
}

/// Boxes of this size all over an area, this many pixels apart.
pub fn all_over(area: Rect, [width, height]: [f64; 2], step: f64) -> impl Iterator<Item = Rect> {
    let steps = move |length: f64| (0..).map(move |k| f64::from(k) * step).take_while(move |at| *at <= length);
    steps(area.height - height)
        .flat_map(move |y| steps(area.width - width).map(move |x| [x, y]))
        .map(move |[x, y]| Rect { x: area.x + x, y: area.y + y, width, height })
}

/// True for leaders that cross or come so near that one could be taken for the other.
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
        assert!(!taken.admits_leader([[0.0, 15.0], [30.0, 15.0]]), "it would run through the box");
        let leader = [[22.0, 0.0], [22.0, 20.0]];
        assert!(taken.admits_leader(leader));
        let beside = |other| {
            let mut taken = taken.clone();
            taken.take_leader(other);
            taken.admits_leader(leader)
        };
        assert!(!beside([[21.0, 10.0], [40.0, 12.0]]), "leaders would cross");
        assert!(!beside([[24.0, 0.0], [24.0, 20.0]]), "one could be taken for the other");
    }

    #[test]
    fn the_nearest_free_place_has_the_shortest_leader() {
        let mut taken = Taken::default();
        let area = Rect { x: 0.0, y: 0.0, width: 100.0, height: 40.0 };
        let labelled = Labelled { tips: &[[50.0, 10.0], [50.0, 30.0]], lengths: [5.0, 60.0], clearance: 1.0 };
        let mut place = || {
            let places = all_over(area, [20.0, 10.0], 5.0).map(|rect| (0.0, rect));
            taken.place_with_leader(&labelled, places, |_| 0.0)
        };
        let (first, leader) = place().unwrap();
        assert!((distance(leader[0], leader[1]) - 5.0).abs() < 1e-9 && !first.contains([50.0, 10.0]));
        let (second, other) = place().unwrap();
        assert!(!first.overlaps(&second) && !near(leader, other));
    }
}
