//! Rotation about a principal axis through the centre of mass: its spectral type over the spin, exactly.

use dashu_ratio::RBig;
use numbers::vector::{dot, norm};
use numbers::{Number, Sign};

use super::cone::PermanentAxis;
use crate::body::{Body, BodyAxis};
use crate::stability::{LinearType, Signs, Verdict};
use numbers::polynomial::{Polynomial, Root, rational};

/// The spectral type of such a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SpinType {
    /// Two imaginary pairs, and the energy is least: stable.
    Minimum,
    /// Two imaginary pairs only: stable in the linear terms (and for a symmetric top by a further integral).
    Elliptic,
    /// One real and one imaginary pair: unstable.
    SaddleCentre,
    /// Two real pairs: unstable.
    Saddle,
    /// A double real pair: unstable.
    DoubleReal,
    /// A complex quadruple: unstable.
    Complex,
    /// An eigenvalue zero, and no real one: open.
    Zero,
    /// An eigenvalue zero and a real pair: unstable.
    ZeroReal,
}

impl SpinType {
    /// Not unstable in the linear terms.
    #[must_use]
    pub fn is_stable(self) -> bool {
        matches!(self, Self::Minimum | Self::Elliptic | Self::Zero)
    }

    /// As it is printed.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Minimum => "elliptic (least energy)",
            Self::Elliptic => "elliptic",
            Self::SaddleCentre => "saddle-centre",
            Self::Saddle => "saddle",
            Self::DoubleReal => "double-real",
            Self::Complex => "complex",
            Self::Zero | Self::ZeroReal => "zero",
        }
    }
}

/// Rotation about a principal axis through the centre of mass with the vertical at one of its ends.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisRotation {
    axis: BodyAxis,
    /// C, A, B.
    pub(super) moments: [RBig; 3],
    /// ρ.
    pub(super) weight: RBig,
}

/// A spin at which the type changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpinChange {
    /// Ω in the body's units.
    pub omega: f64,
    /// Bound on its error.
    pub error_bound: f64,
    /// Below.
    pub from: SpinType,
    /// Above.
    pub to: SpinType,
}

impl SpinChange {
    /// The type at the change itself, in the words of the other relative equilibria, and what is known of it.
    #[must_use]
    pub fn between(&self) -> (&'static str, Verdict) {
        match [self.from, self.to] {
            [SpinType::Complex, to] | [to, SpinType::Complex] if to.is_stable() => ("double-elliptic", Verdict::Open),
            [SpinType::Complex, _] | [_, SpinType::Complex] => ("double-real", Verdict::Unstable),
            [from, to] if !from.is_stable() && !to.is_stable() => ("zero", Verdict::Unstable),
            _ => ("zero", Verdict::Open),
        }
    }
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
        Some(Self { axis, moments: [moment(axis), moment(others[0]), moment(others[1])], weight })
    }

    /// Rotation about an axis that is permanent at every spin, with γ along its direction or against it; |r| is rounded where
    /// r lies on no axis of the frame.
    #[must_use]
    pub fn about(body: &Body, PermanentAxis { axis, direction }: PermanentAxis, gamma: Sign) -> Option<Self> {
        let along = if direction[axis] < 0.0 { -gamma } else { gamma };
        let on_axis = Self::new(body, axis, along);
        on_axis.or_else(|| {
            let r = body.center_f64();
            let length = RBig::try_from(norm(r)).ok()?;
            let weight = gamma.orient(if dot(direction, r) < 0.0 { -length } else { length });
            let moment = |k: BodyAxis| body.moments()[k].value().clone();
            let [second, third] = axis.others();
            Some(Self { axis, moments: [moment(axis), moment(second), moment(third)], weight })
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
    fn polynomials(&self) -> [Vec<RBig>; 3] {
        let [c, a, b] = &self.moments;
        let stiffness = |moment: &RBig| vec![self.weight.clone(), c - moment];
        let (first, second) = (stiffness(a), stiffness(b));
        let coupling = a + b - c;
        let gyroscopic = vec![RBig::ZERO, &coupling * &coupling];
        let sum = rational::add(&rational::scale(&first, a), &rational::scale(&second, b));
        let whole = rational::add(&gyroscopic, &sum);
        [first, second, whole]
    }

    /// (AB)²(b² − 4c) as a polynomial in s.
    fn discriminant(&self) -> Vec<RBig> {
        let [_, a, b] = &self.moments;
        let [first, second, whole] = self.polynomials();
        let product = rational::scale(&rational::mul(&first, &second), &(RBig::from(4) * a * b));
        rational::sub(&rational::mul(&whole, &whole), &product)
    }

    /// Signs of K_A and K_B at a positive s; where one is 0 at every s (a circle of equilibria), positive.
    fn stiffness(&self, s: &RBig) -> [Sign; 2] {
        let [first, second, _] = self.polynomials();
        let is_zero = |p: &[RBig]| p.iter().all(RBig::is_zero);
        [first, second].map(|p| if is_zero(&p) { Sign::Positive } else { sign_at(&p, s) })
    }

    /// The type at a positive s, exactly; of a circle of equilibria the type across it.
    fn type_at(&self, s: &RBig) -> SpinType {
        let [first, second] = self.stiffness(s);
        let [.., whole] = self.polynomials();
        let [b, discriminant] = [whole, self.discriminant()].map(|p| sign_at(&p, s));
        match (Signs { b, c: first * second, discriminant }).linear_type() {
            _ if first == Sign::Positive && second == Sign::Positive => SpinType::Minimum,
            LinearType::Elliptic | LinearType::DoubleElliptic => SpinType::Elliptic,
            LinearType::SaddleCentre => SpinType::SaddleCentre,
            LinearType::Saddle => SpinType::Saddle,
            LinearType::DoubleReal => SpinType::DoubleReal,
            LinearType::Complex => SpinType::Complex,
            LinearType::Zero => SpinType::Zero,
            LinearType::ZeroReal => SpinType::ZeroReal,
        }
    }

    /// All spins Ω > 0 at which the type changes, ascending; none where r = 0, since there the spin is only a unit of
    /// time.
    #[must_use]
    pub fn changes(&self) -> Vec<SpinChange> {
        let [first, second, _] = self.polynomials();
        let mut roots: Vec<Root> = Vec::new();
        for coefficients in [first, second, self.discriminant()] {
            let polynomial = Polynomial::from_rationals(&coefficients);
            if polynomial.is_zero() {
                continue;
            }
            for mut root in polynomial.positive_roots().unwrap_or_default() {
                root.refine(120);
                roots.push(root);
            }
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
                changes.push(SpinChange { omega, error_bound: 4.0 * f64::EPSILON * omega, from, to });
            }
        }
        changes
    }

    /// The type at a spin Ω ≠ 0.
    #[must_use]
    pub fn type_at_spin(&self, omega: f64) -> Option<SpinType> {
        let omega = RBig::try_from(omega).ok()?;
        (!omega.is_zero()).then(|| self.type_at(&(&omega * &omega)))
    }

    /// What is known of the rotation at a spin Ω ≠ 0 (Proposition 13.6 of docs/mathematics.md).
    #[must_use]
    pub fn verdict_at_spin(&self, omega: f64) -> Option<Verdict> {
        let omega = RBig::try_from(omega).ok()?;
        let s = &omega * &omega;
        (!s.is_zero()).then(|| self.verdict(self.type_at(&s), &s))
    }

    fn verdict(&self, found: SpinType, s: &RBig) -> Verdict {
        let [_, a, b] = &self.moments;
        // μ is at least the largest moment: K_A, K_B ≥ 0 and ρ = s(μ − C) ≥ 0.
        let is_least = || self.weight >= RBig::ZERO && !self.stiffness(s).contains(&Sign::Negative);
        match found {
            SpinType::Minimum => Verdict::Energy,
            SpinType::Zero if is_least() => Verdict::Energy,
            SpinType::Elliptic | SpinType::Zero if a == b || self.weight.is_zero() => Verdict::Integral,
            SpinType::Elliptic => Verdict::Spectrum,
            SpinType::Zero => Verdict::Open,
            SpinType::SaddleCentre
            | SpinType::Saddle
            | SpinType::DoubleReal
            | SpinType::Complex
            | SpinType::ZeroReal => Verdict::Unstable,
        }
    }

    /// l at a spin.
    #[must_use]
    pub fn l(&self, omega: f64) -> f64 {
        self.moments[0].to_f64().value() * omega
    }

    /// (h, l) at a spin, exactly on the curve.
    #[must_use]
    pub fn point(&self, omega: f64) -> Option<(Number, Number)> {
        let omega = RBig::try_from(omega).ok()?;
        let l = &self.moments[0] * &omega;
        let h = &l * &omega / RBig::from(2) - &self.weight;
        Some((Number::from_rational(h), Number::from_rational(l)))
    }

    /// h at a spin.
    #[must_use]
    pub fn h(&self, omega: f64) -> f64 {
        0.5 * self.moments[0].to_f64().value() * omega * omega - self.weight.to_f64().value()
    }

    /// λ₁² and λ₂² at a spin: real ones, or the real and imaginary parts of a conjugate pair.
    #[must_use]
    pub fn squared_eigenvalues(&self, omega: f64) -> Squares {
        let [_, a, b] = self.moments.each_ref().map(|x| x.to_f64().value());
        // Exact up to here: beside a root of the discriminant nothing of its sign is lost.
        let omega = RBig::try_from(omega).unwrap_or_default();
        let s = &omega * &omega;
        let at = |c: &[RBig]| c.iter().rev().fold(RBig::ZERO, |sum, c| sum * &s + c).to_f64().value();
        let [first, second, whole] = self.polynomials().map(|c| at(&c));
        let (half, product) = (0.5 * whole / (a * b), first * second / (a * b));
        let discriminant = at(&self.discriminant()) / (4.0 * a * a * b * b);
        if discriminant < 0.0 {
            return Squares::Conjugate { re: -half, im: (-discriminant).sqrt() };
        }
        // The larger one without cancellation, the other from the product.
        let root = discriminant.sqrt();
        let larger = -(half + if half < 0.0 { -root } else { root });
        let smaller = if larger == 0.0 { 0.0 } else { product / larger };
        Squares::Real([larger, smaller])
    }
}

/// The sign of a polynomial.
fn sign_at(coefficients: &[RBig], s: &RBig) -> Sign {
    coefficients.iter().rev().fold(RBig::ZERO, |sum, c| sum * s + c).cmp(&RBig::ZERO).into()
}

/// The two values of λ².
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Squares {
    /// Real: negative ones are frequencies, positive ones rates of growth.
    Real([f64; 2]),
    /// re ± i im.
    Conjugate {
        /// Real part.
        re: f64,
        /// Imaginary part, positive.
        im: f64,
    },
}

impl Squares {
    /// The frequencies |Im λ|, in rad over the unit of time, and the largest rate of growth Re λ.
    #[must_use]
    pub fn frequencies_and_growth(&self) -> ([f64; 2], f64) {
        match *self {
            Self::Real(squares) => {
                let frequency = |x: f64| (-x).max(0.0).sqrt();
                (squares.map(frequency), squares.into_iter().fold(0.0, f64::max).sqrt())
            }
            Self::Conjugate { re, im } => {
                let modulus = (re * re + im * im).sqrt();
                // The smaller part from the product of both, im/2.
                let large = (0.5 * (modulus + re.abs())).sqrt();
                let small = 0.5 * im / large;
                let (frequency, growth) = if re > 0.0 { (small, large) } else { (large, small) };
                ([frequency, frequency], growth)
            }
        }
    }
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
                .all(|change| change.to.is_stable())
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
        assert_eq!(free(1).type_at_spin(0.3), Some(SpinType::SaddleCentre));
        assert_eq!(free(0).type_at_spin(0.3), Some(SpinType::Elliptic));
        assert_eq!(free(2).type_at_spin(0.3), Some(SpinType::Minimum));
        assert!((0..3).all(|axis| free(axis).changes().is_empty()));
    }
}
