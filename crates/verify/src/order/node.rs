//! Where two curves are compared: nodes of their common range.

use bifdiag_schema::{CertifiedNode, PlaceDocument};

use super::orders::{Orders, Stand};
use crate::Refused;
use crate::equilibria::pieces::{Branch, coordinates};
use crate::equilibria::places::{Place, Point, Side};
use crate::numbers::fixed::Fixed;
use crate::numbers::number;

/// Both curves over one x.
pub(crate) struct Node {
    pub x: Fixed,
    pub stands: [Stand; 2],
    /// h of the first curve minus h of the second.
    pub gap: Fixed,
    /// The gap is exactly 0.
    pub meet: bool,
}

/// A node; `None` at an end that both curves share, or at infinity. `side` is the end of the common range that one
/// without x is.
pub(crate) fn read(
    orders: &Orders,
    curves: [usize; 2],
    node: &CertifiedNode,
    side: usize,
) -> Result<Option<Node>, Refused> {
    if let Some(text) = &node.x {
        let x = orders.spaces.set(&number::read(text)?);
        let place = |which: usize| node.places.as_ref().map(|places| &places[which]);
        let stands = [orders.stand(curves[0], place(0), &x)?, orders.stand(curves[1], place(1), &x)?];
        return compare(orders, curves, x, stands, false).map(Some);
    }
    let ends = curves.map(|c| orders.pieces.list[c].ends[side]);
    match (ends[0] == ends[1], &node.places) {
        (true, None) => Ok(None),
        (true, Some(_)) => Err(orders.refused(curves, 0.0, "places are given where none are needed")),
        (false, _) => at_end(orders, curves, node, side).map(Some),
    }
}

/// The node at an end of one curve where the other continues above or below.
fn at_end(orders: &Orders, curves: [usize; 2], node: &CertifiedNode, side: usize) -> Result<Node, Refused> {
    let refuse = |why| orders.refused(curves, 0.0, why);
    let range = common_range(orders, curves).ok_or_else(|| refuse("the curves have no common range"))?;
    let missing = || refuse("an end is missing");
    let x = range[side].cloned().ok_or_else(missing)?;
    let ending = match curves.map(|curve| orders.pieces.end_x(curve, side)) {
        [Some(p), Some(q)] if p.below(q) => usize::from(side == 0),
        [Some(p), Some(q)] if q.below(p) => usize::from(side == 1),
        [Some(_), None] => 0,
        [None, Some(_)] => 1,
        _ => return Err(refuse("two ends are not told apart")),
    };
    let point = orders.pieces.end_point(orders.spaces, curves[ending], side).ok_or_else(missing)?;
    if !is_end_held(orders, curves[ending], node.places.as_ref().map(|p| &p[ending]), side) {
        return Err(refuse("the place of an end is another"));
    }
    let end = Stand { y: coordinate(orders, curves[ending], &point), point };
    let other = orders.stand(curves[1 - ending], node.places.as_ref().map(|p| &p[1 - ending]), &x)?;
    let stands = if ending == 0 { [end, other] } else { [other, end] };
    let meet = orders.meetings.contains(&(curves[ending], side, curves[1 - ending]));
    compare(orders, curves, x, stands, meet)
}

/// A place holds the range in which the end of a curve is known to lie, or is absent where the other curve needs none.
fn is_end_held(orders: &Orders, curve: usize, place: Option<&PlaceDocument>, side: usize) -> bool {
    let piece = &orders.pieces.list[curve];
    let Some(place) = place else { return true };
    let end = &piece.range[if piece.rising { side } else { 1 - side }];
    let (Some(place), Some([low, high])) = (Place::read(place, orders.spaces), end) else {
        return false;
    };
    let [from, to] = place.range(orders.spaces);
    let of_branch = match piece.branch {
        Branch::Over(base) => place.side == Side::Over && place.base == base,
        _ => place.side != Side::Over,
    };
    of_branch && from <= *low && *high <= to
}

fn compare(orders: &Orders, curves: [usize; 2], x: Fixed, stands: [Stand; 2], meet: bool) -> Result<Node, Refused> {
    match orders.spaces.gap(&x, &stands[0].point, &stands[1].point) {
        Some(gap) => Ok(Node { x, stands, gap, meet }),
        None => Err(orders.refused(curves, x.to_f64(), "its heights cannot be compared")),
    }
}

/// The common range of two curves: how it begins and ends. `None` when it is empty.
pub(crate) fn common_range<'a>(orders: &Orders<'a>, curves: [usize; 2]) -> Option<[Option<&'a Fixed>; 2]> {
    let pieces = orders.pieces;
    let [p, q] = curves.map(|curve| [0, 1].map(|side| pieces.end_x(curve, side)));
    let touching = |a: usize, b: usize| {
        let upper = pieces.list[a].ends[1];
        upper == pieces.list[b].ends[0] && upper.is_station()
    };
    for (upper, lower, a, b) in [(p[1], q[0], curves[0], curves[1]), (q[1], p[0], curves[1], curves[0])] {
        if let (Some(upper), Some(lower)) = (upper, lower)
            && (upper.at_most(lower) || touching(a, b))
        {
            return None;
        }
    }
    let later = match (p[0], q[0]) {
        (Some(a), Some(b)) => Some(if a.below(b) { b } else { a }),
        _ => None,
    };
    let earlier = match (p[1], q[1]) {
        (Some(a), Some(b)) => Some(if b.below(a) { b } else { a }),
        (a, b) => a.or(b),
    };
    Some([later, earlier])
}

/// y of an equilibrium in the coordinate of its curve.
pub(crate) fn coordinate(orders: &Orders, curve: usize, point: &Point) -> Option<Fixed> {
    let tau = point.tau.as_ref()?;
    match orders.pieces.list[curve].branch {
        Branch::Generic(number) => {
            let (base, side) = coordinates(orders.spaces, number);
            Some(if side == Side::Minus { -&tau[base] } else { tau[base].clone() })
        }
        Branch::Over(base) => {
            // y/v = γ² and v = P̂ + y, so that v = P̂/(1 − γ²).
            let (_, p_sum) = orders.spaces.sums(base);
            let part = point.gamma[base].square();
            let v = orders.spaces.set(&p_sum).over(&(&Fixed::whole(1) - &part))?;
            Some(&v * &part)
        }
        Branch::Line(_) | Branch::Rotation(_) => None,
    }
}
