//! The further integrals of integrable cases: their derivatives along the flow vanish, and do not for other bodies.

use bifdiag_body::{Body, Holds, IntegrableCase};
use bifdiag_dynamics::field::{
    HeavyTop, State, add, dot, further_integral, further_scale, keeps_further_integral, scale, sub,
};
use proptest::prelude::*;

/// Bodies of each case, with the axes and units in several orders.
const BODIES: [([&str; 3], [&str; 3]); 11] = [
    (["2", "1.5", "1"], ["0", "0", "0"]),
    (["3/2", "1", "1"], ["1", "0", "0"]),
    (["1", "1", "0.7"], ["0", "0", "-2"]),
    (["1.3", "1.3", "1.3"], ["1", "-2", "0.5"]),
    (["2", "2", "1"], ["1", "0", "0"]),
    (["1.4", "0.7", "1.4"], ["0.3", "0", "-0.4"]),
    (["0.5", "1", "1"], ["0", "-1", "2"]),
    (["4", "4", "1"], ["1", "0", "0"]),
    (["0.3", "1.2", "1.2"], ["0", "1", "-0.7"]),
    (["1/2", "1/3", "1/7"], ["1", "0", "2"]),
    (["1/7", "1/2", "1/3"], ["-20", "10", "0"]),
];

/// The derivative of a polynomial of degree four at most along a direction: exact but for rounding.
fn derivative(f: impl Fn(&State) -> f64, at: &State, along: &State) -> f64 {
    let step = |n: f64| f(&State { gamma: add(at.gamma, scale(n, along.gamma)), l: add(at.l, scale(n, along.l)) });
    (8.0 * (step(1.0) - step(-1.0)) - (step(2.0) - step(-2.0))) / 12.0
}

/// The state on the motions that keep the integral.
fn prepared(case: IntegrableCase, top: &HeavyTop, state: State) -> State {
    // Twice: where l is nearly along n, what the first time leaves is all rounding of what it takes away.
    let once = |l: [f64; 3], n: [f64; 3]| sub(l, scale(dot(l, n) / dot(n, n), n));
    let across = |l: [f64; 3], n: [f64; 3]| once(once(l, n), n);
    match case.holds() {
        Holds::Always => state,
        Holds::ZeroMomentum => State { l: across(state.l, state.gamma), ..state },
        Holds::WhereZero => State { l: across(state.l, top.center()), ..state },
    }
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0_f64..1.0)
}

proptest! {
    #[test]
    fn further_integrals_are_constant_along_the_flow(gamma in vector(), l in vector(), body in 0..BODIES.len()) {
        let body = Body::parse(&BODIES[body].0, &BODIES[body].1).unwrap();
        let top = HeavyTop::new(&body);
        let [case] = IntegrableCase::of(&body)[..] else { panic!("one case") };
        let state = prepared(case, &top, State { gamma, l });
        prop_assert!(keeps_further_integral(case, &top, &state));
        let field = top.vector_field(&state);
        let rate = derivative(|state| further_integral(case, &top, state), &state, &field);
        // Four steps of the flow, at each of which the terms are as large as this.
        let far = State { gamma: add(gamma, scale(2.0, field.gamma)), l: add(state.l, scale(2.0, field.l)) };
        let size = further_scale(case, &top, &state) + further_scale(case, &top, &far);
        prop_assert!(rate.abs() <= 1e-12 * (1.0 + size), "{case:?} {rate} {size}");
    }
}

/// A state that random ones came upon: l is along γ but for a fortieth.
#[test]
fn momenta_along_gamma_are_brought_to_the_level() {
    let gamma = [-0.105_222_849_105_715_76, 0.852_485_215_220_471_4, 0.994_147_193_221_842_9];
    let l = [-0.091_365_290_700_329_35, 0.613_823_187_401_475_3, 0.696_155_135_020_538_3];
    let body = Body::parse(&BODIES[7].0, &BODIES[7].1).unwrap();
    let (top, case) = (HeavyTop::new(&body), IntegrableCase::of(&body)[0]);
    assert!(keeps_further_integral(case, &top, &prepared(case, &top, State { gamma, l })));
}

/// Each condition of each case is needed: with another body, or off the level, the derivative is not 0.
#[test]
fn the_conditions_are_needed() {
    let state = State { gamma: [0.48, -0.6, 0.64], l: [0.7, 1.1, -0.9] };
    let rate = |case, moments: [&str; 3], center: [&str; 3], state: &State| {
        let top = HeavyTop::new(&Body::parse(&moments, &center).unwrap());
        derivative(|state| further_integral(case, &top, state), state, &top.vector_field(state)).abs()
    };
    let case = |moments: [&str; 3], center: [&str; 3]| IntegrableCase::of(&Body::parse(&moments, &center).unwrap())[0];
    let kovalevskaya = case(["2", "2", "1"], ["1", "0", "0"]);
    assert!(rate(kovalevskaya, ["2", "2", "1.1"], ["1", "0", "0"], &state) > 1e-3);
    assert!(rate(kovalevskaya, ["2", "2", "1"], ["1", "0", "0.1"], &state) > 1e-3);
    let lagrange = case(["1", "1", "0.7"], ["0", "0", "1"]);
    assert!(rate(lagrange, ["1", "1.1", "0.7"], ["0", "0", "1"], &state) > 1e-3);
    let euler = case(["2", "1.5", "1"], ["0"; 3]);
    assert!(rate(euler, ["2", "1.5", "1"], ["0.1", "0", "0"], &state) > 1e-3);
    let goryachev = case(["4", "4", "1"], ["1", "0", "0"]);
    let top = HeavyTop::new(&Body::parse(&["4", "4", "1"], &["1", "0", "0"]).unwrap());
    assert!(!keeps_further_integral(goryachev, &top, &state));
    assert!(rate(goryachev, ["4", "4", "1"], ["1", "0", "0"], &state) > 1e-3);
    let level = prepared(goryachev, &top, state);
    assert!(rate(goryachev, ["4.1", "4.1", "1"], ["1", "0", "0"], &level) > 1e-4);
    let hess = case(["1/2", "1/3", "1/7"], ["1", "0", "2"]);
    let top = HeavyTop::new(&Body::parse(&["1/2", "1/3", "1/7"], &["1", "0", "2"]).unwrap());
    assert!(!keeps_further_integral(hess, &top, &state));
    assert!(rate(hess, ["1/2", "1/3", "1/7"], ["1", "0", "2"], &state) > 1e-3);
    assert!(rate(hess, ["1/2", "1/3", "1/6"], ["1", "0", "2"], &prepared(hess, &top, state)) > 1e-3);
}
