//! The rules by which the order of two curves follows from what is known at the ends of a stretch of x.
//!
//! Throughout, g is h of the first curve minus h of the second over the same x = l²/2, and `sign` the sign that is
//! claimed of it. Along a curve of critical values dh/dx = 1/J, so that dg/dx = 1/J₁ − 1/J₂ (Proposition 3.6); and J is
//! strictly monotone along a curve, except for one curve of the generic family on which it turns once, at the
//! inflection (Proposition 3.8).

use super::node::{Node, coordinate};
use super::orders::{Orders, Stand};
use crate::equilibria::pieces::{Branch, End, coordinates};
use crate::equilibria::places::{Point, Side};
use crate::numbers::fixed::Fixed;

/// g keeps its sign between two nodes, by one of four rules.
pub(crate) fn keeps_order(orders: &Orders, curves: [usize; 2], nodes: [&Node; 2], sign: i8) -> bool {
    let by_slopes = |slopes: &Fixed| stays_by_drift(nodes, slopes, sign) || stays_by_monotony(nodes, slopes, sign);
    slopes(orders, curves, nodes[0], Some(nodes[1])).is_some_and(|slopes| by_slopes(&slopes))
        || between(orders, curves, nodes).is_some_and(|[p, q]| {
            let stays_apart = orders.spaces.range_gap(&p, &q).and_then(|gap| gap.strict_sign()) == Some(sign);
            stays_apart
                || orders.spaces.over_one_x(&p, &q).is_some_and(|[moment, gap]| {
                    gap.strict_sign() == Some(sign)
                        || joint_slopes(&p, &q, &moment).is_some_and(|slopes| by_slopes(&slopes))
                })
        })
}

/// dg/dx = (J₂ − J₁)/(J₁J₂) from the difference of the moments over one x (Lemma 7.8).
fn joint_slopes(p: &Point, q: &Point, moment: &Fixed) -> Option<Fixed> {
    (-moment).over(&(&p.j * &q.j))
}

/// Lemma 7.2: g at a distance d from a node lies in g(node) ± d·dg/dx with dg/dx from all of the stretch. When
/// this set has the sign for every d up to the other node, so has g.
fn stays_by_drift([from, to]: [&Node; 2], slopes: &Fixed, sign: i8) -> bool {
    let drift = slopes * &(&to.x - &from.x).hull(&Fixed::whole(0));
    (&from.gap + &drift).strict_sign() == Some(sign) || (&to.gap - &drift).strict_sign() == Some(sign)
}

/// Lemma 7.1: where dg/dx is never 0, g lies strictly between its values at the nodes: it has the sign if both have it,
/// or if one has it and the other is 0.
fn stays_by_monotony([from, to]: [&Node; 2], slopes: &Fixed, sign: i8) -> bool {
    let settled = |node: &Node| node.gap.strict_sign() == Some(sign);
    slopes.strict_sign().is_some()
        && (settled(from) || from.meet)
        && (settled(to) || to.meet)
        && !(from.meet && to.meet)
}

/// Every equilibrium that the curves take between two nodes (Corollary 3.10 compares those of one with those of the other).
fn between(orders: &Orders, curves: [usize; 2], [from, to]: [&Node; 2]) -> Option<[Point; 2]> {
    let range = |which: usize| {
        let y = from.stands[which].y.as_ref()?.hull(to.stands[which].y.as_ref()?);
        over(orders, curves[which], &y)
    };
    Some([range(0)?, range(1)?])
}

/// Lemma 7.1: g has the sign before a box and the other behind it, and dg/dx has the other sign throughout: g has one
/// zero, and it lies in the box.
pub(crate) fn crosses_once(orders: &Orders, curves: [usize; 2], [from, low, high, to]: [&Node; 4], sign: i8) -> bool {
    let ordered = from.x.at_most(&low.x) && low.x.below(&high.x) && high.x.at_most(&to.x);
    let signs = low.gap.strict_sign() == Some(sign) && high.gap.strict_sign() == Some(-sign);
    let falls = |slopes: Fixed| slopes.strict_sign() == Some(-sign);
    ordered
        && signs
        && (slopes(orders, curves, from, Some(to)).is_some_and(falls)
            || between(orders, curves, [from, to]).is_some_and(|[p, q]| {
                let joint = orders.spaces.over_one_x(&p, &q).and_then(|[moment, _]| joint_slopes(&p, &q, &moment));
                joint.is_some_and(falls)
            }))
}

/// Lemma 7.4, from a common cusp: there g = 0, and J is strictly monotone from one curve through the cusp to the other
/// unless it turns between the nodes, so that dg/dx has one sign up to the node, which is its sign there.
pub(crate) fn leaves_cusp(orders: &Orders, curves: [usize; 2], node: &Node, side: usize, sign: i8) -> bool {
    let straight = match orders.turn(curves[0]) {
        Some(bend) => {
            let mu = |which: usize| first_tau(&node.stands[which].point);
            let turn = first_tau(bend);
            mu(0).zip(mu(1)).zip(turn).is_some_and(|((p, q), turn)| on_one_side(p, q, turn))
        }
        None => true,
    };
    let one = Fixed::whole(1);
    let [p, q] = node.stands.each_ref().map(|stand| one.over(&stand.point.j));
    let slopes = p.zip(q).and_then(|(p, q)| (&p - &q).strict_sign());
    straight && slopes == Some(if side == 0 { sign } else { -sign })
}

/// Lemma 7.3, from a common pitchfork: there g = 0 and dg/dx = 0, since the curves share the equilibrium; so g has the
/// sign of d²g/dx² if that is the same everywhere up to the node. d(1/J)/dx = −J′/(J² x (ln x)′) with derivatives by y; (ln x)′ may
/// be 0 at the end, where the pair has a cusp, but not before the node, since pieces end at cusps: it has the sign that it has there.
pub(crate) fn leaves_pitchfork(orders: &Orders, curves: [usize; 2], node: &Node, side: usize, sign: i8) -> bool {
    let curvature = |which: usize| {
        let end = orders.pieces.end_point(orders.spaces, curves[which], side)?;
        let y = coordinate(orders, curves[which], &end)?.hull(node.stands[which].y.as_ref()?);
        let range = over(orders, curves[which], &y)?;
        let [log_slope, j_slope] = range.slopes?;
        let inside = node.stands[which].point.slopes.as_ref().and_then(|[log_slope, _]| log_slope.strict_sign());
        Some((-&j_slope.over(&(&range.j.square() * &range.x))?, log_slope, inside))
    };
    let difference = curvature(0).zip(curvature(1)).and_then(|((p, dp, p_inside), (q, dq, q_inside))| {
        let apart = || (&p.over(&dp)? - &q.over(&dq)?).strict_sign();
        let across = || Some((&(&p * &dq) - &(&q * &dp)).strict_sign()? * p_inside? * q_inside?);
        apart().or_else(across)
    });
    difference == Some(sign)
}

/// Lemma 7.1: g has the sign at the node, and dg/dx has it from there to infinity.
pub(crate) fn parts_for_ever(orders: &Orders, curves: [usize; 2], node: &Node, sign: i8) -> bool {
    let slopes = slopes(orders, curves, node, None);
    node.gap.strict_sign() == Some(sign) && slopes.and_then(|slopes| slopes.strict_sign()) == Some(sign)
}

/// Proposition 6.2: both curves tend to the axis of the same space, h − x/a to ∓√q. Where J stays on one side of a, h −
/// x/a is monotone and so lies between its value at the node and its limit: g has the sign if all of one range lies on
/// that side of the other.
pub(crate) fn tends_to_one_axis(orders: &Orders, curves: [usize; 2], node: &Node, sign: i8) -> bool {
    let [Some(p), Some(q)] = curves.map(|c| orders.pieces.list[c].limit) else {
        return false;
    };
    if node.gap.strict_sign() != Some(sign) || p.0 != q.0 {
        return false;
    }
    let space = &orders.spaces.list[p.0];
    let excess = |which: usize, end: i8| {
        let stand = &node.stands[which];
        let range = moments(orders, curves[which], stand, None)?;
        let straight = range.inside(&stand.point.j.hull(&space.a_set));
        let kinetic = (&node.x * &(&space.a_set - &stand.point.j)).over(&(&stand.point.j * &space.a_set))?;
        let now = &kinetic - &stand.point.rho;
        let limit = &Fixed::whole(i32::from(-end)) * &space.root_q;
        straight.then(|| now.hull(&limit))
    };
    let ranges = excess(0, p.1).zip(excess(1, q.1));
    ranges.and_then(|(p, q)| (&p - &q).strict_sign()) == Some(sign)
}

/// Lemma 7.7: where r lies on one axis, of two families over moments on one side of that axis' moment that are both
/// unbounded, or both not, the one over the smaller moment is the higher, wherever both run.
pub(crate) fn ordered_on_axis(orders: &Orders, curves: [usize; 2]) -> Option<i8> {
    let [active] = orders.spaces.active[..] else {
        return None;
    };
    let [p, q] = curves.map(|curve| &orders.pieces.list[curve]);
    let (Branch::Over(first), Branch::Over(second)) = (p.branch, q.branch) else {
        return None;
    };
    let goes_on = [p, q].map(|piece| piece.ends[1] == End::Infinity);
    let comparable = first != second && (first < active) == (second < active) && goes_on[0] == goes_on[1];
    comparable.then_some(if first < second { 1 } else { -1 })
}

/// dg/dx between two nodes, or from a node to infinity.
fn slopes(orders: &Orders, curves: [usize; 2], from: &Node, to: Option<&Node>) -> Option<Fixed> {
    let slope = |which: usize| {
        let j = moments(orders, curves[which], &from.stands[which], to.map(|node| &node.stands[which]))?;
        Fixed::whole(1).over(&j)
    };
    Some(&slope(0)? - &slope(1)?)
}

/// J of a curve between two nodes, or from a node to infinity: between its values at the ends, and at the inflection if
/// that may lie between them.
fn moments(orders: &Orders, curve: usize, from: &Stand, to: Option<&Stand>) -> Option<Fixed> {
    let piece = &orders.pieces.list[curve];
    let limit = || Some(&orders.spaces.list[piece.limit?.0].a_set);
    let end = match to {
        Some(stand) => stand.point.j.clone(),
        None => limit()?.clone(),
    };
    let range = from.point.j.hull(&end);
    let Some(bend) = orders.turn(curve) else {
        return Some(range);
    };
    let last = match to {
        Some(stand) => first_tau(&stand.point)?.clone(),
        None => limit()? - &orders.spaces.list[0].a_set,
    };
    let straight = on_one_side(first_tau(&from.point)?, &last, first_tau(bend)?);
    Some(if straight { range } else { range.hull(&bend.j) })
}

/// μ, measured from the smallest moment.
fn first_tau(point: &Point) -> Option<&Fixed> {
    point.tau.as_ref()?.first()
}

fn on_one_side(p: &Fixed, q: &Fixed, turn: &Fixed) -> bool {
    (p.below(turn) && q.below(turn)) || (turn.below(p) && turn.below(q))
}

/// All equilibria of a curve over a range of its coordinate.
pub(crate) fn over(orders: &Orders, curve: usize, y: &Fixed) -> Option<Point> {
    let spaces = orders.spaces;
    match orders.pieces.list[curve].branch {
        Branch::Generic(number) => {
            let (base, side) = coordinates(spaces, number);
            // Measured from the nearer moment the range is narrower.
            let far = spaces.active.get(number).filter(|_| number > 0);
            let other = far.and_then(|&k| {
                let rest = spaces.difference(k, base) - y;
                rest.below(y).then_some((k, rest))
            });
            match other {
                Some((k, y)) => spaces.point(k, Side::Minus, &y),
                None => spaces.point(base, side, y),
            }
        }
        Branch::Over(base) => spaces.point(base, Side::Over, y),
        Branch::Line(_) | Branch::Rotation(_) => None,
    }
}
