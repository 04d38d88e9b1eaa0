//! The order of the two branches beside a moment a_i, one on each side: the arms of an imperfect pitchfork.
//!
//! Both are solutions of one family: with ε in the place of r_i and μ = a_i + εv, where 1/v = sγ_i > 0, the branch right of
//! a_i has ε = r_i and the one left of it, mirrored in γ_i, ε = −r_i. At fixed x, dh/dε = −γ_i. So if the solution cannot
//! leave a box in which x is monotone in v while ε runs from one to the other, the left branch lies above the right one by
//! ∫γ_i dε, however small r_i is (Lemma 7.5 and Lemma 7.6 of docs/algorithms.md).

use super::evaluator::{Evaluator, Point};
use super::family::Half;
use super::model::Constants;
use bifdiag_equilibria::curves::{Branch, CurveId};
use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::table::Id;

/// Both branches over an end of a stretch: x, and v on the left branch and on the right one.
struct Edge<E> {
    x: E,
    v: [E; 2],
}

/// P̂, Q̂ and their first two derivatives by μ.
struct Sums<E> {
    p: [E; 3],
    q: [E; 3],
}

/// The family with ε anywhere in [−r_i, r_i].
struct Mirrored<'a, E: Enclosure> {
    active: &'a [usize],
    c: &'a Constants<E>,
    group: usize,
    epsilon: E,
}

impl<E: Enclosure> Evaluator<'_, E> {
    /// The sign of h_a − h_b over a stretch whose ends have these x and points, or to infinity, if the curves are the
    /// branches on both sides of a moment and the lemmas apply.
    pub fn mirrored_sign(
        &self,
        curves: [CurveId; 2],
        from: (&E, &[Point<E>; 2]),
        to: Option<(&E, &[Point<E>; 2])>,
    ) -> Option<Sign> {
        let numbers = curves.map(|curve| match self.curves.list[curve].branch {
            Branch::Generic(interval) => Some(interval.index()),
            _ => None,
        });
        let [Some(p), Some(q)] = numbers else { return None };
        if p.abs_diff(q) != 1 {
            return None;
        }
        let group = *self.model.active.get(p.min(q))?;
        let left = usize::from(q < p);
        let edge = |(x, at): (&E, &[Point<E>; 2])| {
            let v = [self.distance(&at[left], group)?, self.distance(&at[1 - left], group)?];
            Some(Edge { x: x.clone(), v: v.map(|y| y / self.c.root_q[group].clone()) })
        };
        let (from, to) = (edge(from)?, to.map(edge));
        let to = match to {
            Some(edge) => Some(edge?),
            None => None,
        };
        let epsilon = self.c.root_q[group].hull(&-self.c.root_q[group].clone());
        let family = Mirrored { active: &self.model.active, c: &self.c, group, epsilon };
        let proved = family.is_monotone_around(&from, to.as_ref())
            || to.as_ref().is_some_and(|to| family.leaves_cusp(&from, to) == Some(true));
        proved.then_some(if left == 0 { Sign::Positive } else { Sign::Negative })
    }

    /// |μ − a| of a point of the generic family beside this moment.
    fn distance(&self, point: &Point<E>, group: usize) -> Option<E> {
        let (half, y) = point.place.as_ref()?;
        let Half::Generic { base, .. } = *half else { return None };
        if base == group {
            return Some(y.clone());
        }
        let (low, high) = (base.min(group), base.max(group));
        Some(self.c.diff[high][low].clone() - y.clone())
    }
}

impl<E: Enclosure> Mirrored<'_, E> {
    fn small(&self, value: i32) -> E {
        self.c.small(value)
    }

    fn double(&self, value: f64) -> E {
        E::double(value, self.c.precision)
    }

    /// Lemma 7.5 for every x of the stretch: the box holds both branches, x is monotone in v there, and at its ends x lies
    /// beyond those of the stretch.
    fn is_monotone_around(&self, from: &Edge<E>, to: Option<&Edge<E>>) -> bool {
        let ends = [Some(from), to].into_iter().flatten();
        let Some(all) = ends.clone().flat_map(|edge| edge.v.clone()).reduce(|p, q| p.hull(&q)) else { return false };
        // Room for the solution to move while ε changes its sign: a few times its shift, or more; a wider box is harder
        // to prove monotone.
        let value = |v: &E| v.bounds().into_iter().sum::<f64>();
        let shift = ends.map(|edge| (value(&edge.v[0]) / value(&edge.v[1]) - 1.0).abs()).fold(0.0, f64::max);
        let rooms = [1.0 + 1e-12 + 16.0 * shift, 1.02, 1.2, 2.0];
        rooms.into_iter().filter(|room| *room <= 2.0).any(|room| {
            let large = (all.upper() * self.double(room)).upper();
            let small = match to {
                Some(_) => (all.lower() / self.double(room)).lower(),
                None => self.small(0),
            };
            // x falls or rises with v.
            let Some(sign) = self.fall(&small.hull(&large)) else { return false };
            let (low, high) = (&from.x, to.map(|edge| &edge.x));
            let at_large = self.x(&large);
            match high {
                None => sign == Sign::Positive && at_large.is_below(low),
                Some(high) if sign == Sign::Positive => at_large.is_below(low) && high.is_below(&self.x(&small)),
                Some(high) => high.is_below(&at_large) && self.x(&small).is_below(low),
            }
        })
    }

    /// Lemma 7.6 for every x of the stretch, where one of the branches may begin at a cusp. On the branch with the smaller
    /// t = 1/v, t is monotone in x, which gives the sign σ of ∂x/∂t there.
    fn leaves_cusp(&self, from: &Edge<E>, to: &Edge<E>) -> Option<bool> {
        let t = [from, to].map(|edge| edge.v.clone().map(|v| self.small(1) / v));
        let lower = |which: usize| (0..2).all(|end| t[end][which].is_below(&t[end][1 - which]));
        let (start, direction) = if lower(0) {
            (0, Sign::Positive)
        } else if lower(1) {
            (1, Sign::Negative)
        } else {
            return None;
        };
        let [first, last] = [&t[0][start], &t[1][start]];
        let sigma = (last.clone() - first.clone()).strict_sign()?;
        let all = t.iter().flatten().cloned().reduce(|p, q| p.hull(&q))?;
        let top = (all.upper() * self.double(1.5)).upper();
        let range = first.hull(last).lower().hull(&top);
        let [in_t, in_epsilon, m] = self.slopes_of_g(&range);
        let proved = in_t.sign() == Some(sigma)
            && in_epsilon.sign() == Some(sigma * direction)
            && m.sign() == Some(-sigma * direction);
        let edge = self.x(&(self.small(1) / top));
        Some(proved && if sigma == Sign::Positive { to.x.is_below(&edge) } else { edge.is_below(&from.x) })
    }

    fn sums(&self, v: &E) -> Sums<E> {
        let zero = || self.small(0);
        let mut sums = Sums { p: [zero(), zero(), zero()], q: [zero(), zero(), zero()] };
        for &j in self.active.iter().filter(|&&j| j != self.group) {
            let inverse = self.small(1) / (self.c.diff[self.group][j].clone() + self.epsilon.clone() * v.clone());
            let square = self.c.q[j].clone() * inverse.square();
            let terms = [
                square.clone(),
                square.clone() * inverse.clone() * self.small(-2),
                square * inverse.square() * self.small(6),
            ];
            for (k, term) in terms.into_iter().enumerate() {
                sums.p[k] = sums.p[k].clone() + term.clone();
                sums.q[k] = sums.q[k].clone() + self.c.a[j].clone() * term;
            }
        }
        sums
    }

    /// p = 1 + v²P̂ and q = a_i + v²Q̂.
    fn p_and_q(&self, v: &E, sums: &Sums<E>) -> [E; 2] {
        let square = v.square();
        [self.small(1) + square.clone() * sums.p[0].clone(), self.c.a[self.group].clone() + square * sums.q[0].clone()]
    }

    /// The sign of −∂x/∂v on a box: of 4a_i p − 3q − εv³(2Q̂'p − 3P̂'q/2), where 4a_i p − 3q = a_i + v²(4a_iP̂ − 3Q̂), with
    /// one v² where the sums all but cancel.
    fn fall(&self, v: &E) -> Option<Sign> {
        let sums = self.sums(v);
        let [p, q] = self.p_and_q(v, &sums);
        let [p0, p1, _] = sums.p;
        let [q0, q1, _] = sums.q;
        let a = self.c.a[self.group].clone();
        let main = a.clone() + v.square() * (a * p0 * self.small(4) - q0 * self.small(3));
        let bend = q1 * p * self.small(2) - p1 * q * self.double(1.5);
        let correction = self.epsilon.clone() * v.clone() * v.square() * bend;
        (main - correction).strict_sign()
    }

    /// ∂g/∂t, ∂g/∂ε and m on a box of t, where g = t³(4a_iP − 3Q) − εm and m = 2Q̂'P − 3P̂'Q/2.
    fn slopes_of_g(&self, t: &E) -> [E; 3] {
        let v = self.small(1) / t.clone();
        let Sums { p: [p0, p1, p2], q: [q0, q1, q2] } = self.sums(&v);
        let (square, a, e) = (t.square(), self.c.a[self.group].clone(), self.epsilon.clone());
        let (p, q) = (p0.clone() + square.clone(), q0.clone() + a.clone() * square.clone());
        let (two, half3, four) = (self.small(2), self.double(1.5), self.small(4));
        let k = a.clone() * p0 * four.clone() - q0 * self.small(3);
        let k_slope = a.clone() * p1.clone() * four - q1.clone() * self.small(3);
        let m = q1.clone() * p.clone() * two.clone() - p1.clone() * q.clone() * half3.clone();
        let m_slope = q2 * p * two.clone() - p2 * q * half3.clone();
        let ev2 = e.clone() * v.square();
        let twice = t.clone() * two.clone();
        let turn = q1.clone() * (twice.clone() - p1.clone() * ev2.clone()) * two
            - p1.clone() * (a.clone() * twice - q1.clone() * ev2) * half3;
        let in_t = square.clone() * (k * self.small(3) + a * square.clone() * self.small(5))
            - e.clone() * t.clone() * k_slope.clone()
            - e.clone() * turn
            + (e.clone() * v.clone()).square() * m_slope.clone();
        let in_epsilon = square * k_slope - m.clone() - e * v * (m_slope + q1 * p1 * self.double(0.5));
        [in_t, in_epsilon, m]
    }

    /// x = q²/(2p^{3/2}v).
    fn x(&self, v: &E) -> E {
        let [p, q] = self.p_and_q(v, &self.sums(v));
        q.square() / (p.clone() * p.sqrt() * v.clone()) * self.double(0.5)
    }
}
