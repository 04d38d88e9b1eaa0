//! Eigenvalues as roots of the characteristic polynomial.

use dashu_base::BitTest;
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::matrix::Symmetric;
use super::real::Real;
use crate::Sign;
use crate::polynomial::{Polynomial, Root};

/// An eigenvalue: a rational, or an isolated root of det(μ − A).
#[derive(Clone, Debug)]
pub struct Eigenvalue {
    /// 1, 2 or 3.
    pub multiplicity: usize,
    /// A positive root of det(y − shift − A).
    root: Root,
    shift: RBig,
}

impl Symmetric {
    /// The distinct eigenvalues, ascending. Those that are not simple are rational, and so is what is left beside them.
    #[must_use]
    pub fn eigenvalues(&self) -> Vec<Eigenvalue> {
        let shift = self.positive_shift();
        let moved = self.map(|i, j, x| if i == j { x + &shift } else { x.clone() });
        let polynomial = Polynomial::from_rationals(&moved.characteristic());
        let roots = polynomial.positive_roots().unwrap_or_default();
        roots.into_iter().map(|root| Eigenvalue::new(&polynomial, root, shift.clone())).collect()
    }

    /// What to add to the diagonal so that all eigenvalues are positive (Gershgorin's circles).
    fn positive_shift(&self) -> RBig {
        if self.leading_minors().iter().all(|minor| *minor > RBig::ZERO) {
            return RBig::ZERO;
        }
        let magnitude = |x: &RBig| x.clone().max(-x.clone());
        let rows = self.rows().each_ref().map(|row| row.iter().fold(RBig::ZERO, |sum, x| sum + magnitude(x)));
        rows.into_iter().fold(RBig::ONE, RBig::max) * RBig::from(2)
    }
}

impl Eigenvalue {
    fn new(polynomial: &Polynomial, mut root: Root, shift: RBig) -> Self {
        // A rational root p/q of an integer polynomial has a q that divides its leading coefficient.
        let leading = polynomial.leading();
        while !root.is_exact() && (&root.hi - &root.lo) * RBig::from(2) * RBig::from(leading.clone()) > RBig::ONE {
            let narrowness = &root.hi / (&root.hi - &root.lo);
            let known = narrowness.numerator().bit_len().saturating_sub(narrowness.denominator().bit_len());
            root.refine(known + 8);
        }
        if !root.is_exact() {
            let at = (&root.lo * RBig::from(leading.clone())).ceil();
            let candidate = RBig::from(at) / RBig::from(leading);
            if polynomial.sign_at(&candidate) == Sign::Zero && candidate <= root.hi {
                root = Root::exact(polynomial, candidate);
            }
        }
        let multiplicity = if root.is_exact() { polynomial.multiplicity_at(&root.lo) } else { 1 };
        Self { multiplicity, root, shift }
    }

    /// The eigenvalue, where it is rational.
    #[must_use]
    pub fn rational(&self) -> Option<RBig> {
        self.root.is_exact().then(|| &self.root.lo - &self.shift)
    }

    /// The eigenvalue up to 2^−bits of the matrix's size (of the eigenvalue itself where the matrix is positive definite).
    #[must_use]
    pub fn enclosed(&mut self, bits: usize) -> Real {
        self.root.refine(bits);
        Real { lo: &self.root.lo - &self.shift, hi: &self.root.hi - &self.shift }
    }

    /// Whether it is a root of a polynomial with these coefficients, by rising power: decided by gcd.
    #[must_use]
    pub fn is_root_of(&self, coefficients: &[RBig]) -> bool {
        let polynomial = Polynomial::from_rationals(coefficients);
        polynomial.is_zero() || self.root.is_root_of(&polynomial.composed(&-self.shift.clone(), &RBig::ONE))
    }
}

impl Polynomial {
    /// The coefficient of the highest power, made positive; 1 for the zero polynomial.
    fn leading(&self) -> IBig {
        let leading = self.coefficients().last().cloned().unwrap_or(IBig::ONE);
        leading.clone().max(-leading)
    }

    /// How often x is a root.
    fn multiplicity_at(&self, x: &RBig) -> usize {
        let mut derivative = self.clone();
        let mut multiplicity = 0;
        while !derivative.is_zero() && derivative.sign_at(x) == Sign::Zero {
            derivative = derivative.derivative();
            multiplicity += 1;
        }
        multiplicity
    }
}
