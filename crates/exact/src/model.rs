//! The exact body in the frame's units, and its constants in any arithmetic.

use dashu_int::IBig;
use dashu_ratio::RBig;

use bifdiag_body::{Axis, Body, Frame, Number};
use bifdiag_equilibria::stability::exact::ExactBody;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::polynomial::{Polynomial, rational};

/// One eigenspace of A.
#[derive(Clone, Debug)]
pub(super) struct Group {
    /// Its moment.
    pub a: RBig,
    /// Σ r² over its axes.
    pub q: RBig,
    /// Its dimension.
    pub size: usize,
}

/// The body: eigenspaces by rising moment, in units in which the largest moment and |r| are of order 1.
#[derive(Clone, Debug)]
pub(super) struct Model {
    pub groups: Vec<Group>,
    /// Σ r².
    pub r2: RBig,
    /// |r|² and |r|² J_r of the body itself, also where its moments and r had to be rounded: the pole lines are exact.
    pub line: [RBig; 2],
    /// The moments and r are those of a tensor, rounded to 130 digits.
    pub rounded: bool,
    /// What the tensor of a rounded body says itself: by it points are compared with curves.
    known: Option<Known>,
    /// Numbers of the groups that carry r.
    pub active: Vec<usize>,
    /// Numbers of the others.
    pub passive: Vec<usize>,
    /// First axis of the frame in each group.
    pub axis: Vec<Axis>,
}

/// Of a tensor: rational, and not rounded.
#[derive(Clone, Debug)]
struct Known {
    /// See [`Model::family`].
    family: [Vec<RBig>; 4],
    /// R̂ and P̂ of each passive group.
    sums: Vec<(RBig, RBig)>,
}

/// A power of two, exactly.
pub(super) fn exact_unit(unit: f64) -> RBig {
    RBig::try_from(unit).unwrap_or(RBig::ONE)
}

impl Model {
    pub fn new(body: &Body, frame: &Frame) -> Self {
        let energy = exact_unit(frame.energy_unit);
        let momentum = exact_unit(frame.momentum_unit);
        // momentum² = (unit of A) · (unit of r).
        let moment = &momentum * &momentum / &energy;
        let mut axes: Vec<(RBig, RBig)> = body
            .moments()
            .iter()
            .zip(body.center())
            .map(|(a, r)| {
                let r = r.value() / &energy;
                (Number::value(a) / &moment, &r * &r)
            })
            .collect();
        axes.sort();
        let mut groups: Vec<Group> = Vec::new();
        let mut axis = Vec::new();
        for (k, (a, q)) in Axis::ALL.into_iter().zip(axes) {
            match groups.last_mut() {
                Some(group) if group.a == a => {
                    group.q += q;
                    group.size += 1;
                }
                _ => {
                    groups.push(Group { a, q, size: 1 });
                    axis.push(k);
                }
            }
        }
        let r2 = groups.iter().fold(RBig::ZERO, |sum, group| sum + &group.q);
        let line =
            [body.center_squared() / (&energy * &energy), body.weighted_moment() / (&energy * &energy * &moment)];
        let (active, passive) = (0..groups.len()).partition(|&k| !groups[k].q.is_zero());
        let rounded = body.is_rounded();
        let known = rounded.then(|| {
            let exact = ExactBody::new(body, frame);
            let passive: &Vec<usize> = &passive;
            Known {
                family: exact.family_in_frame(),
                sums: passive.iter().map(|&group| exact.sums_in_frame(axis[group])).collect(),
            }
        });
        Self { groups, r2, line, rounded, known, active, passive, axis }
    }

    pub fn a(&self, group: usize) -> &RBig {
        &self.groups[group].a
    }

    pub fn difference(&self, i: usize, k: usize) -> RBig {
        &self.groups[i].a - &self.groups[k].a
    }

    /// J_r = Σ a q / Σ q. Precondition: r ≠ 0.
    pub fn j_r(&self) -> RBig {
        self.groups.iter().fold(RBig::ZERO, |sum, g| sum + &g.a * &g.q) / &self.r2
    }

    /// R̂ = Σ q_j/(a_k − a_j) and P̂ = Σ q_j/(a_k − a_j)² over a passive group.
    pub fn sums_over(&self, group: usize) -> (RBig, RBig) {
        let (mut r_sum, mut p_sum) = (RBig::ZERO, RBig::ZERO);
        for &j in &self.active {
            let gap = self.difference(group, j);
            let term = &self.groups[j].q / &gap;
            p_sum += &term / gap;
            r_sum += term;
        }
        (r_sum, p_sum)
    }

    /// D = Π(μ−a), p = P D², q = Q D² and R D over the active groups, coefficients by rising power of μ.
    pub fn family(&self) -> [Vec<RBig>; 4] {
        let factor = |k: usize| vec![-self.a(k).clone(), RBig::ONE];
        let product = |skip: Option<usize>| {
            let kept = self.active.iter().filter(|&&k| Some(k) != skip);
            kept.fold(vec![RBig::ONE], |d, &k| rational::mul(&d, &factor(k)))
        };
        let (mut p, mut q, mut r) = (Vec::new(), Vec::new(), Vec::new());
        for &k in &self.active {
            let rest = product(Some(k));
            let squared = rational::mul(&rest, &rest);
            let weight = &self.groups[k].q;
            p = rational::add(&p, &rational::scale(&squared, weight));
            q = rational::add(&q, &rational::scale(&squared, &(weight * self.a(k))));
            r = rational::add(&r, &rational::scale(&rest, weight));
        }
        [product(None), p, q, r]
    }

    /// [`family`](Self::family) by the tensor of a rounded body.
    pub fn known_family(&self) -> [Vec<RBig>; 4] {
        self.known.as_ref().map_or_else(|| self.family(), |known| known.family.clone())
    }

    /// [`sums_over`](Self::sums_over) by the tensor of a rounded body.
    pub fn known_sums(&self, group: usize) -> (RBig, RBig) {
        let place = || self.passive.iter().position(|&k| k == group);
        let known = self.known.as_ref().and_then(|known| known.sums.get(place()?).cloned());
        known.unwrap_or_else(|| self.sums_over(group))
    }

    /// [`cusp_polynomial`](Self::cusp_polynomial) by the tensor of a rounded body.
    pub fn known_cusp_polynomial(&self) -> Polynomial {
        cusp_polynomial(&self.known_family())
    }

    /// 4(q'D − 2qD')p − 3(p'D − 2pD')q: its roots of odd multiplicity are the cusps of the generic family (Lemma 4.5 of
    /// docs/mathematics.md).
    /// Built over the groups that carry r, so that no spurious factor (μ − a_k) appears; degree 10 for three groups,
    /// 5 for two, 0 for one.
    pub fn cusp_polynomial(&self) -> Polynomial {
        cusp_polynomial(&self.family())
    }

    /// N = (q/2 − RD·D) p − q²/(2J_r) and F = N² − r² p³D²: at a root of F the generic family meets a pole line,
    /// P+ where N < 0 and P− where N > 0 (Proposition 5.3). The leading coefficients of F cancel exactly.
    pub fn pole_polynomials(&self) -> [Polynomial; 2] {
        let [d, p, q, r] = self.family();
        let half = RBig::from_parts(IBig::ONE, 2u8.into());
        let height = rational::sub(&rational::scale(&q, &half), &rational::mul(&r, &d));
        let line = rational::scale(&rational::mul(&q, &q), &(half / self.j_r()));
        let n = rational::sub(&rational::mul(&height, &p), &line);
        let cube = rational::mul(&rational::mul(&p, &p), &rational::mul(&p, &rational::mul(&d, &d)));
        let f = rational::sub(&rational::mul(&n, &n), &rational::scale(&cube, &self.r2));
        [Polynomial::from_rationals(&n), Polynomial::from_rationals(&f)]
    }

    /// Σ q_i q_j (a_i − a_j)² (μ − a_k)³ over the three active groups: its one real root is where dJ/dμ = 0.
    pub fn inflection_polynomial(&self) -> Option<Polynomial> {
        let [i, j, k] = self.active[..] else { return None };
        let term = |i: usize, j: usize, k: usize| {
            let gap = self.difference(i, j);
            let weight = &self.groups[i].q * &self.groups[j].q * &gap * gap;
            let factor = [-self.a(k).clone(), RBig::ONE];
            let cube = rational::mul(&rational::mul(&factor, &factor), &factor);
            rational::scale(&cube, &weight)
        };
        let sum = rational::add(&rational::add(&term(i, j, k), &term(j, k, i)), &term(k, i, j));
        Some(Polynomial::from_rationals(&sum))
    }

    /// In v = s² over a passive group: E = (a v − R̂)²/J_r − a v² + 3R̂ v and E² − 4r² v³, whose roots beyond P̂ are the
    /// meetings with a pole line, P+ where E > 0 and P− where E < 0 (from h = s a/2 − 3R̂/(2s) = x/J_r ∓ r).
    pub fn pole_polynomials_over(&self, group: usize) -> [Polynomial; 2] {
        let (r_sum, _) = self.sums_over(group);
        let a = self.a(group).clone();
        let j = [-r_sum.clone(), a.clone()];
        let square = rational::scale(&rational::mul(&j, &j), &(RBig::ONE / self.j_r()));
        let e = rational::sub(&square, &[RBig::ZERO, r_sum * RBig::from(-3), a]);
        let cube = [RBig::ZERO, RBig::ZERO, RBig::ZERO, &self.r2 * RBig::from(4)];
        let f = rational::sub(&rational::mul(&e, &e), &cube);
        [Polynomial::from_rationals(&e), Polynomial::from_rationals(&f)]
    }
}

fn cusp_polynomial([d, p, q, _]: &[Vec<RBig>; 4]) -> Polynomial {
    let d_prime = rational::derivative(d);
    let reduced = |f: &[RBig]| {
        let first = rational::mul(&rational::derivative(f), d);
        let second = rational::scale(&rational::mul(f, &d_prime), &RBig::from(2));
        rational::sub(&first, &second)
    };
    let left = rational::scale(&rational::mul(&reduced(q), p), &RBig::from(4));
    let right = rational::scale(&rational::mul(&reduced(p), q), &RBig::from(3));
    Polynomial::from_rationals(&rational::sub(&left, &right))
}

/// Numbers of the model in one arithmetic.
#[derive(Clone, Debug)]
pub(super) struct Constants<E: Arithmetic> {
    pub precision: E::Precision,
    pub a: Vec<E>,
    pub q: Vec<E>,
    pub root_q: Vec<E>,
    /// `diff[i][k]` = a_i − a_k.
    pub diff: Vec<Vec<E>>,
    /// R̂ and P̂ of each passive group.
    pub sums: Vec<Option<(E, E)>>,
    pub r: E,
    /// Absent for r = 0.
    pub j_r: Option<E>,
}

impl<E: Arithmetic> Constants<E> {
    pub fn new(model: &Model, precision: E::Precision) -> Self {
        let number = |x: &RBig| E::rational(x, precision);
        let n = model.groups.len();
        let q: Vec<E> = model.groups.iter().map(|g| number(&g.q)).collect();
        let sums = (0..n).map(|k| {
            model.passive.contains(&k).then(|| {
                let (r_sum, p_sum) = model.sums_over(k);
                (number(&r_sum), number(&p_sum))
            })
        });
        Self {
            precision,
            a: model.groups.iter().map(|g| number(&g.a)).collect(),
            root_q: q.iter().map(E::sqrt).collect(),
            q,
            diff: (0..n).map(|i| (0..n).map(|k| number(&model.difference(i, k))).collect()).collect(),
            sums: sums.collect(),
            r: number(&model.r2).sqrt(),
            j_r: (!model.active.is_empty()).then(|| number(&model.j_r())),
        }
    }

    pub fn small(&self, value: i32) -> E {
        E::small(value, self.precision)
    }

    /// The common part of two enclosures of one value. Disjoint ones contradict each other, which is a defect of this
    /// program: then nothing is known, so that nothing is proved from it.
    pub fn common(&self, one: &E, other: &E) -> E {
        one.meet(other).unwrap_or_else(|| E::line(self.precision))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model(a: [&str; 3], r: [&str; 3]) -> Model {
        let body = Body::parse(&a, &r).unwrap();
        Model::new(&body, &body.frame())
    }

    /// D, N and their like from the characteristic polynomial are those from moments and components.
    #[test]
    fn both_ways_to_the_polynomials_agree() {
        for (a, r) in [
            (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
            (["200", "110", "100"], ["0.94868", "0", "0.61623"]),
            (["1/3", "1/7", "2/5"], ["0", "-2/9", "0"]),
            (["2", "2", "1"], ["0.6", "0.8", "1/3"]),
            (["2", "2", "1"], ["0", "0", "1/3"]),
            (["2", "1", "1"], ["3", "0", "0"]),
            (["2", "2", "2"], ["1", "2", "3"]),
        ] {
            let body = Body::parse(&a, &r).unwrap();
            let (model, exact) = (Model::new(&body, &body.frame()), ExactBody::new(&body, &body.frame()));
            assert_eq!(exact.family_in_frame(), model.family(), "{a:?} {r:?}");
            for &group in &model.passive {
                assert_eq!(exact.sums_in_frame(model.axis[group]), model.sums_over(group), "{a:?} {r:?}");
            }
        }
    }

    #[test]
    fn degrees_are_those_of_the_theory() {
        let generic = model(["2", "1.1", "1"], ["0.3", "0.5", "0.7"]);
        assert_eq!(generic.cusp_polynomial().degree(), 10);
        assert_eq!(generic.pole_polynomials()[1].degree(), 16);
        assert_eq!(generic.inflection_polynomial().unwrap().degree(), 3);
        let plane = model(["2", "1.1", "1"], ["0.94868", "0", "0.61623"]);
        assert_eq!((plane.active.len(), plane.passive.len()), (2, 1));
        assert_eq!(plane.cusp_polynomial().degree(), 5);
        let axis = model(["2", "2", "1"], ["0.6", "0.8", "0"]);
        assert_eq!((axis.active.len(), axis.groups.len(), axis.cusp_polynomial().degree()), (1, 2, 0));
        assert!(axis.pole_polynomials()[1].is_zero());
    }
}
