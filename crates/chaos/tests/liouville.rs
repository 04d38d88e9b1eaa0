//! States are spread in Liouville measure: on their surface, in their component, as the flow leaves them and as a thin shell
//! of phase space has them.

use bifdiag_body::Body;
use bifdiag_chaos::EnergySurface;
use bifdiag_diagram::accessible::{AccessibleRegion, component_of};
use bifdiag_dynamics::field::{HeavyTop, State, dot};
use bifdiag_dynamics::integrator::{DEFAULT_TOLERANCE, Taylor};
use bifdiag_numbers::sequence;

fn paper() -> Body {
    Body::from_f64([2.0, 1.1, 1.0], [0.94868, 0.0, 0.61623]).unwrap()
}

/// Functions of a state that a wrong density would move: powers of γ and of the momenta.
fn observables(state: &State) -> [f64; 6] {
    let State { gamma, l } = *state;
    [
        gamma[0] * gamma[0],
        gamma[1] * gamma[1],
        l[0] * l[0],
        l[1] * l[1],
        gamma[2] * l[2],
        gamma[0] * gamma[0] * gamma[1] * gamma[1],
    ]
}

/// The means of the observables and their standard deviations, were the states independent.
fn means(states: &[State]) -> [(f64, f64); 6] {
    let count = states.len() as f64;
    std::array::from_fn(|k| {
        let values = states.iter().map(|state| observables(state)[k]);
        let mean = values.clone().sum::<f64>() / count;
        let square = values.map(|x| (x - mean) * (x - mean)).sum::<f64>() / count;
        (mean, (square / count).sqrt())
    })
}

/// The state after a time.
fn flown(top: &HeavyTop, start: &State, time: f64) -> State {
    let mut motion = Taylor::new(top, start, DEFAULT_TOLERANCE).unwrap();
    loop {
        let step = motion.step().unwrap();
        if step.end().seconds() >= time {
            return step.state((time - step.start().seconds()) / step.length());
        }
    }
}

#[test]
fn states_lie_on_their_surface_and_more_begin_with_the_same() {
    let (h, l) = (5.3, 3.25);
    let surface = EnergySurface::new(&paper(), h, l, 1).unwrap();
    let states = surface.states(0, 500, 3).unwrap();
    for state in &states {
        assert!((surface.top().energy(state) - h).abs() < 1e-13 * 20.0);
        assert!((dot(state.gamma, state.l) - l).abs() < 1e-13 * 10.0);
        assert!((dot(state.gamma, state.gamma) - 1.0).abs() < 1e-14);
    }
    assert_eq!(states[..200], surface.states(0, 200, 3).unwrap());
    assert_ne!(states[..200], surface.states(0, 200, 4).unwrap());
}

/// At these l a minimum of U_l is degenerate, and no path leads down to it; there is one component all the same.
#[test]
fn a_degenerate_minimum_is_no_obstacle() {
    for (a, r, h, l) in [([2.0, 2.0, 1.0], [0.0, 0.0, 1.0], 2.0, 1.0), ([3.0, 2.0, 1.0], [0.0, 1.0, 0.0], 3.0, 2.0)] {
        let body = Body::from_f64(a, r).unwrap();
        assert!(AccessibleRegion::new(&body, h, l).unwrap().partition().is_err());
        let surface = EnergySurface::new(&body, h, l, 1).unwrap();
        for state in surface.states(0, 200, 1).unwrap() {
            assert!((surface.top().energy(&state) - h).abs() < 1e-12);
        }
    }
}

/// The flow keeps the distribution. That of places uniform in area, which is not invariant, it changes: the test would see it.
#[test]
fn the_flow_leaves_the_distribution_as_it_is() {
    let body = Body::from_f64([2.0, 1.5, 0.7], [0.6, 0.0, 0.8]).unwrap();
    let (h, l) = (3.0, 1.2);
    let surface = EnergySurface::new(&body, h, l, 1).unwrap();
    let states = surface.states(0, 3000, 0).unwrap();
    let before = means(&states);
    let moved: Vec<State> = states.iter().map(|state| flown(surface.top(), state, 1.0)).collect();
    for ((was, error), (is, _)) in before.into_iter().zip(means(&moved)) {
        assert!((is - was).abs() < 5.0 * error, "{was} became {is} (± {error})");
    }
    // Every state J^(1/2) times as often, as near as whole numbers come: uniform in area.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 8 to 12")]
    let weight = |state: &State| (8.0 * dot(state.gamma, surface.top().inertia(state.gamma)).sqrt()).round() as usize;
    let repeat = |of: &[State]| -> Vec<State> {
        let pairs = of.iter().zip(&states);
        pairs.flat_map(|(state, start)| std::iter::repeat_n(*state, weight(start))).collect()
    };
    let changes = means(&repeat(&states)).into_iter().zip(means(&repeat(&moved)));
    let largest = changes.zip(before).map(|(((was, _), (is, _)), (_, error))| (is - was).abs() / error);
    assert!(largest.fold(0.0, f64::max) > 6.0);
}

/// Places of a thin shell of phase space, h ± 0.08 and l ± 0.08, from a cube round it: no formula of the measure is used.
#[test]
fn a_thin_shell_of_phase_space_has_the_same_means() {
    let body = Body::from_f64([2.0, 1.5, 0.7], [0.6, 0.0, 0.8]).unwrap();
    let (h, l, half) = (3.0, 1.2, 0.08);
    let surface = EnergySurface::new(&body, h, l, 1).unwrap();
    let sampled = means(&surface.states(0, 4000, 0).unwrap());
    let top = surface.top();
    let reach = top.moments().map(|a| (2.0 * a * (h + half + 1.0)).sqrt());
    let uniform = |k: u64| (sequence::random(k) >> 11) as f64 / (1_u64 << 53) as f64;
    let mut shell = Vec::new();
    for n in 0_u64..4_000_000 {
        let [a, b, c, d, e] = std::array::from_fn(|j| uniform(5 * n + j as u64 + 1));
        let z = 2.0 * a - 1.0;
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * b);
        let across = (1.0 - z * z).sqrt();
        let gamma = [across * cos, across * sin, z];
        let momentum = [c, d, e];
        let state = State { gamma, l: std::array::from_fn(|i| reach[i] * (2.0 * momentum[i] - 1.0)) };
        if (top.energy(&state) - h).abs() < half && (dot(gamma, state.l) - l).abs() < half {
            shell.push(state);
        }
    }
    assert!(shell.len() > 2000, "{}", shell.len());
    for ((mean, _), (other, error)) in sampled.into_iter().zip(means(&shell)) {
        assert!((mean - other).abs() < 4.0 * error, "{mean} and {other} (± {error})");
    }
}

#[test]
fn states_lie_in_their_component_however_small_it_is() {
    // (3.8, 3.25) has two components; just above a minimum one of them is tiny.
    let body = paper();
    let critical = bifdiag_exact::critical(&body, &"3.25".parse().unwrap()).unwrap();
    let second = critical.list.iter().filter(|point| point.index == 0).nth(1).unwrap().h;
    for h in [3.8, second + 1e-3, second + 1e-9] {
        let surface = EnergySurface::new(&body, h, 3.25, 2).unwrap();
        let region = AccessibleRegion::new(&body, h, 3.25).unwrap();
        let partition = region.partition().unwrap().unwrap();
        for component in 0..2 {
            for state in surface.states(component, 64, 0).unwrap() {
                assert_eq!(component_of(&partition, state.gamma), Some(component), "{h}");
            }
        }
    }
}
