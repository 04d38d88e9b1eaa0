//! An exact body in units in which it is whole, and the polynomials of its generic family in μ (Proposition 13.4 of
//! docs/algorithms.md).

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::invariants::Invariants;
use crate::stability::Constants;
use bifdiag_body::{Axis, Body, Frame};
use bifdiag_numbers::Number;
use bifdiag_numbers::enclosure::Arithmetic;
use bifdiag_numbers::polynomial::Polynomial;
use bifdiag_numbers::polynomial::rational::over_one_denominator;
use bifdiag_numbers::symmetric::Symmetric;

/// A body in the frame's order of axes, exact: where its principal form is rounded, what decides is that of its tensor.
#[derive(Clone, Debug)]
pub struct ExactBody {
    /// Moments times `unit_a`, ascending; rounded ones serve as places from which μ is measured.
    pub a: [RBig; 3],
    /// Number of the eigenspace of each axis.
    pub group: [usize; 3],
    /// The axes that carry r.
    pub active: Vec<Axis>,
    /// The axes, one for each eigenspace, on which r vanishes.
    pub passive: Vec<Axis>,
    /// Of the tensor and r times `unit_a` and `unit_r`.
    pub invariants: Invariants,
    unit_a: UBig,
    unit_r: UBig,
    moments: [RBig; 3],
    squares: [RBig; 3],
    momentum_unit: RBig,
    frequency_unit: RBig,
}

/// Sums over the axes that carry r at a moment a_i across it, and the product of a_i − a_k over all other axes.
pub struct Over {
    /// R̂ = Σ r_k²/(a_i − a_k).
    pub r_sum: RBig,
    /// P̂ = Σ r_k²/(a_i − a_k)².
    pub p_sum: RBig,
    /// Σ a_kⁿ r_k²/(a_i − a_k)² for n = 1, 2, 3.
    pub moments: [RBig; 3],
    /// Π (a_i − a_k).
    pub rest: RBig,
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
        let (matrix, center) = match body.tensor() {
            Some(tensor) => {
                (tensor.matrix().map(|_, _, x| x / &a_unit), tensor.center().each_ref().map(|r| r / &energy))
            }
            None => (Symmetric::diagonal(given), center),
        };
        let unit_a = over_one_denominator(matrix.rows().as_flattened()).1;
        let unit_r = over_one_denominator(&center).1;
        let (n, m) = (RBig::from(unit_a.clone()), RBig::from(unit_r.clone()));
        Self {
            a: moments.each_ref().map(|a| a * &n),
            group: frame.group,
            active: frame.active(),
            passive: frame.passive(),
            invariants: Invariants::new(&matrix.map(|_, _, x| x * &n), &center.map(|r| r * &m)),
            unit_a,
            unit_r,
            moments,
            squares,
            frequency_unit: energy / &momentum,
            momentum_unit: momentum,
        }
    }

    /// The sums at a passive moment: where it is rational, from the tensor.
    #[must_use]
    pub fn over(&self, axis: Axis) -> Over {
        let (a, known) = (&self.a[axis], &self.invariants);
        let m = RBig::from(self.unit_r.clone());
        let squared = RBig::from(known.squared.clone());
        let along = RBig::from(known.along.clone());
        let (r_sum, p_sum, rest) = if known.has_moment(a) {
            let d = known.active.at(a);
            let rest = known.characteristic.derivative().at(a);
            (known.numerator.at(a) / &d, known.weight.at(a) / (&d * &d), rest)
        } else {
            let gap = |k: Axis| a - &self.a[k];
            let term = |&k: &Axis| &self.squares[k.index()] * &m * &m / gap(k);
            let sum = |of: &dyn Fn(&Axis) -> RBig| self.active.iter().map(of).fold(RBig::ZERO, |sum, x| sum + x);
            let [j, k] = axis.others().map(gap);
            // An irrational moment is across a rational one that carries r. Where this is the mean of all, its distance has a
            // rational square.
            let (r_sum, p_sum) = match self.active[..] {
                [one] if known.has_mean(&self.a[one]) => {
                    let p_sum = &squared / -known.passive.at(&self.a[one]);
                    (gap(one) * &p_sum, p_sum)
                }
                _ => (sum(&term), sum(&|k| term(k) / gap(*k))),
            };
            (r_sum, p_sum, j * k)
        };
        let first = a * &p_sum - &r_sum;
        let second = a * (&first - &r_sum) + &squared;
        let third = a * a * (&first - RBig::from(2) * &r_sum) + RBig::from(2) * a * &squared + along;
        Over { r_sum, p_sum, moments: [first, second, third], rest }
    }

    /// D, p, q and N = R D in the frame's units, coefficients by rising power of μ.
    #[must_use]
    pub fn family_in_frame(&self) -> [Vec<RBig>; 4] {
        let known = &self.invariants;
        let (n, m) = (RBig::from(self.unit_a.clone()), RBig::from(self.unit_r.clone()));
        // In whole units μ is n μ, and D, p, q and N are m² nᵏ times themselves, D without m².
        let scaled = |polynomial: &Polynomial, power: usize, unit: &RBig| {
            let coefficients = polynomial.coefficients().iter().enumerate();
            let factor = |k: usize| n.pow(k.cast_signed() - power.cast_signed()) / unit;
            coefficients.map(|(k, c)| RBig::from(c.clone()) * factor(k)).collect::<Vec<RBig>>()
        };
        let (degree, unit) = (known.active.degree(), &m * &m);
        let [q, ..] = known.moments();
        let squared = 2 * degree.saturating_sub(1);
        [
            scaled(&known.active, degree, &RBig::ONE),
            scaled(&known.weight, squared, &unit),
            scaled(&q, squared + 1, &unit),
            scaled(&known.numerator, degree.saturating_sub(1), &unit),
        ]
    }

    /// R̂ and P̂ over a passive moment in the frame's units.
    #[must_use]
    pub fn sums_in_frame(&self, axis: Axis) -> (RBig, RBig) {
        let Over { r_sum, p_sum, .. } = self.over(axis);
        let (n, m) = (RBig::from(self.unit_a.clone()), RBig::from(self.unit_r.clone()));
        let unit = &n / (&m * &m);
        (r_sum * &unit, p_sum * unit * n)
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
        fourth / unit.sqr() * ratio.sqr()
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
        let Over { r_sum, p_sum, .. } = self.over(i);
        (&self.a[i] * p_sum + RBig::from(3) * r_sum).is_zero()
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
        let known = &body.invariants;
        let p = known.weight.clone();
        let moments = known.moments();
        let product = known.active.clone();
        let cusp = cusp(&p, &moments[0], &product);
        let zero = known.passive.times(&cusp);
        let mu = [Polynomial::linear(&IBig::ZERO), Polynomial::constant(IBig::ONE)];
        let (swing, resonances) = known.swing_and_resonances(&mu, &moments, (&zero, &IBig::ONE));
        let [q, ..] = moments;
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

/// f′D − 2fD′, which is D³ times the derivative of f/D².
fn slope(f: &Polynomial, d: &Polynomial) -> Polynomial {
    f.derivative().times(d).minus(&f.times(&d.derivative()).scaled(&IBig::from(2)))
}

/// −½[4(q′D − 2qD′)p − 3(p′D − 2pD′)q], which is C D⁵.
fn cusp(p: &Polynomial, q: &Polynomial, d: &Polynomial) -> Polynomial {
    let twice = slope(p, d).times(q).scaled(&IBig::from(3)).minus(&slope(q, d).times(p).scaled(&IBig::from(4)));
    Polynomial::new(twice.coefficients().iter().map(|c| c / IBig::from(2)).collect())
}
