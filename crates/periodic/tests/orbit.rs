//! Closed orbits against the pendulum, whose period and action are elliptic integrals.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_periodic::orbit::{Fixed, PeriodicOrbit, correct};
use bifdiag_schema::OrbitStability;

fn paper(unit: i32) -> HeavyTop {
    let body = Body::parse(&["2", "11/10", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    let size = |x: f64| libm::scalbn(x, unit);
    let texts = |v: [f64; 3]| v.map(|x| format!("{:?}", size(x)));
    let (a, r) = (texts(body.moments_f64()), texts(body.center_f64()));
    let [a, r] = [&a, &r].map(|v| v.each_ref().map(String::as_str));
    HeavyTop::new(&Body::parse(&a, &r).unwrap())
}

/// The arithmetic–geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..12 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// The body swings about its second axis, across which r lies: A₂φ̈ = −|r| sin φ with the period 2π/Ω agm(1, cos(φ/2)).
#[test]
fn a_swinging_plate_is_a_pendulum_in_any_units() {
    for unit in [0, 300] {
        let top = paper(unit);
        let (weight, inertia) = (top.center_norm(), top.moments()[1]);
        let [x, _, z] = top.r_hat().unwrap();
        let (sin, cos) = (libm::sin(0.7), libm::cos(0.7));
        // Turned from r̂ about the second axis, at rest.
        let start = State { gamma: [cos * x - sin * z, 0.0, cos * z + sin * x], l: [0.0; 3] };
        let exact = std::f64::consts::TAU * (inertia / weight).sqrt() / agm(1.0, libm::cos(0.35));
        let (found, period) = correct(&top, &start, 1.01 * exact, Fixed::Both).unwrap();
        assert!((period / exact - 1.0).abs() < 1e-14, "{period} {exact}");
        let orbit = PeriodicOrbit::new(&top, &found, period).unwrap();
        assert!(orbit.residual < 1e-14, "{orbit:?}");
        assert!((orbit.product() - 1.0).abs() < 1e-12, "{orbit:?}");
        assert!(orbit.symmetric);
        // ⟨γ,r⟩ is largest when it hangs, and smallest at either side.
        assert_eq!(orbit.crossings, 4);
        assert!((orbit.h + weight * cos).abs() < 1e-14 * weight);
        assert_eq!(orbit.stability, OrbitStability::Elliptic);
    }
}

/// dS/dh = T where l = 0.
#[test]
fn the_action_of_pendulums_grows_with_their_period() {
    let top = paper(0);
    let [x, _, z] = top.r_hat().unwrap();
    let swing = |angle: f64| {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let start = State { gamma: [cos * x - sin * z, 0.0, cos * z + sin * x], l: [0.0; 3] };
        let exact =
            std::f64::consts::TAU * (top.moments()[1] / top.center_norm()).sqrt() / agm(1.0, libm::cos(0.5 * angle));
        PeriodicOrbit::new(&top, &start, exact).unwrap()
    };
    let [below, middle, above] = [1.199, 1.2, 1.201].map(swing);
    let slope = (above.action - below.action) / (above.h - below.h);
    assert!((slope - middle.period).abs() < 1e-5 * middle.period, "{slope} {}", middle.period);
}
