//! A body as integers: moments and squares of r in the frame's order, with the units in which they are whole.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use crate::stability::Constants;
use bifdiag_body::{Axis, Body, Frame};
use bifdiag_numbers::Number;
use bifdiag_numbers::enclosure::Arithmetic;
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
        }
    }

    /// x = l²/2 in the units of the integers.
    #[must_use]
    pub fn abscissa(&self, l: &Number) -> RBig {
        let l = l.value() / &self.momentum_unit;
        let units = RBig::from(&self.unit_a * &self.unit_r);
        &l * &l / RBig::from(2) * units
    }

    /// Ω² in the units of the integers.
    #[must_use]
    pub fn squared_spin(&self, omega: &RBig) -> RBig {
        // s' = (M/N) s.
        let omega = omega / &self.frequency_unit;
        &omega * &omega * RBig::from(self.unit_r.clone()) / RBig::from(self.unit_a.clone())
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
