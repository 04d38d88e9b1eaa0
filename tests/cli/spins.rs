//! Steady rotations: `state`, `critical-spin`, `campbell` and `critical` say the same.

use bifdiag_body::{Body, Number};
use serde_json::{Value, json};
use support::property::holds_for_bodies;
use support::strata::STRATA;

use crate::builder::bifdiag;

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

pub fn near(p: f64, q: f64, size: f64) -> bool {
    (p - q).abs() <= 1e-6 * size
}

/// The vertical is the direction of the question: it has no end called -axis.
#[test]
fn a_vertical_that_has_to_point_down_is_reported_so() {
    let reply = bifdiag("state --body paper --axis=-1,0,0.2 --spin").and("2 rad/s").succeeds().stdout();
    assert!(reply.contains("rpm, with its other end up") && !reply.contains("-axis"), "{reply}");
}

/// Of what is degenerate and of circles the table says what they stand for.
#[test]
fn degenerate_points_and_circles_are_explained() {
    let fork = bifdiag("critical --A 1,2,3 --r 0,0,1 --l 3").succeeds();
    fork.printing("mult 2: degenerate; several critical points meet in it: two at a cusp, three at a pitchfork");
    bifdiag("critical --body lagrange --l 3").succeeds().printing("circle: a whole circle of relative equilibria");
    bifdiag("critical --A 1,2,2 --r 0,0,0 --l 1").succeeds().printing("circle: a whole circle");
    let none = bifdiag("critical --body paper --l 3.25").succeeds().stdout();
    assert!(!none.contains("mult 2") && !none.contains("circle"), "{none}");
}

/// At a range each line is the answer at one momentum.
#[test]
fn a_range_of_momenta_is_a_line_of_json_each() {
    let lines = bifdiag("critical --body paper --l 0:4:9 --json").succeeds().json_lines();
    assert_eq!(lines.len(), 9);
    for (k, line) in lines.iter().enumerate() {
        let one = bifdiag(&format!("critical --body paper --l {k}/2 --json")).succeeds().json();
        assert_eq!(line["critical"], one["critical"]);
    }
    bifdiag("critical --body paper --l 3.25").succeeds().printing("±0.4807").printing("eigenvalues");
}

/// A body that hangs at rest is in equilibrium, and turns unsteadily nowhere.
#[test]
fn a_body_at_rest_on_its_axis_is_steady() {
    let state = bifdiag("state --A 2,3,1.5 --r 0,0,1 --axis=-z --json --spin").and("0 rpm").succeeds().json();
    assert_eq!(state["steady"]["stable"], json!("energy"), "{state}");
}

/// A body without weight at rest: every orientation will do.
#[test]
fn a_free_body_rests_in_every_orientation() {
    let at_rest = bifdiag("state --A 1,2,3 --r 0,0,0 --axis 1,1,1 --spin").and("0 rpm").succeeds();
    at_rest.printing("at rest every orientation is an equilibrium");
    // About the middle axis it is unstable as soon as it turns.
    let middle = bifdiag("state --A 5,3,4 --r 0,0,0 --axis z --spin").and("0 rpm").succeeds();
    let middle = middle.printing("this verdict is that of rest; rotation about this axis, however slow, has its own");
    assert!(!middle.stdout().contains("no change at any"), "{}", middle.stdout());
    bifdiag("critical --A 1,2,3 --r 0,0,0 --l 0").succeeds().printing("at rest every orientation is an equilibrium");
    bifdiag("critical --A 2,2,2 --r 0,0,0 --l 1").succeeds().printing("rotation about every axis is a relative equil");
    let turning = bifdiag("state --A 2,2,2 --r 0,0,0 --axis 1,1,1 --spin").and("1 rpm").succeeds();
    turning.printing("rotation about every axis is steady");
}

/// Where the pair has its cusp at its pitchfork, U_l has no minimum: U = 3 − s⁶/32 + …, s the sine of the tilt.
#[test]
fn friction_at_a_pitchfork_with_a_cusp_is_told_alike() {
    for body in ["--A 2,3,4 --r 0,0,1", "--A 3,3,4 --r 0,0,1", "--A 3,2,4 --r 0,0,1"] {
        let at_spin = bifdiag(&format!("state {body} --axis z --json --spin")).and("1 rad/s").succeeds().json();
        let at_l = bifdiag(&format!("critical {body} --l 4 --json")).succeeds().json();
        let there = |found: &&Value| near(number(&found["h"]), 3.0, 1.0) && number(&found["gamma"][2]) == -1.0;
        let found = at_l["critical"].as_array().unwrap().iter().find(there).unwrap();
        let friction = |found: &Value| found["friction"]["conserving_l"].clone();
        assert_eq!([&at_spin["steady"], found].map(friction), [json!("lost"), json!("lost")], "{body}");
    }
}

/// |ω| = √2 is the threshold itself: of Lagrange's top Ω² = 4 A1 r/A3², beside a pitchfork Ω² = r/(A2 − A1).
#[test]
fn a_threshold_whose_square_is_rational_is_met_exactly() {
    let at = |line: &str| bifdiag(&format!("state {line} --omega 1,1,0")).succeeds().stdout();
    let sleeping = at("--A 2,2,1 --r 0,0,0.25 --vertical=0,0,1");
    assert!(sleeping.contains("stable (a further integral): double-elliptic"), "{sleeping}");
    let forked = at("--A 2,3,4 --r 2,0,0 --vertical=-1,0,0");
    assert!(forked.contains("open (degenerate): zero"), "{forked}");
}

/// Which axis is meant, and at which spin and with which end up the nearest one turns steadily.
#[test]
fn another_axis_than_the_given_one_is_reported() {
    let state =
        |axis: &str| bifdiag(&format!("state --A 1,2,3 --r 0,0,1 --axis={axis} --spin")).and("3 rad/s").succeeds();
    state("1e-8,0,1").printing("about (0, 0, 1), an axis 5.73e-7° from the vertical");
    assert!(!state("z").stdout().contains("using the nearest"));
    state("1e-3,0,1").printing("the motion is not a steady rotation about the vertical");
    let cone = "--A 2,3,1 --r 1,2,0";
    let off = bifdiag(&format!("state {cone} --axis 1,1,0 --spin")).and("5 rad/s").succeeds();
    off.printing("rotation about the vertical is steady at one spin only: 11.356091 rpm, with this end up");
    let never = bifdiag(&format!("state {cone} --axis 1,2,3 --spin")).and("5 rad/s").succeeds();
    never.printing("rotation about the vertical is steady at no spin");
    let rests = "the body rests with either end up, but rotation about";
    for spin in ["5 rad/s", "0 rpm"] {
        let through_com = bifdiag(&format!("state {cone} --axis 1,2,0 --spin")).and(spin).succeeds();
        through_com.printing(&format!("{rests} the vertical is steady at no spin"));
    }
    let slow = bifdiag(&format!("state {cone} --axis 1,2,0 --spin")).and("1e-9 rpm").succeeds();
    slow.printing("steady rotation, ").printing("at this spin the axis of a steady rotation is within 10⁻⁶ rad of it");
    for (axis, up) in [("1,1.01,0.1", "+axis"), ("-1,-1.01,-0.1", "-axis")] {
        let found = bifdiag(&format!("critical-spin {cone} --axis={axis} --json")).succeeds().json();
        assert_eq!(found["nearest"]["up"], json!(up), "{found}");
        assert!(number(&found["nearest"]["spin"]["rad_per_s"]) > 1.0, "{found}");
    }
    let reply = bifdiag(&format!("critical-spin {cone} --axis=-1,-1.01,-0.1")).succeeds();
    reply.printing(" rpm only, with its other end up");
}

/// At the spin of a fold, the axis in which two meet may be the nearest, and is listed once.
#[test]
fn the_nearest_steady_axis_may_be_that_of_a_fold() {
    let part = "--inertia 4,4.5,4,0,1,0 --products tensor --com 0.1,0,0 --mass 1 --g 10";
    let found = bifdiag(&format!("state {part} --axis 0,3,4 --spin")).and("1 rad/s").succeeds();
    found.printing("the axis of the nearest steady rotation is (0, 0, 1), 36.9° from the vertical");
    let body = "--A 3,4.5,5 --r 0.432,0,1.024";
    let found = bifdiag(&format!("state {body} --axis=-0.6,0.1,0.8 --spin")).and("1 rad/s").succeeds();
    assert!(!found.stdout().contains("equally near"), "{}", found.stdout());
    found.printing("is (-0.6, 0, 0.8), 5.71° from the vertical");
}

/// A motion that is not steady is not along the axis either, however small the angle.
#[test]
fn the_angle_to_the_nearest_axis_is_not_rounded_to_nothing() {
    let found = bifdiag("state --A 5,4,3 --r 1,0,0 --omega 1.5,0,0 --vertical 1,1e-6,0").succeeds();
    found.printing("not a steady rotation").printing("(1, 0, 0), 5.73e-5° from the vertical");
}

/// A standing top that turns fast about its largest moment lies in a minimum of U_l, but hanging it has less energy.
#[test]
fn a_local_minimum_is_not_called_the_least() {
    let found = bifdiag("critical-spin --A 1,2,3 --r 0,0,1 --axis z").succeeds();
    assert!(!found.stdout().contains("least"), "{}", found.stdout());
    found.printing("elliptic (local minimum)");
}

#[test]
fn only_pairs_that_oscillate_have_frequencies() {
    let state = |line: &str, spin: &str| bifdiag(&format!("state {line} --spin")).and(spin).succeeds().stdout();
    let body = "--A 1,2,3 --r 0,0,1 --axis z";
    assert!(!state(body, "0.3 rad/s").contains("Hz"), "two real pairs");
    assert!(state(body, "0.8 rad/s").contains("frequency of small oscillations: 0."));
    assert!(state(body, "3 rad/s").contains("frequencies of small oscillations: 0."));
    assert!(state("--A 1,1,2 --r 0,0,1 --axis z", "3 rad/s").contains(" Hz, twice, seen"));
    assert!(state("--A 1,1,0.5 --r 0,0,1 --axis z", "3 rad/s").contains("frequency of oscillations that grow: 0."));
    let directory = tempfile::tempdir().unwrap();
    let run = bifdiag(&format!("campbell {body} --to")).and("0.9 rad/s").inside(directory.path()).succeeds();
    run.printing("saddle to saddle-centre").printing("the next change of type is at 9.5492966 rpm, beyond --to");
    // A change at the end of the range, to its rounding, is in it.
    let elsewhere = tempfile::tempdir().unwrap();
    let at_end = bifdiag("campbell --A 1,2,3 --r=1,0,0 --axis=-x --no-plot --to").and("1 rad/s");
    at_end.inside(elsewhere.path()).succeeds().printing("\n9.5492966 rpm: ");
    let csv = std::fs::read_to_string(directory.path().join("bifdiag-out/campbell.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!((&rows[0][1..3], rows[399][1]), (&["NaN", "NaN"][..], "NaN"));
    assert!(rows[399][2].parse::<f64>().unwrap() > 0.08, "{:?}", rows[399]);
}

#[test]
fn the_spins_of_campbells_diagram_are_checked() {
    let directory = tempfile::tempdir().unwrap();
    let run = |moments: &str, to: &str| {
        let run = bifdiag(&format!("campbell --A {moments} --r 0,0,1 --axis z --to")).and(to);
        run.inside(directory.path()).refused().printing_nothing()
    };
    run("1,2,3", "0 rpm").telling("the largest spin must be greater than 0");
    run("1,2,3", "-10 rpm").telling("the largest spin must be greater than 0");
    // A frequency of 1e449.
    run("1e-150,1e-150,1e150", "1e149 rad/s").telling("overflow");
    let other = bifdiag("campbell --A 1,2,3 --r 0,1,0 --axis 0,1,0.1 --to").and("1 Hz").refused();
    other.telling("the nearest permanent axis is (0, 1, 0), 5.71° away");
}

/// A pole that enters U changes the section, not U.
#[test]
fn on_a_pole_line_the_section_changes() {
    let directory = tempfile::tempdir().unwrap();
    let sphere = |line: &str| bifdiag(&format!("sphere {line}")).inside(directory.path()).succeeds();
    // J(r̂) = 1.36, so that the lines at l = 1.36 are h = 0.68 ± 1.
    for h in ["-0.32", "1.68"] {
        sphere(&format!("--A 2,1.1,1 --r 0.6,0,0.8 --l 1.36 --h={h}")).printing("a pole lies on ∂U, P changes here");
    }
    // A pole line that is a critical curve, and a critical curve alone.
    sphere("--A 2,2,1 --r 0,0,1 --h 1.5 --l 1").printing("on a curve of the bifurcation diagram");
    sphere("--A 2,1,1 --r 0,0,0 --h 0.25 --l 1").printing("on a curve of the bifurcation diagram");
}

/// Without weight U is the same everywhere at these moments: rounding drew thousands of patches.
#[test]
fn a_sphere_on_which_u_is_constant_has_no_pattern() {
    let directory = tempfile::tempdir().unwrap();
    let sphere = |line: &str| bifdiag(&format!("sphere {line}")).inside(directory.path()).succeeds();
    sphere("--A 1,1,1 --r 0,0,0 --h 0.5 --l 1 --out s");
    let svg = std::fs::read_to_string(directory.path().join("s/sphere.svg")).unwrap();
    // It is on a curve, where no component has a number.
    assert!(svg.len() < 300_000 && !svg.contains(">1<"), "{} bytes", svg.len());
    // Rounded numbers are reported to be, with a minus sign.
    sphere("--A 2,2,1 --r 0,0,1 --h=-0.2600090312791064 --l 1.1 --out s");
    let svg = std::fs::read_to_string(directory.path().join("s/sphere.svg")).unwrap();
    assert!(svg.contains("h ≈ −0.260009") && !svg.contains("-0.2600090312791064"));
}

/// `show` and `critical` say the same of a curve.
#[test]
fn a_curve_is_judged_in_the_words_of_a_state() {
    bifdiag("show L+.1 --A 2,2,1 --r 0,0,1")
        .succeeds()
        .printing("elliptic, stable (minimum of energy); with friction stable");
    bifdiag("show S23.1 --A 2,1,1 --r 0,0,0").succeeds().printing("elliptic, stable (a further integral)");
    bifdiag("show L- --A 25,1,1 --r 0,0,1")
        .succeeds()
        .printing("elliptic, stable (Arnold's theorem); with friction unstable in 2 directions");
    bifdiag("show L-.1 --A 1,2,3 --r 0,0,1").succeeds().printing("saddle, unstable; with friction unstable in 2");
}

/// Forks where f64 finds no regions: the exact atlas has them.
#[test]
fn regions_beside_a_spin_are_those_of_the_exact_atlas() {
    let body = "--A 1,1.4,0.74999999999 --r 1,0,0";
    let found = bifdiag(&format!("critical-spin {body} --axis 1,0,0 --json")).succeeds().json();
    assert_eq!(found.get("note"), None, "{found}");
    let forks = found["changes"].as_array().unwrap().iter().filter(|change| change["event"] == json!("fork"));
    let spins: Vec<f64> = forks.map(|change| number(&change["spin"]["rad_per_s"])).collect();
    for expected in [2.0, 2.5_f64.sqrt()] {
        assert!(spins.iter().any(|spin| near(*spin, expected, 1.0)), "{found}");
    }
    let state = bifdiag(&format!("state {body} --axis 1,0,0 --json --spin")).and("3 rad/s").succeeds().json();
    assert!(state["steady"]["regions"][1].is_string() && state["steady"].get("note").is_none(), "{state}");
    let directory = tempfile::tempdir().unwrap();
    bifdiag(&format!("sphere {body} --region R1")).inside(directory.path()).succeeds().printing("region R1");
}

/// Every relative equilibrium is a steady state at its spin, with the same h, l and verdict, and its axis has that spin.
#[test]
fn steady_rotations_are_the_relative_equilibria() {
    for stratum in STRATA {
        holds_for_bodies(stratum, 2, |body: &Body| {
            let join = |numbers: &[Number; 3]| numbers.each_ref().map(|n| n.text().to_owned()).join(",");
            let options = format!("--A {} --r={}", join(body.moments()), join(body.center()));
            let largest = |v: [f64; 3]| v.into_iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let (a, r) = (largest(body.moments_f64()), largest(body.center_f64()));
            let l = 1.3 * (a * if r > 0.0 { r } else { a }).sqrt();
            let all = bifdiag(&format!("critical {options} --l {l:?} --json")).succeeds().json();
            for point in all["critical"].as_array().unwrap() {
                let up: Vec<f64> = point["gamma"].as_array().unwrap().iter().map(|x| -number(x)).collect();
                let omega = number(&point["omega"]);
                let text = |factor: f64| up.iter().map(|x| format!("{:?}", factor * x)).collect::<Vec<_>>().join(",");
                let (line, spin) = (format!("--vertical={} --omega={}", text(1.0), text(omega)), omega.abs());
                let state = bifdiag(&format!("state {options} {line} --json")).succeeds().json();
                let steady = &state["steady"];
                assert!(!steady.is_null(), "{stratum:?} {options} {line}\n{state}");
                let size = r + l * spin;
                assert!(
                    near(number(&steady["h"]), number(&point["h"]), size),
                    "{stratum:?} {options}\n{state}\n{point}"
                );
                assert!(near(number(&steady["l"]).abs(), l, l), "{stratum:?} {options}\n{state}");
                let unstable = point["stable"] == json!(false);
                assert_eq!(steady["stable"] == json!(false), unstable, "{stratum:?} {options}\n{state}\n{point}");
                let found = bifdiag(&format!("critical-spin {options} --axis={} --json", text(1.0))).succeeds().json();
                let listed = |steady: &Value| {
                    steady["up"] == json!("+axis") && near(number(&steady["spin"]["rad_per_s"]), spin, 1e3 * spin)
                };
                let known = found["permanent"] == json!(true)
                    || found["steady"].as_array().is_some_and(|list| list.iter().any(listed));
                assert!(known, "{stratum:?} {options} {line}\n{found}");
            }
            Ok(())
        });
    }
}

/// At rest the fallback lost the angle to the axis, and a body beside its equilibrium was reported as steady.
#[test]
fn a_body_at_rest_beside_its_equilibrium_is_not_steady() {
    let state = "state --A 1.3,2.1,1.6 --r 0,1,0 --omega 0,0,0 --vertical 1,-1,0";
    let text = bifdiag(state).succeeds().printing("the motion is not a steady rotation about the vertical");
    text.printing("(0, -1, 0), 45° from the vertical");
    assert!(bifdiag(&format!("{state} --json")).succeeds().json()["steady"].is_null());
}

/// There are frequencies over the spin, of rotations none of which is nearer than the others.
#[test]
fn an_axis_across_all_steady_axes_has_none_nearest() {
    let (body, why) = ("--A 2,2,3 --r 1,0,2", "at fast spins all steady axes are perpendicular to the given one");
    let refused = bifdiag(&format!("campbell {body} --axis y --no-plot --to")).and("60 rpm").refused();
    refused.telling(why).telling("such as one of (1, 0, 0)");
    bifdiag(&format!("critical-spin {body} --axis y")).succeeds().printing(&format!("note: {why}"));
    assert!(!bifdiag(&format!("critical-spin {body} --axis x")).succeeds().stdout().contains("note:"));
}

/// 0.6 · 4 − 0.8 · 3 is 0 with the decimals that were given, and not with their doubles.
#[test]
fn a_vertical_momentum_that_is_zero_is_printed_so() {
    let body = "--A 4,4,1 --r 1,1,0";
    for state in [
        format!("{body} --omega 1,1,-3 --vertical=-0.6,0,-0.8"),
        "--A 2,2,4 --r 0,0,1 --omega 1.2,0.9,0 --vertical 0.6,-0.8,0".to_owned(),
    ] {
        bifdiag(&format!("state {state}")).succeeds().printing(", l = 0 about the upward vertical");
    }
    for start in
        ["--gamma 0.6,0,0.8 --omega 1,1,-3", "--gamma 3,0,4 --l-vector 4,4,-3", "--gamma 0.6,0,0.8 --l-vector 4,4,-3"]
    {
        bifdiag(&format!("orbit {body} {start} --times 0:1:2")).succeeds().printing(", l = 0\n");
    }
    bifdiag(&format!("orbit {body} --gamma 0.6,0,0.8 --omega 1,1,-2.9 --times 0:1:2"))
        .succeeds()
        .printing(", l = 0.08\n");
}

/// Of a symmetric pair of steady axes each end of the given axis has its own; a circle of axes is listed once.
#[test]
fn each_end_has_its_own_axis_of_a_pair() {
    for (body, axis, k) in [("--A 2,3,4 --r 0,0,1", "1,0,0", 0), ("--A 2,3,5 --r 1,1,0", "0,0,1", 2)] {
        let found = bifdiag(&format!("critical-spin {body} --axis={axis} --json")).succeeds().json();
        let families = found["families"].as_array().unwrap();
        let ends: Vec<f64> = families.iter().map(|family| family["fast_axis"][k].as_f64().unwrap()).collect();
        assert_eq!(ends, [1.0, -1.0], "{body}");
        // Where a type begins, too.
        for (plus, minus) in
            families[0]["stretches"].as_array().unwrap().iter().zip(families[1]["stretches"].as_array().unwrap())
        {
            let axis = |stretch: &Value| Some(stretch["from"].as_object()?["axis"].as_array()?.clone());
            let Some((plus, minus)) = axis(plus).zip(axis(minus)) else { continue };
            let sum = plus[k].as_f64().unwrap() + minus[k].as_f64().unwrap();
            assert!(sum == 0.0 && plus[(k + 1) % 3] == minus[(k + 1) % 3], "{plus:?} {minus:?}");
        }
    }
    let place = tempfile::tempdir().unwrap();
    for (axis, end) in [("1,0,0", "(1, 0, 0)"), ("-1,0,0", "(-1, 0, 0)")] {
        let line = format!("campbell --A 2,3,4 --r 0,0,1 --axis={axis} --no-plot --to");
        bifdiag(&line)
            .and("900 rpm")
            .inside(place.path())
            .succeeds()
            .printing(&format!("and tends to {end} at fast spins"));
    }
    // Both have the same exceptions, which are reported once.
    let reply = bifdiag("critical-spin --A 5,2,3 --r 1,0,0 --axis y").succeeds().stdout();
    assert_eq!(reply.matches("  S2: 9.665702 rpm (1:3 resonance): stable").count(), 1, "{reply}");
    assert_eq!(reply.matches("(D4 = 0)").count(), 2, "{reply}");
    let circle = bifdiag("critical-spin --A 2,2,3.5 --r 0,0,0.4 --axis x --json").succeeds().json();
    assert_eq!(circle["families"].as_array().unwrap().len(), 1);
}

/// What eight digits of rpm do not tell is said as it was given.
#[test]
fn a_spin_is_printed_as_given_where_digits_are_lost() {
    let given = [
        ("99999998 deg/s", "1.6666666e7 rpm = 1745329.2 rad/s, given as 99999998 deg/s"),
        ("123456789 rpm", "rad/s, given as 123456789 rpm"),
        ("10 Hz", "spin 600 rpm = 62.831853 rad/s\n"),
        ("360 deg/s", "spin 60 rpm = 6.2831853 rad/s\n"),
    ];
    for (spin, printed) in given {
        bifdiag("state --A 1,2,3 --r=1,0,0 --axis=-x --spin").and(spin).succeeds().printing(printed);
    }
}

/// Within 10⁻⁶ rad of a steady axis a vertical has its own one spin, which is another.
#[test]
fn the_spin_of_a_vertical_near_a_steady_axis_is_its_own() {
    let own = "rotation about the vertical is steady at one spin only: 9301.0315 rpm, with this end up";
    for spin in ["10000 rpm", "20000 rpm"] {
        let near = bifdiag("state --body paper --axis 0.000001,0,1 --spin").and(spin).succeeds();
        near.printing(own).printing("the axis of a steady rotation is within 10⁻⁶ rad of the vertical");
    }
    bifdiag("critical-spin --body paper --axis 0.000001,0,1").succeeds().printing("at one spin only: 9301.0315 rpm");
    // Beside the cone a vertical has no spin.
    let beside = bifdiag("state --body paper --axis 0.0000001,0.0000009,1 --spin").and("20000 rpm").succeeds().stdout();
    assert!(!beside.contains("steady at one spin only"), "{beside}");
    // Ω² = (e×r)·(e×Ae)/|e×Ae|² = 1 exactly for this axis.
    let exact = bifdiag("state --A 20,45,40 --r 5.4,12.8,0 --axis=-0.6,0.8,0 --spin").and("1 rad/s").succeeds();
    exact.printing("rotation about this axis is steady at this spin only");
}

/// Spins beyond f64 are wrong input in a range, too, and are told in the unit that was typed.
#[test]
fn ranges_of_spins_beyond_f64_are_refused() {
    for output in ["", " --json", " --out a.csv", " --out a.svg"] {
        let line = format!("critical --body paper{output} --spin");
        bifdiag(&line).and("0:1e60:3 rpm").refused().telling(" rpm is too fast").telling("to 2.27273e44 rad/s");
    }
    let slow = bifdiag("campbell --body paper --axis 0,0,-1 --no-plot --to").and("5.5e-46 rad/s").refused();
    slow.telling("give a spin from 9.22747e-39 to 2.27273e44 rad/s");
}

/// Four families begin in one place where a symmetry makes two folds of one.
#[test]
fn a_fold_does_not_count_its_axes() {
    let symmetric = bifdiag("critical-spin --A 4,3,2 --r 1,0,1").succeeds();
    let symmetric = symmetric.printing("2 below 11.356091 rpm, 6 at faster spins");
    symmetric.printing("fold: at this spin steady axes appear in one place; just below it they do not exist");
}

/// Exactly at its cusp a circle has index 0 and is no minimum.
#[test]
fn a_degenerate_circle_is_said_to_be_no_minimum() {
    let sentence = "degenerate: S12.1, no minimum in spite of index 0";
    bifdiag("critical --A 3,3,21/4 --r 0,0,6 --l 8").succeeds().printing(sentence);
    let beside = bifdiag("critical --A 3,3,21/4 --r 0,0,6 --l 8.01").succeeds().stdout();
    assert!(!beside.contains("degenerate"), "{beside}");
}
