//! Checks the order of two curves, stretch by stretch.

use super::Refused;
use super::family::{Place, Point, Side, Spaces};
use super::fixed::Fixed;
use super::pieces::{End, Family, Pieces, coordinates, distance};
use schema::{CertifiedNode, CertifiedPair, CertifiedStretch, PlaceDocument};

/// Newton steps that sharpen a place: each doubles its digits.
const STEPS: usize = 4;

/// A curve over one x.
#[derive(Clone, Debug)]
pub(super) struct Stand {
    /// y in the coordinate of the curve's interval.
    y: Option<Fixed>,
    pub point: Point,
}

/// Both curves over one x.
struct Node {
    x: Fixed,
    stands: [Stand; 2],
    /// Sign of the gap; 0 where the curves are known to meet.
    gap: Fixed,
    meet: bool,
}

/// Checks curves and pairs.
pub(super) struct Orders<'a> {
    pub spaces: &'a Spaces,
    pub pieces: &'a Pieces,
    /// μ at the one place where dJ/dμ = 0, and the equilibrium there.
    pub inflection: Option<(usize, Point)>,
    /// (curve, side, other): the other passes through this end, proved by gcd.
    pub meetings: Vec<(usize, usize, usize)>,
}

impl Orders<'_> {
    /// The equilibrium of a curve over x, from the place that the certificate names: x of both its ends must enclose x.
    pub fn stand(&self, curve: usize, place: Option<&PlaceDocument>, x: &Fixed) -> Result<Stand, Refused> {
        let piece = &self.pieces.list[curve];
        let refused = || Refused::Place { curve: piece.id.clone(), x: x.to_f64() };
        let family = match piece.family {
            Family::Line(plus) => {
                let point = self.spaces.line(plus, x).ok_or_else(refused)?;
                return Ok(Stand { y: None, point });
            }
            Family::Rotation(base) => {
                return Ok(Stand { y: None, point: self.spaces.rotation(base, x) });
            }
            family => family,
        };
        let place = place.and_then(Place::read).ok_or_else(refused)?;
        if place.base >= self.spaces.list.len() {
            return Err(refused());
        }
        let (base, side) = match family {
            Family::Generic(number) if place.side != Side::Over => coordinates(self.spaces, number),
            Family::Over(base) if place.side == Side::Over && place.base == base => (base, Side::Over),
            _ => return Err(refused()),
        };
        let [low, high] = place.range(self.spaces);
        // The place lies on this curve: between its ends' enclosures.
        let before = piece.range[0].as_ref().is_some_and(|end| low < end[0]);
        let after = piece.range[1].as_ref().is_some_and(|end| high > end[1]);
        let outside = match family {
            Family::Generic(number) => {
                let left = number.checked_sub(1).map(|n| &self.spaces.list[self.spaces.active[n]].a);
                let right = self.spaces.active.get(number).map(|&k| &self.spaces.list[k].a);
                left.is_some_and(|a| low <= *a) || right.is_some_and(|a| high >= *a)
            }
            _ => low < dashu_ratio::RBig::ZERO,
        };
        if before || after || outside {
            return Err(refused());
        }
        let y_of = |mu| if side == Side::Over { mu } else { distance(self.spaces, base, side, &mu) };
        let ends = [Fixed::of(&y_of(low.clone())), Fixed::of(&y_of(high.clone()))];
        let state = |y: &Fixed| self.spaces.point(base, side, y).ok_or_else(refused);
        // x at both ends of the place; an end inside the enclosure of a cusp or pitchfork needs no comparison.
        let at_station = [
            piece.range[0].as_ref().is_some_and(|end| low <= end[1]),
            piece.range[1].as_ref().is_some_and(|end| high >= end[0]),
        ];
        for (which, y) in ends.iter().enumerate() {
            if at_station[which] {
                continue;
            }
            let smaller_x = (which == 0) == piece.rising;
            let reached = state(y)?.x;
            let holds = if smaller_x { reached.at_most(x) } else { x.at_most(&reached) };
            if !holds {
                return Err(refused());
            }
        }
        let mut y = ends[0].hull(&ends[1]);
        for _ in 0..STEPS {
            let middle = y.middle();
            let (at, over) = (state(&middle)?, state(&y)?);
            let Some([log_slope, _]) = &over.slopes else { break };
            let Some(step) = (&at.x - x).over(&(&over.x * log_slope)) else { break };
            let Some(next) = y.meet(&(&middle - &step)) else { return Err(refused()) };
            if next == y {
                break;
            }
            y = next;
        }
        Ok(Stand { point: state(&y)?, y: Some(y) })
    }

    fn node(&self, curves: [usize; 2], x: Fixed, places: Option<&[PlaceDocument; 2]>) -> Result<Node, Refused> {
        let first = self.stand(curves[0], places.map(|p| &p[0]), &x)?;
        let second = self.stand(curves[1], places.map(|p| &p[1]), &x)?;
        self.node_of(curves, x, [first, second])
    }

    fn node_of(&self, curves: [usize; 2], x: Fixed, stands: [Stand; 2]) -> Result<Node, Refused> {
        let gap = self
            .spaces
            .gap(&x, &stands[0].point, &stands[1].point)
            .ok_or_else(|| self.pair_refused(curves, &x, "its heights cannot be compared"))?;
        Ok(Node { x, stands, gap, meet: false })
    }

    fn pair_refused(&self, curves: [usize; 2], x: &Fixed, why: &'static str) -> Refused {
        Refused::Pair { curves: curves.map(|c| self.pieces.list[c].id.clone()), x: x.to_f64(), why }
    }

    /// The common range of two curves: how it begins and ends. `None` when it is empty.
    pub fn common_range(&self, curves: [usize; 2]) -> Result<Option<[Option<Fixed>; 2]>, Refused> {
        let end = |curve: usize, side: usize| self.pieces.end_x(self.spaces, curve, side);
        let (p, q) = ([end(curves[0], 0)?, end(curves[0], 1)?], [end(curves[1], 0)?, end(curves[1], 1)?]);
        let touching = |a: usize, b: usize| {
            let (upper, lower) = (self.pieces.list[a].ends[1], self.pieces.list[b].ends[0]);
            upper == lower && matches!(upper, End::Cusp(_) | End::Pitchfork(_))
        };
        for (upper, lower, a, b) in [(&p[1], &q[0], curves[0], curves[1]), (&q[1], &p[0], curves[1], curves[0])] {
            if let (Some(upper), Some(lower)) = (upper, lower)
                && (upper.at_most(lower) || touching(a, b))
            {
                return Ok(None);
            }
        }
        let later = |a: &Option<Fixed>, b: &Option<Fixed>| match (a, b) {
            (Some(a), Some(b)) => Some(if a.below(b) { b.clone() } else { a.clone() }),
            _ => None,
        };
        let earlier = |a: &Option<Fixed>, b: &Option<Fixed>| match (a, b) {
            (Some(a), Some(b)) => Some(if b.below(a) { b.clone() } else { a.clone() }),
            (Some(a), None) => Some(a.clone()),
            (None, b) => b.clone(),
        };
        Ok(Some([later(&p[0], &q[0]), earlier(&p[1], &q[1])]))
    }

    /// Checks a pair; the boxes of its crossings are returned.
    pub fn pair(&self, curves: [usize; 2], pair: &CertifiedPair) -> Result<Vec<[Fixed; 2]>, Refused> {
        let zero = Fixed::whole(0);
        let refuse = |why| self.pair_refused(curves, &zero, why);
        let mut crossings = Vec::new();
        let count = pair.stretches.len();
        let mut sign_before: Option<i8> = None;
        for (number, stretch) in pair.stretches.iter().enumerate() {
            let joined = number == 0 || pair.stretches[number - 1].to == stretch.from;
            let ends_inside =
                (number > 0 && stretch.from.x.is_none()) || (number + 1 < count && stretch.to.x.is_none());
            let ends_early =
                (number == 0 && stretch.from.x.is_some()) || (number + 1 == count && stretch.to.x.is_some());
            if !joined || ends_inside || ends_early {
                return Err(refuse("its stretches leave a gap"));
            }
            if !matches!(stretch.sign, -1 | 1) || sign_before.is_some_and(|sign| sign != stretch.sign) {
                return Err(refuse("its signs contradict each other"));
            }
            crossings.extend(self.stretch(curves, stretch)?);
            sign_before = Some(if stretch.crossing.is_some() { -stretch.sign } else { stretch.sign });
        }
        if count == 0 { Err(refuse("nothing is claimed of it")) } else { Ok(crossings) }
    }

    fn stretch(&self, curves: [usize; 2], stretch: &CertifiedStretch) -> Result<Option<[Fixed; 2]>, Refused> {
        let from = self.read(curves, &stretch.from, 0)?;
        let to = self.read(curves, &stretch.to, 1)?;
        let at = from.as_ref().or(to.as_ref()).map_or_else(|| Fixed::whole(0), |node| node.x.clone());
        let refuse = |why| self.pair_refused(curves, &at, why);
        let sign = stretch.sign;
        if let (Some(p), Some(q)) = (&from, &to)
            && !p.x.below(&q.x)
        {
            return Err(refuse("a stretch runs backwards"));
        }
        if let Some(boxed) = &stretch.crossing {
            let (Some(from), Some(to)) = (&from, &to) else { return Err(refuse("a crossing has no box")) };
            let [first, last] = boxed;
            let inner = [self.read(curves, first, 0)?, self.read(curves, last, 1)?];
            let [Some(low), Some(high)] = inner else { return Err(refuse("a crossing has no box")) };
            let ordered = from.x.at_most(&low.x) && low.x.below(&high.x) && high.x.at_most(&to.x);
            let signs = strict(&low.gap) == Some(sign) && strict(&high.gap) == Some(-sign);
            let monotone = self.slopes(curves, from, Some(to)).and_then(|slopes| strict(&slopes)) == Some(-sign);
            return if ordered && signs && monotone {
                Ok(Some([low.x, high.x]))
            } else {
                Err(refuse("a crossing is not where the certificate says, or not the only one there"))
            };
        }
        let holds = match (&from, &to) {
            (Some(from), Some(to)) => self.constant(curves, from, to, sign),
            (Some(from), None) => match self.pieces.list[curves[0]].ends[1] {
                End::Infinity => self.far(curves, from, sign),
                _ => self.beside(curves, from, 1, sign),
            },
            (None, Some(to)) => self.beside(curves, to, 0, sign),
            (None, None) => false,
        };
        if holds { Ok(None) } else { Err(refuse("the order that is claimed does not follow")) }
    }

    /// A node; `None` at an end that both curves share, or at infinity.
    fn read(&self, curves: [usize; 2], node: &CertifiedNode, side: usize) -> Result<Option<Node>, Refused> {
        let zero = Fixed::whole(0);
        if let Some(text) = &node.x {
            let x = super::number(text).ok_or_else(|| Refused::Number { text: text.clone() })?;
            return self.node(curves, Fixed::of(&x), node.places.as_ref()).map(Some);
        }
        let ends = curves.map(|c| self.pieces.list[c].ends[side]);
        if ends[0] == ends[1] {
            return Ok(None);
        }
        let refuse = |why| self.pair_refused(curves, &zero, why);
        let range = self.common_range(curves)?.ok_or_else(|| refuse("the curves have no common range"))?;
        let x = range[side].clone().ok_or_else(|| refuse("an end is missing"))?;
        // Which of the two ends there.
        let own = |c: usize| self.pieces.end_x(self.spaces, c, side);
        let reaches = [own(curves[0])?, own(curves[1])?];
        let ending = match &reaches {
            [Some(p), Some(q)] if p.below(q) => usize::from(side == 0),
            [Some(p), Some(q)] if q.below(p) => usize::from(side == 1),
            [Some(_), None] => 0,
            [None, Some(_)] => 1,
            _ => return Err(refuse("two ends are not told apart")),
        };
        let point =
            self.pieces.end_point(self.spaces, curves[ending], side).ok_or_else(|| refuse("an end is missing"))?;
        let y = self.coordinate(curves[ending], &point);
        let end = Stand { y, point };
        let other = self.stand(curves[1 - ending], node.places.as_ref().map(|p| &p[1 - ending]), &x)?;
        let stands = if ending == 0 { [end, other] } else { [other, end] };
        let mut node = self.node_of(curves, x, stands)?;
        node.meet = self.meetings.contains(&(curves[ending], side, curves[1 - ending]));
        Ok(Some(node))
    }

    /// y of an equilibrium in the coordinate of its curve.
    fn coordinate(&self, curve: usize, point: &Point) -> Option<Fixed> {
        let tau = point.tau.as_ref()?;
        match self.pieces.list[curve].family {
            Family::Generic(number) => {
                let (base, side) = coordinates(self.spaces, number);
                Some(if side == Side::Minus { -&tau[base] } else { tau[base].clone() })
            }
            Family::Over(base) => self.over_coordinate(base, point),
            _ => None,
        }
    }

    /// y over a space: y/v = γ², v = P̂/(1 − γ²).
    fn over_coordinate(&self, base: usize, point: &Point) -> Option<Fixed> {
        let (_, p_sum) = self.spaces.sums(base);
        let part = point.gamma[base].square();
        let v = Fixed::of(&p_sum).over(&(&Fixed::whole(1) - &part))?;
        Some(&v * &part)
    }

    /// J between two nodes of a curve, or to infinity.
    fn moments(&self, curve: usize, from: &Stand, to: Option<&Stand>) -> Option<Fixed> {
        let piece = &self.pieces.list[curve];
        let end = match to {
            Some(stand) => stand.point.j.clone(),
            None => self.spaces.list[piece.limit?.0].a_set.clone(),
        };
        let range = from.point.j.hull(&end);
        let (Family::Generic(number), Some((at, bend))) = (piece.family, &self.inflection) else { return Some(range) };
        if *at != number {
            return Some(range);
        }
        let mu = |stand: &Stand| stand.point.tau.as_ref().map(|tau| tau[0].clone());
        let last = match to {
            Some(stand) => mu(stand)?,
            None => &self.spaces.list[piece.limit?.0].a_set - &self.spaces.list[0].a_set,
        };
        let turn = bend.tau.as_ref()?[0].clone();
        let (first, same) =
            (mu(from)?, |a: &Fixed, b: &Fixed| (a.below(&turn) && b.below(&turn)) || (turn.below(a) && turn.below(b)));
        Some(if same(&first, &last) { range } else { range.hull(&bend.j) })
    }

    fn slopes(&self, curves: [usize; 2], from: &Node, to: Option<&Node>) -> Option<Fixed> {
        let slope = |which: usize| {
            let j = self.moments(curves[which], &from.stands[which], to.map(|node| &node.stands[which]))?;
            Fixed::whole(1).over(&j)
        };
        Some(&slope(0)? - &slope(1)?)
    }

    fn constant(&self, curves: [usize; 2], from: &Node, to: &Node, sign: i8) -> bool {
        if let Some(slopes) = self.slopes(curves, from, Some(to)) {
            let reach = (&to.x - &from.x).hull(&Fixed::whole(0));
            let drift = &slopes * &reach;
            if strict(&(&from.gap + &drift)) == Some(sign) || strict(&(&to.gap - &drift)) == Some(sign) {
                return true;
            }
            if strict(&slopes).is_some() {
                let settled = |node: &Node| strict(&node.gap) == Some(sign);
                if (settled(from) || from.meet) && (settled(to) || to.meet) && !(from.meet && to.meet) {
                    return true;
                }
            }
        }
        self.over_range(curves, from, to).is_some_and(|gap| strict(&gap) == Some(sign))
    }

    fn over_range(&self, curves: [usize; 2], from: &Node, to: &Node) -> Option<Fixed> {
        let range = |which: usize| {
            let y = from.stands[which].y.as_ref()?.hull(to.stands[which].y.as_ref()?);
            self.over(curves[which], &y)
        };
        self.spaces.range_gap(&range(0)?, &range(1)?)
    }

    /// All equilibria of a curve over a range of its coordinate.
    fn over(&self, curve: usize, y: &Fixed) -> Option<Point> {
        match self.pieces.list[curve].family {
            Family::Generic(number) => {
                let (base, side) = coordinates(self.spaces, number);
                // The nearer moment gives sharper ranges.
                let far = self.spaces.active.get(number).filter(|_| number > 0);
                let other = far.and_then(|&k| {
                    let width = &self.spaces.list[k].a_set - &self.spaces.list[base].a_set;
                    let y = &width - y;
                    let half = &width - &y;
                    y.below(&half).then_some((k, y))
                });
                match other {
                    Some((k, y)) => self.spaces.point(k, Side::Minus, &y),
                    None => self.spaces.point(base, side, y),
                }
            }
            Family::Over(base) => self.spaces.point(base, Side::Over, y),
            _ => None,
        }
    }

    /// Beside a common cusp or pitchfork.
    fn beside(&self, curves: [usize; 2], node: &Node, side: usize, sign: i8) -> bool {
        match self.pieces.list[curves[0]].ends[side] {
            End::Cusp(_) => {
                // J is strictly monotone from one curve through the cusp to the other.
                let straight = match (self.pieces.list[curves[0]].family, &self.inflection) {
                    (Family::Generic(number), Some((at, bend))) if *at == number => {
                        let mu = |which: usize| node.stands[which].point.tau.as_ref().map(|tau| tau[0].clone());
                        let (Some(p), Some(q), Some(turn)) = (mu(0), mu(1), bend.tau.as_ref().map(|tau| &tau[0]))
                        else {
                            return false;
                        };
                        (p.below(turn) && q.below(turn)) || (turn.below(&p) && turn.below(&q))
                    }
                    _ => true,
                };
                let one = Fixed::whole(1);
                let slopes = one
                    .over(&node.stands[0].point.j)
                    .zip(one.over(&node.stands[1].point.j))
                    .and_then(|(p, q)| strict(&(&p - &q)));
                straight && slopes == Some(if side == 0 { sign } else { -sign })
            }
            End::Pitchfork(_) => {
                let curvature = |which: usize| {
                    let end = self.pieces.end_point(self.spaces, curves[which], side)?;
                    let y = self.coordinate(curves[which], &end)?.hull(node.stands[which].y.as_ref()?);
                    let range = self.over(curves[which], &y)?;
                    let [log_slope, j_slope] = range.slopes?;
                    Some(-&j_slope.over(&(&(&range.j.square() * &range.x) * &log_slope))?)
                };
                let difference = curvature(0).zip(curvature(1)).map(|(p, q)| &p - &q);
                difference.and_then(|d| strict(&d)) == Some(sign)
            }
            _ => false,
        }
    }

    fn far(&self, curves: [usize; 2], node: &Node, sign: i8) -> bool {
        if strict(&node.gap) != Some(sign) {
            return false;
        }
        if self.slopes(curves, node, None).and_then(|slopes| strict(&slopes)) == Some(sign) {
            return true;
        }
        let limits = curves.map(|c| self.pieces.list[c].limit);
        let [Some(p), Some(q)] = limits else { return false };
        if p.0 != q.0 {
            return false;
        }
        // h − x/a is monotone where J stays on one side of a, and its limit is known.
        let excess = |which: usize, (base, end): (usize, i8)| {
            let stand = &node.stands[which];
            let space = &self.spaces.list[base];
            let range = self.moments(curves[which], stand, None)?;
            let straight = range.inside(&stand.point.j.hull(&space.a_set));
            let kinetic = (&node.x * &(&space.a_set - &stand.point.j)).over(&(&stand.point.j * &space.a_set))?;
            let now = &kinetic - &stand.point.rho;
            let limit = &Fixed::whole(i32::from(-end)) * &space.root_q;
            straight.then(|| now.hull(&limit))
        };
        excess(0, p).zip(excess(1, q)).is_some_and(|(p, q)| strict(&(&p - &q)) == Some(sign))
    }
}

fn strict(set: &Fixed) -> Option<i8> {
    set.sign().filter(|sign| *sign != 0)
}
