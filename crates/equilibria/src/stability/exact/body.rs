//! A body as integers, moments and squares of r in the frame's order with the units in which they are whole, and the
//! polynomials of its generic family in μ (Proposition 13.4 of docs/algorithms.md).

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use crate::stability::{Constants, RESONANCES};
use bifdiag_body::{Axis, Body, Frame};
use bifdiag_numbers::Number;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::polynomial::Polynomial;
use bifdiag_numbers::polynomial::rational::over_one_denominator;

/// A body in the frame's order of axes, exact.
#[derive(Clone, Debug)]
pub struct ExactBody {
    /// Moments times `unit_a`, ascending.
    pub a: [IBig; 3],
    /// |r|² on each eigenspace, at its first axis, times `unit_r`².
    pub rho: [IBig; 3],
    /// Number of the eigenspace of each axis.
    pub group: [usize; 3],
    /// The axes that carry r.
    pub active: Vec<Axis>,
    /// The axes, one for each eigenspace, on which r vanishes.
    pub passive: Vec<Axis>,
    unit_a: UBig,
    unit_r: UBig,
    moments: [RBig; 3],
    squares: [RBig; 3],
    momentum_unit: RBig,
    frequency_unit: RBig,
    /// See [`Body::square_correction`].
    correction: RBig,
}

impl ExactBody {
    /// The body of a frame.
    #[must_use]
    pub fn new(body: &Body, frame: &Frame) -> Self {
        let power = |x: f64| RBig::try_from(x).unwrap_or(RBig::ONE);
        let (energy, momentum) = (power(frame.energy_unit), power(frame.momentum_unit));
        let a_unit = &momentum * &momentum / &energy;
        let given = body.moments().each_ref().map(|a| a.value() / &a_unit);
        let center = body.center().each_ref().map(|r| r.value() / &energy);
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| given[i].cmp(&given[j]));
        let moments = order.map(|i| given[i].clone());
        let mut squares = [RBig::ZERO; 3];
        for k in 0..3 {
            let first = (0..=k).find(|&m| frame.group[m] == frame.group[k]).unwrap_or(k);
            squares[first] += &center[order[k]] * &center[order[k]];
        }
        let unit_a = over_one_denominator(&moments).1;
        let unit_r = over_one_denominator(&center).1;
        let whole = |x: RBig| x.numerator().clone();
        let (n, m) = (RBig::from(unit_a.clone()), RBig::from(unit_r.clone()));
        Self {
            a: moments.each_ref().map(|a| whole(a * &n)),
            rho: squares.each_ref().map(|x| whole(x * &m * &m)),
            group: frame.group,
            active: frame.active(),
            passive: frame.passive(),
            unit_a,
            unit_r,
            moments,
            squares,
            frequency_unit: energy / &momentum,
            momentum_unit: momentum,
            correction: body.square_correction(),
        }
    }

    /// x = l²/2 in the units of the integers.
    #[must_use]
    pub fn abscissa(&self, l: &Number) -> RBig {
        let l = l.value() / &self.momentum_unit;
        let units = RBig::from(&self.unit_a * &self.unit_r);
        &l * &l / RBig::from(2) * units
    }

    /// Ω⁴ in the units of the integers.
    #[must_use]
    pub fn fourth_power_of_spin(&self, fourth: &RBig) -> RBig {
        // s' = (M/N) s.
        let ratio = RBig::from(self.unit_r.clone()) / RBig::from(self.unit_a.clone());
        let unit = self.frequency_unit.sqr();
        fourth / &self.correction / unit.sqr() * ratio.sqr()
    }

    /// A difference of multipliers in the frame's units.
    #[must_use]
    pub fn moment_in_frame(&self, delta: &RBig) -> RBig {
        delta / RBig::from(self.unit_a.clone())
    }

    /// z = 1/Ω⁴ in the frame's units.
    #[must_use]
    pub fn z_in_frame(&self, z: &RBig) -> RBig {
        // s' = (M/N) s.
        let ratio = RBig::from(self.unit_r.clone()) / RBig::from(self.unit_a.clone());
        z * &ratio * &ratio
    }

    /// The numbers of the linearisation, in the frame's units.
    #[must_use]
    pub fn constants<E: Arithmetic>(&self, precision: E::Precision) -> Constants<E> {
        Constants::exact(&self.moments, &self.squares, precision)
    }

    /// The pair over a passive moment has its cusp where it leaves the generic family: a_i P̂ + 3R̂ = 0 (Proposition 4.7 of
    /// docs/mathematics.md).
    #[must_use]
    pub fn has_cusp_at_pitchfork(&self, i: Axis) -> bool {
        let term = |&k: &Axis| {
            let gap = &self.a[i] - &self.a[k];
            RBig::from(&self.rho[k] * (&self.a[i] + IBig::from(3) * &gap)) / RBig::from(&gap * &gap)
        };
        self.active.iter().map(term).fold(RBig::ZERO, |sum, term| sum + term) == RBig::ZERO
    }

    /// True when A⁻¹ across r is a multiple of 1, so that both pairs of eigenvalues at rest agree:
    /// (Σ(1 − r̂_i²)/A_i)² = 4J_r/det A.
    #[must_use]
    pub fn is_round_across_r(&self) -> bool {
        let [a, b, c] = &self.a;
        let [p, q, r] = &self.rho;
        let sum = (q + r) * b * c + (p + r) * a * c + (p + q) * a * b;
        &sum * &sum == IBig::from(4) * (p + q + r) * (p * a + q * b + r * c) * (a * b * c)
    }
}

/// With P = p/D², Q = q/D² over the active axes: χ = `zero`/(p² det A), β = `swing`/(p q det A) and mβ² − nχ is the
/// polynomial of that resonance over (p q det A)².
#[derive(Clone, Debug)]
pub struct Forms {
    pub(super) p: Polynomial,
    q: Polynomial,
    /// D = Π (μ − a_k) over the active axes.
    product: Polynomial,
    /// The cusp polynomial of Lemma 4.5 of docs/mathematics.md.
    pub cusp: Polynomial,
    /// For the sign of c: the cusp polynomial times Π (μ − a_k) over the other axes.
    pub zero: Polynomial,
    /// For the sign of b.
    pub swing: Polynomial,
    /// For the signs of b² − 4c, 4b² − 25c and 9b² − 100c.
    pub resonances: [Polynomial; 3],
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
        let weight: [Polynomial; 3] = Axis::ALL.map(|k| {
            let others = product_of(&mut body.active.iter().copied().filter(|&m| m != k));
            if body.active.contains(&k) { others.squared().scaled(&body.rho[k]) } else { Polynomial::new(Vec::new()) }
        });
        let (p, q) = (moment(body, &weight, 0), moment(body, &weight, 1));
        let cusp = cusp(&p, &q, &product);
        let zero = passive.times(&cusp);
        let (swing, resonances) = swing_and_resonances(body, &line, &weight, &zero);
        Self { p, q, product, cusp, zero, swing, resonances }
    }

    /// q⁴ − 4x²p³D²: its roots are the multipliers of the equilibria at x (Proposition 4.8 of docs/algorithms.md).
    #[must_use]
    pub fn at_momentum(&self, x: &RBig) -> Polynomial {
        let (over, under) = (x.numerator(), IBig::from(x.denominator().clone()));
        let left = self.q.squared().squared().scaled(&(&under * &under));
        let right = self.p.squared().times(&self.p).times(&self.product.squared());
        left.minus(&right.scaled(&(IBig::from(4) * over * over)))
    }

    /// p′D − 2pD′ = P′D³: its roots are the multipliers at which the spin turns.
    #[must_use]
    pub fn fold(&self) -> Polynomial {
        slope(&self.p, &self.product)
    }

    /// p − s²D²: its roots are the multipliers of the steady rotations with Ω⁴ = s², since s² = P (Theorem 3.2 of
    /// docs/mathematics.md).
    #[must_use]
    pub fn at_spin(&self, fourth: &RBig) -> Polynomial {
        let (over, under) = (fourth.numerator(), IBig::from(fourth.denominator().clone()));
        self.p.scaled(&under).minus(&self.product.squared().scaled(over))
    }
}

/// Σ a_k^power g_k.
fn moment(body: &ExactBody, weight: &[Polynomial; 3], power: usize) -> Polynomial {
    let zero = Polynomial::new(Vec::new());
    (0..3).fold(zero, |sum, k| sum.plus(&weight[k].scaled(&body.a[k].pow(power))))
}

/// f′D − 2fD′, which is D³ times the derivative of f/D².
fn slope(f: &Polynomial, d: &Polynomial) -> Polynomial {
    f.derivative().times(d).minus(&f.times(&d.derivative()).scaled(&IBig::from(2)))
}

/// −½[4(q′D − 2qD′)p − 3(p′D − 2pD′)q], which is C D⁵.
fn cusp(p: &Polynomial, q: &Polynomial, d: &Polynomial) -> Polynomial {
    let twice = slope(p, d).times(q).scaled(&IBig::from(3)).minus(&slope(q, d).times(p).scaled(&IBig::from(4)));
    Polynomial::new(twice.coefficients().iter().map(|c| c / IBig::from(2)).collect())
}

/// The signs of b and of mb² − nc on a family with weights g_k, proportional to γ_k², and lines T_k = μ − a_k; `zero` is
/// C = Σ (g_i T_j T_k Q + 4 (a_j − a_k)² T_i g_j g_k). With Q = Σ a g and S = Σ a² g they are
/// B = (tr A Q − 2S)² + Σ a_j a_k ((T_j g_k + T_k g_j) Q + 4 (a_j − a_k)² g_j g_k) and mB² − n det A Q² C.
pub(super) fn swing_and_resonances(
    body: &ExactBody,
    line: &[Polynomial; 3],
    weight: &[Polynomial; 3],
    zero: &Polynomial,
) -> (Polynomial, [Polynomial; 3]) {
    let [a, b, c] = &body.a;
    let (q, second) = (moment(body, weight, 1), moment(body, weight, 2));
    let gyroscopic = q.scaled(&(a + b + c)).minus(&second.scaled(&IBig::from(2))).squared();
    let swing = (0..3).fold(gyroscopic, |sum, i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let gap = &body.a[j] - &body.a[k];
        let hanging = line[j].times(&weight[k]).plus(&line[k].times(&weight[j])).times(&q);
        let coupled = weight[j].times(&weight[k]).scaled(&(IBig::from(4) * &gap * &gap));
        sum.plus(&hanging.plus(&coupled).scaled(&(&body.a[j] * &body.a[k])))
    });
    let (square, product) = (swing.squared(), q.squared().times(zero).scaled(&(a * b * c)));
    let resonances = RESONANCES.map(|[m, n]| square.scaled(&IBig::from(m)).minus(&product.scaled(&IBig::from(n))));
    (swing, resonances)
}
