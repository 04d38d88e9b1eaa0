//! The classical Runge–Kutta method of order 4.

use bifdiag_dynamics::field::{HeavyTop, State, add, scale};

/// x + c k.
fn shifted(x: &State, c: f64, k: &State) -> State {
    State { gamma: add(x.gamma, scale(c, k.gamma)), l: add(x.l, scale(c, k.l)) }
}

/// The state after a step of length h.
pub(super) fn step(top: &HeavyTop, state: &State, h: f64) -> State {
    let k1 = top.vector_field(state);
    let k2 = top.vector_field(&shifted(state, 0.5 * h, &k1));
    let k3 = top.vector_field(&shifted(state, 0.5 * h, &k2));
    let k4 = top.vector_field(&shifted(state, h, &k3));
    let weights = [(h / 6.0, k1), (h / 3.0, k2), (h / 3.0, k3), (h / 6.0, k4)];
    weights.iter().fold(*state, |x, (weight, k)| shifted(&x, *weight, k))
}
