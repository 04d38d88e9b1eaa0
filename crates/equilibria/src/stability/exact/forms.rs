//! The polynomials of the generic family, in μ, with integer coefficients (Proposition 13.4 of docs/mathematics.md).

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::body::ExactBody;
use bifdiag_body::Axis;
use bifdiag_numbers::polynomial::Polynomial;

/// With P = p/D², Q = q/D² over the active axes: χ = `passive`·`cusp`/(p² det A), β = `swing`/(p q det A) and
/// β² − 4χ = `collision`/(p q det A)².
#[derive(Clone, Debug)]
pub struct Forms {
    p: Polynomial,
    q: Polynomial,
    /// Π (μ − a_k) over the active axes.
    product: Polynomial,
    /// Π (μ − a_k) over the other axes.
    pub passive: Polynomial,
    /// The cusp polynomial of Lemma 4.5 of docs/mathematics.md.
    pub cusp: Polynomial,
    /// Of the sign of b.
    pub swing: Polynomial,
    /// Of the sign of b² − 4c.
    pub collision: Polynomial,
}

impl Forms {
    /// The polynomials of a body with r ≠ 0.
    #[must_use]
    pub fn new(body: &ExactBody) -> Self {
        let line = body.a.each_ref().map(Polynomial::linear);
        let one = Polynomial::constant(IBig::ONE);
        let product_of = |axes: &mut dyn Iterator<Item = Axis>| axes.fold(one.clone(), |p, k| p.times(&line[k]));
        let product = product_of(&mut body.active.iter().copied());
        let passive = product_of(&mut Axis::ALL.into_iter().filter(|k| !body.active.contains(k)));
        // D² r_k²/τ_k²
        let zero = Polynomial::new(Vec::new());
        let weight: [Polynomial; 3] = Axis::ALL.map(|k| {
            let others = product_of(&mut body.active.iter().copied().filter(|&m| m != k));
            if body.active.contains(&k) { others.squared().scaled(&body.rho[k]) } else { zero.clone() }
        });
        let moment =
            |power: usize| (0..3).fold(zero.clone(), |sum, k| sum.plus(&weight[k].scaled(&body.a[k].pow(power))));
        let (p, q, second) = (moment(0), moment(1), moment(2));
        let cusp = cusp(&p, &q, &product);
        let swing = swing(body, &line, &weight, &q, &second);
        let determinant = &body.a[0] * &body.a[1] * &body.a[2];
        let product_term = q.squared().times(&passive).times(&cusp).scaled(&(IBig::from(4) * determinant));
        let collision = swing.squared().minus(&product_term);
        Self { p, q, product, passive, cusp, swing, collision }
    }

    /// q⁴ − 4x²p³D²: its roots are the multipliers of the equilibria at x (Proposition 4.8 of docs/mathematics.md).
    #[must_use]
    pub fn at_momentum(&self, x: &RBig) -> Polynomial {
        let (over, under) = (x.numerator(), IBig::from(x.denominator().clone()));
        let left = self.q.squared().squared().scaled(&(&under * &under));
        let right = self.p.squared().times(&self.p).times(&self.product.squared());
        left.minus(&right.scaled(&(IBig::from(4) * over * over)))
    }

    /// p − s²D²: its roots are the multipliers of the steady rotations with Ω² = s, since s² = P (Theorem 3.2 of
    /// docs/mathematics.md).
    #[must_use]
    pub fn at_spin(&self, s: &RBig) -> Polynomial {
        let (over, under) = (s.numerator(), IBig::from(s.denominator().clone()));
        self.p.scaled(&(&under * &under)).minus(&self.product.squared().scaled(&(over * over)))
    }

    /// Of the sign of c.
    #[must_use]
    pub fn zero(&self) -> Polynomial {
        self.passive.times(&self.cusp)
    }
}

/// −½[4(q′D − 2qD′)p − 3(p′D − 2pD′)q], which is C D⁵.
fn cusp(p: &Polynomial, q: &Polynomial, d: &Polynomial) -> Polynomial {
    let slope = d.derivative();
    let of = |f: &Polynomial| f.derivative().times(d).minus(&f.times(&slope).scaled(&IBig::from(2)));
    let twice = of(p).times(q).scaled(&IBig::from(3)).minus(&of(q).times(p).scaled(&IBig::from(4)));
    Polynomial::new(twice.coefficients().iter().map(|c| c / IBig::from(2)).collect())
}

/// det A · P Q β D⁴.
fn swing(
    body: &ExactBody,
    line: &[Polynomial; 3],
    weight: &[Polynomial; 3],
    q: &Polynomial,
    second: &Polynomial,
) -> Polynomial {
    let trace = &body.a[0] + &body.a[1] + &body.a[2];
    let gyroscopic = q.scaled(&trace).minus(&second.scaled(&IBig::from(2))).squared();
    (0..3).fold(gyroscopic, |sum, i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let gap = &body.a[j] - &body.a[k];
        let hanging = line[j].times(&weight[k]).plus(&line[k].times(&weight[j])).times(q);
        let coupled = weight[j].times(&weight[k]).scaled(&(IBig::from(4) * &gap * &gap));
        sum.plus(&hanging.plus(&coupled).scaled(&(&body.a[j] * &body.a[k])))
    })
}
