//! Real roots, and the latitudes w = ⟨γ, r⟩ that belong to them, compared exactly.

use std::cell::{Ref, RefCell};
use std::cmp::Ordering;
use std::rc::Rc;

use dashu_ratio::RBig;
use numbers::Sign;
use numbers::enclosure::{Arithmetic, Enclosure};
use numbers::polynomial::{Polynomial, Root};
use numbers::wide::Wide;

/// Precisions in which two latitudes are compared; they are equal only where the answer does not depend on them.
const STAGES: [usize; 7] = [64, 128, 256, 512, 1024, 2048, 4096];

/// The value at a rational of a polynomial with coefficients by rising power.
pub(super) fn value(c: &[RBig], at: &RBig) -> RBig {
    c.iter().rev().fold(RBig::ZERO, |sum, c| sum * at + c)
}

/// An isolated real root: base + sign · root. Its copies share what is known of it, so that it is narrowed once.
#[derive(Clone, Debug)]
pub(super) struct RealRoot {
    base: RBig,
    sign: Sign,
    root: Rc<RefCell<Root>>,
}

impl RealRoot {
    /// All real roots, ascending; `None` when they cannot be isolated.
    pub fn all(polynomial: &Polynomial) -> Option<Vec<Self>> {
        if polynomial.is_zero() {
            return None;
        }
        // The base must not be a root: one of degree + 1 numbers is none.
        let bases = (0..=polynomial.degree()).map(|k| RBig::from_parts(k.into(), 37u8.into()));
        let base = bases.into_iter().find(|base| polynomial.sign_at(base) != Sign::Zero)?;
        let side = |sign: Sign| -> Option<Vec<Self>> {
            let roots = polynomial.composed(&base, &RBig::from(i8::from(sign))).positive_roots()?;
            Some(roots.into_iter().map(|root| Self::new(base.clone(), sign, root)).collect())
        };
        let mut all = side(Sign::Negative)?;
        all.reverse();
        all.extend(side(Sign::Positive)?);
        Some(all)
    }

    /// A rational one.
    pub fn rational(at: &RBig) -> Self {
        let one = RBig::ONE;
        let base = at - &one;
        let root = Root::exact(&Polynomial::from_rationals(&[-one.clone(), one.clone()]), one);
        Self::new(base, Sign::Positive, root)
    }

    fn new(base: RBig, sign: Sign, root: Root) -> Self {
        Self { base, sign, root: Rc::new(RefCell::new(root)) }
    }

    /// They are copies of one root.
    fn is_copy_of(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.root, &other.root) && self.sign == other.sign && self.base == other.base
    }

    /// The range that isolates it.
    pub fn range(&self) -> [RBig; 2] {
        let root: Ref<Root> = self.root.borrow();
        if self.sign == Sign::Positive {
            [&self.base + &root.lo, &self.base + &root.hi]
        } else {
            [&self.base - &root.hi, &self.base - &root.lo]
        }
    }

    fn refine(&self, bits: usize) {
        self.root.borrow_mut().refine(bits);
    }

    fn enclosed(&self, bits: usize) -> Wide {
        self.refine(bits);
        let [lo, hi] = self.range();
        Wide::rational(&lo, bits).hull(&Wide::rational(&hi, bits))
    }

    /// A range that holds the square root of `square` on neither side; `None` when the root is one of them.
    pub fn range_beside(&self, square: &RBig) -> Option<[RBig; 2]> {
        for bits in STAGES {
            let [lo, hi] = self.range();
            let inner = |w: &RBig| w * w < *square;
            let straddles = lo < RBig::ZERO && hi > RBig::ZERO;
            if inner(&lo) == inner(&hi) && (!straddles || inner(&lo)) {
                return Some([lo, hi]);
            }
            self.refine(bits);
        }
        None
    }

    /// The order of two roots; `None`: they are equal, or closer than the largest precision.
    pub fn compare(&self, other: &Self) -> Option<Ordering> {
        if self.is_copy_of(other) {
            return None;
        }
        for bits in STAGES {
            let ([a, b], [c, d]) = (self.range(), other.range());
            if b < c {
                return Some(Ordering::Less);
            }
            if d < a {
                return Some(Ordering::Greater);
            }
            self.refine(bits);
            other.refine(bits);
        }
        None
    }
}

/// ω = ρ/√p along Staude's curve: coefficients of ρ = R D and p = P D².
#[derive(Debug)]
pub(super) struct Course {
    pub rho: Vec<RBig>,
    pub p: Vec<RBig>,
}

/// A latitude.
#[derive(Clone, Debug)]
pub(super) enum Latitude<'a> {
    /// ± ω at a root.
    OnCurve { course: &'a Course, root: RealRoot, sign: Sign },
    /// A root itself.
    Straight(RealRoot),
}

impl Latitude<'_> {
    pub fn negated(mut self) -> Self {
        match &mut self {
            Self::OnCurve { sign, .. } => *sign = -*sign,
            Self::Straight(root) => {
                root.base = -root.base.clone();
                root.sign = -root.sign;
            }
        }
        self
    }

    fn enclosed(&self, bits: usize) -> Wide {
        match self {
            Self::Straight(root) => root.enclosed(bits),
            Self::OnCurve { course, root, sign } => {
                let mu = root.enclosed(bits);
                let horner = |c: &[RBig]| {
                    let zero = Wide::small(0, bits);
                    c.iter().rev().fold(zero, |sum, c| sum * mu.clone() + Wide::rational(c, bits))
                };
                let omega = horner(&course.rho) / horner(&course.p).sqrt();
                sign.orient(omega)
            }
        }
    }

    /// The order of two latitudes; `None`: they are equal, or closer than the largest precision.
    pub fn compare(&self, other: &Self) -> Option<Ordering> {
        let same = match (self, other) {
            (Self::Straight(p), Self::Straight(q)) => p.is_copy_of(q),
            (Self::OnCurve { root: p, sign, .. }, Self::OnCurve { root: q, sign: other, .. }) => {
                p.is_copy_of(q) && sign == other
            }
            _ => false,
        };
        if same {
            return None;
        }
        STAGES.into_iter().find_map(|bits| {
            let (p, q) = (self.enclosed(bits), other.enclosed(bits));
            (p - q).strict_sign().map(|sign| sign.cmp(&Sign::Zero))
        })
    }
}
