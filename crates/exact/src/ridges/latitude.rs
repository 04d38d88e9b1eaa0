//! Real roots, and the latitudes w = ⟨γ, r⟩ that belong to them, compared exactly.

use std::cell::{OnceCell, Ref, RefCell};
use std::cmp::Ordering;
use std::rc::Rc;

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::polynomial::{Polynomial, Root};
use bifdiag_numbers::wide::{Interval128, Interval384, Wide};
use dashu_ratio::RBig;

/// Precisions in which two roots are compared.
const STAGES: [usize; 7] = [64, 128, 256, 512, 1024, 2048, 4096];

/// Precisions in which two latitudes are compared that intervals of 128 and 384 bits do not separate; they are equal only
/// where the answer does not depend on them.
const FURTHER: [usize; 4] = [512, 1024, 2048, 4096];

/// The value at a rational of a polynomial with coefficients by rising power.
pub(super) fn value(c: &[RBig], at: &RBig) -> RBig {
    c.iter().rev().fold(RBig::ZERO, |sum, c| sum * at + c)
}

/// An isolated real root: base + step · root. Its copies share what is known of it, so that it is narrowed once.
#[derive(Clone, Debug)]
pub(super) struct RealRoot {
    base: RBig,
    step: RBig,
    root: Rc<Isolated>,
}

/// What is known of a root.
#[derive(Debug)]
struct Isolated {
    range: RefCell<Root>,
    /// In these arithmetics, once they were asked for.
    narrow: OnceCell<Interval128>,
    wide: OnceCell<Interval384>,
}

impl RealRoot {
    /// All real roots, ascending; `None` when they cannot be isolated.
    pub fn all(polynomial: &Polynomial) -> Option<Vec<Self>> {
        // The base must not be a root: at least one of degree + 1 numbers is not.
        let bases = (0..=polynomial.degree()).map(|k| RBig::from_parts(k.into(), 37u8.into()));
        let base = bases.into_iter().find(|base| polynomial.sign_at(base) != Sign::Zero)?;
        Self::about(polynomial, &[base])
    }

    /// All real roots, ascending, each measured from the nearest of these rising numbers, so that those that are very close to
    /// one have all their digits. `None` when they cannot be isolated, or one of the numbers is a root.
    pub fn about(polynomial: &Polynomial, bases: &[RBig]) -> Option<Vec<Self>> {
        if polynomial.is_zero() || bases.iter().any(|base| polynomial.sign_at(base) == Sign::Zero) {
            return None;
        }
        let mut all = Vec::new();
        for (number, base) in bases.iter().enumerate() {
            let before = number.checked_sub(1).map(|number| (base - &bases[number]) / RBig::from(2));
            let after = bases.get(number + 1).map(|next| (next - base) / RBig::from(2));
            let mut below = Self::beside(polynomial, base, Sign::Negative, before)?;
            below.reverse();
            all.extend(below);
            // In the very middle between two numbers.
            let middle = after.as_ref().map(|reach| base + reach);
            all.extend(Self::beside(polynomial, base, Sign::Positive, after)?);
            all.extend(
                middle.filter(|middle| polynomial.sign_at(middle) == Sign::Zero).map(|middle| Self::rational(&middle)),
            );
        }
        Some(all)
    }

    /// The roots on one side of a base, nearer than `reach`, by distance.
    fn beside(polynomial: &Polynomial, base: &RBig, sign: Sign, reach: Option<RBig>) -> Option<Vec<Self>> {
        let is_bounded = reach.is_some();
        let step = sign.orient(reach.unwrap_or(RBig::ONE));
        let local = polynomial.composed(base, &step);
        let roots = if is_bounded { local.roots_in_unit() } else { local.positive_roots() }?;
        Some(roots.into_iter().map(|root| Self::new(base.clone(), step.clone(), root)).collect())
    }

    /// A rational one.
    pub fn rational(at: &RBig) -> Self {
        let one = RBig::ONE;
        let base = at - &one;
        let root = Root::exact(&Polynomial::from_rationals(&[-one.clone(), one.clone()]), one);
        Self::new(base, RBig::ONE, root)
    }

    fn new(base: RBig, step: RBig, root: Root) -> Self {
        let root = Isolated { range: RefCell::new(root), narrow: OnceCell::new(), wide: OnceCell::new() };
        Self { base, step, root: Rc::new(root) }
    }

    /// They are copies of one root.
    fn is_copy_of(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.root, &other.root) && self.step == other.step && self.base == other.base
    }

    /// The range that isolates it.
    pub fn range(&self) -> [RBig; 2] {
        let root: Ref<Root> = self.root.range.borrow();
        let [lo, hi] = [&root.lo, &root.hi].map(|end| &self.base + &self.step * end);
        if self.step > RBig::ZERO { [lo, hi] } else { [hi, lo] }
    }

    fn refine(&self, bits: usize) {
        self.root.range.borrow_mut().refine(bits);
    }

    /// The distance of the root from a number, with the root's own coordinate in one arithmetic.
    fn from<E: Enclosure>(&self, origin: &RBig, at: &E, precision: E::Precision) -> E {
        E::rational(&(&self.base - origin), precision) + E::rational(&self.step, precision) * at.clone()
    }

    fn narrow(&self) -> &Interval128 {
        self.root.narrow.get_or_init(|| self.root.range.borrow().enclosed(()))
    }

    fn wide(&self) -> &Interval384 {
        self.root.wide.get_or_init(|| self.root.range.borrow().enclosed(()))
    }

    fn refined(&self, bits: usize) -> Wide {
        self.refine(bits);
        let root = self.root.range.borrow();
        Wide::rational(&root.lo, bits).hull(&Wide::rational(&root.hi, bits))
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

/// A latitude: a value of ω = ⟨γ, r⟩.
pub(super) trait Latitude: Clone {
    /// −ω.
    fn negated(self) -> Self;

    /// The order of two latitudes; `None`: they are equal, or what is known of them does not separate them.
    fn compare(&self, other: &Self) -> Option<Ordering>;
}

/// All that is known is where it lies.
impl<E: Enclosure> Latitude for E {
    fn negated(self) -> Self {
        -self
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        (self.clone() - other.clone()).strict_sign().map(|sign| sign.cmp(&Sign::Zero))
    }
}

/// ω = RD/√(PD²) along Staude's curve.
#[derive(Debug)]
pub(super) struct StaudeCurve {
    /// Each moment that carries r, with q.
    pub moments: Vec<[RBig; 2]>,
}

impl StaudeCurve {
    /// ω at a root: from the distances μ − a_k, so that close to a moment no digit is lost.
    fn at<E: Enclosure>(&self, root: &RealRoot, at: &E, precision: E::Precision) -> E {
        let tau: Vec<E> = self.moments.iter().map(|[a, _]| root.from(a, at, precision)).collect();
        let (mut rho, mut p) = (E::small(0, precision), E::small(0, precision));
        for (k, [_, q]) in self.moments.iter().enumerate() {
            let others = (0..tau.len()).filter(|&j| j != k);
            let rest = others.fold(E::small(1, precision), |product, j| product * tau[j].clone());
            let q = E::rational(q, precision);
            rho = rho + q.clone() * rest.clone();
            p = p + q * rest.square();
        }
        rho / p.sqrt()
    }
}

/// A latitude that can be enclosed in any precision.
#[derive(Clone, Debug)]
pub(super) enum RootLatitude {
    /// ± ω at a root.
    OnCurve { along: Rc<StaudeCurve>, root: RealRoot, sign: Sign },
    /// A root itself.
    Straight(RealRoot),
}

impl RootLatitude {
    fn root(&self) -> &RealRoot {
        match self {
            Self::Straight(root) | Self::OnCurve { root, .. } => root,
        }
    }

    /// The latitude, with its root's own coordinate in one arithmetic.
    fn over<E: Enclosure>(&self, at: &E, precision: E::Precision) -> E {
        match self {
            Self::Straight(root) => root.from(&RBig::ZERO, at, precision),
            Self::OnCurve { along, root, sign } => sign.orient(along.at(root, at, precision)),
        }
    }
}

impl Latitude for RootLatitude {
    fn negated(mut self) -> Self {
        match &mut self {
            Self::OnCurve { sign, .. } => *sign = -*sign,
            Self::Straight(root) => {
                root.base = -root.base.clone();
                root.step = -root.step.clone();
            }
        }
        self
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
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
        let [p, q] = [self.root(), other.root()];
        let sign = (self.over(p.narrow(), ()) - other.over(q.narrow(), ())).strict_sign();
        let sign = sign.or_else(|| (self.over(p.wide(), ()) - other.over(q.wide(), ())).strict_sign());
        let further = |bits| (self.over(&p.refined(bits), bits) - other.over(&q.refined(bits), bits)).strict_sign();
        sign.or_else(|| FURTHER.into_iter().find_map(further)).map(|sign| sign.cmp(&Sign::Zero))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_numbers::polynomial::rational;

    #[test]
    fn roots_about_several_numbers_are_found_once_and_with_all_their_digits() {
        let tiny = RBig::ONE / RBig::from(10).pow(40);
        let bases = [RBig::ZERO, RBig::ONE];
        // On both sides of either number, and in the very middle.
        let half = RBig::ONE / RBig::from(2);
        let planted =
            [RBig::from(-5), -tiny.clone(), tiny.clone(), half, RBig::ONE - &tiny, RBig::ONE + &tiny, RBig::from(7)];
        let product = planted.iter().fold(vec![RBig::ONE], |p, root| rational::mul(&p, &[-root.clone(), RBig::ONE]));
        let polynomial = Polynomial::from_rationals(&product);
        let found = RealRoot::about(&polynomial, &bases).unwrap();
        assert_eq!(found.len(), planted.len());
        for (root, at) in found.iter().zip(&planted) {
            let [lo, hi] = root.range();
            assert!(lo <= *at && at <= &hi, "{at}");
            let nearest = bases.iter().min_by_key(|base| (at - *base).sqr()).unwrap();
            let exact = Interval128::rational(&(at - nearest), ());
            let [lo, hi] = (root.from(nearest, root.narrow(), ()) / exact).bounds();
            assert!(lo <= 1.0 && hi >= 1.0 && hi - lo < 1e-15, "{at}: {lo} {hi}");
        }
        assert!(RealRoot::about(&polynomial, &[tiny]).is_none());
    }
}
