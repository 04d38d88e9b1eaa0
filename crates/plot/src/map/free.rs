//! Free places for texts with leaders.

use super::view::View;
use crate::page::{Point, Rect, Taken, distance};

/// Lengths of leaders, and the steps of the places that are tried for their texts.
const LEADER: [f64; 2] = [9.0, 260.0];
const STEP: f64 = 5.0;

/// What is taken is clear of everything else by so many pixels.
pub(super) const CLEAR: f64 = 1.5;

/// The nearest free place for a box of this size in the map, and the leader to it from one of the tips.
pub(super) fn beside(
    tips: &[Point],
    [width, height]: [f64; 2],
    view: &View,
    taken: &Taken,
    leaders: &[[Point; 2]],
) -> Option<(Rect, [Point; 2])> {
    let inner = view.rect.grown(-2.0);
    let steps = |length: f64| (0..).map(|k| f64::from(k) * STEP).take_while(move |at| *at <= length);
    let places = steps(inner.width - width)
        .flat_map(|x| steps(inner.height - height).map(move |y| [x, y]))
        .map(|[x, y]| Rect { x: inner.x + x, y: inner.y + y, width, height });
    let free: Vec<Rect> = places.filter(|rect| taken.admits_box(&rect.grown(CLEAR))).collect();
    let mut ways: Vec<(f64, Rect, Point)> = free
        .iter()
        .flat_map(|rect| tips.iter().map(|tip| (distance(*tip, rect.nearest(*tip)), *rect, *tip)))
        .filter(|(length, ..)| (LEADER[0]..=LEADER[1]).contains(length))
        .collect();
    ways.sort_by(|p, q| p.0.total_cmp(&q.0));
    ways.into_iter().find_map(|(_, rect, tip)| {
        let leader = [tip, rect.nearest(tip)];
        taken.admits_leader(leader, leaders).then_some((rect, leader))
    })
}
