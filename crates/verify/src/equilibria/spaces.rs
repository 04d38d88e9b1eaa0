//! The body of a document, exact: the eigenspaces of A in the certificate's units, and the exact polynomials whose roots are cusps, inflections and
//! meetings with pole lines.

use bifdiag_schema::BodyDocument;
use dashu_ratio::RBig;

use crate::Refused;
use crate::numbers::fixed::Fixed;
use crate::numbers::number;
use crate::numbers::polynomial::{Coefficients, Polynomial, plus, times};

/// A and r as the document writes them.
pub(crate) struct Body {
    pub moments: [RBig; 3],
    pub center: [RBig; 3],
}

impl Body {
    pub fn read(document: &BodyDocument) -> Result<Self, Refused> {
        let [a1, a2, a3] = document.given.moments.each_ref().map(|text| number::given(text));
        let [r1, r2, r3] = document.given.center.each_ref().map(|text| number::given(text));
        let body = Self { moments: [a1?, a2?, a3?], center: [r1?, r2?, r3?] };
        match body.moments.iter().position(|moment| *moment <= RBig::ZERO) {
            Some(axis) => Err(Refused::Body { axis: axis + 1, value: document.given.moments[axis].clone() }),
            None => Ok(body),
        }
    }
}

/// An eigenspace of A.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    pub a: RBig,
    /// |r|² of the part of r in it.
    pub q: RBig,
    /// Its axes, numbered as the body's.
    pub axes: Vec<usize>,
    pub a_set: Fixed,
    pub q_set: Fixed,
    pub root_q: Fixed,
}

/// The body in the certificate's units.
#[derive(Clone, Debug)]
pub(crate) struct Spaces {
    /// The unit of moments of inertia, and that of energy, in those of the body.
    pub moment: RBig,
    pub energy: RBig,
    /// By rising moment.
    pub list: Vec<Space>,
    /// Numbers of those that carry r.
    pub active: Vec<usize>,
    pub r2: RBig,
    /// |r|.
    pub norm: Fixed,
    /// a_i − a_k.
    differences: Vec<Vec<Fixed>>,
    /// Fractional bits of the numbers here, and of all that are computed from them.
    bits: usize,
}

impl Space {
    fn new(a: RBig, axes: Vec<usize>, r: &[RBig; 3], bits: usize) -> Option<Self> {
        let q = axes.iter().fold(RBig::ZERO, |sum, &axis| sum + &r[axis] * &r[axis]);
        let q_set = Fixed::of(&q, bits);
        Some(Self { a_set: Fixed::of(&a, bits), root_q: q_set.root()?, q_set, a, q, axes })
    }
}

impl Spaces {
    /// A in units of `moment`, r in units of `energy`; sets have this number of bits.
    pub fn new(body: &Body, [moment, energy]: [RBig; 2], bits: usize) -> Result<Self, Refused> {
        let r = body.center.each_ref().map(|r| r / &energy);
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| body.moments[i].cmp(&body.moments[j]));
        let mut groups: Vec<(RBig, Vec<usize>)> = Vec::new();
        for i in order {
            let a = &body.moments[i] / &moment;
            match groups.last_mut() {
                Some((last, axes)) if *last == a => axes.push(i),
                _ => groups.push((a, vec![i])),
            }
        }
        let unbounded = || Refused::uncertain("the centre of mass cannot be enclosed");
        let list: Option<Vec<Space>> = groups.into_iter().map(|(a, axes)| Space::new(a, axes, &r, bits)).collect();
        let list = list.ok_or_else(unbounded)?;
        let r2 = r.iter().fold(RBig::ZERO, |sum, c| sum + c * c);
        let norm = Fixed::of(&r2, bits).root().ok_or_else(unbounded)?;
        let active = (0..list.len()).filter(|&k| !list[k].q.is_zero()).collect();
        let row = |i: &Space| list.iter().map(|k| Fixed::of(&(&i.a - &k.a), bits)).collect();
        let differences = list.iter().map(row).collect();
        Ok(Self { moment, energy, list, active, r2, norm, differences, bits })
    }

    /// The unit of l², in which x = l²/2 is measured.
    pub fn square_of_momentum(&self) -> RBig {
        &self.moment * &self.energy * RBig::from(2)
    }

    /// An exact number as a set.
    pub fn set(&self, x: &RBig) -> Fixed {
        Fixed::of(x, self.bits)
    }

    /// Fractional bits of the sets here.
    pub fn bits(&self) -> usize {
        self.bits
    }

    /// Numbers of the spaces without r.
    pub fn passive(&self) -> Vec<usize> {
        (0..self.list.len()).filter(|k| !self.active.contains(k)).collect()
    }

    /// a_i − a_k.
    pub fn difference(&self, i: usize, k: usize) -> &Fixed {
        &self.differences[i][k]
    }

    /// The moments between which a branch of the generic family runs, by its number from below.
    pub fn interval(&self, branch: usize) -> [Option<&RBig>; 2] {
        [branch.checked_sub(1).map(|n| &self.list[self.active[n]].a), self.active.get(branch).map(|&k| &self.list[k].a)]
    }

    /// J of r̂.
    pub fn j_r(&self) -> RBig {
        self.list.iter().fold(RBig::ZERO, |sum, s| sum + &s.a * &s.q) / &self.r2
    }

    /// R̂ and P̂ over a space without r (Theorem 3.3).
    pub fn sums(&self, base: usize) -> (RBig, RBig) {
        self.active.iter().fold((RBig::ZERO, RBig::ZERO), |(r, p), &k| {
            let d = &self.list[base].a - &self.list[k].a;
            let term = &self.list[k].q / &d;
            (r + &term, p + term / d)
        })
    }

    /// μ − a_k.
    pub fn factor(&self, k: usize) -> Coefficients {
        vec![-self.list[k].a.clone(), RBig::ONE]
    }

    /// Π_{j≠skipped} (μ−a_j)^power over the active spaces.
    pub fn product(&self, skipped: &[usize], power: usize) -> Coefficients {
        self.active.iter().filter(|k| !skipped.contains(k)).fold(vec![RBig::ONE], |product, &k| {
            (0..power).fold(product, |product, _| times(&product, &self.factor(k)))
        })
    }

    /// D (Σ t_k)(Σ u_k a_k) + 4 Σ_{i<k} u_i u_k (a_i−a_k)² D/((μ−a_i)(μ−a_k)) with u_k = q_k Π_{j≠k}(μ−a_j)² and
    /// D t_k = q_k Π_{j≠k}(μ−a_j)³: the numerator of T J + 4V, whose zeros are the cusps (Lemma 4.5).
    pub fn cusp_polynomial(&self) -> Polynomial {
        let u = |k: usize| times(&self.product(&[k], 2), &[self.list[k].q.clone()]);
        let (mut t, mut j, mut v) = (Vec::new(), Vec::new(), Vec::new());
        for (n, &k) in self.active.iter().enumerate() {
            t = plus(&t, &self.product(&[k], 3), &self.list[k].q);
            j = plus(&j, &u(k), &self.list[k].a);
            for &i in &self.active[..n] {
                let d = &self.list[i].a - &self.list[k].a;
                let term = times(&times(&u(i), &u(k)), &self.product(&[i, k], 1));
                v = plus(&v, &term, &(&d * &d));
            }
        }
        Polynomial::new(&plus(&times(&t, &j), &v, &RBig::from(4)))
    }

    /// N and F of the meetings with pole lines (Proposition 5.3).
    pub fn pole_polynomials(&self) -> [Polynomial; 2] {
        let (mut p, mut q, mut r) = (Vec::new(), Vec::new(), Vec::new());
        for &k in &self.active {
            let squared = self.product(&[k], 2);
            p = plus(&p, &squared, &self.list[k].q);
            q = plus(&q, &squared, &(&self.list[k].q * &self.list[k].a));
            r = plus(&r, &self.product(&[k], 1), &self.list[k].q);
        }
        let d = self.product(&[], 1);
        let half = RBig::ONE / RBig::from(2);
        let height = plus(&plus(&[], &q, &half), &times(&r, &d), &RBig::from(-1));
        let line = -(&half / self.j_r());
        let n = plus(&times(&height, &p), &times(&q, &q), &line);
        let cube = times(&times(&p, &times(&p, &p)), &times(&d, &d));
        let f = plus(&times(&n, &n), &cube, &-self.r2.clone());
        [n, f].map(|polynomial| Polynomial::new(&polynomial))
    }

    /// E and E² − 4r²v³ over a space without r, in y = v − P̂ (Proposition 5.4).
    pub fn pole_polynomials_over(&self, base: usize) -> [Polynomial; 2] {
        let (r_sum, p_sum) = self.sums(base);
        let a = &self.list[base].a;
        let j = [-r_sum.clone(), a.clone()];
        let e = plus(&[RBig::ZERO, r_sum * RBig::from(3), -a.clone()], &times(&j, &j), &(RBig::ONE / self.j_r()));
        let f = plus(&times(&e, &e), &[RBig::ZERO, RBig::ZERO, RBig::ZERO, RBig::ONE], &(&self.r2 * RBig::from(-4)));
        // Horner's scheme with v = P̂ + y.
        let v = [p_sum, RBig::ONE];
        [e, f].map(|polynomial| {
            let in_y = polynomial.iter().rev().fold(Vec::new(), |sum: Coefficients, coefficient| {
                plus(&times(&sum, &v), std::slice::from_ref(coefficient), &RBig::ONE)
            });
            Polynomial::new(&in_y)
        })
    }

    /// The cubic whose one root is the place where dJ/dμ = 0 (Proposition 3.8).
    pub fn inflection_polynomial(&self, [i, j, k]: [usize; 3]) -> Polynomial {
        let sum = [(i, j, k), (j, k, i), (k, i, j)].into_iter().fold(Vec::new(), |sum, (i, j, k)| {
            let d = &self.list[i].a - &self.list[j].a;
            let cube = (0..3).fold(vec![RBig::ONE], |cube, _| times(&cube, &self.factor(k)));
            plus(&sum, &cube, &(&self.list[i].q * &self.list[j].q * &d * &d))
        });
        Polynomial::new(&sum)
    }
}
