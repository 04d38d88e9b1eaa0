//! One step: the Taylor polynomial from the middle of a set, and what is proved of the motions from all of it.
//!
//! **Theorem.** Let f(x) = Bx + Q(x, x) with ‖Q(u, v)‖ ≤ κ‖u‖‖v‖, p a polynomial, d = ṗ − f(p), ‖d‖ ≤ δ on [0, h], and
//! L ≥ 0 a bound of the logarithmic norm of Df(p(t)) there (the largest eigenvalue of its symmetric part). Let x(t) solve
//! ẋ = f(x), e = x − p, e(0) = e₀, and let V solve V̇ = Df(p)V, V(0) = 1.
//!
//! 1. If (‖e₀‖ + hδ) exp((L + κε)h) < ε, then x exists on [0, h] and ‖e‖ < ε there.
//! 2. Then ‖e(t) − V(t)e₀‖ ≤ t e^{Lt} (κε² + δ).
//! 3. If W(0) = 1 and ‖Ẇ − Df(p)W‖ ≤ η, then ‖V(t) − W(t)‖ ≤ t e^{Lt} η.
//! 4. The derivative U of the flow along x satisfies ‖U(t) − V(t)‖ ≤ 2κε t exp((2L + 2κε)t).
//!
//! *Proof.* f is quadratic, hence ė = Df(p)e + Q(e, e) − d exactly, and the right derivative of ‖e‖ is at most
//! L‖e‖ + κ‖e‖² + δ. While ‖e‖ ≤ ε, Gronwall's lemma gives ‖e(t)‖ ≤ (‖e₀‖ + tδ) exp((L + κε)t) < ε: so ‖e‖ never
//! reaches ε, and a bounded solution continues to exist. Variation of constants with ‖V(t)V(s)⁻¹‖ ≤ e^{L(t−s)} gives 2
//! and 3, and 4 since U̇ = (Df(p) + 2Q(e, ·))U. ∎
//!
//! The polynomials p and W may come from anywhere: here they are Taylor polynomials whose coefficients are rounded, and
//! those roundings are part of the defects. No set is ever put into the recurrences, so that orders of some hundred are
//! as good as on paper.

use dashu_ratio::RBig;

use crate::bound::{exp, frobenius, norm, spectral, up};
use crate::field::{QuadraticField, Series};
use crate::scalar::Scalar;
use crate::set::{FlowSet, Matrix, Shape};

/// Terms of the polynomial of the variation. What it multiplies in a set of motions is small, and a few digits would do; the
/// derivative of a return is a product of those of all steps, where expansion and contraction multiply what is missing.
const VARIATION_ORDER: usize = 20;

/// Coefficients whose roundings are bounded term by term.
const FIRST: usize = 6;

/// Roundoff of doubles.
const UNIT: f64 = f64::EPSILON / 2.0;

/// The order of a series for a precision: about 1 − ln(unit)/2, which does the least work (Jorba and Zou).
#[must_use]
pub fn order_for(unit: f64) -> usize {
    // −ln 2 · log₂ unit, at most 700.
    let bits = f64::from(-libm::ilogb(unit)).clamp(20.0, 1000.0);
    let mut order = 8_usize;
    while (order as f64) < 1.0 + 0.5 * std::f64::consts::LN_2 * bits {
        order += 2;
    }
    order
}

/// A step, and the motions of a whole set in it.
#[derive(Clone, Debug)]
pub struct Step<'a, S: Scalar, const N: usize> {
    field: &'a QuadraticField<S, N>,
    start: FlowSet<S, N>,
    /// p.
    series: Series<S, N>,
    /// Of W.
    variation: Vec<Matrix<N>>,
    length: f64,
    /// Bounds of ‖p(t)‖, ‖d‖ and ε.
    size: f64,
    defect: f64,
    deviation: f64,
    /// ‖e(t) − W(t)e₀‖ with the roundings of p(t), and ‖U(t) − W(t)‖, for all t of the step.
    rest: f64,
    derivative_rest: f64,
}

/// A state: a point, and bounds of how far the motions of the set are from it in each coordinate.
#[derive(Clone, Debug)]
pub struct Enclosed<S, const N: usize> {
    /// The point.
    pub middle: [S; N],
    /// The bounds.
    pub radii: [f64; N],
}

/// Norms of coefficients and their Cauchy products.
struct Norms {
    x: Vec<f64>,
    w: Vec<f64>,
    /// Σ ‖x_j‖ ‖x_{k−j}‖ and Σ ‖x_j‖ ‖W_{k−j}‖.
    xx: Vec<f64>,
    xw: Vec<f64>,
    /// Bounds of the roundings in the first coefficients, where they count.
    first: Vec<f64>,
    /// The last coefficient in the full precision.
    exact: usize,
}

fn cauchy(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (sum, y) in product[i..].iter_mut().zip(b) {
            *sum += x * y;
        }
    }
    product
}

/// Σ_k c_k hᵏ over a range of powers.
fn powers(h: f64, terms: impl Iterator<Item = f64>) -> f64 {
    let mut power = 1.0;
    let sum: f64 = terms
        .map(|c| {
            let term = c * power;
            power *= h;
            term
        })
        .sum();
    up(sum)
}

impl<'a, S: Scalar, const N: usize> Step<'a, S, N> {
    /// The longest step from a set whose defect is about a rounding, at most `longest`; `None` where nothing can be proved: the
    /// set is too wide, or a number left the range of doubles.
    #[must_use]
    pub fn new(field: &'a QuadraticField<S, N>, start: FlowSet<S, N>, longest: f64) -> Option<Self> {
        let order = order_for(field.accuracy);
        // With steps of e⁻² of the radius of convergence the k-th term is about e⁻²ᵏ: beyond this one doubles suffice.
        let spare = usize::try_from(libm::ilogb(UNIT) - libm::ilogb(field.accuracy)).unwrap_or(0);
        let exact = if S::unit(field.precision) < UNIT { (35 * spare / 100 + 4).min(order) } else { 0 };
        let series = field.series(&start.middle, exact, order);
        let doubles = &series.doubles;
        let variation = field.variation(doubles, VARIATION_ORDER);
        let x: Vec<f64> = (0..=order).map(|k| norm(&doubles.each_ref().map(|row| row[k]))).collect();
        let first = field.roundings(doubles, FIRST);
        let w: Vec<f64> = variation.iter().map(frobenius).collect();
        let norms = Norms { xx: cauchy(&x, &x), xw: cauchy(&x, &w), x, w, first, exact };
        if !norms.xx.iter().chain(&norms.xw).all(|x| x.is_finite()) {
            return None;
        }
        let steepness = steepness(&field.jacobian(&doubles.each_ref().map(|row| row[0])));
        let steepness = up(steepness + 64.0 * UNIT * (field.lambda + 2.0 * field.kappa_terms * norms.x[0]));
        let mut step = Self {
            field,
            start,
            series,
            variation,
            length: 0.0,
            size: 0.0,
            defect: 0.0,
            deviation: 0.0,
            rest: 0.0,
            derivative_rest: 0.0,
        };
        let mut length = radius(&norms.x).min(longest);
        for _ in 0..80 {
            // Few bits, so that sums of steps are exact and short.
            step.length = f64::from_bits(length.to_bits() & !((1 << 36) - 1));
            if step.is_proved(&norms, steepness) {
                return Some(step);
            }
            length *= 0.85;
        }
        None
    }

    /// Bounds for the present length; false if they do not exist or the truncation is larger than the roundings.
    fn is_proved(&mut self, norms: &Norms, steepness: f64) -> bool {
        let (field, h) = (self.field, self.length);
        let order = norms.x.len() - 1;
        let tail = powers(h, std::iter::once(0.0).chain(norms.x[1..].iter().copied()));
        let steepness = up(steepness + field.sigma * tail);
        if steepness * h > 3.0 {
            return false;
        }
        let growth = exp(steepness * h);
        let truncation = up(power(h, order)
            * (field.lambda * norms.x[order] + field.kappa * powers(h, norms.xx[order..].iter().copied())));
        if truncation > 4.0 * field.accuracy * norms.x[0] {
            return false;
        }
        let unit = S::unit(field.precision);
        // Beyond the exact coefficients the rounding of the first ones to doubles counts, too.
        let unit_at = |k: usize| if k < norms.exact { unit } else { UNIT };
        let rounded = |k: usize| {
            let terms = match norms.first.get(k) {
                Some(first) => *first,
                None => (k as f64 + field.depth) * (field.kappa_terms * norms.xx[k] + field.lambda * norms.x[k]),
            };
            unit_at(k) * terms
        };
        let defect = up(truncation + powers(h, (0..order).map(rounded)));
        let size = self.start.size();
        let guess = up(1.2 * (size + h * defect) * growth);
        // ‖e‖ < ε with the guess for ε, and therefore this bound, which is nearly always smaller.
        let deviation = up((size + h * defect) * exp((steepness + field.kappa * guess) * h));
        if deviation >= guess {
            return false;
        }
        let last = norms.w.len() - 1;
        let rounded = |k: usize| {
            let terms = 2.0 * field.kappa_terms * norms.xw[k] + field.lambda * norms.w[k];
            // All summands of a row are added one after the other.
            ((k as f64 + 1.0) * field.width + 12.0) * UNIT * terms
        };
        let variation_defect = up(powers(h, (0..last).map(rounded))
            + power(h, last)
                * (field.lambda * norms.w[last] + 2.0 * field.kappa * powers(h, norms.xw[last..].iter().copied())));
        // Of Horner's rule and of the time itself; a coefficient beyond the exact ones passes through both arithmetics.
        let evaluated = |unit_at: &dyn Fn(usize) -> f64, norms: &[f64]| {
            powers(h, norms.iter().enumerate().map(|(k, norm)| (3.0 * k as f64 + 3.0) * unit_at(k) * norm))
        };
        let variation_error = up(h * growth * variation_defect + evaluated(&|_| UNIT, &norms.w));
        (self.size, self.defect, self.deviation) = (up(norms.x[0] + tail), defect, deviation);
        self.rest = up(variation_error * size
            + h * growth * (field.kappa * deviation * deviation + defect)
            + evaluated(&|k| if k <= norms.exact { unit } else { 2.0 * UNIT }, &norms.x));
        let spread = up(2.0 * field.kappa * deviation * h);
        self.derivative_rest = up(variation_error + spread * growth * growth * exp(spread));
        self.rest.is_finite() && self.derivative_rest.is_finite()
    }

    /// Its length in time, a double of few bits.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Where it starts.
    #[must_use]
    pub fn start(&self) -> &FlowSet<S, N> {
        &self.start
    }

    /// A bound of ‖x(t) − p(t)‖ in the step.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.deviation
    }

    /// p(t), rounded, and W(t); t from 0 to the length.
    fn polynomials(&self, time: &RBig) -> ([S; N], Matrix<N>) {
        let precision = self.field.precision;
        let at = S::rational(time, precision);
        let time = at.to_double();
        let middle = std::array::from_fn(|i| {
            let (first, all) = (&self.series.exact[i], &self.series.doubles[i]);
            let beyond = all[first.len()..].iter().rev().fold(0.0, |sum, c| sum * time + c);
            first.iter().rev().fold(S::double(beyond, precision), |sum, c| sum.times(&at, precision).plus(c, precision))
        });
        let at = time;
        let map = self.variation.iter().rev().fold([[0.0; N]; N], |mut sum, c| {
            for (sum, c) in sum.as_flattened_mut().iter_mut().zip(c.as_flattened()) {
                *sum = *sum * at + c;
            }
            sum
        });
        (middle, map)
    }

    /// A bound of ‖p(t)‖ in the step.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// A bound of ‖ṗ − f(p)‖ in the step.
    #[must_use]
    pub fn defect(&self) -> f64 {
        self.defect
    }

    /// A bound of ‖e(t) − W(t)e₀‖ in the step, with the roundings of p(t).
    #[must_use]
    pub fn rest(&self) -> f64 {
        self.rest
    }

    /// The coefficients of p, rounded, by rows.
    #[must_use]
    pub fn coefficients(&self) -> &[Vec<f64>; N] {
        &self.series.doubles
    }

    /// The image of the start's shape under W(t), and a bound of what the motions of the set are beside it, with all roundings.
    #[must_use]
    pub fn image(&self, time: &RBig) -> (Shape<N>, f64) {
        self.imaged(&self.polynomials(time).1)
    }

    fn imaged(&self, map: &Matrix<N>) -> (Shape<N>, f64) {
        let (shape, rounding) = self.start.shape.image(map);
        (shape, up(rounding + self.rest))
    }

    /// The motions of the set at a time from the start of the step, which is not beyond its end.
    #[must_use]
    pub fn at(&self, time: &RBig) -> Enclosed<S, N> {
        let (middle, map) = self.polynomials(time);
        let (shape, rest) = self.imaged(&map);
        Enclosed { middle, radii: shape.component_radii().map(|radius| up(radius + rest)) }
    }

    /// W and p at the end, as they are computed.
    #[must_use]
    pub fn plain_end(&self) -> (Matrix<N>, [S; N]) {
        let (middle, map) = self.polynomials(&RBig::try_from(self.length).unwrap_or(RBig::ZERO));
        (map, middle)
    }

    /// The set at the end; `None` when a number left the range of doubles.
    #[must_use]
    pub fn end(&self) -> Option<FlowSet<S, N>> {
        let (middle, map) = self.polynomials(&RBig::try_from(self.length).ok()?);
        self.start.mapped(&map, self.rest, middle)
    }

    /// The derivative of the flow along every motion of the set, at a time from the start of the step: a matrix and a bound of
    /// the distance from it.
    #[must_use]
    pub fn derivative(&self, time: &RBig) -> (Matrix<N>, f64) {
        (self.polynomials(time).1, self.derivative_rest)
    }
}

/// A bound of the largest eigenvalue of the symmetric part, not below 0.
fn steepness<const N: usize>(matrix: &Matrix<N>) -> f64 {
    let symmetric: Matrix<N> = std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (matrix[i][j] + matrix[j][i])));
    spectral(&symmetric)
}

/// hᵏ, not below it.
fn power(h: f64, k: usize) -> f64 {
    up((0..k).fold(1.0, |power, _| power * h))
}

/// About e⁻² of the radius of convergence, as the last two coefficients show it.
fn radius(norms: &[f64]) -> f64 {
    let order = norms.len() - 1;
    let estimate = |k: usize| {
        let ratio = norms[k].max(1e-280) / norms[0].max(1e-280);
        libm::exp(-2.0 - libm::log(ratio) / k as f64)
    };
    estimate(order).min(estimate(order - 1)).min(1e6)
}
