//! The linearised flow along a branch of relative equilibria: λ⁴ + bλ² + c (Theorem 13.1), its signs as those of
//! polynomials in a parameter of the branch, and the linear type that follows (Corollary 13.2).

use std::slice;

use bifdiag_schema::Stability;
use dashu_int::IBig;
use dashu_ratio::RBig;

use crate::equilibria::spaces::Spaces;
use crate::numbers::polynomial::{Coefficients, Polynomial, product, times, whole};

/// Polynomials with the signs of b, c and b² − 4c.
pub(crate) struct Flow {
    b: Polynomial,
    c: Polynomial,
    discriminant: Polynomial,
    /// With the signs of 4b² − 25c and 9b² − 100c.
    resonances: [Polynomial; 2],
    /// A circle of equilibria, along which c = 0: b alone decides the type across it.
    circle: bool,
}

/// A principal axis: its moment, and the weight γ² and μ − a up to factors that all axes share, in the parameter.
struct Axis<T> {
    a: T,
    weight: Vec<T>,
    tau: Vec<T>,
}

impl Flow {
    /// On the generic family and, where r lies on an axis, on the lines of ±r̂, in μ: γ_k² is q_k/(μ−a_k)² up to a factor.
    pub fn generic(spaces: &Spaces) -> Self {
        let axes = axes(spaces, |k| {
            let product = || times(&spaces.product(&[k], 2), &[spaces.list[k].q.clone()]);
            let weight = if spaces.active.contains(&k) { product() } else { Vec::new() };
            (weight, spaces.factor(k))
        });
        Self::new(&axes, false)
    }

    /// Over a space without r, in z = 1/s²: γ_k² = z q_k/(a − a_k)², and what is left of 1 in the space itself.
    pub fn over(spaces: &Spaces, base: usize) -> Self {
        let (_, p_sum) = spaces.sums(base);
        let axes = axes(spaces, |k| {
            let d = &spaces.list[base].a - &spaces.list[k].a;
            let weight = if k == base {
                vec![RBig::ONE, -p_sum.clone()]
            } else {
                vec![RBig::ZERO, &spaces.list[k].q / (&d * &d)]
            };
            (weight, vec![d])
        });
        Self::new(&axes, spaces.list[base].axes.len() == 2)
    }

    /// Multiplied by det A and the squares of what the weights share: with J = Σ w a, d = a_j − a_k, v² = w_j w_k d²,
    /// c = J Σ w_i τ_j τ_k + 4 Σ τ_i v_i² and J b = (J tr A − 2 Σ w a²)² + Σ a_j a_k [J (τ_j w_k + τ_k w_j) + 4 v_i²].
    fn new(axes: &[Axis<RBig>; 3], circle: bool) -> Self {
        let axes = &in_integers(axes);
        let mean = |power: usize| axes.iter().fold(Vec::new(), |sum, x| plus(&sum, &x.weight, &x.a.pow(power)));
        let (j, second) = (mean(1), mean(2));
        let trace = &axes[0].a + &axes[1].a + &axes[2].a;
        let determinant = &axes[0].a * &axes[1].a * &axes[2].a;
        let swing = plus(&plus(&[], &j, &trace), &second, &IBig::from(-2));
        let (mut b, mut hanging, mut twisted) = (product(&swing, &swing), Vec::new(), Vec::new());
        for i in 0..3 {
            let [x, y, z] = [&axes[i], &axes[(i + 1) % 3], &axes[(i + 2) % 3]];
            let d = &y.a - &z.a;
            let v = plus(&[], &product(&y.weight, &z.weight), &(IBig::from(4) * &d * &d));
            hanging = plus(&hanging, &product(&x.weight, &product(&y.tau, &z.tau)), &IBig::ONE);
            twisted = plus(&twisted, &product(&x.tau, &v), &IBig::ONE);
            let across = plus(&product(&y.tau, &z.weight), &product(&z.tau, &y.weight), &IBig::ONE);
            b = plus(&b, &plus(&product(&j, &across), &v, &IBig::ONE), &(&y.a * &z.a));
        }
        let c = plus(&product(&j, &hanging), &twisted, &IBig::ONE);
        let right = product(&product(&j, &j), &c);
        let square = product(&b, &b);
        let defect = |m: i32, n: i32| {
            let square = plus(&[], &square, &IBig::from(m));
            Polynomial::primitive(plus(&square, &right, &(IBig::from(-n) * &determinant)))
        };
        let (discriminant, resonances) = (defect(1, 4), [defect(4, 25), defect(9, 100)]);
        let [b, c] = [b, c].map(Polynomial::primitive);
        Self { b, c, discriminant, resonances, circle }
    }

    /// Where the type changes between the ends of curves, this is zero.
    pub fn condition(&self) -> &Polynomial {
        if self.circle { &self.b } else { &self.discriminant }
    }

    /// Where one frequency is twice or three times the other, these are zero.
    pub fn resonances(&self) -> &[Polynomial; 2] {
        &self.resonances
    }

    /// The type at a parameter inside a curve.
    pub fn stability(&self, t: &RBig) -> Stability {
        let b = self.b.sign_at(t);
        if self.circle { across(b) } else { linear_type(b, self.c.sign_at(t), self.discriminant.sign_at(t)) }
    }
}

/// One axis for each direction, r along the first of its space.
fn axes(spaces: &Spaces, of: impl Fn(usize) -> (Coefficients, Coefficients)) -> [Axis<RBig>; 3] {
    let mut all = spaces.list.iter().enumerate().flat_map(|(k, space)| {
        let (weight, tau) = of(k);
        (0..space.axes.len()).map(move |n| Axis {
            a: space.a.clone(),
            weight: if n == 0 { weight.clone() } else { Vec::new() },
            tau: tau.clone(),
        })
    });
    std::array::from_fn(|_| all.next().expect("three axes"))
}

/// Moments and τ times one integer, weights times another: b, c and their defects are homogeneous in either.
fn in_integers(axes: &[Axis<RBig>; 3]) -> [Axis<IBig>; 3] {
    let lengths = axes.each_ref().map(|axis| [axis.weight.len(), axis.tau.len()]);
    let sizes: Coefficients = axes.iter().flat_map(|axis| [slice::from_ref(&axis.a), &axis.tau].concat()).collect();
    let mut sizes = whole(&sizes).0.into_iter();
    let weights: Coefficients = axes.iter().flat_map(|axis| axis.weight.iter().cloned()).collect();
    let mut weights = whole(&weights).0.into_iter();
    lengths.map(|[weight, tau]| Axis {
        a: sizes.next().expect("a moment of each axis"),
        tau: sizes.by_ref().take(tau).collect(),
        weight: weights.by_ref().take(weight).collect(),
    })
}

/// p + factor q.
fn plus(p: &[IBig], q: &[IBig], factor: &IBig) -> Vec<IBig> {
    let term = |k: usize| q.get(k).map_or(IBig::ZERO, |c| c * factor);
    (0..p.len().max(q.len())).map(|k| p.get(k).map_or_else(|| term(k), |c| c + term(k))).collect()
}

/// Rotation without weight about an axis of a space: λ² = −Ω² and −Ω²(a_k − a_i)(a_k − a_j)/(a_i a_j).
pub(crate) fn without_weight(spaces: &Spaces, base: usize) -> Stability {
    let a = &spaces.list[base].a;
    let others = spaces.list.iter().enumerate().filter(|(k, _)| *k != base);
    let moments: Vec<&RBig> = others.flat_map(|(_, space)| std::iter::repeat_n(&space.a, space.axes.len())).collect();
    // Else a circle or sphere of equilibria.
    let [i, j] = moments[..] else { return across(1) };
    let (product, others) = ((a - i) * (a - j), i * j);
    linear_type(1, sign(&product), sign(&((&product - &others) * (product - others))))
}

fn sign(x: &RBig) -> i8 {
    i8::from(*x > RBig::ZERO) - i8::from(*x < RBig::ZERO)
}

/// The signs of b, c and b² − 4c.
fn linear_type(b: i8, c: i8, discriminant: i8) -> Stability {
    match (c, discriminant, b) {
        (0, ..) => Stability::Zero,
        (-1, ..) => Stability::SaddleCentre,
        (_, -1, _) => Stability::Complex,
        (_, 0, 1) => Stability::DoubleElliptic,
        (_, 0, _) => Stability::DoubleReal,
        (.., 1) => Stability::Elliptic,
        _ => Stability::Saddle,
    }
}

/// Across a circle or a sphere of equilibria λ² = −b.
fn across(b: i8) -> Stability {
    match b {
        0 => Stability::Zero,
        1 => Stability::Elliptic,
        _ => Stability::Saddle,
    }
}
