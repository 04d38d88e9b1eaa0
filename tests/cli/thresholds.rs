//! Rotation at, below and above the spins at which it changes: `state`, `critical-spin` and `critical` judge it alike.

use std::cell::Cell;

use bifdiag_body::{Body, Number};
use dashu_ratio::RBig;
use serde_json::{Value, json};
use support::property::holds_for_bodies;
use support::strata::STRATA;

use crate::builder::bifdiag;

/// What `critical` says at l of the equilibrium with this vertical.
fn critical(body: &str, l: &str, gamma: [f64; 3]) -> (Value, Value) {
    let all = bifdiag(&format!("critical {body} --l={l} --json")).succeeds().json();
    let near = |point: &&Value| {
        let at = |k: usize| point["gamma"][k].as_f64().unwrap();
        point["multiplicity"].is_string() || (0..3).all(|k| (at(k) - gamma[k]).abs() < 1e-12)
    };
    // About an axis of its own before one of a circle.
    let list: Vec<&Value> = all["critical"].as_array().unwrap().iter().filter(near).collect();
    let point = list.iter().find(|point| point["multiplicity"].is_number()).or(list.first());
    let point = point.unwrap_or_else(|| panic!("{body} l = {l}: {all}"));
    (point["stability"].clone(), point["stable"].clone())
}

/// The steady rotation that `state` tells.
fn steady(body: &str, turning: &str, spin: &str) -> Value {
    let state = bifdiag(&format!("state {body} {turning} --json --spin")).and(spin).succeeds().json();
    let steady = state["steady"].clone();
    assert!(!steady.is_null(), "{body} {turning} {spin}\n{state}");
    steady
}

/// Bodies of every stratum with |ρ| = |C − A| Ω², so that K_A vanishes at the rational spin Ω with one end up, if A ≠ C.
#[test]
fn rational_thresholds_are_judged_as_in_critical() {
    let (compared, at_threshold) = (Cell::new(0), Cell::new(0));
    for stratum in STRATA {
        holds_for_bodies(stratum, 1, |body: &Body| {
            let moments = body.moments().each_ref().map(|x| x.value().clone());
            let text = moments.each_ref().map(RBig::to_string).join(",");
            for axis in 0..3 {
                let (own, other) = (&moments[axis], &moments[(axis + 1) % 3]);
                let weight = (own - other) * RBig::from_parts(9.into(), 4u8.into());
                let mut center = ["0".to_owned(), "0".to_owned(), "0".to_owned()];
                center[axis] = weight.to_string();
                let body = format!("--A {text} --r={}", center.join(","));
                for spin in ["3/4", "3/2", "3"] {
                    let l = own * spin.parse::<Number>().unwrap().value();
                    for up in [1.0, -1.0] {
                        let mut vertical = [0.0; 3];
                        vertical[axis] = up;
                        let turning = format!("--axis={}{}", if up < 0.0 { "-" } else { "" }, ["x", "y", "z"][axis]);
                        let found = steady(&body, &turning, &format!("{spin} rad/s"));
                        let expected = critical(&body, &l.to_string(), vertical.map(|x| 0.0 - x));
                        let reply = (found["stability"].clone(), found["stable"].clone());
                        assert_eq!(reply, expected, "{stratum:?} {body} {turning} {spin}\n{found}");
                        compared.set(compared.get() + 1);
                        at_threshold.set(at_threshold.get() + i32::from(found.get("at").is_some()));
                    }
                }
            }
            Ok(())
        });
    }
    let (compared, at_threshold) = (compared.get(), at_threshold.get());
    assert!(compared > 300 && at_threshold > 40, "{compared} {at_threshold}");
}

#[test]
fn coincidences_are_judged_as_in_critical() {
    for (body, turning, spin, l, gamma, verdict) in [
        // Degenerate, but the least: stable by energy.
        ("--A 3,2.5,2 --r 0,0,1", "--axis=-z", "1 rad/s", "2", [0.0, 0.0, 1.0], json!("energy")),
        // Lagrange's top where it wakes.
        ("--A 1,1,0.5 --r 0,0,1", "--axis z", "4 rad/s", "2", [0.0, 0.0, -1.0], json!("integral")),
        ("--A 1,2.4,3 --r 0,0,0.6", "--axis z", "1 rad/s", "3", [0.0, 0.0, -1.0], Value::Null),
        // A minimum goes on alone: 4 · 2 < 3 · 3, and 4 · 2.25 = 3 · 3 no more.
        ("--A 1,2,3 --r 0,0,1", "--axis z", "1 rad/s", "3", [0.0, 0.0, -1.0], json!("energy")),
        ("--A 1,2.25,3 --r 0,0,0.75", "--axis z", "1 rad/s", "3", [0.0, 0.0, -1.0], Value::Null),
        ("--A 1,1.2,1.7 --r 0,0,0.5", "--axis z", "1 rad/s", "1.7", [0.0, 0.0, -1.0], json!("energy")),
        // Where a pair leaves a rotation about an axis that is not principal.
        ("--A 1,2,3 --r 1.2,0.8,0", "--axis=-0.6,-0.8,0", "1 rad/s", "1.64", [0.6, 0.8, 0.0], json!("energy")),
        ("--A 1,2,3 --r 1.2,0.8,0", "--axis=-3,-4,0", "1 rad/s", "41/25", [0.6, 0.8, 0.0], json!("energy")),
    ] {
        let found = steady(body, turning, spin);
        let reply = (found["stability"].clone(), found["stable"].clone());
        assert_eq!(reply, critical(body, l, gamma), "{body} {turning}");
        assert_eq!(reply.1, verdict, "{body} {turning}");
    }
    let spin = bifdiag("critical-spin --A 1,2,3 --r 1.2,0.8,0 --axis=-0.6,-0.8,0 --json").succeeds().json();
    let [one] = spin["steady"].as_array().unwrap().as_slice() else { panic!("{spin}") };
    assert_eq!((&one["stability"], &one["stable"]), (&json!("zero"), &json!("energy")));
    assert_eq!(one["spin"]["rad_per_s"], json!(1.0));
}

/// The nearest double of 30/π rpm is the threshold of 1 rad/s, but no decimal is: π is not rational.
#[test]
fn only_the_root_itself_is_at_the_threshold() {
    let body = "--A 1,2,3 --r 0,0,1";
    let state = |spin: &str| steady(body, "--axis z", spin);
    assert_eq!(state("1 rad/s")["at"]["kind"], json!("stability-and-region"));
    for (spin, side, kind) in [
        ("9.549296585513720146133025802 rpm", "above", "saddle-centre"),
        ("9.549296585513720146133025803 rpm", "below", "elliptic"),
        ("0.999999999999999999999999 rad/s", "above", "saddle-centre"),
    ] {
        let found = state(spin);
        assert_eq!((found.get("at"), &found["stability"]), (None, &json!(kind)), "{spin} {found}");
        assert!((found[side]["spin"]["rad_per_s"].as_f64().unwrap() - 1.0).abs() < 1e-12, "{spin} {found}");
    }
    let reply = bifdiag(&format!("state {body} --axis z --spin")).and("1 rad/s").succeeds();
    reply.printing("this spin is a threshold: saddle-centre below, elliptic (local minimum) above");
    // Beside the axis: the nearest steady rotation is judged as exactly.
    let beside = bifdiag(&format!("state {body} --axis 1e-3,0,1 --json --spin")).and("1 rad/s").succeeds().json();
    assert_eq!(beside["nearest"]["at"]["kind"], json!("stability-and-region"), "{beside}");
}

/// Without weight rotation about the axes of equal moments is one of a circle, which is stable.
#[test]
fn free_bodies_with_equal_moments_turn_steadily_about_a_circle_of_axes() {
    for (body, axis) in [("2,2,1", "1,0,0"), ("3,3,1", "1,2,0"), ("2,1,1", "0,1,0"), ("2,1,1", "0,3,4")] {
        let body = format!("--A {body} --r 0,0,0");
        let found = steady(&body, &format!("--axis {axis}"), "1 rad/s");
        assert_eq!((&found["stability"], &found["one_of"]), (&json!("elliptic"), &json!("circle")), "{found}");
        assert_ne!(found["stable"], json!(false), "{found}");
        assert!(found["growth_time_s"].is_null(), "{found}");
        let spins = bifdiag(&format!("critical-spin {body} --axis {axis} --json")).succeeds().json();
        let slow = spins["slow"].as_array().unwrap();
        assert!(slow.iter().all(|kind| kind.as_str().unwrap().starts_with("elliptic")), "{spins}");
        let reply = bifdiag(&format!("state {body} --axis {axis} --spin")).and("1 rad/s").succeeds();
        reply.printing("it is one of a circle of steady rotations").printing("frequency of small oscillations: 0.");
    }
}

/// At |ω| = √½ or √2 a pair leaves the axis: neither the axis of the pair nor its type is that of a rounded spin, and the
/// regions are those of the same rotation at a rational spin.
#[test]
fn a_fork_at_an_irrational_spin_is_judged_as_at_a_rational_one() {
    for (irrational, rational) in [
        (
            "--A 3,5,8 --r 0,1,0 --omega 0.5,0.5,0 --vertical 1,1,0",
            "--A 3,5,8 --r 0,2,0 --omega 0.6,0.8,0 --vertical 1,1,0",
        ),
        (
            "--A 2,3,4 --r 2,0,0 --omega 1,1,0 --vertical=-1,1,0",
            "--A 2,3,4 --r 1,0,0 --omega 0.6,0.8,0 --vertical=-1,1,0",
        ),
        (
            "--A 2,2,1 --r 0,0,0.5 --omega 0.5,0,0.5 --vertical=-1,0,-1",
            "--A 2,2,1 --r 0,0,1 --omega 0.6,0,0.8 --vertical=-1,0,-1",
        ),
        (
            "--A 3,5,8 --r 0,1,0 --omega 0.5,0.5,0 --vertical 0,1,0",
            "--A 3,5,8 --r 0,2,0 --omega 0.6,0.8,0 --vertical 0,1,0",
        ),
        // Axes that are steady at this spin only: a pair leaves them, hanging and upright, and two of them meet.
        (
            "--A 4,3,2 --r 0,3,8 --omega 2,1,0 --vertical 0,-0.6,-0.8",
            "--A 4,3,2 --r 0,15,40 --omega 3,4,0 --vertical 0,-0.6,-0.8",
        ),
        (
            "--A 2,3,4 --r 0,3,8 --omega 2,1,0 --vertical 0,0.6,0.8",
            "--A 2,3,4 --r 0,15,40 --omega 3,4,0 --vertical 0,0.6,0.8",
        ),
        (
            "--A 2,3,4 --r 0,27,64 --omega 10,5,0 --vertical 0,-3,4",
            "--A 2,3,4 --r 0,135,320 --omega 15,20,0 --vertical 0,-3,4",
        ),
    ] {
        let [found, expected] = [irrational, rational]
            .map(|line| bifdiag(&format!("state {line} --json")).succeeds().json()["nearest"].clone());
        for field in ["axis", "stability", "nonlinear", "regions", "one_of"] {
            assert_eq!(found[field], expected[field], "{irrational}: {field}");
        }
    }
}

/// A pair leaves the axis, or it ends in a cusp, at Ω² = 1 in some unit of time, whatever Ω is in another one.
#[test]
fn an_axis_that_is_steady_at_one_spin_is_judged_in_every_unit_of_time() {
    for (body, centers, kind) in [
        ("4,3,2", ["0,0.6,1.6", "0,0.3,0.8", "0,1.2,3.2", "0,6,16", "0,3,8"], "stable (minimum of energy): zero"),
        (
            "2.4,2,3",
            [
                "0,9/1375,-1088/1375",
                "0,45/1375,-5440/1375",
                "0,18/1375,-2176/1375",
                "0,27/1375,-3264/1375",
                "0,63/1375,-7616/1375",
            ],
            "open (degenerate): zero",
        ),
    ] {
        for center in centers {
            bifdiag(&format!("critical-spin --A {body} --r {center} --axis 0,-3,-4")).succeeds().printing(kind);
        }
    }
}

/// Where |n| is irrational, so is Ω² = |n| |n × r|/|n × An|: the forks and the cusp were found by hand.
#[test]
fn an_axis_that_is_steady_at_a_spin_with_an_irrational_square_is_judged_exactly() {
    for (line, kind) in [
        ("--A 2,3,4 --r 0,1,2 --axis 0,1,1", "unstable: zero"),
        ("--A 2,3,4 --r 0,3,6 --axis 0,5,5", "unstable: zero"),
        ("--A 4,3,2 --r 0,1,2 --axis 0,-1,-1", "stable (minimum of energy): zero"),
        ("--A 4,3,2 --r 0,1/7,2/7 --axis 0,-2,-2", "stable (minimum of energy): zero"),
        ("--A 2.4,2,3 --r 0,1,-9 --axis 0,-1,-1", "open (degenerate): zero"),
        ("--A 2.4,2,3 --r 0,5,-45 --axis 0,-1,-1", "open (degenerate): zero"),
    ] {
        bifdiag(&format!("critical-spin {line}")).succeeds().printing(kind);
    }
}

/// The equations know ratios alone.
#[test]
fn tiny_and_huge_bodies_turn_as_bodies_of_size_one() {
    let state = |size: &str| {
        let body = format!("--A 1{size},2{size},2.5{size} --r 0,0,1{size} --axis z");
        let found = bifdiag(&format!("state {body} --json --spin")).and("1 rad/s").succeeds().json();
        ["growth_time_s", "frequencies_hz"].map(|field| found["steady"][field].clone())
    };
    let [growth, frequencies] = state("");
    assert!(
        (growth.as_f64().unwrap() - 1.540_221).abs() < 1e-6 && frequencies[1].as_f64().unwrap() > 0.086,
        "{frequencies}"
    );
    for size in ["e-90", "e-140", "e90", "e140"] {
        assert_eq!(state(size), [growth.clone(), frequencies.clone()], "{size}");
    }
}

/// A principal axis off the centre of mass is steady at no spin, whatever its digits are in the frame of the part.
#[test]
fn an_axis_of_a_tilted_part_is_principal_where_its_tensor_says_so() {
    let part = "--inertia 1,44162/28561,443771/285610,0,0,-12852/28561 --products tensor --com 0,-61/507,-199/338 --mass 1 --g 1";
    let found = bifdiag(&format!("critical-spin {part} --unphysical --axis 0,120/169,119/169")).succeeds();
    found.printing("this axis is principal, but the centre of mass does not lie on it");
}

/// The curve of a pair is 1e-40 from that of the axis there.
#[test]
fn regions_beside_a_rotation_next_to_a_fork_are_exact() {
    for (spin, below) in [("0.99999999999999999999", "R3"), ("0.999999999", "R3"), ("1.00000000000000000001", "R1")] {
        let state = bifdiag("state --A 8,5,11 --r 3,0,0 --axis x --spin").and(format!("{spin} rad/s")).succeeds();
        state.printing(&format!("regions beside it: {below} below, "));
    }
}
