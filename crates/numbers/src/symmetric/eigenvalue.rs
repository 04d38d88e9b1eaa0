//! Eigenvalues as roots of the characteristic polynomial, and the real numbers that they and their axes lead to.

use dashu_base::{BitTest, SquareRoot};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::matrix::Symmetric;
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
    /// The distinct eigenvalues, ascending. Multiple ones are rational, and so is the simple one beside a double one.
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
}

/// A real number, exact or enclosed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Real {
    /// Not above the number.
    pub lo: RBig,
    /// Not below the number; equal to `lo` when the number is this rational.
    pub hi: RBig,
}

impl Real {
    /// The rational number itself, with equal ends.
    #[must_use]
    pub fn exact(value: RBig) -> Self {
        Self { lo: value.clone(), hi: value }
    }

    /// The number is the rational `lo`.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        self.lo == self.hi
    }

    /// −x.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self { lo: -self.hi.clone(), hi: -self.lo.clone() }
    }

    /// hi − lo ≤ 10^−digits · |x|.
    #[must_use]
    pub fn is_known_to(&self, digits: usize) -> bool {
        let size = if self.lo > RBig::ZERO { &self.lo } else { &-self.hi.clone() };
        self.is_exact() || (&self.hi - &self.lo) * power_of_ten(digits) <= *size
    }

    /// √x of a rational x ≥ 0: exact where x is a square, else enclosed to `digits` decimal digits.
    #[must_use]
    pub fn root_of(x: &RBig, digits: usize) -> Self {
        let (numerator, denominator) = (x.numerator().clone().into_parts().1, x.denominator().clone());
        let [p, q] = [&numerator, &denominator].map(SquareRoot::sqrt);
        if &p * &p == numerator && &q * &q == denominator {
            return Self::exact(RBig::from_parts(p.into(), q));
        }
        // √(p/q) = √(p q 4^s) / (q 2^s), where s makes one unit less than 10^-digits of it.
        let product = &numerator * &denominator;
        let wanted = 4 * digits + 4;
        let shift = wanted.saturating_sub(product.bit_len() / 2);
        let root = (product << (2 * shift)).sqrt();
        let unit = denominator << shift;
        let over = |root: UBig| RBig::from_parts(IBig::from(root), unit.clone());
        Self { lo: over(root.clone()), hi: over(root + UBig::ONE) }
    }

    /// A decimal of `digits` significant digits, off by at most one unit of the last one and the width of the enclosure;
    /// an exact number with fewer digits is unchanged.
    #[must_use]
    pub fn decimal(&self, digits: usize) -> String {
        let middle = (&self.lo + &self.hi) / RBig::from(2);
        crate::decimal::of_length(&middle, digits)
    }

    /// The double nearest to the middle, and a bound on its error: 0 where the number is this double.
    #[must_use]
    pub fn rounded(&self) -> (f64, f64) {
        let middle = self.to_f64();
        let exact = RBig::try_from(middle).unwrap_or_default();
        let error = (&self.hi - &exact).max(&exact - &self.lo);
        (middle, if error.is_zero() { 0.0 } else { error.to_f64().value().next_up() })
    }

    /// The nearest double of the middle.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        ((&self.lo + &self.hi) / RBig::from(2)).to_f64().value()
    }
}

/// 10^power.
pub(super) fn power_of_ten(power: usize) -> RBig {
    RBig::from(IBig::from(10).pow(power))
}
