//! What is known of rotation about a principal axis at one spin: its stability, its frequencies and rates of growth.

use bifdiag_numbers::Sign;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::power::{exponent, times_power_of_two};
use bifdiag_numbers::wide::{Interval384, Wide};
use dashu_ratio::RBig;

use super::rotation::{AxisRotation, sign_of, value_at};
use crate::critical::{Equilibrium, Multiplicity};
use crate::nonlinear::{Friction, Nonlinear, Question, Setting};
use crate::stability::{Constants, Eigenvalues, LinearType, RESONANCES, Reduced, State};
use bifdiag_body::Axis;

/// What is known of a rotation at one spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Judged {
    /// The linear type.
    pub kind: LinearType,
    /// What is known of its stability.
    pub nonlinear: Nonlinear,
    /// What damping leaves of it.
    pub friction: Friction,
    /// The eigenvalues of the flow reduced by l, per unit of time.
    pub eigenvalues: Eigenvalues,
}

/// Bits of enclosures where 384 do not decide.
const WIDE_BITS: [usize; 2] = [1500, 6000];

impl From<Equilibrium> for Judged {
    fn from(found: Equilibrium) -> Self {
        let Equilibrium { stability: kind, nonlinear, friction, eigenvalues, .. } = found;
        Self { kind, nonlinear, friction, eigenvalues }
    }
}

impl AxisRotation {
    /// What is known of the rotation at a spin Ω ≠ 0 (Proposition 13.6 of docs/mathematics.md): what
    /// [`critical`](crate::critical::critical()) says of it at the same l.
    #[must_use]
    pub fn stability_at_spin(&self, omega: &RBig) -> Option<Judged> {
        self.stability_at(&(omega * omega))
    }

    /// The same by s = Ω², which is rational where Ω is not.
    #[must_use]
    pub fn stability_at(&self, s: &RBig) -> Option<Judged> {
        if s.is_zero() {
            return None;
        }
        let [_, a, b] = &self.moments;
        let (kind, stiffness) = (self.linear_type_at(s), self.stiffness(s));
        let falling = stiffness.into_iter().map(|sign| u8::from(sign == Sign::Negative)).sum();
        let setting =
            Setting { index: falling, minimum: self.minimum(stiffness), integral: a == b || self.weight.is_zero() };
        let is_set = self.multiplicity() != Multiplicity::Points(1);
        let beyond = self
            .beyond::<Interval384>(s, (kind, setting), ())
            .or_else(|| WIDE_BITS.into_iter().find_map(|bits| self.beyond::<Wide>(s, (kind, setting), bits)));
        let (c, state) = self.enclosed::<Interval384>(s, ());
        let reduced = Reduced::new(&c, &state);
        let question = Question { c: &c, state: &state, reduced: &reduced, kind, setting };
        let nonlinear = beyond.unwrap_or_else(|| question.undecided(self.resonances(s)));
        let friction = Friction::new(&reduced, kind, setting, is_set);
        Some(Judged { kind, nonlinear, friction, eigenvalues: reduced.eigenvalues(kind, is_set, 1.0) })
    }

    /// The state with the first axis as that of rotation.
    fn enclosed<E: Enclosure>(&self, s: &RBig, precision: E::Precision) -> (Constants<E>, State<E>) {
        let squares = [&self.weight * &self.weight, RBig::ZERO, RBig::ZERO];
        let c = Constants::exact(&self.moments, &squares, precision);
        let number = |x: &RBig| E::rational(x, precision);
        let state = State::about(&c, Axis::ALL[0], &number(s), &number(&(&self.weight / s)));
        (c, state)
    }

    /// The verdict in some precision.
    fn beyond<E: Enclosure>(
        &self,
        s: &RBig,
        (kind, setting): (LinearType, Setting),
        precision: E::Precision,
    ) -> Option<Nonlinear> {
        let (c, state) = self.enclosed::<E>(s, precision);
        let reduced = Reduced::new(&c, &state);
        Question { c: &c, state: &state, reduced: &reduced, kind, setting }.verdict(self.resonances(s))
    }

    /// Which of the resonances 1:2 and 1:3 between imaginary pairs hold.
    fn resonances(&self, s: &RBig) -> [Option<bool>; 2] {
        let [.., whole] = self.polynomials();
        let whole = value_at(&whole, s);
        let (b2, c) = (&whole * &whole, value_at(&self.stiffness_product(), s) * self.product());
        [1, 2].map(|k| {
            let [m, n] = RESONANCES[k];
            Some(RBig::from(m) * &b2 == RBig::from(n) * &c)
        })
    }

    /// Whether U_l has a strict minimum where the Hessian is degenerate.
    fn minimum(&self, stiffness: [Sign; 2]) -> Option<bool> {
        // μ is at least the largest moment: K_A, K_B ≥ 0 and ρ = s(μ − C) ≥ 0.
        if self.weight >= RBig::ZERO && stiffness.iter().all(|&sign| sign != Sign::Negative) {
            return Some(true);
        }
        if stiffness.contains(&Sign::Negative) {
            return Some(false);
        }
        // On the great circle to the axis A with K_A = ρ + sd = 0, d = C − A, with q = sin² of the angle:
        // U = ½sC²/(C − dq) − ρ√(1 − q) = const + (sd/8)(4d/C − 1)q² + …
        let [c, a, b] = &self.moments;
        let soft = stiffness.into_iter().zip([a, b]).find(|(sign, _)| *sign == Sign::Zero);
        let d = c - soft?.1;
        // At 4d = C the next term is −(sC/128)q³.
        Some(sign_of(&(&d * (RBig::from(4) * &d - c))) == Sign::Positive)
    }

    /// The frequencies |Im λ|, in rad over the unit of time, and the largest rate of growth Re λ at a spin with s = Ω².
    #[must_use]
    pub fn frequencies_and_growth(&self, s: &RBig) -> ([f64; 2], f64) {
        let [.., whole] = self.polynomials();
        let (whole, both) = (value_at(&whole, s), value_at(&self.stiffness_product(), s));
        // λ⁴ + 2 half λ² + product = 0, exact up to here: beside a root of the discriminant nothing of its sign is lost. In units
        // of 2ᵏ for λ no square leaves the range of doubles.
        let half = whole / (RBig::from(2) * self.product());
        let product = both / self.product();
        let discriminant = &half * &half - &product;
        let sizes = [(&half, 2), (&product, 4)].into_iter().filter(|(x, _)| !x.is_zero());
        let Some(k) = sizes.map(|(x, degree)| exponent(x) / degree).max() else { return ([0.0; 2], 0.0) };
        let [half, product, discriminant] = [(half, 2), (product, 4), (discriminant, 4)]
            .map(|(x, degree)| times_power_of_two(x, -degree * k).to_f64().value());
        let size = |x: f64| libm::ldexp(x, i32::try_from(k).unwrap_or(0));
        if discriminant < 0.0 {
            // λ² = −half ± i im. The smaller part of λ from the product of both, im/2.
            let im = (-discriminant).sqrt();
            let large = (0.5 * ((half * half + im * im).sqrt() + half.abs())).sqrt();
            let small = 0.5 * im / large;
            let (frequency, growth) = if half < 0.0 { (small, large) } else { (large, small) };
            return ([size(frequency); 2], size(growth));
        }
        // Negative squares are frequencies, positive ones rates of growth: the larger one without cancellation, the other
        // from the product.
        let root = discriminant.sqrt();
        let larger = -(half + if half < 0.0 { -root } else { root });
        let smaller = if larger == 0.0 { 0.0 } else { product / larger };
        let squares = if discriminant == 0.0 { [-half; 2] } else { [larger, smaller] };
        let growth = squares.into_iter().fold(0.0, f64::max).sqrt();
        (squares.map(|x| size((-x).max(0.0).sqrt())), size(growth))
    }
}
