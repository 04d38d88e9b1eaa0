//! Where a motion starts, exactly, and boxes that hold it.

use bifdiag_body::Body;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::wide::Wide;
use dashu_ratio::RBig;

use crate::bound::up;
use crate::scalar::Scalar;
use crate::set::FlowSet;

/// The start: a vertical of any length, the angular velocity, both in the body's axes, and Euler's angle φ.
#[derive(Clone, Debug, PartialEq)]
pub struct ExactStart {
    /// γ up to a positive factor; not 0.
    pub gamma: [RBig; 3],
    /// ω.
    pub omega: [RBig; 3],
    /// φ.
    pub phi: RBig,
}

/// Bits that the box of a start has beyond those of the motion.
const GUARD: usize = 64;

impl ExactStart {
    /// The same state, with time running backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { omega: self.omega.clone().map(|x| -x), ..self.clone() }
    }

    /// A power of two near the frequencies of the motion: in units of it everything is of moderate size.
    #[must_use]
    pub fn speed(&self, body: &Body) -> RBig {
        let double = |x: &RBig| x.to_f64().value();
        let omega = self.omega.iter().map(|x| double(x).abs()).fold(0.0, f64::max);
        let least = body.moments_f64().into_iter().fold(f64::INFINITY, f64::min);
        let weight = body.center_f64().into_iter().map(f64::abs).fold(0.0, f64::max);
        let speed = omega.max(2.0 * (weight / least).sqrt());
        // The nearest power: that of 4/3 of it, rounded down.
        let exponent = if speed > 0.0 { libm::ilogb(speed * 4.0 / 3.0) } else { 0 };
        let power = RBig::from(dashu_int::IBig::ONE << exponent.unsigned_abs() as usize);
        if exponent >= 0 { power } else { RBig::ONE / power }
    }

    /// (γ, ω/speed) at the start.
    #[must_use]
    pub fn free<S: Scalar>(&self, speed: &RBig, precision: S::Precision, bits: usize) -> FlowSet<S, 6> {
        let [x, y, z] = self.vertical(bits + GUARD);
        let [a, b, c] = self.velocity(speed, bits + GUARD);
        enclosed(&[x, y, z, a, b, c], precision)
    }

    /// (q, ω/speed) at the start.
    #[must_use]
    pub fn attitude<S: Scalar>(&self, speed: &RBig, precision: S::Precision, bits: usize) -> FlowSet<S, 7> {
        let [w, x, y, z] = self.quaternion(bits + GUARD);
        let [a, b, c] = self.velocity(speed, bits + GUARD);
        enclosed(&[w, x, y, z, a, b, c], precision)
    }

    pub(crate) fn velocity(&self, speed: &RBig, bits: usize) -> [Wide; 3] {
        self.omega.each_ref().map(|x| Wide::rational(&(x / speed), bits))
    }

    /// γ of length 1.
    pub(crate) fn vertical(&self, bits: usize) -> [Wide; 3] {
        let square = self.gamma.iter().fold(RBig::ZERO, |sum, x| sum + x * x);
        let length = Wide::rational(&square, bits).sqrt();
        self.gamma.each_ref().map(|x| Wide::rational(x, bits) / length.clone())
    }

    /// R_z(φ) R_x(ϑ) R_z(ψ) with γ = (sin ψ sin ϑ, cos ψ sin ϑ, cos ϑ), and ψ = 0 where γ = ±e₃.
    fn quaternion(&self, bits: usize) -> [Wide; 4] {
        let number = |value: i32| Wide::small(value, bits);
        let half = |x: Wide| x * Wide::double(0.5, bits);
        let [x, y, z] = self.vertical(bits);
        let across = (x.square() + y.square()).sqrt();
        // The half angles: the larger of cosine and sine by a root, the other one by the sine of the whole angle.
        let halved = |cosine: Wide, sine: Wide, positive: bool| {
            if positive {
                let c = half(number(1) + cosine).sqrt();
                (c.clone(), half(sine) / c)
            } else {
                let s = half(number(1) - cosine).sqrt();
                (half(sine) / s.clone(), s)
            }
        };
        let (cos, sin) = halved(z, across.clone(), self.gamma[2] >= RBig::ZERO);
        let (cos_psi, sin_psi) = if self.gamma[0].is_zero() && self.gamma[1].is_zero() {
            (number(1), number(0))
        } else {
            let (c, s) = halved(y / across.clone(), x / across, self.gamma[1] >= RBig::ZERO);
            // ψ/2 from −π/2 to π/2, so that its cosine is not negative.
            if self.gamma[1] < RBig::ZERO && self.gamma[0] < RBig::ZERO { (-c, -s) } else { (c, s) }
        };
        let (cos_phi, sin_phi) = cosine_and_sine(&(&self.phi / RBig::from(2)), bits);
        let product = |a: &Wide, b: &Wide| a.clone() * b.clone();
        let (cc, ss) = (product(&cos_phi, &cos_psi), product(&sin_phi, &sin_psi));
        let (sc, cs) = (product(&sin_phi, &cos_psi), product(&cos_phi, &sin_psi));
        [
            cos.clone() * (cc.clone() - ss.clone()),
            sin.clone() * (cc + ss),
            sin * (sc.clone() - cs.clone()),
            cos * (sc + cs),
        ]
    }
}

/// cos x and sin x.
fn cosine_and_sine(x: &RBig, bits: usize) -> (Wide, Wide) {
    let mut small = x.clone();
    let mut doublings = 0;
    while small.clone() * small.clone() > RBig::ONE / RBig::from(16) {
        small /= RBig::from(2);
        doublings += 1;
    }
    let bits = bits + 4 * doublings;
    // Σ xᵏ/k!; the rest is less than twice the first term that is left out.
    let (mut term, mut sums) = (Wide::small(1, bits), [Wide::small(0, bits), Wide::small(0, bits)]);
    let at = Wide::rational(&small, bits);
    let terms = u32::try_from(bits / 2 + 4).unwrap_or(u32::MAX);
    for k in 0..terms {
        let signed = if k % 4 < 2 { term.clone() } else { -term.clone() };
        let sum = &mut sums[k as usize % 2];
        *sum = sum.clone() + signed;
        term = term * at.clone() / Wide::double(f64::from(k + 1), bits);
    }
    let rest = term.clone().hull(&-term) * Wide::small(2, bits);
    let [mut cos, mut sin] = sums.map(|sum| sum + rest.clone());
    for _ in 0..doublings {
        let product = sin.clone() * cos.clone();
        (cos, sin) = (cos.square() - sin.square(), product.clone() + product);
    }
    (cos, sin)
}

/// A box about intervals.
fn enclosed<S: Scalar, const N: usize>(values: &[Wide; N], precision: S::Precision) -> FlowSet<S, N> {
    let mut radii = [f64::INFINITY; N];
    let middle = std::array::from_fn(|i| {
        let ends = values[i].exact_bounds().unwrap_or([RBig::ZERO, RBig::ZERO]);
        let middle = (&ends[0] + &ends[1]) / RBig::from(2);
        let rounded = S::rational(&middle, precision);
        if let (Some(found), Some(_)) = (rounded.to_rational(), values[i].exact_bounds()) {
            let far = ends.map(|end| (end - found.clone()).to_f64().value().abs());
            radii[i] = up(far[0].max(far[1]));
        }
        rounded
    });
    FlowSet::new(middle, radii)
}
