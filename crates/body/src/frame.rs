//! The body in the frame in which everything is computed: sorted, rotated and scaled.

use dashu_base::Sign;
use dashu_int::{IBig, UBig};
use dashu_ratio::Relaxed;

use super::axis::Axis;
use super::rigid_body::Body;
use bifdiag_numbers::Number;
use bifdiag_numbers::vector::{direction, dot};

/// A body with principal moments in ascending order and r in the closed positive octant.
///
/// - `a[0] ≤ a[1] ≤ a[2]`, `r[k] ≥ 0`; axes are permuted and reflected to get there.
/// - Equal moments share a [`group`](Self::group); r is turned inside the group's eigenspace so that
///   only its first axis carries a component.
/// - Units are powers of four, so that `a[2]` and `|r|` lie in [1, 4) and scaling is free of error:
///   with A = 4^m a and r = 4^k ρ one has l = 2^(m+k) l' and h = 4^k h'.
/// - Every field is the correctly rounded value of its exact rational (square roots: twice rounded);
///   in particular the differences `diff` and `offset` carry no cancellation error.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Principal moments, ascending.
    pub a: [f64; 3],
    /// Centre of mass, componentwise ≥ 0; exactly 0 where the given one is.
    pub r: [f64; 3],
    /// `diff[i][j]` = a_i − a_j.
    pub diff: [[f64; 3]; 3],
    /// Number of the eigenspace of axis k, ascending from 0.
    pub group: [usize; 3],
    /// |r|.
    pub r_norm: f64,
    /// J_r = ⟨r̂, A r̂⟩ (NaN when r = 0).
    pub j_r: f64,
    /// a_k − J_r (NaN when r = 0).
    pub offset: [f64; 3],
    /// Where r vanishes on the eigenspace of a_i: R̂ = Σ r_j²/(a_i − a_j) and the excess −3R̂ − a_i P̂ with
    /// P̂ = Σ r_j²/(a_i − a_j)² (positive: the pair over a_i has a cusp beyond its pitchfork). 0 elsewhere.
    pub symmetric_sums: [SymmetricSums; 3],
    /// Columns are the frame's axes in the body's coordinates: γ_body = `to_body` · γ_frame.
    pub to_body: [[f64; 3]; 3],
    /// h = `energy_unit` · h'. A power of four.
    pub energy_unit: f64,
    /// l = `momentum_unit` · l'. A power of two.
    pub momentum_unit: f64,
    /// ω = `frequency_unit` · ω'. A power of two.
    pub frequency_unit: f64,
}

/// Sums over the axes k with r_k ≠ 0, for an axis i with r_i = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SymmetricSums {
    /// R̂.
    pub r_sum: f64,
    /// −3R̂ − a_i P̂.
    pub cusp_excess: f64,
}

/// The exponent k with |x| in [4^k, 4^(k+1)); 0 for x = 0.
fn quarter_exponent(x: f64) -> i32 {
    if x == 0.0 {
        return 0;
    }
    let exponent = ((x.abs().to_bits() >> 52) & 0x7ff) as i32 - 1023;
    exponent.div_euclid(2)
}

/// 2^e for |e| ≤ 1022.
fn power_of_two(e: i32) -> f64 {
    f64::from_bits(u64::from((1023 + e).unsigned_abs()) << 52)
}

/// x · 4^(−k), exactly.
fn scaled(x: &Relaxed, k: i32) -> Relaxed {
    let factor = Relaxed::from(IBig::from(UBig::ONE << (2 * k.unsigned_abs() as usize)));
    if k > 0 { x / factor } else { x * factor }
}

/// x · 4^(−k), rounded once.
fn nearest(x: &Relaxed, k: i32) -> f64 {
    // Far from the ends of the range of f64 a power of two rounds nothing.
    const LARGE: f64 = 1e140;
    let is_safe = |y: f64| (1.0 / LARGE..LARGE).contains(&y.abs());
    let rounded = x.to_f64().value();
    if k.unsigned_abs() < 200 && is_safe(rounded) {
        rounded * power_of_two(-2 * k)
    } else {
        scaled(x, k).to_f64().value()
    }
}

impl Body {
    /// The body in the sorted, scaled frame in which everything is computed.
    #[must_use]
    pub fn frame(&self) -> Frame {
        Frame::new(self)
    }
}

impl Frame {
    fn new(body: &Body) -> Self {
        let largest = |numbers: &[Number; 3]| numbers.iter().fold(0.0, |m: f64, x| m.max(x.to_f64().abs()));
        let a_exponent = quarter_exponent(largest(body.moments()));
        let r_exponent = quarter_exponent(largest(body.center()));
        // Fractions are not reduced: that costs more than it saves.
        let a = body.moments().each_ref().map(|x| x.value().clone().relax());
        let r = body.center().each_ref().map(|x| x.value().clone().relax());

        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| body.moments()[i].cmp(&body.moments()[j]));
        let mut group = [0; 3];
        for k in 1..3 {
            group[k] = group[k - 1] + usize::from(body.moments()[order[k]] != body.moments()[order[k - 1]]);
        }
        let r_squared = r.each_ref().map(|x| x * x);
        let (r_frame, to_body) = rotate(&order, &group, &r, &r_squared, r_exponent);

        let mut diff = [[0.0; 3]; 3];
        for (i, j) in [(1, 0), (2, 0), (2, 1)] {
            if group[i] != group[j] {
                // Also one that is below all doubles is none of 0.
                diff[i][j] = nearest(&(&a[order[i]] - &a[order[j]]), a_exponent).max(f64::MIN_POSITIVE);
                diff[j][i] = -diff[i][j];
            }
        }
        let norm_squared = &r_squared[0] + &r_squared[1] + &r_squared[2];
        let (j_r, offset) = if norm_squared.is_zero() {
            (f64::NAN, [f64::NAN; 3])
        } else {
            let j_r = (0..3).fold(Relaxed::ZERO, |sum, i| sum + &r_squared[i] * &a[i]) / &norm_squared;
            (nearest(&j_r, a_exponent), order.map(|i| nearest(&(&a[i] - &j_r), a_exponent)))
        };
        Self {
            a: order.map(|i| nearest(&a[i], a_exponent)),
            r: r_frame,
            diff,
            group,
            r_norm: nearest(&norm_squared, 2 * r_exponent).sqrt(),
            j_r,
            offset,
            symmetric_sums: symmetric_sums(&order, &group, &a, &r_squared, [a_exponent, r_exponent]),
            to_body,
            energy_unit: power_of_two(2 * r_exponent),
            momentum_unit: power_of_two(a_exponent + r_exponent),
            frequency_unit: power_of_two(r_exponent - a_exponent),
        }
    }

    /// γ (or any other vector) in the coordinates in which the body was given.
    #[must_use]
    pub fn vector_to_body(&self, v: [f64; 3]) -> [f64; 3] {
        self.to_body.map(|row| dot(row, v))
    }

    /// A vector of the coordinates in which the body was given, in this frame.
    #[must_use]
    pub fn vector_from_body(&self, v: [f64; 3]) -> [f64; 3] {
        let rows = &self.to_body;
        std::array::from_fn(|k| rows[0][k] * v[0] + rows[1][k] * v[1] + rows[2][k] * v[2])
    }

    /// r̂ in this frame (NaN when r = 0).
    #[must_use]
    pub fn r_hat(&self) -> [f64; 3] {
        self.r.map(|x| x / self.r_norm)
    }

    /// The axes k with r_k ≠ 0, by rising moment.
    #[must_use]
    pub fn active(&self) -> Vec<Axis> {
        Axis::ALL.into_iter().filter(|&k| self.r[k] > 0.0).collect()
    }

    /// The first axis of each eigenspace on which r vanishes.
    #[must_use]
    pub fn passive(&self) -> Vec<Axis> {
        let shares = |k: Axis, m: &Axis| self.group[*m] == self.group[k];
        let is_first = |k: Axis| Axis::ALL.iter().find(|m| shares(k, m)) == Some(&k);
        let carries = |k: Axis| Axis::ALL.iter().any(|m| self.r[*m] > 0.0 && shares(k, m));
        Axis::ALL.into_iter().filter(|&k| is_first(k) && !carries(k)).collect()
    }

    /// True when r = 0: Euler's case.
    #[must_use]
    pub fn is_euler(&self) -> bool {
        self.r_norm == 0.0
    }
}

/// R̂ and −3R̂ − a_i P̂ for each axis on whose eigenspace r vanishes.
fn symmetric_sums(
    order: &[usize; 3],
    group: &[usize; 3],
    a: &[Relaxed; 3],
    r_squared: &[Relaxed; 3],
    [a_exponent, r_exponent]: [i32; 2],
) -> [SymmetricSums; 3] {
    std::array::from_fn(|k| {
        let (eigenspace, others): (Vec<usize>, Vec<usize>) = (0..3).partition(|&m| group[m] == group[k]);
        if eigenspace.iter().any(|&m| !r_squared[order[m]].is_zero()) {
            return SymmetricSums::default();
        }
        let moment = &a[order[k]];
        let (mut r_sum, mut p_sum) = (Relaxed::ZERO, Relaxed::ZERO);
        for m in others {
            let gap = moment - &a[order[m]];
            let term = &r_squared[order[m]] / &gap;
            p_sum += &term / gap;
            r_sum += term;
        }
        let excess = &r_sum * Relaxed::from(-3) - moment * p_sum;
        let exponent = 2 * r_exponent - a_exponent;
        SymmetricSums { r_sum: nearest(&r_sum, exponent), cusp_excess: nearest(&excess, exponent) }
    })
}

/// r in the frame, and the matrix whose columns are the frame's axes.
fn rotate(
    order: &[usize; 3],
    group: &[usize; 3],
    r: &[Relaxed; 3],
    r_squared: &[Relaxed; 3],
    exponent: i32,
) -> ([f64; 3], [[f64; 3]; 3]) {
    let mut r_frame = [0.0; 3];
    let mut to_body = [[0.0; 3]; 3];
    let mut first = 0;
    while first < 3 {
        let axes: Vec<usize> = (first..3).filter(|&k| group[k] == group[first]).map(|k| order[k]).collect();
        let squared = axes.iter().fold(Relaxed::ZERO, |sum, &i| sum + &r_squared[i]);
        let basis = eigenspace_basis(&axes, r, exponent);
        let single = axes.iter().filter(|&&i| !r[i].is_zero()).count() <= 1;
        r_frame[first] = if single {
            axes.iter().map(|&i| nearest(&r[i], exponent).abs()).fold(0.0, f64::max)
        } else {
            nearest(&squared, 2 * exponent).sqrt()
        };
        for (k, vector) in basis.iter().enumerate() {
            for i in 0..3 {
                to_body[i][first + k] = vector[i];
            }
        }
        first += axes.len();
    }
    (r_frame, to_body)
}

/// An orthonormal basis of the span of `axes` whose first vector points along the projection of r.
fn eigenspace_basis(axes: &[usize], r: &[Relaxed; 3], exponent: i32) -> Vec<[f64; 3]> {
    let mut lead = [0.0; 3];
    for &i in axes {
        // For a single axis only the sign matters.
        lead[i] = if axes.len() == 1 { sign(&r[i]) } else { nearest(&r[i], exponent) };
    }
    let mut basis: Vec<[f64; 3]> = Vec::with_capacity(axes.len());
    if let Some(unit) = direction(lead) {
        basis.push(unit);
    }
    // Gram-Schmidt over the axes, those that differ most from the lead first.
    let mut rest = axes.to_vec();
    rest.sort_by(|&i, &j| lead[i].abs().total_cmp(&lead[j].abs()).then(i.cmp(&j)));
    for i in rest {
        if basis.len() == axes.len() {
            break;
        }
        let mut v = [0.0; 3];
        v[i] = 1.0;
        for b in &basis {
            let overlap = b[i];
            for c in 0..3 {
                v[c] -= overlap * b[c];
            }
        }
        if let Some(unit) = direction(v) {
            basis.push(unit);
        }
    }
    basis
}

fn sign(x: &Relaxed) -> f64 {
    match x.sign() {
        _ if x.is_zero() => 0.0,
        Sign::Positive => 1.0,
        Sign::Negative => -1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(a: [&str; 3], r: [&str; 3]) -> Frame {
        Body::parse(&a, &r).unwrap().frame()
    }

    #[test]
    fn moments_are_sorted_and_r_is_in_the_positive_octant() {
        let f = frame(["2", "1.1", "1"], ["0.5", "-0.25", "0"]);
        assert_eq!(f.a, [1.0, 1.1, 2.0]);
        assert_eq!(f.r.map(|x| x * f.energy_unit), [0.0, 0.25, 0.5]);
        assert_eq!(f.vector_to_body([0.0, 1.0, 0.0]), [0.0, -1.0, 0.0]);
    }

    #[test]
    fn differences_carry_no_cancellation_error() {
        let f = frame(["1", "1.0000000003", "1.273"], ["1", "1", "1"]);
        assert_eq!(f.diff[1][0], 3e-10);
        assert_eq!(f.diff[0][1], -3e-10);
    }

    #[test]
    fn equal_moments_share_a_group_whose_first_axis_carries_r() {
        let f = frame(["2", "1", "2"], ["3", "0.5", "-4"]);
        assert_eq!(f.group, [0, 1, 1]);
        assert_eq!(f.r.map(|x| x * f.energy_unit), [0.5, 5.0, 0.0]);
        let back = f.vector_to_body(f.r);
        let there = f.vector_from_body(back);
        assert!((0..3).all(|i| (there[i] - f.r[i]).abs() < 1e-15 * 5.0));
        for (x, y) in back.iter().zip([3.0, 0.5, -4.0]) {
            assert!((x * f.energy_unit - y).abs() < 1e-15 * 5.0);
        }
    }

    #[test]
    fn units_are_powers_of_four() {
        let f = frame(["1e-6", "5e-6", "5e-6"], ["3e6", "0", "1"]);
        assert!((1.0..4.0).contains(&f.a[2]));
        assert!((1.0..4.0).contains(&f.r[0].max(f.r[1]).max(f.r[2])));
        assert_eq!(f.energy_unit * f.r_norm, 9_000_000_000_001f64.sqrt());
    }

    #[test]
    fn isotropic_and_weightless_bodies_have_frames() {
        let f = frame(["1", "1", "1"], ["1", "2", "2"]);
        assert_eq!(f.group, [0, 0, 0]);
        assert!((f.r[0] * f.energy_unit - 3.0).abs() < 1e-15 * 3.0);
        assert_eq!((f.r[1], f.r[2]), (0.0, 0.0));
        assert!(frame(["1", "1", "2"], ["0", "0", "0"]).is_euler());
    }
}
