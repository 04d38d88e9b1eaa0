//! The order of the two branches beside a moment a_i, one on each side (Lemma 7.5 and Lemma 7.6): both are solutions of
//! one family, with ε in place of r_i and μ = a_i + εv, and at fixed x dh/dε = −γ_i < 0. The proof that the solution
//! stays in a box while ε runs from −r_i to r_i is repeated here; the certificate says nothing about it.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::node::Node;
use super::orders::Orders;
use crate::equilibria::pieces::Branch;
use crate::equilibria::places::Point;
use crate::equilibria::spaces::Spaces;
use crate::numbers::fixed::Fixed;

/// Both branches over an end of a stretch: x, and v = |μ − a_i|/r_i on the left branch and on the right one.
struct Edge {
    x: Fixed,
    v: [Fixed; 2],
}

/// The family with ε anywhere in [−r_i, r_i].
struct Mirrored<'a> {
    spaces: &'a Spaces,
    base: usize,
    epsilon: Fixed,
}

/// P̂, Q̂ and their first two derivatives by μ.
struct Sums {
    p: [Fixed; 3],
    q: [Fixed; 3],
}

/// The lemmas give this sign of h of the first curve minus h of the second between two nodes, or to infinity.
pub(crate) fn orders_branches(orders: &Orders, curves: [usize; 2], from: &Node, to: Option<&Node>, sign: i8) -> bool {
    let points = |node: &Node| (node.x.clone(), node.stands.each_ref().map(|stand| stand.point.clone()));
    family(orders, curves, &points(from), to.map(points).as_ref()).is_some_and(|(family, [from, to], left)| {
        family.path(from.as_ref(), to.as_ref()).is_some() && sign == if left == 0 { 1 } else { -1 }
    })
}

/// x, and the equilibria of two curves over it.
type Both = (Fixed, [Point; 2]);

/// The family of both curves, what is known at the ends, and which curve is the left branch.
fn family<'a>(
    orders: &'a Orders,
    curves: [usize; 2],
    from: &Both,
    to: Option<&Both>,
) -> Option<(Mirrored<'a>, [Option<Edge>; 2], usize)> {
    let number = |curve: usize| match orders.pieces.list[curve].branch {
        Branch::Generic(number) => Some(number),
        _ => None,
    };
    let (p, q) = (number(curves[0])?, number(curves[1])?);
    if p.abs_diff(q) != 1 {
        return None;
    }
    let spaces = orders.spaces;
    let base = *spaces.active.get(p.min(q))?;
    let left = usize::from(q < p);
    let root = &spaces.list[base].root_q;
    let edge = |(x, points): &Both| {
        let tau = |which: usize| points[which].tau.as_ref()?.get(base);
        Some(Edge { x: x.clone(), v: [(-tau(left)?).over(root)?, tau(1 - left)?.over(root)?] })
    };
    let ends = [Some(edge(from)?), to.map(edge).map_or(Some(None), |edge| edge.map(Some))?];
    let positive = ends.iter().flatten().flat_map(|edge| &edge.v).all(Fixed::is_positive);
    positive.then(|| (Mirrored { spaces, base, epsilon: root.hull(&-root) }, ends, left))
}

/// The end of the tightest box, 1 + 2⁻ᵏ times its content, at which x lies beyond the stretch. The solution
/// needs room to move while ε changes its sign, about as far as the branches lie apart; a wider box is harder to prove
/// monotone, and may reach beyond a cusp.
fn nearest(end: impl Fn(&Fixed) -> Option<Fixed>, holds: impl Fn(&Fixed) -> bool, shift: &Fixed) -> Option<Fixed> {
    /// The least room is 2⁻ᵏ.
    const ROOMS: usize = 96;
    /// How much less than their distance.
    const LESS: usize = 4;
    let part = |k: usize, sixteenths: u8| RBig::from_parts(IBig::from(sixteenths), UBig::ONE << (k + 4));
    let at = |k, sixteenths| end(&Fixed::of(&(RBig::ONE + part(k, sixteenths)), ROOMS + 4)).filter(&holds);
    let wide = |&k: &usize| !Fixed::of(&part(k, 16), ROOMS + 4).below(shift);
    let first = (0..=ROOMS).rev().find(wide).map_or(0, |k| (k + LESS).min(ROOMS));
    (0..=first).rev().find_map(|k| [9, 10, 12, 16].into_iter().find_map(|sixteenths| at(k, sixteenths)))
}

impl Mirrored<'_> {
    /// A range of v that the solution does not leave while ε runs from −r_i to r_i, for every x between the ends.
    fn path(&self, from: Option<&Edge>, to: Option<&Edge>) -> Option<Fixed> {
        self.box_around(from, to).or_else(|| self.leaves_cusp(from?, to?))
    }

    /// Lemma 7.5 for every x between the ends: a box of v that holds both branches, in which x is monotone, and at whose
    /// ends x lies beyond those of the stretch.
    fn box_around(&self, from: Option<&Edge>, to: Option<&Edge>) -> Option<Fixed> {
        let from = from?;
        let held = from.v.iter().chain(to.iter().flat_map(|edge| &edge.v)).cloned().reduce(|v, w| v.hull(&w))?;
        // x falls with v, as it does towards infinity, or rises.
        let falls = to.is_none_or(|to| to.v[0].middle().below(&from.v[0].middle()));
        let before = |v: &Fixed| self.x(v).is_some_and(|x| x.below(&from.x));
        let behind = |v: &Fixed| to.is_none_or(|to| self.x(v).is_some_and(|x| to.x.below(&x)));
        let large = |room: &Fixed| Some((&held * room).upper());
        let small = |room: &Fixed| {
            if to.is_none() { Some(Fixed::whole(0)) } else { Some(held.over(room)?.lower()) }
        };
        // About as far as the branches lie apart.
        let shift = |edge: &Edge| Some((&edge.v[0].over(&edge.v[1])? - &Fixed::whole(1)).square().root()?.lower());
        let shift = shift(from)?;
        let ends = if falls {
            nearest(small, behind, &shift).zip(nearest(large, before, &shift))
        } else {
            nearest(small, before, &shift).zip(nearest(large, behind, &shift))
        };
        let (small, large) = ends?;
        let found = small.hull(&large);
        (self.fall(&found) == Some(if falls { 1 } else { -1 })).then_some(found)
    }

    /// Lemma 7.6 for every x between the ends, where one of the branches may begin at a cusp. On the branch with the
    /// smaller t = 1/v, t is monotone in x, which gives the sign σ of ∂x/∂t there. The range of v that the lemma gives.
    fn leaves_cusp(&self, from: &Edge, to: &Edge) -> Option<Fixed> {
        let one = Fixed::whole(1);
        let inverse = |v: &[Fixed; 2]| Some([one.over(&v[0])?, one.over(&v[1])?]);
        let t = [inverse(&from.v)?, inverse(&to.v)?];
        let lower = |which: usize| t.iter().all(|t| t[which].below(&t[1 - which]));
        let (start, direction) = if lower(0) {
            (0, 1)
        } else if lower(1) {
            (1, -1)
        } else {
            return None;
        };
        let sigma = (&t[1][start] - &t[0][start]).strict_sign()?;
        let held = t[0][0].hull(&t[0][1]).hull(&t[1][0].hull(&t[1][1]));
        let top = &held.upper() + &held.upper().half();
        let range = t[0][start].hull(&t[1][start]).lower().hull(&top);
        let [in_t, in_epsilon, m] = self.slopes_of_g(&range)?;
        let proved = in_t.strict_sign() == Some(sigma)
            && in_epsilon.strict_sign() == Some(sigma * direction)
            && m.strict_sign() == Some(-sigma * direction);
        let edge = self.x(&one.over(&top)?)?;
        let beyond = if sigma > 0 { to.x.below(&edge) } else { edge.below(&from.x) };
        (proved && beyond).then(|| one.over(&range))?
    }

    fn sums(&self, v: &Fixed) -> Option<Sums> {
        let zero = || Fixed::whole(0);
        let mut sums = Sums { p: [zero(), zero(), zero()], q: [zero(), zero(), zero()] };
        for &j in self.spaces.active.iter().filter(|&&j| j != self.base) {
            let tau = self.spaces.difference(self.base, j) + &(&self.epsilon * v);
            let inverse = Fixed::whole(1).over(&tau)?;
            let square = (&self.spaces.list[j].root_q * &inverse).square();
            let terms = [
                square.clone(),
                &(&square * &inverse) * &Fixed::whole(-2),
                &(&square * &inverse.square()) * &Fixed::whole(6),
            ];
            for (k, term) in terms.iter().enumerate() {
                sums.p[k] = &sums.p[k] + term;
                sums.q[k] = &sums.q[k] + &(&self.spaces.list[j].a_set * term);
            }
        }
        Some(sums)
    }

    /// p = 1 + v²P̂ and q = a_i + v²Q̂.
    fn p_and_q(&self, v: &Fixed, sums: &Sums) -> [Fixed; 2] {
        let square = v.square();
        [&Fixed::whole(1) + &(&square * &sums.p[0]), &self.spaces.list[self.base].a_set + &(&square * &sums.q[0])]
    }

    /// 2Q̂'P − 3P̂'Q/2 for these P and Q, or with p and q in their place.
    fn bend(p1: &Fixed, q1: &Fixed, p: &Fixed, q: &Fixed) -> Fixed {
        &(&(q1 * p) * &Fixed::whole(2)) - &(&(p1 * q) * &Fixed::whole(3)).half()
    }

    /// The sign of −∂x/∂v on a box: of 4a_i p − 3q − εv³(2Q̂'p − 3P̂'q/2), where 4a_i p − 3q = a_i + v²(4a_iP̂ − 3Q̂): the
    /// sums may all but cancel, and not v² with itself.
    fn fall(&self, v: &Fixed) -> Option<i8> {
        let sums = self.sums(v)?;
        let [p, q] = self.p_and_q(v, &sums);
        let a = &self.spaces.list[self.base].a_set;
        let turn = &(&(a * &sums.p[0]) * &Fixed::whole(4)) - &(&sums.q[0] * &Fixed::whole(3));
        let main = a + &(&v.square() * &turn);
        let bend = Self::bend(&sums.p[1], &sums.q[1], &p, &q);
        let correction = &(&(&self.epsilon * v) * &v.square()) * &bend;
        (&main - &correction).strict_sign()
    }

    /// ∂g/∂t, ∂g/∂ε and m on a box of t, where g = t³(4a_iP − 3Q) − εm and m = 2Q̂'P − 3P̂'Q/2.
    fn slopes_of_g(&self, t: &Fixed) -> Option<[Fixed; 3]> {
        let v = Fixed::whole(1).over(t)?;
        let Sums { p: [p0, p1, p2], q: [q0, q1, q2] } = self.sums(&v)?;
        let (square, a, e) = (t.square(), &self.spaces.list[self.base].a_set, &self.epsilon);
        let (p, q) = (&p0 + &square, &q0 + &(a * &square));
        let mix = |p: &Fixed, q: &Fixed| &(&(a * p) * &Fixed::whole(4)) - &(q * &Fixed::whole(3));
        let (k, k_slope) = (mix(&p0, &q0), mix(&p1, &q1));
        let (m, m_slope) = (Self::bend(&p1, &q1, &p, &q), Self::bend(&p2, &q2, &p, &q));
        let (ev, ev2, twice) = (e * &v, e * &v.square(), t * &Fixed::whole(2));
        let turn = Self::bend(&p1, &q1, &(&twice - &(&p1 * &ev2)), &(&(a * &twice) - &(&q1 * &ev2)));
        let main = &square * &(&(&k * &Fixed::whole(3)) + &(&(a * &square) * &Fixed::whole(5)));
        let rest = &(&(e * t) * &k_slope) + &(e * &turn);
        let in_t = &(&main - &rest) + &(&ev.square() * &m_slope);
        let in_epsilon = &(&(&square * &k_slope) - &m) - &(&ev * &(&m_slope + &(&q1 * &p1).half()));
        Some([in_t, in_epsilon, m])
    }

    /// x = q²/(2p^{3/2}v).
    fn x(&self, v: &Fixed) -> Option<Fixed> {
        let [p, q] = self.p_and_q(v, &self.sums(v)?);
        Some(q.square().over(&(&(&p * &p.root()?) * v))?.half())
    }
}
