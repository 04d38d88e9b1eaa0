//! The tangent vector with which the variational equations begin.

use crate::field::{HeavyTop, State, dot};

/// √(2 A_max (h + 2|r|)): the unit of δl. (Unlike the largest |l| it does not vanish where the top is at rest.)
pub(super) fn momentum_unit(top: &HeavyTop, state: &State) -> f64 {
    top.momentum_scale(top.energy(state) + top.center_norm()).max(f64::MIN_POSITIVE.sqrt())
}

/// A vector of length 1 tangent to the surface of constant H, ⟨γ,γ⟩ and ⟨γ,l⟩, with l in units of `momentum_unit`.
///
/// It is the projection of one fixed vector, chosen with no symmetry, so that it has a share of every direction.
pub(super) fn tangent_vector(top: &HeavyTop, state: &State, momentum_unit: f64) -> State {
    const DIRECTION: [f64; 6] = [0.57, -0.31, 0.43, 0.37, 0.29, -0.41];
    let State { gamma, l } = *state;
    let omega = top.angular_velocity(l);
    let r = top.center();
    // The gradients in (γ, l/unit).
    let mut normals: [[f64; 6]; 3] = [[0.0; 6]; 3];
    for i in 0..3 {
        (normals[0][i], normals[1][i], normals[2][i]) = (gamma[i], l[i], -r[i]);
        (normals[1][i + 3], normals[2][i + 3]) = (momentum_unit * gamma[i], momentum_unit * omega[i]);
    }
    let mut vector = DIRECTION;
    for k in 0..3 {
        let size = length(&normals[k]);
        for j in 0..k {
            normals[k] = without(normals[k], &normals[j]);
        }
        // At a relative equilibrium the gradients are dependent.
        let rest = length(&normals[k]);
        let factor = if rest > size * 1e-12 { 1.0 / rest } else { 0.0 };
        normals[k] = normals[k].map(|x| x * factor);
    }
    // Twice: once would leave the rounding of the cancelled part.
    for normal in normals.iter().chain(&normals) {
        vector = without(vector, normal);
    }
    let [a, b, c, d, e, f] = vector.map(|x| x / length(&vector));
    State { gamma: [a, b, c], l: [d, e, f].map(|x| x * momentum_unit) }
}

/// v − n⟨n,v⟩.
fn without(mut v: [f64; 6], n: &[f64; 6]) -> [f64; 6] {
    let share: f64 = v.iter().zip(n).map(|(a, b)| a * b).sum();
    for (a, b) in v.iter_mut().zip(n) {
        *a -= share * b;
    }
    v
}

fn length(v: &[f64; 6]) -> f64 {
    let [a, b, c, d, e, f] = *v;
    (dot([a, b, c], [a, b, c]) + dot([d, e, f], [d, e, f])).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangent_vectors_keep_the_integrals_and_have_length_1() {
        let top = HeavyTop::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]);
        for k in 0..50 {
            let x = |step: f64| 2.0 * (f64::from(k) * step % 1.0) - 1.0;
            let gamma = [x(0.41), x(0.73), x(0.27)];
            let size = dot(gamma, gamma).sqrt();
            let state = State { gamma: gamma.map(|g| g / size), l: [3.0 * x(0.13), 3.0 * x(0.59), 3.0 * x(0.87)] };
            let scale = top.momentum_scale(top.energy(&state));
            let vector = tangent_vector(&top, &state, scale);
            let momentum = vector.l.map(|x| x / scale);
            assert!((dot(vector.gamma, vector.gamma) + dot(momentum, momentum) - 1.0).abs() < 1e-14);
            assert!(dot(state.gamma, vector.gamma).abs() < 1e-14);
            assert!((dot(state.gamma, vector.l) + dot(state.l, vector.gamma)).abs() < 1e-13 * scale);
            let energy = dot(top.angular_velocity(state.l), vector.l) - dot(top.center(), vector.gamma);
            assert!(energy.abs() < 1e-13 * scale * scale, "{energy:e}");
        }
    }
}
