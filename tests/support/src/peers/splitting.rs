//! A splitting method: every substep is the exact flow of a part of H under the same Poisson bracket.
//!
//! H = l₁²/2A₁ + l₂²/2A₂ + l₃²/2A₃ − ⟨γ,r⟩. The flow of lᵢ²/2Aᵢ turns γ and l about axis i by −(lᵢ/Aᵢ)t, that of
//! −⟨γ,r⟩ adds −t γ×r to l (Proposition 12.3 of docs/algorithms.md). All of them keep ⟨γ,γ⟩ and ⟨γ,l⟩, so that their
//! composition does, to rounding.

use bifdiag_dynamics::field::{HeavyTop, State, cross, scale, sub};

/// Suzuki's composition of five symmetric steps, of order 4: p, p, 1 − 4p, p, p with p = 1/(4 − 4^{1/3}).
const OUTER: f64 = 0.414_490_771_794_375_7;
const INNER: f64 = 1.0 - 4.0 * OUTER;

/// The state after a step.
pub(super) fn step(top: &HeavyTop, state: &State, length: f64) -> State {
    let mut next = *state;
    for part in [OUTER, OUTER, INNER, OUTER, OUTER] {
        symmetric(top, &mut next, part * length);
    }
    next
}

/// Strang's symmetric composition, of order 2.
fn symmetric(top: &HeavyTop, state: &mut State, t: f64) {
    let half = 0.5 * t;
    fall(top, state, half);
    turn(top, state, 0, half);
    turn(top, state, 1, half);
    turn(top, state, 2, t);
    turn(top, state, 1, half);
    turn(top, state, 0, half);
    fall(top, state, half);
}

/// The flow of −⟨γ,r⟩.
fn fall(top: &HeavyTop, state: &mut State, t: f64) {
    state.l = sub(state.l, scale(t, cross(state.gamma, top.center())));
}

/// The flow of l_axis²/2A_axis: γ̇ = γ×ω, l̇ = l×ω with ω constant along the axis.
fn turn(top: &HeavyTop, state: &mut State, axis: usize, t: f64) {
    let (p, q) = ((axis + 1) % 3, (axis + 2) % 3);
    let angle = state.l[axis] * top.inverse_moments()[axis] * t;
    let (sin, half) = (libm::sin(angle), libm::sin(0.5 * angle));
    // Increments, with cos − 1 = −2 sin²(angle/2): a rounded cosine would stretch a steady rotation a little by
    // the same factor in every step.
    let cos_less_1 = -2.0 * half * half;
    for v in [&mut state.gamma, &mut state.l] {
        let (x, y) = (v[p], v[q]);
        v[p] = x + cos_less_1.mul_add(x, sin * y);
        v[q] = y + cos_less_1.mul_add(y, -sin * x);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bifdiag_body::Body;
    use bifdiag_dynamics::field::Integrals;

    #[test]
    fn casimirs_stay_at_rounding_and_the_energy_bounded() {
        let top = HeavyTop::new(&Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap());
        let start = State { gamma: [0.6, 0.0, 0.8], l: [2.0, 1.0, 2.5] };
        let first = Integrals::of(&top, &start);
        let mut state = start;
        let mut worst = Integrals::default();
        for _ in 0..20_000 {
            state = step(&top, &state, 0.02);
            worst = worst.max(&Integrals::of(&top, &state).distance(&first));
        }
        // 20,000 steps of 35 substeps: a random walk of 840 roundings.
        assert!(worst.gamma_squared < 5e-13 && worst.vertical_momentum < 2e-12, "{worst:?}");
        assert!(worst.energy < 1e-5 && worst.energy > 1e-12, "{worst:?}");
    }
}
