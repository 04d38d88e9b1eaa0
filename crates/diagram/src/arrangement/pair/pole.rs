//! Pole line against a critical curve near it, to relative accuracy.
//!
//! When r lies close to a principal axis, critical points c lie close to p = ±r̂ and U(p) − U(c) is of second order in
//! δ = p − c: far below the rounding of U. With s(μ − A)c = r (Corollary 3.11 of docs/algorithms.md):
//! U(p) − U(c) = s/(2J_p) [4α² + 2αβ + J_c ⟨δ, (μ−A)δ⟩ + μ|δ|²(2α + β)], α = ⟨δ, Ac⟩, β = ⟨δ, Aδ⟩, and
//! J_p − J_c = 2α + β. The component of δ along the large axis m follows from |p| = |c|:
//! δ_m = −Σ_{j≠m} δ_j (p_j + c_j)/(p_m + c_m).
//!
//! Near the other pole, −p, the kinetic parts are the same and U(p) − U(−p) = −2⟨p, r⟩.

use bifdiag_body::{Axis, Frame};
use bifdiag_equilibria::curves::{Gap, Mu, Point};
use bifdiag_numbers::UNIT_ROUNDOFF as U;

/// h_line − h_curve and (1/J_line) − (1/J_curve), each with its bound; `None` when c is near neither p nor −p.
pub(super) fn gaps(frame: &Frame, line: &Point, curve: &Point, mu: Mu) -> Option<[Gap; 2]> {
    let (p, c) = (line.gamma, curve.gamma);
    let m = (0..3).max_by(|&i, &j| p[i].abs().total_cmp(&p[j].abs()))?;
    if p[m] * c[m] > 0.0 {
        return gaps_beside(frame, line, curve, mu, m);
    }
    if c[m] == 0.0 {
        return None;
    }
    let opposite = Point { gamma: p.map(|g| -g), rho: -line.rho, ..*line };
    let [gap, slope] = gaps_beside(frame, &opposite, curve, mu, m)?;
    let (value, rho_error) = (gap.value - 2.0 * line.rho, 8.0 * U * line.rho.abs());
    Some([Gap { value, error: gap.error + rho_error + 2.0 * U * value.abs() }, slope])
}

/// The same where p_m c_m > 0, m the axis nearest to p.
fn gaps_beside(frame: &Frame, line: &Point, curve: &Point, mu: Mu, m: usize) -> Option<[Gap; 2]> {
    let (p, c) = (line.gamma, curve.gamma);
    let sum = p[m] + c[m];
    let (mut delta, mut error) = ([0.0; 3], [0.0; 3]);
    let (mut alpha, mut alpha_error) = (0.0, 0.0);
    for j in (0..3).filter(|&j| j != m) {
        delta[j] = p[j] - c[j];
        error[j] = 8.0 * U * (p[j].abs() + c[j].abs());
        let ratio = (p[j] + c[j]) / sum;
        delta[m] -= delta[j] * ratio;
        error[m] += (error[j] + 8.0 * U * delta[j].abs()) * ratio.abs();
        let weight = frame.a[j] * c[j] - frame.a[m] * c[m] * ratio;
        let weight_scale = frame.a[j] * c[j].abs() + frame.a[m] * c[m].abs() * ratio.abs();
        alpha += delta[j] * weight;
        alpha_error += error[j] * weight.abs() + 16.0 * U * delta[j].abs() * weight_scale;
    }
    let tau = Axis::ALL.map(|k| mu.minus_moment(frame, k));
    let quadratic = |weight: &dyn Fn(usize) -> f64| {
        let value: f64 = (0..3).map(|k| weight(k) * delta[k] * delta[k]).sum();
        let scale = |k: usize| weight(k).abs() * delta[k].abs() * (2.0 * error[k] + 8.0 * U * delta[k].abs());
        (value, (0..3).map(scale).sum::<f64>())
    };
    let (beta, beta_error) = quadratic(&|k| frame.a[k]);
    let (norm, norm_error) = quadratic(&|_| 1.0);
    let (form, form_error) = quadratic(&|k| tau[k]);
    if norm > 0.25 {
        return None;
    }
    let moment = 2.0 * alpha + beta;
    let moment_error = 2.0 * alpha_error + beta_error;
    let s = 2.0 * curve.x / (curve.j * curve.j);
    let mu = mu.value(frame);
    let terms = [4.0 * alpha * alpha, 2.0 * alpha * beta, curve.j * form, mu * norm * moment];
    let factor = s / (2.0 * line.j);
    let scale: f64 = terms.iter().map(|term| term.abs()).sum();
    let bracket_error = 8.0 * alpha.abs() * alpha_error
        + 2.0 * (alpha.abs() * beta_error + beta.abs() * alpha_error)
        + curve.j * form_error
        + mu.abs() * (norm * moment_error + norm_error * moment.abs())
        + 32.0 * U * scale;
    let slope = -moment / (curve.j * line.j);
    let slope_error = (moment_error + 16.0 * U * moment.abs()) / (curve.j * line.j);
    // c is critical at an x that is off by a few units of roundoff.
    let value = factor * terms.iter().sum::<f64>();
    let error = 2.0 * factor * bracket_error + 64.0 * U * curve.x * slope.abs();
    Some([Gap { value, error }, Gap { value: slope, error: 2.0 * slope_error }])
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Body;
    use bifdiag_equilibria::curves::{CriticalSet, Orbit};

    /// Where the plain difference has digits, the formula agrees with it.
    #[test]
    fn the_formula_agrees_with_the_difference_of_heights() {
        let body = Body::parse(&["2", "1.1", "1.3"], &["1", "0.01", "0.02"]).unwrap();
        let set = CriticalSet::new(body.frame()).unwrap();
        let (mut compared, mut beside_opposite) = (0, 0);
        for line in set.curves.iter().filter(|curve| matches!(curve.orbit, Orbit::Pole(_))) {
            for curve in set.curves.iter().filter(|curve| curve.is_critical()) {
                for x in [0.3, 1.0, 3.0, 9.0] {
                    if x <= curve.x()[0] || x >= curve.x()[1] {
                        continue;
                    }
                    let (p, c) = (line.point(&set.frame, x), curve.point(&set.frame, x));
                    let mu = curve.arc(x).mu(&set.frame, x).unwrap();
                    let Some([gap, slope]) = gaps(&set.frame, &p, &c, mu) else { continue };
                    let plain = Gap::between(&set.frame, &p, &c);
                    let opposite = (0..3).map(|k| p.gamma[k] * c.gamma[k]).sum::<f64>() < 0.0;
                    assert!((gap.value - plain.value).abs() <= gap.error + plain.error, "{gap:?} {plain:?}");
                    assert!((slope.value - (p.slope() - c.slope())).abs() <= slope.error + 1e-15, "{slope:?}");
                    // Beside the other pole the error of 2⟨p, r⟩ remains.
                    assert!(opposite || gap.error <= plain.error);
                    beside_opposite += usize::from(opposite);
                    compared += 1;
                }
            }
        }
        assert!(compared >= 16 && beside_opposite >= 4, "{compared} {beside_opposite}");
    }
}
