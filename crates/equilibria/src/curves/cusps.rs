//! Cusps and the inflection of the generic family, isolated completely.

use super::curve::IntervalId;
use super::curve_point::Gap;
use super::families::{GenericState, Mu};
use bifdiag_body::{Axis, Frame};
use bifdiag_numbers::UNIT_ROUNDOFF;
use bifdiag_numbers::bernstein::{Cell, Form as FormOf, Isolation};
use bifdiag_numbers::root::itp;
use bifdiag_numbers::table::Id;
use nalgebra::DMatrix;

/// Of degree 10 at most: the cusp polynomial of three distinct moments.
type CuspForm = FormOf<11>;

/// Degree-10 products of rounded linear forms, summed: fewer than 64 roundings on any path.
const ROUNDINGS: f64 = 64.0;

/// An interval of μ between neighbouring moments that carry r.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MuInterval {
    /// The moment at the left end; `None`: −∞.
    pub left: Option<Axis>,
    /// The moment at the right end; `None`: ∞.
    pub right: Option<Axis>,
}

/// The cusps on one interval.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cusps {
    /// Simple cusps by rising μ.
    pub at: Vec<Mu>,
    /// Places where rounding leaves the number of cusps open (they appear and vanish in pairs).
    pub clusters: Vec<Mu>,
}

impl MuInterval {
    /// The side of the interval on which the cell lies, as (base, sign of δ, [|δ|]).
    fn side(&self, frame: &Frame, cell: &Cell, from_left: bool) -> (Axis, f64, [f64; 2]) {
        match (self.left, self.right) {
            (Some(left), Some(right)) => {
                let width = frame.diff[right][left];
                if from_left {
                    (left, 1.0, [width * cell.u[0], width * cell.u[1]])
                } else {
                    (right, -1.0, [width * cell.v[0], width * cell.v[1]])
                }
            }
            (None, Some(right)) => {
                let scale = outer_scale(frame, right);
                (right, -1.0, [scale * cell.v[0] / cell.u[0], scale * cell.v[1] / cell.u[1]])
            }
            _ => unreachable!("the interval that ends at +∞ has no cusps"),
        }
    }

    /// The simple root of `value` in an isolating cell, to full precision in δ.
    pub(crate) fn polish(&self, frame: &Frame, isolation: &Isolation, value: impl Fn(Mu) -> f64) -> Mu {
        let mut cell = isolation.cell;
        let mut from_left = self.left.is_some();
        if let (Some(left), Some(right)) = (self.left, self.right) {
            if cell.u[0] >= 0.5 {
                from_left = false;
            } else if cell.v[1] < 0.5 {
                let middle = Mu { base: left, delta: 0.5 * frame.diff[right][left] };
                from_left = (value(middle) > 0.0) == isolation.rising;
                if from_left {
                    (cell.u[1], cell.v[1]) = (0.5, 0.5);
                } else {
                    (cell.u[0], cell.v[0]) = (0.5, 0.5);
                }
            }
        }
        let (base, sign, distance) = self.side(frame, &cell, from_left);
        let at = bracket_by_ratio(distance, |y| (value(Mu { base, delta: sign * y }) > 0.0) == isolation.rising);
        let f = |y: f64| value(Mu { base, delta: sign * y });
        let [a, b] = at;
        let (fa, fb) = (f(a), f(b));
        let y = if (fa > 0.0) == (fb > 0.0) {
            // Both ends are rounding-close to the root.
            if fa.abs() < fb.abs() { a } else { b }
        } else {
            itp(a, b, fa, fb, 0.0, f)
        };
        Mu { base, delta: sign * y }
    }

    /// The interval between active moments with this number, from μ = −∞.
    pub(crate) fn numbered(active: &[Axis], n: usize) -> Self {
        Self { left: n.checked_sub(1).map(|left| active[left]), right: active.get(n).copied() }
    }

    /// The differences μ − a_k up to a common factor, and that factor, each linear: at u = 0 and at u = 1. Not on the
    /// interval that ends at +∞.
    pub(crate) fn lines(&self, frame: &Frame) -> ([[f64; 2]; 3], [f64; 2]) {
        match (self.left, self.right) {
            (Some(left), Some(right)) => ([0, 1, 2].map(|k| [frame.diff[left][k], frame.diff[right][k]]), [1.0, 1.0]),
            (_, right) => {
                let first = right.unwrap_or(Axis::ALL[0]);
                let scale = outer_scale(frame, first);
                (std::array::from_fn(|k| [-scale, -frame.diff[k][first]]), [0.0, 1.0])
            }
        }
    }

    /// Sign of μ − a_k inside the interval.
    fn sign(&self, k: Axis) -> f64 {
        if self.right.is_some_and(|right| k >= right) { -1.0 } else { 1.0 }
    }
}

/// The unit of |δ| left of all moments.
fn outer_scale(frame: &Frame, first: Axis) -> f64 {
    (0..3).filter(|&k| frame.r[k] > 0.0).map(|k| frame.diff[k][first]).fold(0.0, f64::max)
}

/// The cusp polynomial (T J + 4V) P² Π|μ−a_k|⁵ of Lemma 4.5 on an interval, as a form in u and 1 − u.
///
/// P²TJ = Σ_i a_i r_i⁴/τ_i⁵ + Σ_{i<j} r_i² r_j² (a_j τ_j + a_i τ_i)/(τ_i³ τ_j³) and
/// P²V = Σ_{i<j} r_i² r_j² (a_i − a_j)²/(τ_i³ τ_j³) with τ = μ − a; every |τ| is linear in u and of one sign, so that
/// each summand is a product of non-negative forms.
fn cusp_form(frame: &Frame, interval: &MuInterval, active: &[Axis]) -> CuspForm {
    let (lines, [at_zero, at_one]) = interval.lines(frame);
    let unit = CuspForm::linear(at_zero, at_one);
    let lines: Vec<CuspForm> = active.iter().map(|&k| CuspForm::linear(lines[k][0].abs(), lines[k][1].abs())).collect();
    let squares: Vec<CuspForm> = lines.iter().map(|line| line.times(line)).collect();
    let fifths: Vec<CuspForm> =
        squares.iter().zip(&lines).map(|(square, line)| square.times(square).times(line)).collect();
    let n = active.len();
    let others = |skip: &[usize]| {
        (0..n).filter(|m| !skip.contains(m)).fold(None, |product: Option<CuspForm>, m| {
            Some(product.map_or(fifths[m], |product| product.times(&fifths[m])))
        })
    };
    let with_others = |form: CuspForm, skip: &[usize]| others(skip).map_or(form, |rest| rest.times(&form));
    let weight = |m: usize| frame.r[active[m]] * frame.r[active[m]];
    let sign = |m: usize| interval.sign(active[m]);
    let moment = |m: usize| frame.a[active[m]];

    let mut sum = CuspForm::zero(5 * (n - 1));
    for i in 0..n {
        if let Some(rest) = others(&[i]) {
            sum.add_scaled(sign(i) * moment(i) * weight(i) * weight(i), &rest);
        }
        for j in i + 1..n {
            let product = squares[i].times(&squares[j]);
            let d = frame.diff[active[i]][active[j]];
            let mut line = CuspForm::zero(1);
            line.add_scaled(sign(i) * moment(i), &lines[i]);
            line.add_scaled(sign(j) * moment(j), &lines[j]);
            line.add_scaled(4.0 * d * d, &unit);
            let factor = weight(i) * weight(j) * sign(i) * sign(j);
            sum.add_scaled(factor, &with_others(product.times(&line), &[i, j]));
        }
    }
    sum
}

/// All cusps of the generic family on an interval, by Descartes' rule and subdivision, then polished on T J + 4V.
///
/// On the interval that ends at +∞ both T and V are positive: no cusps (Proposition 4.6). With one active moment the
/// family is a straight line: no cusps.
#[must_use]
pub fn cusps(frame: &Frame, interval: &MuInterval, active: &[Axis]) -> Cusps {
    let mut found = Cusps::default();
    if interval.right.is_none() || active.len() < 2 {
        return found;
    }
    let mut isolations = cusp_form(frame, interval, active).isolate_roots(ROUNDINGS);
    isolations.sort_by(|a, b| a.cell.u[0].total_cmp(&b.cell.u[0]));
    // On the outer interval u = 0 is μ = −∞ and u = 1 is the moment, so u rises with μ on every interval.
    for isolation in isolations {
        if isolation.cluster.is_none() {
            found.at.push(interval.polish(frame, &isolation, |mu| GenericState::at(frame, mu).cusp_function()));
        } else {
            let from_left = interval.left.is_some() && isolation.cell.u[0] < 0.5;
            let (base, sign, distance) = interval.side(frame, &isolation.cell, from_left);
            let at = if distance[0].is_finite() { 0.5 * (distance[0] + distance[1]) } else { 2.0 * distance[1] };
            found.clusters.push(Mu { base, delta: sign * at });
        }
    }
    found
}

/// Two roots of the cusp polynomial, real or a complex pair, in the coordinate ln t, t = u/(1 − u).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CuspPair {
    /// The middle of the two.
    pub middle: f64,
    /// The square of half their difference: negative for a complex pair, which is no cusp, and 0 at a swallowtail, through
    /// which it passes with a slope.
    pub square: Gap,
}

/// The pairs of neighbouring cusps on an interval, and those that may be born: complex pairs of roots on the right of the
/// complex plane.
#[must_use]
pub fn cusp_pairs(frame: &Frame, interval: IntervalId) -> Vec<CuspPair> {
    /// Error of the square where it is near to 0.
    const ERROR: f64 = 1e-13;
    let active = frame.active();
    // The last interval has no cusp, and a body of which fewer moments carry r has fewer intervals.
    if active.len() < 2 || interval.index() >= active.len() {
        return Vec::new();
    }
    let interval = MuInterval::numbered(&active, interval.index());
    let form = cusp_form(frame, &interval, &active);
    let coefficients = form.coefficients();
    let degree = coefficients.len() - 1;
    let (first, last) = (coefficients[0], coefficients[degree]);
    // So that the product of the roots has the size 1.
    let scale = libm::exp(libm::log((first / last).abs()) / degree as f64);
    if !(scale > 0.0 && scale.is_finite()) {
        return Vec::new();
    }
    let mut factor = 1.0;
    let mut scaled: Vec<f64> = Vec::with_capacity(degree);
    for coefficient in coefficients {
        scaled.push(coefficient * factor);
        factor *= scale;
    }
    let leading = scaled[degree];
    let companion = DMatrix::from_fn(degree, degree, |i, j| match (i, j) {
        (0, j) => -scaled[degree - 1 - j] / leading,
        (i, j) => f64::from(u8::from(i == j + 1)),
    });
    let roots = companion.complex_eigenvalues();
    let mut real: Vec<f64> = roots.iter().filter(|t| t.im == 0.0 && t.re > 0.0).map(|t| libm::log(t.re)).collect();
    real.sort_by(f64::total_cmp);
    let unborn = roots.iter().filter(|t| t.im > 0.0 && t.re > 0.0);
    let unborn = unborn.map(|t| (0.5 * libm::log(t.re * t.re + t.im * t.im), libm::atan2(t.im, t.re)));
    let pairs = real.windows(2).map(|pair| (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]), 1.0));
    pairs
        .chain(unborn.map(|(middle, half)| (middle, half, -1.0)))
        .map(|(middle, half, sign)| {
            let square = Gap { value: sign * half * half, error: ERROR };
            CuspPair { middle: middle + libm::log(scale), square }
        })
        .collect()
}

/// How near a cusp of the generic family is to the pitchfork of the pair over a moment a_i without r: T J + 4V at μ = a_i, as a
/// part of what its terms add up to without their signs. It is 0 where they meet.
#[must_use]
pub fn cusp_at_pitchfork(frame: &Frame, axis: Axis) -> Gap {
    let GenericState { gamma, j, mean_inverse, spread, .. } = GenericState::at(frame, Mu { base: axis, delta: 0.0 });
    let term = |k: Axis| if frame.r[k] > 0.0 { gamma[k] * gamma[k] / frame.diff[axis][k].abs() } else { 0.0 };
    let size = j * Axis::ALL.map(term).iter().sum::<f64>() + 4.0 * spread.abs();
    Gap { value: (mean_inverse * j + 4.0 * spread) / size, error: ROUNDINGS * UNIT_ROUNDOFF }
}

/// Narrows [first, second] (one may be 0, one ∞) to a ratio of at most 4; `beyond(y)` says whether the root lies
/// between `first` and y.
fn bracket_by_ratio(ends: [f64; 2], beyond: impl Fn(f64) -> bool) -> [f64; 2] {
    const RATIO: f64 = 4.0;
    let [mut first, mut second] = ends;
    for _ in 0..2200 {
        let (small, large) = (first.min(second), first.max(second));
        if small > 0.0 && large <= RATIO * small {
            break;
        }
        let middle = if large.is_infinite() {
            if small == 0.0 { 1.0 } else { small * 64.0 }
        } else if small == 0.0 {
            large / 64.0
        } else {
            small.sqrt() * large.sqrt()
        };
        if beyond(middle) {
            second = middle;
        } else {
            first = middle;
        }
    }
    [first, second]
}

/// The only place where J is extremal along the generic family: the root of Σ_k c_k (μ − a_k)³ = 0 with
/// c_k = r_i² r_j² (a_i − a_j)² (Proposition 3.8 of docs/algorithms.md; increasing in μ, so the root is unique). Needs
/// three active moments.
///
/// Returns the interval (1 or 2 of the four) and μ; `None` when the root falls on the middle moment.
#[must_use]
pub fn inflection(frame: &Frame) -> Option<(usize, Mu)> {
    let [first, middle, last] = Axis::ALL;
    let [r1, r2, r3] = frame.r.map(|x| x * x);
    let d = &frame.diff;
    let c = [r2 * r3 * d[2][1] * d[2][1], r1 * r3 * d[2][0] * d[2][0], r1 * r2 * d[1][0] * d[1][0]];
    let f = |mu: Mu| {
        let term = |k: Axis| {
            let tau = mu.minus_moment(frame, k);
            c[k] * tau * tau * tau
        };
        term(first) + term(middle) + term(last)
    };
    // At the middle moment the sum has the sign of r3²(a2 − a1) − r1²(a3 − a2).
    let at_middle = r3 * d[1][0] - r1 * d[2][1];
    if at_middle == 0.0 {
        return None;
    }
    let (interval, left, right) = if at_middle > 0.0 { (1, first, middle) } else { (2, middle, last) };
    let half = 0.5 * d[right][left];
    let (base, sign) = if f(Mu { base: left, delta: half }) > 0.0 { (left, 1.0) } else { (right, -1.0) };
    let g = |y: f64| f(Mu { base, delta: sign * y });
    // f rises with μ: towards the base on the left f < 0, towards the base on the right f > 0.
    let [a, b] = bracket_by_ratio([0.0, half], |y| (g(y) > 0.0) == (sign > 0.0));
    let (fa, fb) = (g(a), g(b));
    if (fa > 0.0) == (fb > 0.0) || a < 1e-290 {
        return None;
    }
    Some((interval, Mu { base, delta: sign * itp(a, b, fa, fb, 0.0, g) }))
}
