//! A family of relative equilibria on a coordinate t > 0, with the conditions for a change of type as polynomials in t.

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::body::{ExactBody, Forms, Over};
use crate::stability::{Constants, State};
use bifdiag_body::Axis;
use bifdiag_numbers::enclosure::{Enclosure, horner};
use bifdiag_numbers::polynomial::rational::{self, over_one_denominator};
use bifdiag_numbers::polynomial::{Polynomial, Root};

/// A family of relative equilibria with one parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// The generic family over an interval between active moments, numbered from μ = −∞.
    Generic(usize),
    /// The family over the passive moment of this axis.
    Over(Axis),
}

/// The parameter as a function of t.
#[derive(Clone, Debug)]
enum Coordinate {
    /// μ = a_first − t.
    Left(Axis),
    /// μ = a_left + (a_right − a_left) t, t < 1.
    Inner(Axis, Axis),
    /// μ = a_last + t.
    Right(Axis),
    /// z = 1/s² = z_max t, t < 1.
    Over { axis: Axis, r_sum: RBig, z_max: RBig },
}

/// A family on its coordinate.
#[derive(Clone, Debug)]
pub struct FamilyChart {
    /// The family.
    pub family: Family,
    coordinate: Coordinate,
    /// Pieces are numbered against t: by rising μ, by rising s, and on an axis by rising l.
    pub is_reversed: bool,
    /// For the sign of c; the zero polynomial on a circle of equilibria.
    pub zero: Polynomial,
    /// Its factor that changes sign at cusps.
    pub cusp: Polynomial,
    /// Where the pairs over passive moments leave the family: the axis and t, which is a root of a polynomial.
    pub pitchforks: Vec<(Axis, Root)>,
    /// For the sign of b.
    pub swing: Polynomial,
    /// For the signs of b² − 4c, 4b² − 25c and 9b² − 100c.
    pub resonances: [Polynomial; 3],
    /// p = Σ D² r_k²/τ_k²; 1 over a passive moment.
    total: Polynomial,
}

/// Bits to which a pitchfork at an irrational moment is known at first.
const PITCHFORK_BITS: usize = 400;

impl FamilyChart {
    /// The generic family over interval `n`.
    #[must_use]
    pub fn generic(body: &ExactBody, forms: &Forms, n: usize) -> Self {
        let left = n.checked_sub(1).map(|k| body.active[k]);
        let right = body.active.get(n).copied();
        let coordinate = match (left, right) {
            (Some(left), Some(right)) => Coordinate::Inner(left, right),
            (Some(last), None) => Coordinate::Right(last),
            (None, right) => Coordinate::Left(right.unwrap_or(Axis::ALL[0])),
        };
        let map = |p: &Polynomial| coordinate.mapped(body, p);
        let fork = |&k: &Axis| Some((k, coordinate.pitchfork(body, k)?));
        let pitchforks = body.passive.iter().filter_map(fork).collect();
        let (zero, cusp) = (map(&forms.zero), map(&forms.cusp));
        let (swing, resonances) = (map(&forms.swing), forms.resonances.each_ref().map(map));
        let is_reversed = matches!(coordinate, Coordinate::Left(_)) || body.active.len() == 1;
        Self {
            family: Family::Generic(n),
            zero,
            cusp,
            pitchforks,
            swing,
            resonances,
            is_reversed,
            total: map(&forms.p),
            coordinate,
        }
    }

    /// The family over a passive moment; needs r ≠ 0.
    #[must_use]
    pub fn over(body: &ExactBody, axis: Axis) -> Self {
        let Over { r_sum, p_sum, moments, rest } = body.over(axis);
        let (a, z_max) = (&body.a[axis], RBig::ONE / p_sum);
        // Σ a_kⁿ γ_k², γ_i² and a_i + 3zR̂ are linear in t, with γ_i² = 1 − t: [at 0, slope], taken over one denominator.
        let power = [a.clone(), a * a, a * a * a];
        let moment = |n: usize| [power[n].clone(), &moments[n] * &z_max - &power[n]];
        let cusp = [a.clone(), RBig::from(3) * &r_sum * &z_max];
        let linear = [moment(0), moment(1), moment(2), [RBig::ONE, -RBig::ONE], cusp];
        let whole = over_one_denominator(linear.as_flattened()).0;
        let polynomial = |n: usize| Polynomial::new(whole[2 * n..2 * n + 2].to_vec());
        let (moments, cusp) = ([0, 1, 2].map(polynomial), polynomial(4));
        // χ det A = γ_i² τ_j τ_k (a_i + 3zR̂).
        let zero = polynomial(3).times(&cusp).scaled(rest.numerator());
        let mu = [a.numerator().clone(), IBig::from(a.denominator().clone())].map(Polynomial::constant);
        let times = IBig::from(rest.denominator().clone());
        let (swing, resonances) = body.invariants.swing_and_resonances(&mu, &moments, (&zero, &times));
        let [zero, cusp, swing] = [zero, cusp, swing].map(Polynomial::primitive);
        let resonances = resonances.map(Polynomial::primitive);
        let (family, coordinate) = (Family::Over(axis), Coordinate::Over { axis, r_sum, z_max });
        let total = Polynomial::constant(IBig::ONE);
        Self { family, coordinate, is_reversed: true, zero, cusp, pitchforks: Vec::new(), swing, resonances, total }
    }

    /// The polynomial whose roots are the equilibria at x.
    #[must_use]
    pub fn at_momentum(&self, body: &ExactBody, forms: &Forms, x: &RBig) -> Polynomial {
        let Coordinate::Over { axis, r_sum, z_max } = &self.coordinate else {
            return self.coordinate.mapped(body, &forms.at_momentum(x));
        };
        // (a − zR̂)⁴ = 4x²z
        let j = [body.a[*axis].clone(), -(r_sum * z_max)];
        let square = rational::mul(&j, &j);
        let fourth = rational::mul(&square, &square);
        Polynomial::from_rationals(&rational::sub(&fourth, &[RBig::ZERO, RBig::from(4) * x * x * z_max]))
    }

    /// The polynomial whose roots are the steady rotations with this Ω⁴.
    #[must_use]
    pub fn at_spin(&self, body: &ExactBody, forms: &Forms, fourth: &RBig) -> Polynomial {
        match &self.coordinate {
            // z = 1/Ω⁴
            Coordinate::Over { z_max, .. } => Polynomial::from_rationals(&[-RBig::ONE, fourth * z_max]),
            coordinate => coordinate.mapped(body, &forms.at_spin(fourth)),
        }
    }

    /// The polynomial whose roots are the folds of the generic family, where its spin turns.
    #[must_use]
    pub fn fold(&self, body: &ExactBody, forms: &Forms) -> Polynomial {
        self.coordinate.mapped(body, &forms.fold())
    }

    /// Roots of a polynomial in t on the family, ascending. `None` when they are closer than 2^-4000.
    #[must_use]
    pub fn roots(&self, polynomial: &Polynomial) -> Option<Vec<Root>> {
        if self.is_bounded() { polynomial.roots_in_unit() } else { polynomial.positive_roots() }
    }

    /// p at t, up to a positive factor that is the same for all t.
    pub fn total<E: Enclosure>(&self, t: &RBig, precision: E::Precision) -> E {
        horner(&self.total.enclosed(precision), &E::rational(t, precision), precision)
    }

    /// The degree at most of the polynomial with the zeros of Arnold's determinant (Theorem 13.13 of docs/algorithms.md).
    pub fn degree_of_determinant(&self, body: &ExactBody) -> usize {
        match self.family {
            Family::Over(_) => 9,
            Family::Generic(_) if body.active.len() == 1 => 5,
            Family::Generic(_) => 9 * (2 * body.active.len() - 1),
        }
    }

    /// Its zeros, with their multiplicity, that are not zeros of the determinant: pitchforks, double moments, and the
    /// resonance 1:2 at a moment (l = ∞). On an axis pitchforks are poles of the determinant unless a cusp is there, and the
    /// resonance is not one of them.
    pub fn zeros_of_degeneracy(&self, body: &ExactBody) -> Vec<RBig> {
        let is_axis = body.active.len() == 1 && matches!(self.family, Family::Generic(_));
        let is_double = |k: Axis| body.group.iter().filter(|group| **group == body.group[k.index()]).count() > 1;
        let order = |p: &Polynomial| p.coefficients().iter().take_while(|c| c.is_zero()).count();
        let resonant = |p: &Polynomial| if is_axis { 0 } else { order(p) };
        let at = |k: Axis, t: RBig, resonance: &Polynomial| {
            let double = if is_double(k) { 2 - usize::from(is_axis) } else { 0 };
            vec![t; double + resonant(resonance)]
        };
        let [_, resonance, _] = &self.resonances;
        let at_pitchfork = |(k, t): &(Axis, Root)| {
            let times = usize::from(!is_axis) + usize::from(body.has_cusp_at_pitchfork(*k));
            vec![t.lo.clone(); times]
        };
        let pitchforks = self.pitchforks.iter().flat_map(at_pitchfork);
        let ends = match &self.coordinate {
            Coordinate::Left(axis) | Coordinate::Right(axis) => at(*axis, RBig::ZERO, resonance),
            Coordinate::Inner(left, right) => {
                let turned = resonance.composed(&RBig::ONE, &RBig::from(-1));
                [at(*left, RBig::ZERO, resonance), at(*right, RBig::ONE, &turned)].concat()
            }
            Coordinate::Over { axis, .. } => {
                let times = if body.has_cusp_at_pitchfork(*axis) { 3 } else { 1 };
                [vec![RBig::ONE; times], vec![RBig::ZERO; resonant(resonance)]].concat()
            }
        };
        pitchforks.chain(ends).collect()
    }

    /// t < 1.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        matches!(self.coordinate, Coordinate::Inner(..) | Coordinate::Over { .. })
    }

    /// c = 0 throughout: a circle of equilibria.
    #[must_use]
    pub fn is_circle(&self) -> bool {
        self.zero.is_zero()
    }

    /// The equilibrium at a root, or the range that holds it, narrowed to 2^−bits relative to the next moment.
    pub fn state<E: Enclosure>(&self, body: &ExactBody, c: &Constants<E>, root: &mut Root, bits: usize) -> State<E> {
        root.refine(bits);
        let number = |x: &RBig| E::rational(x, c.precision);
        if let Coordinate::Over { axis, z_max, .. } = &self.coordinate {
            let [lo, hi] = [&root.lo, &root.hi].map(|t| number(&body.z_in_frame(&(t * z_max))));
            return State::over(c, *axis, &lo.hull(&hi));
        }
        let (base, ends) = self.coordinate.distance(body, root, bits);
        State::generic(c, base, &number(&ends[0]).hull(&number(&ends[1])))
    }

    /// The equilibria over a narrow range of t.
    pub fn state_over<E: Enclosure>(&self, body: &ExactBody, c: &Constants<E>, range: [&RBig; 2]) -> State<E> {
        let number = |x: &RBig| E::rational(x, c.precision);
        let hull = |ends: [RBig; 2]| number(&ends[0]).hull(&number(&ends[1]));
        if let Coordinate::Over { axis, z_max, .. } = &self.coordinate {
            return State::over(c, *axis, &hull(range.map(|t| body.z_in_frame(&(t * z_max)))));
        }
        let (base, scale, from) = self.coordinate.nearest(body, range[1]);
        State::generic(c, base, &hull(range.map(|t| body.moment_in_frame(&((t - &from) * &scale)))))
    }
}

impl Coordinate {
    fn mapped(&self, body: &ExactBody, p: &Polynomial) -> Polynomial {
        let number = |k: &Axis| body.a[*k].clone();
        match self {
            Self::Left(first) => p.composed(&number(first), &RBig::from(-1)),
            Self::Inner(left, right) => p.composed(&number(left), &(number(right) - number(left))),
            Self::Right(last) => p.composed(&number(last), &RBig::ONE),
            Self::Over { .. } => p.clone(),
        }
    }

    /// t of μ = a_k, if that is on the family.
    fn of_moment(&self, body: &ExactBody, k: Axis) -> Option<RBig> {
        let gap = |i: Axis, j: Axis| &body.a[i] - &body.a[j];
        let t = match *self {
            Self::Left(first) => gap(first, k),
            Self::Inner(left, right) => gap(k, left) / gap(right, left),
            Self::Right(last) => gap(k, last),
            Self::Over { .. } => return None,
        };
        let bounded = matches!(self, Self::Inner(..));
        (t > RBig::ZERO && !(bounded && t >= RBig::ONE)).then_some(t)
    }

    /// t of μ = a_k, if that is on the family: of an irrational moment a root of the polynomial of all passive ones.
    fn pitchfork(&self, body: &ExactBody, k: Axis) -> Option<Root> {
        let t = self.of_moment(body, k)?;
        if body.invariants.has_moment(&body.a[k]) {
            return Some(Root::exact(&Polynomial::from_rationals(&[-&t, RBig::ONE]), t));
        }
        let polynomial = self.mapped(body, &body.invariants.passive);
        let mut roots = polynomial.positive_roots()?;
        for root in &mut roots {
            root.refine(PITCHFORK_BITS);
        }
        let distance = |root: &Root| (&root.lo - &t).max(&t - &root.lo);
        roots.into_iter().min_by_key(distance)
    }

    /// The active moment from which μ is measured where t is at most `hi`, dμ/dt, and t at this moment.
    fn nearest(&self, body: &ExactBody, hi: &RBig) -> (Axis, RBig, RBig) {
        match *self {
            Self::Left(first) => (first, RBig::from(-1), RBig::ZERO),
            Self::Right(last) => (last, RBig::ONE, RBig::ZERO),
            Self::Over { axis, .. } => (axis, RBig::ZERO, RBig::ZERO),
            Self::Inner(left, right) => {
                let width = &body.a[right] - &body.a[left];
                let is_left = *hi <= RBig::ONE / RBig::from(2);
                if is_left { (left, width, RBig::ZERO) } else { (right, width, RBig::ONE) }
            }
        }
    }

    /// The nearest active moment and μ − a_base at the ends of the root's range, in the frame's units.
    fn distance(&self, body: &ExactBody, root: &mut Root, bits: usize) -> (Axis, [RBig; 2]) {
        root.refine(bits);
        let (base, scale, from) = self.nearest(body, &root.hi);
        if from == RBig::ONE {
            // Relative to 1 − t, which may be small.
            let mut finer = bits;
            while !root.is_exact() && (&root.hi - &root.lo) * RBig::from(IBig::ONE << bits) > RBig::ONE - &root.hi {
                finer *= 2;
                root.refine(finer);
            }
        }
        let mut ends = [&root.lo, &root.hi].map(|t| body.moment_in_frame(&((t - &from) * &scale)));
        ends.sort();
        (base, ends)
    }
}
