//! The order of two critical curves over all their common range of x: stretches on which the sign of h_a − h_b is proved,
//! and crossings, each alone in its box.
//!
//! On a stretch the slopes 1/J lie between their end values (J is monotone but for one known place). If they are
//! disjoint, the gap is monotone and its signs at the ends tell whether the curves cross, once. Otherwise the gap is
//! bounded from one end, by the identity of [`Evaluator::range_sign`], or by the lemmas of `mirror`; otherwise the stretch is halved. Both ends of
//! the half-line are closed by limits: a common cusp by the monotony of J through it, a common pitchfork by curvature,
//! x → ∞ by the limits of slope and of h − x/a.

use dashu_ratio::RBig;

use super::curves::{Place, Shape};
use super::family::Half;
use super::plane::rounded;
use super::point::{Evaluator, Passage, Point};
use numbers::Sign;
use numbers::enclosure::Enclosure;
use top::curves::{CurveId, End, PitchforkId};

/// How deep a stretch is halved.
const DEPTH: u32 = 48;
/// How often x is multiplied by 8 on the way to infinity.
const FAR: u32 = 90;

/// How many points of curves the order of two curves may cost in one precision: a count of work, so that the answer does
/// not depend on the machine.
pub(super) const POINTS: u32 = 4000;

/// What ends a stretch.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Mark {
    /// The lower or upper end of the common range.
    End,
    /// This x.
    At(RBig),
}

/// A stretch with a proved sign of h_a − h_b, or with one crossing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stretch {
    pub x: [Mark; 2],
    /// Sign at the lower end.
    pub sign: Sign,
    pub proof: Proof,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Proof {
    /// One sign all along.
    Constant,
    /// The gap is monotone and vanishes once, between these two.
    Crossing([RBig; 2]),
}

/// Everything about one pair.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PairProof {
    pub curves: [CurveId; 2],
    pub stretches: Vec<Stretch>,
}

/// What was not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Open {
    pub x: [f64; 2],
}

/// Both curves over one x.
#[derive(Clone, Debug)]
struct Node<E: Enclosure> {
    x: E,
    /// One of the two curves ends here.
    is_end: bool,
    at: [Point<E>; 2],
    sign: Option<Sign>,
    gap: E,
}

impl<E: Enclosure> Node<E> {
    fn mark(&self) -> Mark {
        let at = self.x.exact_bounds().filter(|_| !self.is_end);
        at.map_or(Mark::End, |[at, _]| Mark::At(at))
    }
}

/// How the common range of two curves begins or ends.
enum Side<E: Enclosure> {
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
    /// The order of curves a and b, neither of which is a line or structurally lowest. `None` when they have no common x.
    pub fn pair(&self, a: CurveId, b: CurveId) -> Result<Option<PairProof>, Open> {
        self.allow(POINTS);
        let curves = [a, b];
        let anywhere = Open { x: [0.0, f64::INFINITY] };
        let lower = self.side(curves, 0).ok_or(anywhere)?;
        let upper = self.side(curves, 1).ok_or(anywhere)?;
        let (Some(lower), Some(upper)) = (lower, upper) else { return Ok(None) };
        if let (Some(low), Some(high)) = (position(&lower), position(&upper)) {
            if high.is_below(&low) {
                return Ok(None);
            }
            if !low.is_below(&high) {
                // The range may be empty: one curve ends where the other begins.
                return self
                    .touching(curves)
                    .map_or_else(|| Err(Open { x: [low.bounds()[0], high.bounds()[1]] }), |()| Ok(None));
            }
        }
        let mut stretches = Vec::new();
        let first = self.leave(curves, &lower, &upper, &mut stretches)?;
        let Some(first) = first else { return Ok(Some(PairProof { curves, stretches })) };
        match upper {
            Side::Infinity => self.to_infinity(curves, first, &mut stretches)?,
            Side::Node(last) => self.between(curves, &first, &last, DEPTH, &mut stretches)?,
            Side::Cusp(_) | Side::Pitchfork(_) => {
                let last = self.approach(curves, &upper, &first, &mut stretches)?;
                let tail = stretches.pop();
                self.between(curves, &first, &last, DEPTH, &mut stretches)?;
                stretches.extend(tail);
            }
            Side::Origin => return Err(anywhere),
        }
        Ok(Some(PairProof { curves, stretches }))
    }

    /// One curve ends at the very event at which the other begins.
    fn touching(&self, [a, b]: [CurveId; 2]) -> Option<()> {
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

    /// How the common range begins (side 0) or ends (side 1). `Some(None)`: there is none.
    #[allow(clippy::option_option)]
    fn side(&self, curves: [CurveId; 2], side: usize) -> Option<Option<Side<E>>> {
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

    fn node_of(&self, x: E, is_end: bool, at: [Point<E>; 2]) -> Node<E> {
        let gap = self.gap(&at[0], &at[1]);
        Node { x, is_end, sign: gap.sign(), gap, at }
    }

    /// A node at which the curves are known to meet.
    fn meeting(&self, node: Node<E>) -> Node<E> {
        Node { sign: Some(Sign::Zero), gap: self.c.small(0), ..node }
    }

    /// The node over this x.
    fn node(&self, curves: [CurveId; 2], x: &E) -> Option<Node<E>> {
        let at = [self.point(curves[0], x)?, self.point(curves[1], x)?];
        Some(self.node_of(x.clone(), false, at))
    }

    /// The node over a number with few bits near low + t (high − low).
    fn node_within(&self, curves: [CurveId; 2], low: &E, high: &E, t: f64) -> Option<Node<E>> {
        self.node(curves, &self.place_within(low, high, t)?)
    }

    /// A number with few bits near low + t (high − low), strictly between the two.
    fn place_within(&self, low: &E, high: &E, t: f64) -> Option<E> {
        let precision = self.c.precision;
        let place = (low.clone() + (high.clone() - low.clone()) * E::double(t, precision)).middle();
        let double = place.bounds().into_iter().sum::<f64>() * 0.5;
        let few = E::double(few_bits(double), precision);
        let inside = |x: &E| (low.is_below(x) && x.is_below(high)) || (high.is_below(x) && x.is_below(low));
        if inside(&few) {
            return Some(few);
        }
        let short = place.exact_bounds().zip(low.exact_bounds().zip(high.exact_bounds()));
        let short = short.map(|([place, _], ([low, _], [high, _]))| {
            let room = [&place - low, high - &place].map(|d| if d < RBig::ZERO { -d } else { d });
            let room = room.into_iter().min().unwrap_or(RBig::ONE);
            E::rational(&rounded(place, &room), precision)
        });
        let is_point = |x: &E| x.exact_bounds().is_some_and(|[lo, hi]| lo == hi);
        short.into_iter().chain([place]).find(|x| is_point(x) && inside(x))
    }

    /// The first node with a proved gap, and the stretch before it.
    fn leave(
        &self,
        curves: [CurveId; 2],
        lower: &Side<E>,
        upper: &Side<E>,
        stretches: &mut Vec<Stretch>,
    ) -> Result<Option<Node<E>>, Open> {
        match lower {
            Side::Node(node) => Ok(Some((**node).clone())),
            Side::Cusp(x) | Side::Pitchfork(x) => {
                let from = x.upper();
                let to = position(upper).map_or_else(|| from.clone() * self.c.small(2), |x| x.lower());
                let open = Open { x: [from.bounds()[0], to.bounds()[1]] };
                let mut t = if position(upper).is_some() { 0.5 } else { 1.0 };
                for _ in 0..DEPTH {
                    let found = self
                        .node_within(curves, &from, &to, t)
                        .and_then(|node| self.sign_beside(curves, lower, &node, 0).map(|sign| (sign, node)));
                    if let Some((sign, node)) = found {
                        stretches.push(Stretch { x: [Mark::End, node.mark()], sign, proof: Proof::Constant });
                        return Ok(Some(node));
                    }
                    t *= 0.25;
                }
                Err(open)
            }
            Side::Origin | Side::Infinity => Err(Open { x: [0.0, f64::INFINITY] }),
        }
    }

    /// The last node before a common end, and the stretch after it.
    fn approach(
        &self,
        curves: [CurveId; 2],
        upper: &Side<E>,
        first: &Node<E>,
        stretches: &mut Vec<Stretch>,
    ) -> Result<Node<E>, Open> {
        let from = first.x.upper();
        let to = position(upper).map(|x| x.lower());
        let open = Open { x: [from.bounds()[0], to.as_ref().map_or(f64::INFINITY, |to| to.bounds()[1])] };
        let to = to.ok_or(open)?;
        let mut t = 0.5;
        for _ in 0..DEPTH {
            let found = self
                .node_within(curves, &to, &from, t)
                .and_then(|node| self.sign_beside(curves, upper, &node, 1).map(|sign| (sign, node)));
            if let Some((sign, node)) = found {
                stretches.push(Stretch { x: [node.mark(), Mark::End], sign, proof: Proof::Constant });
                return Ok(node);
            }
            t *= 0.25;
        }
        Err(open)
    }

    /// The sign of the gap between a common cusp or pitchfork and a node.
    fn sign_beside(&self, curves: [CurveId; 2], end: &Side<E>, node: &Node<E>, side: usize) -> Option<Sign> {
        match end {
            Side::Cusp(_) => {
                if self.bends(curves[0], &node.at[0], &node.at[1])? {
                    return None;
                }
                let slopes = node.at[0].slope(&self.c) - node.at[1].slope(&self.c);
                let sign = slopes.strict_sign()?;
                Some(if side == 0 { sign } else { -sign })
            }
            Side::Pitchfork(_) => {
                let curvature = |which: usize| {
                    let (half, y) = node.at[which].place.clone()?;
                    let end = self.end_point(curves[which], side)?;
                    let (end_half, end_y) = end.place?;
                    if half != end_half {
                        return None;
                    }
                    Some(self.state(half, &y.hull(&end_y)).curvature())
                };
                (curvature(0)? - curvature(1)?).strict_sign()
            }
            _ => None,
        }
    }

    /// True when dJ/dμ may vanish between two points of one branch. `None` when that cannot be told.
    fn bends(&self, curve: CurveId, p: &Point<E>, q: &Point<E>) -> Option<bool> {
        let Some((_, place)) = &self.curves.inflection else { return Some(false) };
        let (p, q) = (p.place.as_ref()?, q.place.as_ref()?);
        let _ = curve;
        if matches!(p.0, Half::Over { .. }) {
            return Some(false);
        }
        let sides = [self.beyond(p, place), self.beyond(q, place)];
        Some(match sides {
            [Some(x), Some(y)] => x != y,
            _ => true,
        })
    }

    /// Whether a point of the generic family lies at larger μ than a place.
    fn beyond(&self, (half, y): &(Half, E), place: &Place) -> Option<bool> {
        let (Half::Generic { base: p, sign: s }, Half::Generic { base: q, sign: t }) = (*half, place.half) else {
            return None;
        };
        if (p, s) == (q, t) {
            let at = self.place(place);
            return if at.is_below(y) {
                Some(s == Sign::Positive)
            } else if y.is_below(&at) {
                Some(s == Sign::Negative)
            } else {
                None
            };
        }
        if p == q { Some(s > t) } else { Some(p > q) }
    }

    /// J between two points of one curve; to infinity when `to` is absent.
    fn moments(&self, curve: CurveId, from: &Point<E>, to: Option<&Point<E>>) -> Option<E> {
        let list = &self.curves.list[curve];
        let end = match (to, list.limit) {
            (Some(point), _) => point.over.j.clone(),
            (None, Some(limit)) => self.c.a[limit.group].clone(),
            (None, None) => return None,
        };
        let range = from.over.j.hull(&end);
        let Some((_, place)) = &self.curves.inflection else { return Some(range) };
        let start = from.place.as_ref()?;
        if matches!(start.0, Half::Over { .. }) {
            return Some(range);
        }
        let other = if let Some(point) = to {
            self.beyond(point.place.as_ref()?, place)
        } else {
            let limit = list.limit?;
            self.beyond(&(Half::Generic { base: limit.group, sign: limit.side }, self.c.small(0)), place)
        };
        // The inflection lies on another interval of the family, or beside the range: J is monotone there.
        match (self.beyond(start, place), other) {
            (Some(x), Some(y)) if x == y => Some(range),
            _ => Some(range.hull(&self.state(place.half, &self.place(place)).j)),
        }
    }

    /// Difference of the slopes between two nodes; to infinity when the second is absent.
    fn slopes(&self, curves: [CurveId; 2], from: &Node<E>, to: Option<&Node<E>>) -> Option<E> {
        let range = |which: usize| {
            let j = self.moments(curves[which], &from.at[which], to.map(|node| &node.at[which]))?;
            Some(self.c.small(1) / j)
        };
        Some(range(0)? - range(1)?)
    }

    /// The order between two nodes: settled at once, or on both sides of a node between them.
    fn between(
        &self,
        curves: [CurveId; 2],
        from: &Node<E>,
        to: &Node<E>,
        depth: u32,
        stretches: &mut Vec<Stretch>,
    ) -> Result<(), Open> {
        let open = Open { x: [from.x.bounds()[0], to.x.bounds()[1]] };
        if let Some((sign, proof)) = self.settled(curves, from, to).ok_or(open)? {
            stretches.push(Stretch { x: [from.mark(), to.mark()], sign, proof });
            return Ok(());
        }
        let depth = depth.checked_sub(1).ok_or(open)?;
        let middle = self.middle(curves, from, to).ok_or(open)?;
        self.between(curves, from, &middle, depth, stretches)?;
        self.between(curves, &middle, to, depth, stretches)
    }

    /// The order between two nodes without another one; `Some(None)` when that does not show it, `None` when the box of
    /// a crossing cannot be found.
    #[allow(clippy::option_option)]
    fn settled(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>) -> Option<Option<(Sign, Proof)>> {
        if let Some(found) = self.slopes(curves, from, Some(to)).and_then(|slopes| self.by_slopes(from, to, &slopes)) {
            return self.resolved(curves, from, to, found).map(Some);
        }
        if let Some(sign) = self.sign_over(from, to) {
            return Some(Some((sign, Proof::Constant)));
        }
        let edges = [from, to].map(|node| (&node.x, &node.at));
        Some(self.mirrored_sign(curves, edges[0], Some(edges[1])).map(|sign| (sign, Proof::Constant)))
    }

    /// The course of the gap between two nodes with the range of the difference of slopes.
    fn by_slopes(&self, from: &Node<E>, to: &Node<E>, slopes: &E) -> Option<Course> {
        let reach = (to.x.clone() - from.x.clone()).hull(&self.c.small(0));
        // The gap at the lower end, then at the upper end.
        let ends = [from.gap.clone() + slopes.clone() * reach.clone(), to.gap.clone() - slopes.clone() * reach];
        if let Some(sign) = ends.iter().find_map(Enclosure::strict_sign) {
            return Some(Course::Constant(sign));
        }
        slopes.strict_sign()?;
        match (from.sign?, to.sign?) {
            (p, q) if p == q && p != Sign::Zero => Some(Course::Constant(p)),
            // They meet at one end, which is proved elsewhere.
            (Sign::Zero, q) | (q, Sign::Zero) if q != Sign::Zero => Some(Course::Constant(q)),
            (p, q) if p * q == Sign::Negative => Some(Course::Crossing(p)),
            _ => None,
        }
    }

    /// What slopes tell, with the box of the crossing; `None` when that cannot be found.
    fn resolved(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>, found: Course) -> Option<(Sign, Proof)> {
        match found {
            Course::Constant(sign) => Some((sign, Proof::Constant)),
            Course::Crossing(sign) => Some((sign, Proof::Crossing(self.crossing(curves, from, to, sign)?))),
        }
    }

    /// A node between two others: at the first of several places that gives a sure sign.
    fn middle(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>) -> Option<Node<E>> {
        let (low, high) = (from.x.upper(), to.x.lower());
        let (near, far) = (low.bounds()[1], high.bounds()[0]);
        // Far apart, halve the logarithm.
        let share =
            if far > 4.0 * near && near > 0.0 { ((near / far).sqrt() - near / far) / (1.0 - near / far) } else { 0.5 };
        [1.0, 0.8, 1.22].into_iter().find_map(|t| {
            self.node_within(curves, &low, &high, share * t)
                .filter(|node| node.sign.is_some_and(|sign| sign != Sign::Zero))
        })
    }

    /// The sign from the identity over the ranges of both curves.
    fn sign_over(&self, from: &Node<E>, to: &Node<E>) -> Option<Sign> {
        let state = |which: usize| {
            let (p, y) = from.at[which].place.as_ref()?;
            let (q, z) = to.at[which].place.as_ref()?;
            (p == q).then(|| self.state(*p, &y.hull(z)))
        };
        self.range_sign(&state(0)?, &state(1)?)
    }

    /// A small box around the one crossing between two nodes.
    fn crossing(&self, curves: [CurveId; 2], from: &Node<E>, to: &Node<E>, sign: Sign) -> Option<[RBig; 2]> {
        self.boxed(curves, [from.x.upper(), to.x.lower()], [&from.gap, &to.gap], sign)
    }

    /// A box of the crossing inside another one, at whose ends the gap has these signs: as small as these bits make it.
    pub fn narrowed(&self, curves: [CurveId; 2], x: &[RBig; 2]) -> Option<[RBig; 2]> {
        self.allow(POINTS);
        let ends = x.each_ref().map(|x| E::rational(x, self.c.precision));
        let nodes = [self.node(curves, &ends[0])?, self.node(curves, &ends[1])?];
        let [Some(p), Some(q)] = nodes.each_ref().map(|node| node.sign) else { return None };
        let found =
            (p * q == Sign::Negative).then(|| self.boxed(curves, ends, [&nodes[0].gap, &nodes[1].gap], p))??;
        (found[0] >= x[0] && found[1] <= x[1]).then_some(found)
    }

    fn boxed(&self, curves: [CurveId; 2], [mut low, mut high]: [E; 2], gaps: [&E; 2], sign: Sign) -> Option<[RBig; 2]> {
        let value = |gap: &E| {
            let [lo, hi] = gap.bounds();
            0.5 * (lo + hi)
        };
        let [mut at_low, mut at_high] = gaps.map(value);
        let close = self.c.small(4) * E::double(E::resolution(self.c.precision), self.c.precision);
        // Illinois' variant of the secant rule: the sign of an end that stays is damped.
        for _ in 0..80 {
            if (high.clone() - low.clone()).is_below(&(high.clone() * close.clone())) {
                break;
            }
            let secant = at_low / (at_low - at_high);
            let share = if secant > 1e-12 && secant < 1.0 { secant } else { 0.5 };
            let between = (low.clone() + (high.clone() - low.clone()) * E::double(share, self.c.precision)).middle();
            let inside = low.is_below(&between) && between.is_below(&high);
            let x = if inside { between } else { low.hull(&high).middle() };
            let node = self.node(curves, &x)?;
            match node.sign {
                Some(s) if s == sign => {
                    low = x;
                    at_low = value(&node.gap);
                    at_high *= 0.5;
                }
                Some(s) if s == -sign => {
                    high = x;
                    at_high = value(&node.gap);
                    at_low *= 0.5;
                }
                _ => {
                    let around = self.around(curves, &x, [&low, &high], sign);
                    if let Some(ends) = around {
                        [low, high] = ends;
                    }
                    break;
                }
            }
        }
        let [at, _] = low.exact_bounds()?;
        let [_, end] = high.exact_bounds()?;
        Some([at, end])
    }

    /// The sign is hidden at x: sure signs close by, on both sides.
    fn around(&self, curves: [CurveId; 2], x: &E, [low, high]: [&E; 2], sign: Sign) -> Option<[E; 2]> {
        let precision = self.c.precision;
        let sure = |at: &E, wanted: Sign| self.node(curves, at).is_some_and(|node| node.sign == Some(wanted));
        let mut reach = E::resolution(precision);
        for _ in 0..60 {
            let step = x.clone() * E::double(reach, precision);
            let (down, up) = ((x.clone() - step.clone()).lower(), (x.clone() + step).upper());
            let below = if low.is_below(&down) { sure(&down, sign).then_some(down) } else { Some(low.clone()) };
            let above = if up.is_below(high) { sure(&up, -sign).then_some(up) } else { Some(high.clone()) };
            if let (Some(below), Some(above)) = (below, above) {
                return Some([below, above]);
            }
            reach *= 2.0;
        }
        None
    }

    fn to_infinity(&self, curves: [CurveId; 2], first: Node<E>, stretches: &mut Vec<Stretch>) -> Result<(), Open> {
        let mut node = first;
        for _ in 0..FAR {
            if let Some(sign) = self.far_sign(curves, &node) {
                stretches.push(Stretch { x: [node.mark(), Mark::End], sign, proof: Proof::Constant });
                return Ok(());
            }
            let from = node.x.bounds()[1];
            let next = [8.0, 7.0, 10.0]
                .into_iter()
                .find_map(|factor| {
                    self.node(curves, &E::double(few_bits(factor * from), self.c.precision))
                        .filter(|node| node.sign.is_some_and(|sign| sign != Sign::Zero))
                })
                .ok_or(Open { x: [from, f64::INFINITY] })?;
            self.between(curves, &node, &next, DEPTH, stretches)?;
            node = next;
        }
        Err(Open { x: [node.x.bounds()[0], f64::INFINITY] })
    }

    /// The sign all the way to infinity.
    fn far_sign(&self, curves: [CurveId; 2], node: &Node<E>) -> Option<Sign> {
        if let Some(sign) = self.mirrored_sign(curves, (&node.x, &node.at), None) {
            return Some(sign);
        }
        let gap = node.sign?.strict()?;
        if self.slopes(curves, node, None).and_then(|slopes| slopes.strict_sign()) == Some(gap) {
            return Some(gap);
        }
        let limits = curves.map(|c| self.curves.list[c].limit);
        let [Some(p), Some(q)] = limits else { return None };
        if p.group != q.group {
            return None;
        }
        let phi = |which: usize| {
            let limit = limits[which]?;
            let point = &node.at[which];
            // J is monotone towards a: no inflection ahead, so that h − x/a is monotone.
            let a = self.c.a[limit.group].clone();
            let now = point.h_above(&self.c, limit.group, &a);
            let root = self.c.root_q[limit.group].clone();
            let end = match limit.side {
                Sign::Positive => -root,
                Sign::Negative => root,
                Sign::Zero => self.c.small(0),
            };
            self.straight(curves[which], point).then(|| now.hull(&end))
        };
        let (p, q) = (phi(0)?, phi(1)?);
        (p - q).strict_sign().filter(|sign| *sign == gap)
    }

    /// J is monotone from this point to infinity.
    fn straight(&self, curve: CurveId, point: &Point<E>) -> bool {
        let Some((_, place)) = &self.curves.inflection else { return true };
        let (Some(start), Some(limit)) = (&point.place, self.curves.list[curve].limit) else { return false };
        if matches!(start.0, Half::Over { .. }) {
            return true;
        }
        let end = (Half::Generic { base: limit.group, sign: limit.side }, self.c.small(0));
        matches!((self.beyond(start, place), self.beyond(&end, place)), (Some(x), Some(y)) if x == y)
    }
}

/// A double near this one with few bits.
fn few_bits(x: f64) -> f64 {
    const DROPPED: u32 = 30;
    f64::from_bits((x.to_bits() >> DROPPED) << DROPPED)
}

/// What the slopes tell of a stretch.
#[derive(Clone, Copy, Debug)]
enum Course {
    /// One sign.
    Constant(Sign),
    /// From this sign to the opposite one, once.
    Crossing(Sign),
}

fn position<E: Enclosure>(side: &Side<E>) -> Option<E> {
    match side {
        Side::Cusp(x) | Side::Pitchfork(x) => Some(x.clone()),
        Side::Node(node) => Some(node.x.clone()),
        Side::Infinity | Side::Origin => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::curves::Curves;
    use super::super::model::Model;
    use super::*;
    use numbers::interval::Interval;
    use top::body::{Body, Preset};
    use top::curves::CriticalSet;
    use top::diagram::{Arrangement, Change};

    fn crossings(body: &Body) -> usize {
        let model = Model::new(body, &body.frame());
        let curves = Curves::new(&model, 160).unwrap();
        let evaluator = Evaluator::<Interval>::new(&model, &curves, &[], ());
        let arrangement = Arrangement::new(CriticalSet::new(body.frame()).unwrap());
        let mut found = Vec::new();
        for b in curves.list.ids() {
            for a in curves.list.ids().take_while(|a| *a < b) {
                let family = |c: CurveId| matches!(curves.list[c].shape, Shape::Family(_)) && !curves.list[c].lowest;
                if !family(a) || !family(b) {
                    continue;
                }
                if let Some(proof) = evaluator.pair(a, b).unwrap_or_else(|open| panic!("{body:?} {a:?} {b:?} {open:?}"))
                {
                    found.extend(proof.stretches.iter().filter_map(|s| match &s.proof {
                        Proof::Crossing(x) => Some(x.clone().map(|x| x.to_f64().value())),
                        Proof::Constant => None,
                    }));
                }
            }
        }
        found.sort_by(|p, q| p[0].total_cmp(&q[0]));
        let lines = |c: CurveId| arrangement.set.curves[c].pole.is_some() || !arrangement.set.curves[c].is_critical();
        let expected: Vec<f64> = arrangement
            .events
            .iter()
            .filter(|e| matches!(e.change, Change::Swap([a, b]) if !lines(a) && !lines(b)))
            .map(|e| e.x)
            .collect();
        assert_eq!(found.len(), expected.len(), "{body:?} {found:?} {expected:?}");
        for (x, e) in found.iter().zip(expected) {
            assert!((x[0] - e).abs() < 1e-9 * e && x[1] - x[0] < 1e-9 * e, "{x:?} {e}");
        }
        found.len()
    }

    #[test]
    fn pairs_cross_where_the_standard_arrangement_says() {
        for preset in Preset::all() {
            crossings(&preset.body());
        }
        let mut total = 0;
        for (a, r) in [
            (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
            (["1", "1.7", "2.2"], ["0.1", "0.1", "0.9"]),
            (["1", "1.0001", "1.9"], ["0.8", "1e-4", "0.6"]),
            (["2", "1.1", "1"], ["0.94868", "1e-6", "0.61623"]),
        ] {
            total += crossings(&Body::parse(&a, &r).unwrap());
        }
        assert!(total > 0);
    }
}
