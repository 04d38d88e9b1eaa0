//! Where the common range of two curves begins and ends.

use super::node::Node;
use crate::curves::Shape;
use crate::evaluator::{Evaluator, Passage, Point};
use crate::family::Half;
use bifdiag_equilibria::curves::{CurveId, End, PitchforkId};
use bifdiag_numbers::enclosure::Enclosure;

/// How the common range of two curves begins or ends.
pub(super) enum Side<E: Enclosure> {
    /// At a cusp that both share.
    Cusp(E),
    /// At a pitchfork that both share: the places on both.
    Pitchfork(E),
    /// One of them ends, the other is elsewhere.
    Node(Box<Node<E>>),
    Infinity,
    Origin,
}

impl<E: Enclosure> Evaluator<'_, E> {
    /// One curve ends at the very event at which the other begins.
    pub(super) fn touching(&self, [a, b]: [CurveId; 2]) -> Option<()> {
        let (p, q) = (&self.curves.list[a], &self.curves.list[b]);
        let same = |x: End, y: End| x == y && matches!(x, End::Cusp(_) | End::Pitchfork(_));
        (same(p.ends[1], q.ends[0]) || same(p.ends[0], q.ends[1])).then_some(())
    }

    /// x at which a curve ends; `None` when it cannot be enclosed.
    pub fn end_x(&self, curve: CurveId, side: usize) -> Option<E> {
        match self.curves.list[curve].ends[side] {
            End::Origin => Some(self.c.small(0)),
            End::Infinity => None,
            End::Cusp(_) | End::Pitchfork(_) => {
                if let Shape::Family(_) = self.curves.list[curve].shape {
                    self.end_point(curve, side).map(|point| point.x)
                } else if let End::Pitchfork(number) = self.curves.list[curve].ends[side] {
                    Some(self.pitchfork_x(number))
                } else {
                    None
                }
            }
        }
    }

    /// x of a pitchfork: on the pair that leaves there.
    pub fn pitchfork_x(&self, number: PitchforkId) -> E {
        let group = self.curves.pitchforks[number].group;
        self.state(Half::Over { group }, &self.c.small(0)).x
    }

    /// The point where a curve of a family ends.
    pub fn end_point(&self, curve: CurveId, side: usize) -> Option<Point<E>> {
        let Shape::Family(segments) = &self.curves.list[curve].shape else { return None };
        let segment = if side == 0 { segments.first()? } else { segments.last()? };
        let y = self.bound(segment, &segment.ends[side])?;
        Some(Point::at_end(segment.half, y.clone(), self.state(segment.half, &y), &self.c))
    }

    /// How the common range begins (side 0) or ends (side 1). `Some(None)`: it has no such end.
    #[allow(clippy::option_option)]
    pub(super) fn side(&self, curves: [CurveId; 2], side: usize) -> Option<Option<Side<E>>> {
        let ends = curves.map(|c| self.curves.list[c].ends[side]);
        match ends {
            [End::Infinity, End::Infinity] => return Some(Some(Side::Infinity)),
            [End::Origin, End::Origin] => return Some(Some(Side::Origin)),
            [End::Cusp(p), End::Cusp(q)] if p == q => {
                return Some(Some(Side::Cusp(self.end_point(curves[0], side)?.x)));
            }
            [End::Pitchfork(p), End::Pitchfork(q)] if p == q => {
                return Some(Some(Side::Pitchfork(self.pitchfork_x(p))));
            }
            _ => {}
        }
        // The later beginning, the earlier ending.
        let finite = |end: End| matches!(end, End::Cusp(_) | End::Pitchfork(_));
        let ending = match ends.map(finite) {
            [true, false] => 0,
            [false, true] => 1,
            [true, true] => {
                let x = [self.end_point(curves[0], side)?.x, self.end_point(curves[1], side)?.x];
                let second_later = if x[0].is_below(&x[1]) {
                    true
                } else if x[1].is_below(&x[0]) {
                    false
                } else {
                    return None;
                };
                usize::from(second_later == (side == 0))
            }
            [false, false] => return None,
        };
        let other = 1 - ending;
        let end = self.end_point(curves[ending], side)?;
        // The other curve may not reach this x at all.
        for far in [0, 1] {
            if let Some(limit) = self.end_x(curves[other], far) {
                let outside = if far == 0 { end.x.is_below(&limit) } else { limit.is_below(&end.x) };
                if outside {
                    return Some(None);
                }
                let strictly_inside = if far == 0 { limit.is_below(&end.x) } else { end.x.is_below(&limit) };
                if !strictly_inside {
                    // It ends where the other begins: no common range. Anything else is not decided here.
                    return self.touching(curves).map(|()| None);
                }
            }
        }
        let opposite = self.point(curves[other], &end.x)?;
        let at = if ending == 0 { [end, opposite] } else { [opposite, end] };
        let x = at[ending].x.clone();
        let node = self.node_of(x, true, at);
        let meet = self.meet_at(Passage { curve: curves[ending], side, other: curves[other] });
        Some(Some(Side::Node(Box::new(if meet { self.meeting(node) } else { node }))))
    }
}

pub(super) fn position<E: Enclosure>(side: &Side<E>) -> Option<E> {
    match side {
        Side::Cusp(x) | Side::Pitchfork(x) => Some(x.clone()),
        Side::Node(node) => Some(node.x.clone()),
        Side::Infinity | Side::Origin => None,
    }
}
