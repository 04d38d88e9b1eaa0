//! The integrals |q|² = 1, h and l, and what they say of a set that the motion has brought here.
//!
//! An integral J has on the whole motion the value J₀ that it had at the start. For a point x = m + y of the set
//! ⟨∇J(m), y⟩ = J₀ − J(m) − ρ(y) with ρ of second order, which is known far better than the set knows it after some steps.
//! Any vectors w₁, w₂, w₃ give, with the gradients nₖ,
//!
//!   y = My + Σ wₖ⟨nₖ, y⟩,   M = 1 − Σ wₖnₖᵀ,
//!
//! so that the set lies in its image under M, moved and widened by what is known of the ⟨nₖ, y⟩. W = ΣNᵀ(NΣNᵀ)⁻¹ with a
//! covariance Σ of the set leaves least, as in Kalman's filter: the error of phase that goes with a wrong h or l leaves the
//! set together with it.

use bifdiag_body::Body;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::wide::Wide;
use dashu_ratio::RBig;

use crate::bound::{norm, up};
use crate::field::ATTITUDE;
use crate::scalar::Scalar;
use crate::set::{FlowSet, Matrix, inverse};
use crate::start::ExactStart;

type Point = [f64; ATTITUDE];

/// Bits that the values have beyond those of the motion.
const GUARD: usize = 32;

/// The values of the integrals at the start, and what they are computed from.
#[derive(Clone, Debug)]
pub struct Integrals {
    /// A and r/speed².
    moments: [Wide; 3],
    center: [Wide; 3],
    /// |q|², h/speed² and l/speed.
    values: [Wide; 3],
    bits: usize,
    /// Doubles of A and r/speed², and bounds of their norms.
    a: [f64; 3],
    r: [f64; 3],
    largest: f64,
    weight: f64,
}

impl Integrals {
    /// Those of the motion from a start, ω in units of `speed`.
    #[must_use]
    pub fn new(body: &Body, start: &ExactStart, speed: &RBig, bits: usize) -> Self {
        let bits = bits + GUARD;
        let square = speed * speed;
        let center = body.center().each_ref().map(|r| r.value() / &square);
        let double = |x: &RBig| x.to_f64().value();
        let (a, r) = (body.moments_f64(), center.each_ref().map(double));
        let mut integrals = Self {
            moments: body.moments().each_ref().map(|a| Wide::rational(a.value(), bits)),
            center: center.each_ref().map(|r| Wide::rational(r, bits)),
            values: std::array::from_fn(|_| Wide::small(1, bits)),
            bits,
            a,
            r,
            largest: up(a.into_iter().fold(0.0, f64::max)),
            weight: norm(&r),
        };
        let [h, l] = integrals.of(&start.vertical(bits), &start.velocity(speed, bits));
        integrals.values[1..].clone_from_slice(&[h, l]);
        integrals
    }

    /// h = ½⟨ω, Aω⟩ − ⟨γ, r⟩ and l = ⟨γ, Aω⟩.
    fn of(&self, gamma: &[Wide; 3], omega: &[Wide; 3]) -> [Wide; 2] {
        let zero = Wide::small(0, self.bits);
        (0..3).fold([zero.clone(), zero], |[h, l], i| {
            let momentum = self.moments[i].clone() * omega[i].clone();
            let half = momentum.clone() * omega[i].clone() * Wide::double(0.5, self.bits);
            [h + half - gamma[i].clone() * self.center[i].clone(), l + momentum * gamma[i].clone()]
        })
    }

    /// J₀ − J(m) for the three integrals: a double, and a bound of how far it is from that.
    fn gaps<S: Scalar>(&self, middle: &[S; ATTITUDE]) -> Option<[[f64; 2]; 3]> {
        let exact = middle.each_ref().map(S::to_rational);
        let exact = exact.map(|x| x.map(|x| Wide::rational(&x, self.bits)));
        let [Some(w), Some(x), Some(y), Some(z), Some(a), Some(b), Some(c)] = exact else { return None };
        let twice = |u: &Wide, v: &Wide| Wide::small(2, self.bits) * u.clone() * v.clone();
        let [ww, xx, yy, zz] = [&w, &x, &y, &z].map(Wide::square);
        let across = xx + yy;
        let gamma =
            [twice(&x, &z) - twice(&w, &y), twice(&y, &z) + twice(&w, &x), ww.clone() - across.clone() + zz.clone()];
        let [h, l] = self.of(&gamma, &[a, b, c]);
        let mut gaps = [[0.0; 2]; 3];
        for (gap, (value, here)) in gaps.iter_mut().zip(self.values.iter().zip([ww + across + zz, h, l])) {
            let ends = (value.clone() - here).exact_bounds()?;
            let middle = 0.5 * (&ends[0] + &ends[1]).to_f64().value();
            let exact = RBig::try_from(middle).ok()?;
            let [below, above] = ends.map(|end| (end - &exact).to_f64().value().abs());
            *gap = [middle, up(below.max(above))];
        }
        Some(gaps)
    }

    /// The gradients at a point, rounded: sums of at most three products of three numbers.
    fn gradients(&self, m: &Point) -> [Point; 3] {
        let [w, x, y, z, ..] = m.map(|x| 2.0 * x);
        // Of γ by q.
        let turned = [[-y, z, -w, x], [x, w, z, y], [w, -x, -y, z]];
        let q = [m[0], m[1], m[2], m[3]];
        let momentum: [f64; 3] = std::array::from_fn(|i| self.a[i] * m[4 + i]);
        let mut n = [[0.0; ATTITUDE]; 3];
        for i in 0..3 {
            // γ is a quadratic form.
            let gamma = 0.5 * (0..4).map(|j| turned[i][j] * q[j]).sum::<f64>();
            for j in 0..4 {
                n[1][j] -= self.r[i] * turned[i][j];
                n[2][j] += momentum[i] * turned[i][j];
            }
            n[1][4 + i] = momentum[i];
            n[2][4 + i] = self.a[i] * gamma;
        }
        n[0][..4].copy_from_slice(&[w, x, y, z]);
        n
    }

    /// A set that holds those points of `set` that lie on the levels of the motion; `None` where it would not be smaller.
    #[must_use]
    pub fn tightened<S: Scalar>(
        &self,
        set: &FlowSet<S, ATTITUDE>,
        precision: S::Precision,
    ) -> Option<FlowSet<S, ATTITUDE>> {
        let m = set.middle.each_ref().map(S::to_double);
        let (gaps, n) = (self.gaps(&set.middle)?, self.gradients(&m));
        let radii = set.component_radii();
        let size = norm(&radii);
        let parts = |[a, b, c, d, e, f, g]: Point| [norm(&[a, b, c, d]), norm(&[e, f, g])];
        let ([turn, rate], [q, omega]) = (parts(radii), parts(m));
        // ρ: γ(q + u) = γ(q) + Dγ(q)u + γ(u) with |γ(u)| = |u|², |Dγ(q)u| ≤ 2|q||u|.
        let rest = [
            turn * turn,
            0.5 * self.largest * rate * rate + self.weight * turn * turn,
            self.largest * turn * (2.0 * q * rate + turn * (omega + rate)),
        ];
        // More than the sizes of gradients; 64 units cover their roundings and the sum of absolute values in them.
        let steep = [2.0 * q, self.largest * omega + 2.0 * self.weight * q, self.largest * q * (2.0 * omega + q)];
        let weights = weights(set, &n)?;
        let (mut ball, mut entries, mut shift) = (0.0, ATTITUDE as f64, [0.0; ATTITUDE]);
        for k in 0..3 {
            let slack = gaps[k][1] + rest[k] + 32.0 * f64::EPSILON * steep[k] * size;
            let length = norm(&weights[k]);
            ball += length * (slack + 8.0 * f64::EPSILON * gaps[k][0].abs());
            entries += length * norm(&n[k]);
            for (shift, w) in shift.iter_mut().zip(&weights[k]) {
                *shift += w * gaps[k][0];
            }
        }
        let map: Matrix<ATTITUDE> = std::array::from_fn(|i| {
            std::array::from_fn(|j| f64::from(u8::from(i == j)) - (0..3).map(|k| weights[k][i] * n[k][j]).sum::<f64>())
        });
        // The roundings of M, and of the middle.
        ball += 16.0 * f64::EPSILON * entries * size + S::unit(precision) * (q + omega + norm(&shift));
        let middle = std::array::from_fn(|i| set.middle[i].plus(&S::double(shift[i], precision), precision));
        set.mapped(&map, up(ball), middle).filter(|held| held.size() < size)
    }
}

/// The columns of W. Nothing depends on what they are.
fn weights<S: Scalar>(set: &FlowSet<S, ATTITUDE>, n: &[Point; 3]) -> Option<[Point; 3]> {
    let (mut gram, mut along) = ([[0.0; 3]; 3], [[0.0; ATTITUDE]; 3]);
    for generator in set.shape.generators() {
        let dots = n.each_ref().map(|n| n.iter().zip(&generator).map(|(n, g)| n * g).sum::<f64>());
        for k in 0..3 {
            for (gram, dot) in gram[k].iter_mut().zip(&dots) {
                *gram += dots[k] * dot;
            }
            for (along, g) in along[k].iter_mut().zip(&generator) {
                *along += dots[k] * g;
            }
        }
    }
    let inverse = inverse(&gram)?;
    Some(std::array::from_fn(|k| std::array::from_fn(|i| (0..3).map(|m| along[m][i] * inverse[m][k]).sum())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::set::{identity, product};
    use support::random::SplitMix64;

    /// What a set says of ⟨c, x⟩: a middle and a radius.
    fn along(set: &FlowSet<f64, ATTITUDE>, c: &Point) -> [f64; 2] {
        let dot = |v: [f64; ATTITUDE]| v.iter().zip(c).map(|(v, c)| v * c).sum::<f64>();
        [dot(set.middle), set.shape.reach(|v| dot(v).abs())]
    }

    /// The start lies on its levels: every set that holds it still holds it after it was tightened, in all directions, and along
    /// the gradients such a set is as narrow as second order lets it be.
    #[test]
    fn tightened_sets_hold_the_levels_and_are_narrow_across_them() {
        let mut random = SplitMix64::new(11);
        let exact = |x: f64| RBig::try_from(x).unwrap();
        let mut smaller = 0;
        for round in 0..400 {
            let mut three = |size: f64| -> [f64; 3] { std::array::from_fn(|_| size * random.between(-1.0, 1.0)) };
            let [a, r] = [three(0.4).map(|x| format!("{}", 1.0 + x)), three(1.0).map(|x| format!("{x}"))];
            let Ok(body) = Body::parse(&a, &r) else { continue };
            let start = ExactStart { gamma: three(1.0).map(exact), omega: three(3.0).map(exact), phi: RBig::ZERO };
            let speed = start.speed(&body);
            let point = start.attitude::<f64>(&speed, (), 53).middle;
            let size = [1e-2, 1e-4, 1e-7, 1e-10][round % 4];
            let map: Matrix<ATTITUDE> = std::array::from_fn(|i| {
                std::array::from_fn(|j| random.between(-0.3, 0.3) + identity::<ATTITUDE>()[i][j])
            });
            let inside: Point = std::array::from_fn(|_| size * random.between(-0.9, 0.9));
            let mut column = [[0.0; ATTITUDE]; ATTITUDE];
            for (row, x) in column.iter_mut().zip(inside) {
                row[0] = x;
            }
            let moved = product(&map, &column);
            let middle: Point = std::array::from_fn(|i| point[i] - moved[i][0]);
            let set = FlowSet::<f64, ATTITUDE>::new(middle, [size; ATTITUDE]).mapped(&map, 1e-15, middle).unwrap();
            let integrals = Integrals::new(&body, &start, &speed, 53);
            let Some(held) = integrals.tightened(&set, ()) else { continue };
            smaller += 1;
            let normals = integrals.gradients(&held.middle);
            let others: Vec<Point> = (0..40).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
            for c in normals.iter().chain(&others) {
                let [center, radius] = along(&held, c);
                let value = point.iter().zip(c).map(|(x, c)| x * c).sum::<f64>();
                assert!((value - center).abs() <= radius + 1e-15, "{round}: {value} {center} {radius}");
            }
            for (new, old) in normals.iter().zip(integrals.gradients(&middle)) {
                let ([_, now], [_, before]) = (along(&held, new), along(&set, &old));
                assert!(now <= 400.0 * size * before + 1e-13, "{round}: {now} {before}");
            }
        }
        assert!(smaller > 250, "{smaller}");
    }

    /// In a steady rotation the gradients of h and l depend on each other: the set stays unchanged or shrinks.
    #[test]
    fn dependent_gradients_do_no_harm() {
        let body = Body::parse(&["2", "2", "1"], &["0", "0", "1"]).unwrap();
        let exact = |v: [i32; 3]| v.map(RBig::from);
        let start = ExactStart { gamma: exact([0, 0, 1]), omega: exact([0, 0, 2]), phi: RBig::ZERO };
        let speed = start.speed(&body);
        let mut set = start.attitude::<f64>(&speed, (), 53);
        set.shape.radii = [1e-6; ATTITUDE];
        let held = Integrals::new(&body, &start, &speed, 53).tightened(&set, ());
        assert!(held.is_none_or(|held| held.size() < set.size() && held.middle.iter().all(|x| x.is_finite())));
    }
}
