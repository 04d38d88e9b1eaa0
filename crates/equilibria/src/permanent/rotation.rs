//! Rotation about a principal axis through the centre of mass: its spectral type over the spin, exactly.

use std::cmp::Ordering;

use bifdiag_numbers::polynomial::{Polynomial, Root, rational};
use bifdiag_numbers::symmetric::{self, Real};
use bifdiag_numbers::vector::dot;
use bifdiag_numbers::{Number, Sign};
use dashu_ratio::RBig;

use super::cone::PermanentAxis;
use crate::critical::Multiplicity;
use crate::stability::{LinearType, Signs};
use bifdiag_body::{Body, BodyAxis};
use bifdiag_schema::SpinType;

/// Digits of |r| where it is not rational.
const DIGITS: usize = 60;

/// A spin at which the type changes.
#[derive(Clone, Debug)]
pub struct SpinChange {
    /// Ω in the body's units.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// Below.
    pub from: SpinType,
    /// Above.
    pub to: SpinType,
    /// Ω².
    squared: Root,
}

impl SpinChange {
    /// How a spin compares with the change, by its square, exactly.
    #[must_use]
    pub fn place_of(&self, squared: &RBig) -> Ordering {
        self.squared.place_of(squared)
    }
}

/// Rotation about a principal axis through the centre of mass with the vertical at one of its ends.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisRotation {
    axis: BodyAxis,
    /// C, A, B.
    pub moments: [RBig; 3],
    /// ρ.
    pub weight: RBig,
    /// Where the second and the third moment are irrational and rounded: their product and ρ², which are exact.
    pub(super) exact: Option<[RBig; 2]>,
}

/// The product of the moments across an axis, det A/C, and |r|², by the tensor, where C is rational and they are rounded.
fn exact_across(body: &Body, [c, a, b]: &[RBig; 3]) -> Option<[RBig; 2]> {
    let tensor = body.tensor().filter(|tensor| tensor.matrix().subtracted_from(c).determinant().is_zero())?;
    let product = tensor.matrix().determinant() / c;
    (product != a * b).then(|| [product, body.center_squared()])
}

impl AxisRotation {
    /// Rotation about a principal axis with γ = ±e_axis; `None` when the centre of
    /// mass does not lie on the axis.
    #[must_use]
    pub fn new(body: &Body, axis: BodyAxis, gamma: Sign) -> Option<Self> {
        let others = axis.others();
        if others.iter().any(|&k| !body.center()[k].value().is_zero()) {
            return None;
        }
        let moment = |k: BodyAxis| body.moments()[k].value().clone();
        let weight = gamma.orient(body.center()[axis].value().clone());
        let moments = [moment(axis), moment(others[0]), moment(others[1])];
        Some(Self { axis, exact: exact_across(body, &moments), moments, weight })
    }

    /// Rotation about an axis that is permanent at every spin, with γ along its direction or against it; where |r| is
    /// not rational it is rounded to 60 digits.
    #[must_use]
    pub fn about(body: &Body, PermanentAxis { axis, direction }: PermanentAxis, gamma: Sign) -> Option<Self> {
        let along = if direction[axis] < 0.0 { -gamma } else { gamma };
        let on_axis = Self::new(body, axis, along);
        on_axis.or_else(|| {
            let r = body.center_f64();
            let exact = body.center().each_ref().map(|x| x.value().clone());
            let length = Real::root_of(&symmetric::dot(&exact, &exact), DIGITS).lo;
            let weight = gamma.orient(if dot(direction, r) < 0.0 { -length } else { length });
            let moment = |k: BodyAxis| body.moments()[k].value().clone();
            let [second, third] = axis.others();
            let moments = [moment(axis), moment(second), moment(third)];
            Some(Self { axis, exact: exact_across(body, &moments), moments, weight })
        })
    }

    /// The body that turns, its centre of mass at the end of the axis that points along γ.
    pub(super) fn body(&self) -> Option<Body> {
        let mut moments = [const { String::new() }; 3];
        let [second, third] = self.axis.others();
        for (k, moment) in [self.axis, second, third].into_iter().zip(&self.moments) {
            moments[k] = moment.to_string();
        }
        let center: [String; 3] =
            BodyAxis::ALL.map(|k| if k == self.axis { self.weight.to_string() } else { "0".to_owned() });
        Body::parse(&moments.each_ref().map(String::as_str), &center.each_ref().map(String::as_str)).ok()
    }

    /// The axis.
    #[must_use]
    pub fn axis(&self) -> BodyAxis {
        self.axis
    }

    /// K_A, K_B and AB·b as polynomials in s.
    pub(super) fn polynomials(&self) -> [Vec<RBig>; 3] {
        let [c, a, b] = &self.moments;
        let stiffness = |moment: &RBig| vec![self.weight.clone(), c - moment];
        // (A + B − C)² s + A K_A + B K_B, by A + B and AB.
        let sum = a + b;
        let slope = c * (c - &sum) + RBig::from(2) * self.product();
        [stiffness(a), stiffness(b), vec![&self.weight * sum, slope]]
    }

    /// K_A K_B, by A + B and AB.
    pub(super) fn stiffness_product(&self) -> Vec<RBig> {
        let [c, a, b] = &self.moments;
        let sum = a + b;
        let middle = &self.weight * (RBig::from(2) * c - &sum);
        let square = self.exact.as_ref().map_or_else(|| &self.weight * &self.weight, |[_, squared]| squared.clone());
        vec![square, middle, c * (c - sum) + self.product()]
    }

    /// (AB)²(b² − 4c) as a polynomial in s.
    pub(super) fn discriminant(&self) -> Vec<RBig> {
        let [.., whole] = self.polynomials();
        let product = rational::scale(&self.stiffness_product(), &(RBig::from(4) * self.product()));
        rational::sub(&rational::mul(&whole, &whole), &product)
    }

    /// How many rotations at the same spin it is one of: where r = 0, those about all axes of an eigenspace of A.
    #[must_use]
    pub fn multiplicity(&self) -> Multiplicity {
        let [c, a, b] = &self.moments;
        match (self.weight.is_zero(), c == a, c == b) {
            (true, true, true) => Multiplicity::Sphere,
            (true, true, false) | (true, false, true) => Multiplicity::Circle,
            _ => Multiplicity::Points(1),
        }
    }

    /// Signs of K_A and K_B at a positive s; where one is 0 at every s (along a circle of equilibria), positive.
    pub(super) fn stiffness(&self, s: &RBig) -> [Sign; 2] {
        let [first, second, _] = self.polynomials();
        let is_zero = |p: &[RBig]| p.iter().all(RBig::is_zero);
        let mut signs = [&first, &second].map(|p| if is_zero(p) { Sign::Positive } else { sign_at(p, s) });
        // Of rounded numbers the product is exact.
        if self.exact.is_some() && value_at(&self.stiffness_product(), s).is_zero() {
            let [p, q] = [&first, &second].map(|p| value_at(p, s)).map(|x| x.clone().max(-x));
            signs[usize::from(q < p)] = Sign::Zero;
        }
        signs
    }

    /// The product of the second and the third moment.
    pub(super) fn product(&self) -> RBig {
        let [_, a, b] = &self.moments;
        self.exact.as_ref().map_or_else(|| a * b, |[product, _]| product.clone())
    }

    /// The linear type at a positive s; across a circle or sphere of equilibria.
    pub(super) fn linear_type_at(&self, s: &RBig) -> LinearType {
        let [.., whole] = self.polynomials();
        let b = sign_at(&whole, s);
        if self.multiplicity() != Multiplicity::Points(1) {
            return Signs::transverse_type(b);
        }
        let [first, second] = self.stiffness(s);
        Signs { b, c: first * second, discriminant: sign_at(&self.discriminant(), s) }.linear_type()
    }

    /// The type at a positive s.
    fn type_at(&self, s: &RBig) -> SpinType {
        match self.linear_type_at(s) {
            _ if self.stiffness(s) == [Sign::Positive; 2] => SpinType::Minimum,
            LinearType::Elliptic | LinearType::DoubleElliptic => SpinType::Elliptic,
            LinearType::SaddleCentre => SpinType::SaddleCentre,
            LinearType::Saddle => SpinType::Saddle,
            LinearType::DoubleReal => SpinType::DoubleReal,
            LinearType::Complex => SpinType::Complex,
            LinearType::Zero | LinearType::ZeroReal => SpinType::Zero,
        }
    }

    /// All spins Ω > 0 at which the type changes, ascending; none where r = 0, since there the spin is only a unit of
    /// time.
    #[must_use]
    pub fn changes(&self) -> Vec<SpinChange> {
        let [first, second, _] = self.polynomials();
        let mut roots: Vec<Root> = Vec::new();
        // Of rounded numbers the product of both is exact.
        let stiffness = if self.exact.is_some() { vec![self.stiffness_product()] } else { vec![first, second] };
        for coefficients in stiffness.into_iter().chain([self.discriminant()]) {
            roots.extend(positive_roots(&coefficients));
        }
        roots.sort_by(|p, q| p.lo.cmp(&q.lo));
        // Equal roots of two of the polynomials overlap.
        roots.dedup_by(|later, earlier| later.lo <= earlier.hi);
        let mut changes = Vec::new();
        for (k, root) in roots.iter().enumerate() {
            let two = RBig::from(2);
            let below =
                k.checked_sub(1).map_or_else(|| &root.lo / &two, |before| (&roots[before].hi + &root.lo) / &two);
            let above = roots.get(k + 1).map_or_else(|| &root.hi * &two, |after| (&root.hi + &after.lo) / &two);
            let (from, to) = (self.type_at(&below), self.type_at(&above));
            if from != to {
                let omega = root.hi.to_f64().value().sqrt();
                let error_bound = 4.0 * f64::EPSILON * omega;
                changes.push(SpinChange { omega, error_bound, from, to, squared: root.clone() });
            }
        }
        changes
    }

    /// The spins Ω > 0 at which K_A, K_B and the discriminant vanish, its smaller root first; a double one is both.
    pub(super) fn thresholds(&self) -> [Option<f64>; 4] {
        let spin = |root: &Root| root.hi.to_f64().value().sqrt();
        let [first, second, _] = self.polynomials().map(|stiffness| positive_roots(&stiffness).first().map(spin));
        let [lower, upper] = match &positive_roots(&self.discriminant())[..] {
            // The other root is 0.
            [root] if root.odd => [None, Some(spin(root))],
            found => [found.first(), found.last()].map(|root| root.map(spin)),
        };
        [first, second, lower, upper]
    }

    /// The type at the slowest spins.
    #[must_use]
    pub fn slowest_type(&self) -> SpinType {
        let any = || self.type_at(&RBig::ONE);
        self.changes().first().map_or_else(any, |first| first.from)
    }

    /// The name of a type for this rotation: with C = 2A = 2B, and of a free plate about its normal, both pairs agree
    /// at every spin.
    #[must_use]
    pub fn own(&self, kind: SpinType) -> SpinType {
        let [c, a, b] = &self.moments;
        let is_double = *c == a + b && (a == b || self.weight.is_zero());
        if kind == SpinType::Minimum && is_double { SpinType::DoubleMinimum } else { kind }
    }

    /// The type at a spin Ω ≠ 0.
    #[must_use]
    pub fn type_at_spin(&self, omega: &RBig) -> Option<SpinType> {
        (!omega.is_zero()).then(|| self.type_at(&(omega * omega)))
    }

    /// l at a spin.
    #[must_use]
    pub fn l(&self, omega: f64) -> f64 {
        self.moments[0].to_f64().value() * omega
    }

    /// h at a change, 0 where it is.
    #[must_use]
    pub fn h_at(&self, change: &SpinChange) -> f64 {
        let half = &self.moments[0] / RBig::from(2);
        if change.squared.place_of(&(&self.weight / &half)) == Ordering::Equal {
            return 0.0;
        }
        (half * &change.squared.lo - &self.weight).to_f64().value()
    }

    /// (h, l) at a spin Ω with s = Ω², exactly on the curve where Ω is exact.
    #[must_use]
    pub fn point(&self, omega: &RBig, s: &RBig) -> (Number, Number) {
        let l = &self.moments[0] * omega;
        let h = &self.moments[0] * s / RBig::from(2) - &self.weight;
        (Number::from_rational(h), Number::from_rational(l))
    }

    /// h at a spin.
    #[must_use]
    pub fn h(&self, omega: f64) -> f64 {
        0.5 * self.moments[0].to_f64().value() * omega * omega - self.weight.to_f64().value()
    }
}

/// The positive roots of a polynomial, refined to 120 bits; none where it vanishes everywhere.
fn positive_roots(coefficients: &[RBig]) -> Vec<Root> {
    let polynomial = Polynomial::from_rationals(coefficients);
    if polynomial.is_zero() {
        return Vec::new();
    }
    let mut roots = polynomial.positive_roots().unwrap_or_default();
    for root in &mut roots {
        root.refine(120);
    }
    roots
}

/// The value of a polynomial.
pub(super) fn value_at(coefficients: &[RBig], s: &RBig) -> RBig {
    coefficients.iter().rev().fold(RBig::ZERO, |sum, c| sum * s + c)
}

pub(super) fn sign_of(value: &RBig) -> Sign {
    value.cmp(&RBig::ZERO).into()
}

/// The sign of a polynomial.
fn sign_at(coefficients: &[RBig], s: &RBig) -> Sign {
    sign_of(&value_at(coefficients, s))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rotation(a: [&str; 3], r: [&str; 3], axis: usize, gamma: Sign) -> AxisRotation {
        AxisRotation::new(&Body::parse(&a, &r).unwrap(), BodyAxis::ALL[axis], gamma).unwrap()
    }

    /// Lagrange's upright top sleeps from C²Ω² = 4 A r on.
    #[test]
    fn the_sleeping_top_wakes_at_its_threshold() {
        let upright = rotation(["2", "2", "0.5"], ["0", "0", "3"], 2, Sign::Negative);
        let changes = upright.changes();
        let threshold = 4.0 * (2.0_f64 * 3.0).sqrt();
        assert_eq!(changes.len(), 1);
        assert!((changes[0].omega - threshold).abs() < changes[0].error_bound);
        assert_eq!((changes[0].from, changes[0].to), (SpinType::Complex, SpinType::Elliptic));
        assert!(
            rotation(["2", "2", "0.5"], ["0", "0", "3"], 2, Sign::Positive)
                .changes()
                .iter()
                .all(|change| change.to.is_elliptic())
        );
    }

    /// An asymmetric upright top: c < 0 between the roots of K_A and K_B.
    #[test]
    fn an_asymmetric_top_is_a_saddle_between_two_spins() {
        // C = 3 > A, B: K_A = -1 + 2 s, K_B = -1 + s.
        let changes = rotation(["1", "2", "3"], ["0", "0", "1"], 2, Sign::Negative).changes();
        let types: Vec<_> = changes.iter().map(|change| (change.from, change.to)).collect();
        assert_eq!(types.last(), Some(&(SpinType::SaddleCentre, SpinType::Minimum)));
        let last = &changes[changes.len() - 1];
        assert!((last.omega - 1.0).abs() <= last.error_bound);
        let before = &changes[changes.len() - 2];
        assert!((before.omega - 0.5_f64.sqrt()).abs() <= before.error_bound);
    }

    /// The middle axis of a free body is unstable, at every spin.
    #[test]
    fn a_free_body_tumbles_about_its_middle_axis() {
        let body = ["1", "2", "3"];
        let free = |axis| rotation(body, ["0", "0", "0"], axis, Sign::Positive);
        let types = [0, 1, 2].map(|axis| free(axis).type_at_spin(&RBig::ONE));
        assert_eq!(types, [SpinType::Elliptic, SpinType::SaddleCentre, SpinType::Minimum].map(Some));
        assert!((0..3).all(|axis| free(axis).changes().is_empty()));
    }
}
