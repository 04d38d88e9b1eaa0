//! Rational points exactly on curves, from rational unit vectors γ: with s = t² a relative equilibrium at γ has
//! r = s(μ − A)γ, J = ⟨γ, Aγ⟩, l = tJ and h = sJ/2 − ⟨γ, r⟩, all rational.

use bifdiag_body::{Body, Number};
use dashu_ratio::RBig;
use support::random::SplitMix64;

/// What a point lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A pole line.
    PoleLine,
    /// A curve of the generic family.
    Generic,
    /// A symmetric pair.
    Pair,
    /// A cusp of the generic family.
    GenericCusp,
    /// A cusp of a pair.
    PairCusp,
    /// A pitchfork.
    Fork,
    /// A crossing of a pair with the line of −r̂, r on an axis.
    DoublePoint,
}

/// All of them.
pub const KINDS: [Kind; 7] =
    [Kind::PoleLine, Kind::Generic, Kind::Pair, Kind::GenericCusp, Kind::PairCusp, Kind::Fork, Kind::DoublePoint];

/// A body and a point on one of its curves.
#[derive(Clone, Debug)]
pub struct Tie {
    pub body: Body,
    pub h: Number,
    pub l: Number,
}

/// Unit vectors times their common denominator.
const UNITS: [[i64; 4]; 6] = [[1, 2, 2, 3], [2, 3, 6, 7], [1, 4, 8, 9], [4, 4, 7, 9], [2, 6, 9, 11], [6, 6, 7, 11]];

fn ratio(p: i64, q: i64) -> RBig {
    RBig::from(p) / RBig::from(q)
}

fn between(random: &mut SplitMix64, low: i64, high: i64) -> i64 {
    let steps = u64::try_from(high - low).expect("a range");
    low + i64::try_from(random.next_u64() % steps).expect("a small number")
}

/// A rational unit vector of random signs and order.
fn unit(random: &mut SplitMix64) -> [RBig; 3] {
    let [a, b, c, n] = UNITS[random.index(UNITS.len())];
    let mut parts = [a, b, c];
    parts.rotate_left(random.index(3));
    parts.map(|part| ratio(if random.unit() < 0.5 { -part } else { part }, n))
}

fn dot(p: &[RBig; 3], q: &[RBig; 3]) -> RBig {
    &p[0] * &q[0] + &p[1] * &q[1] + &p[2] * &q[2]
}

fn moments(random: &mut SplitMix64) -> [RBig; 3] {
    [0, 1, 2].map(|k| ratio(between(random, 20, 60) + 41 * k, 40))
}

impl Tie {
    fn new(a: [RBig; 3], r: [RBig; 3], h: RBig, l: RBig) -> Option<Self> {
        let body = Body::new(a.map(Number::from_rational), r.map(Number::from_rational)).ok()?;
        Some(Self { body, h: Number::from_rational(h), l: Number::from_rational(l) })
    }

    /// The relative equilibrium with multiplier μ and s = t² at γ.
    fn at(a: [RBig; 3], mu: &RBig, gamma: &[RBig; 3], t: &RBig) -> Option<Self> {
        let s = t * t;
        let r = [0, 1, 2].map(|k| &s * (mu - &a[k]) * &gamma[k]);
        let square = gamma.each_ref().map(|g| g * g);
        let j = dot(&a, &square);
        let h = &s * &j / RBig::from(2) - dot(gamma, &r);
        Self::new(a, r, h, t * j)
    }

    /// The size of energies there.
    pub fn scale(&self) -> RBig {
        let h = self.h.value().clone();
        let size = if h < RBig::ZERO { -h } else { h };
        if size.is_zero() { RBig::ONE } else { size }
    }
}

impl Kind {
    /// A random point; `None` where the chosen numbers give no body.
    pub fn tie(self, random: &mut SplitMix64) -> Option<Tie> {
        let t = ratio(between(random, 8, 30), 16);
        match self {
            Self::PoleLine => {
                let (a, gamma) = (moments(random), unit(random));
                let r = gamma.each_ref().map(|g| g * RBig::from(3));
                let square = gamma.each_ref().map(|g| g * g);
                let l = ratio(between(random, 1, 400), 100);
                let side = RBig::from(if random.unit() < 0.5 { -3 } else { 3 });
                let h = &l * &l / (RBig::from(2) * dot(&a, &square)) + side;
                Tie::new(a, r, h, l)
            }
            Self::Generic => {
                let mu = ratio(between(random, -60, 260), 41);
                Tie::at(moments(random), &mu, &unit(random), &t)
            }
            Self::Pair => {
                let a = moments(random);
                let mu = a[random.index(3)].clone();
                Tie::at(a, &mu, &unit(random), &t)
            }
            Self::Fork => {
                let a = moments(random);
                let axis = random.index(3);
                let mu = a[axis].clone();
                let mut gamma = [ratio(3, 5), ratio(4, 5), RBig::ZERO];
                gamma.rotate_right((axis + 1) % 3);
                Tie::at(a, &mu, &gamma, &t)
            }
            Self::GenericCusp => generic_cusp(random, &t),
            Self::PairCusp => pair_cusp(random, &t),
            Self::DoublePoint => double_point(random),
        }
    }
}

/// TJ + 4V = 0 with T = Σw/τ and V = Σ w_i w_j (τ_i − τ_j)²/(τ_i τ_j), so that J = −4V/T and μ = J + Σwτ.
fn generic_cusp(random: &mut SplitMix64, t: &RBig) -> Option<Tie> {
    let gamma = unit(random);
    let tau = [0, 1, 2].map(|_| ratio(between(random, -60, 60), 17));
    if tau.iter().any(RBig::is_zero) {
        return None;
    }
    let w = gamma.each_ref().map(|g| g * g);
    let mean = (0..3).fold(RBig::ZERO, |sum, k| sum + &w[k] / &tau[k]);
    let mut spread = RBig::ZERO;
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let gap = &tau[i] - &tau[j];
        spread += &w[i] * &w[j] * &gap * gap / (&tau[i] * &tau[j]);
    }
    if mean.is_zero() {
        return None;
    }
    let mu = dot(&w, &tau) - RBig::from(4) * spread / mean;
    let a = [0, 1, 2].map(|k| &mu - &tau[k]);
    if a.iter().any(|a| *a < ratio(1, 4) || *a > RBig::from(9)) || a[0] == a[1] || a[1] == a[2] || a[0] == a[2] {
        return None;
    }
    Tie::at(a, &mu, &gamma, t)
}

/// a_i s² = −3R̂ with R̂ = s² Σ(a_i − a_j)γ_j².
fn pair_cusp(random: &mut SplitMix64, t: &RBig) -> Option<Tie> {
    let mut a = moments(random);
    let gamma = unit(random);
    let w = gamma.each_ref().map(|g| g * g);
    let axis = random.index(3);
    let others: Vec<usize> = (0..3).filter(|&k| k != axis).collect();
    let sum = others.iter().fold(RBig::ZERO, |sum, &k| sum + &a[k] * &w[k]);
    let weight = others.iter().fold(RBig::ZERO, |sum, &k| sum + &w[k]);
    a[axis] = RBig::from(3) * sum / (RBig::ONE + RBig::from(3) * weight);
    let mu = a[axis].clone();
    if others.iter().any(|&k| a[k] == mu) {
        return None;
    }
    Tie::at(a, &mu, &gamma, t)
}

/// Katok's bodies: l² = 4(1/√k − 1), h = l²/2 + 1 for A = (1, 1 − k, A₃).
fn double_point(random: &mut SplitMix64) -> Option<Tie> {
    let m = ratio(between(random, 6, 30), 16);
    let root = RBig::ONE / (RBig::ONE + &m * &m / RBig::from(4));
    let a = RBig::ONE - &root * &root;
    let other = ratio(between(random, 21, 60), 20);
    let h = &m * &m / RBig::from(2) + RBig::ONE;
    Tie::new([RBig::ONE, a, other], [RBig::ONE, RBig::ZERO, RBig::ZERO], h, m)
}
