//! The axes about which a body turns steadily: all of them at a spin, over spins, and beside a permanent one.

use serde_json::{Value, json};

use super::spins::{near, number};
use crate::builder::bifdiag;

/// On Staude's cone, off the principal axes: s(u × Au) = u × r with s = √2.
#[test]
fn an_axis_of_staudes_cone_is_steady_at_one_spin() {
    let body = "--A 2,3,1 --r 1,2,0";
    for (axis, up) in [("1,1,0", "+axis"), ("-1,-1,0", "-axis")] {
        let found = bifdiag(&format!("critical-spin {body} --axis={axis} --json")).succeeds().json();
        let [steady] = found["steady"].as_array().unwrap().as_slice() else { panic!("{found}") };
        assert_eq!((&found["permanent"], &steady["up"]), (&json!(false), &json!(up)));
        // ⁴√2 and 5⁄2 of it, to the last digits: the axis lies on the cone itself.
        let omega = 2.0_f64.sqrt().sqrt();
        assert!((number(&steady["spin"]["rad_per_s"]) - omega).abs() < 1e-14, "{found}");
        assert!((number(&steady["l"]) - 2.5 * omega).abs() < 1e-14, "{found}");
        assert_eq!(found.get("nearest"), None, "{found}");
    }
    bifdiag(&format!("critical-spin {body} --axis 1,1,0")).succeeds().printing("steady at one spin only: 11.356");
    // Every axis with u₁ = u₂ lies on it: (1, 1, 1) × (2, 3, 1) = (1, 1, 1) × r.
    let other = bifdiag(&format!("critical-spin {body} --axis 1,1,1 --json")).succeeds().json();
    let spin = number(&other["steady"][0]["spin"]["rad_per_s"]);
    assert!((spin - 3.0_f64.sqrt().sqrt()).abs() < 1e-14, "{other}");
    let off = bifdiag(&format!("critical-spin {body} --axis 1,2,3 --json")).succeeds().json();
    assert_eq!(off["steady"], json!([]));
    bifdiag(&format!("critical-spin {body} --axis 1,2,3")).succeeds().printing("is steady at no spin");
    let turned = bifdiag("campbell --A 1,2,2.5 --r 0,-1,0 --axis 1,1.2,0 --to 30rpm").refused();
    turned.telling("rotation about it is steady at one spin only, with its other end up");
}

/// Equal moments make more axes principal than those of the frame; the middle between two planes of the cone is not on it.
#[test]
fn special_bodies_have_the_permanent_axes_of_their_eigenspaces() {
    for (line, permanent) in [
        ("--A 1,1,2 --r 1,1,0 --axis 1,1,0", true),
        ("--A 1,1,2 --r 0,0,0 --axis 1,2,0", true),
        ("--A 1,1,1 --r 1,2,0 --axis 1,2,0", true),
        ("--A 1,1,1 --r 1,2,0 --axis 0,0,1", false),
        ("--A 1,2,3 --r 0,0,1 --axis 1,1,0", false),
        ("--A 2,3,1.5 --r 1,2,0 --axis 1,0,0", false),
        ("--A 1,1,2 --r 0,0,0 --axis 1,1,1", false),
    ] {
        let found = bifdiag(&format!("critical-spin {line} --json")).succeeds().json();
        assert_eq!(found["permanent"], json!(permanent), "{line}");
        assert_eq!(found.get("steady"), (!permanent).then_some(&json!([])), "{line}");
    }
    let midway = bifdiag("critical-spin --A 1,2,3 --r 0,0,1 --axis 1,1,0 --json").succeeds().json();
    assert!(near(number(&midway["nearest"]["angle_deg"]), 45.0, 1.0), "{midway}");
    let state = bifdiag("state --A 1,1,2 --r 0,0,0 --axis 1,1,0 --spin").and("1 rad/s");
    state.succeeds().printing("no change at any larger spin");
}

/// Every axis at a spin, in a part's frame too: each is steady by `state`, and the relative equilibrium of its own l.
#[test]
fn all_steady_axes_at_a_spin_are_listed() {
    let part = "--inertia 3,2.6,4.2,0.2,-0.1,0.15 --products tensor --com 0.02,0.01,0.03 --mass 50 --g 9.80665";
    let paper = "--body paper";
    for (body, spin, count) in [(paper, "2 rad/s", 4), (paper, "6 rad/s", 6), (part, "300 rpm", 6)] {
        let all = bifdiag(&format!("critical {body} --json --spin")).and(spin).succeeds().json();
        let axes = all["axes"].as_array().unwrap();
        assert_eq!(axes.len(), count, "{all}");
        for axis in axes {
            let text: Vec<String> =
                axis["axis"].as_array().unwrap().iter().map(|x| format!("{:?}", number(x))).collect();
            let state = format!("state {body} --axis={} --json --spin", text.join(","));
            let state = bifdiag(&state).and(spin).succeeds().json();
            assert_eq!(state["steady"]["stable"], axis["stable"], "{state}\n{axis}");
            assert!(
                (number(&state["steady"]["h"]) - number(&axis["h"])).abs() < 1e-9 * number(&axis["h"]).abs(),
                "{axis}"
            );
            let same = bifdiag(&format!("critical {body} --l {:?} --json", number(&axis["l"]))).succeeds().json();
            let found = same["critical"].as_array().unwrap().iter().find(|point| point["branch"] == axis["branch"]);
            assert_eq!(found.unwrap()["stability"], axis["stability"]);
        }
    }
    let text = bifdiag("critical --body lagrange --spin").and("300 rpm").succeeds();
    text.printing("steady axes at 300 rpm = 31.415927 rad/s").printing("circle");
    bifdiag("critical --A 1,2,2 --r 0,0,0 --spin").and("1 Hz").succeeds().printing("circle");
    bifdiag("critical --body paper --spin").and("0 rpm").succeeds().printing("at rest").printing("from −r̂");
    let csv = bifdiag("critical --body paper --out - --spin").and("2 rad/s").succeeds().stdout();
    assert!(csv.starts_with("axis1,axis2,axis3,l,h,gamma1,"), "{csv}");
    assert_eq!(csv.lines().count(), 5);
    bifdiag("critical --body paper --l 1 --spin").and("1 Hz").refused().telling("cannot be used with");
    bifdiag("critical --body paper --method newton --spin").and("1 Hz").refused().telling("follows the curves");
}

/// The axes x, y and z of a part need not be principal: the advice names axes that the command then accepts.
#[test]
fn a_free_part_is_reported_its_principal_axes() {
    let part = "critical-spin --inertia 3,2.6,4.2,0.2,-0.1,0.15 --products tensor --com 0,0,0 --mass 50 --g 9.8";
    let reply = bifdiag(&format!("{part} --tolerance 1%")).refused().stderr();
    assert!(!reply.contains("--axis x, y or z"), "{reply}");
    let axes: Vec<&str> = reply.split("--axis=").skip(1).map(|rest| rest.split([' ', ';']).next().unwrap()).collect();
    assert_eq!(axes.len(), 3, "{reply}");
    for axis in axes {
        let found = bifdiag(&format!("{part} --axis={} --json", axis.trim_end_matches(','))).succeeds().json();
        assert_eq!(found["permanent"], json!(true), "{axis}");
    }
}

/// The message gave the momentum that nobody asked for.
#[test]
fn a_spin_out_of_range_is_refused_as_a_spin() {
    for (spin, size) in [("1e100 rad/s", "too fast"), ("1e-100 rad/s", "too slow")] {
        let reply = bifdiag("critical --body paper --spin").and(spin).refused().telling(size).stderr();
        assert!(reply.contains("rad/s, or 0") && !reply.contains("l ="), "{reply}");
    }
    bifdiag("critical --body paper").refused().telling("--l is missing").telling("--spin \"300 rpm\"");
}

/// At a spin of 1e9 rad/s the weight changes h by less than its rounding: the order is still that of h.
#[test]
fn fast_rotations_are_sorted_by_the_weight_too() {
    for line in ["critical --body paper --json --spin=1e9_rad/s", "critical --body paper --json --l 1e9"] {
        let (line, spin) =
            line.split_once('=').map_or((line, None), |(line, spin)| (line, Some(spin.replace('_', " "))));
        let run = bifdiag(line);
        let found = spin.map_or(bifdiag(line), |spin| run.and(spin)).succeeds().json();
        let list = found.get("axes").unwrap_or(&found["critical"]).as_array().unwrap();
        let down: Vec<[f64; 3]> = list.iter().map(|p| [0, 1, 2].map(|k| number(&p["gamma"][k]))).collect();
        // Axis 1 is listed with the centre of mass below the fixed point first, and so is axis 3.
        let ends = |axis: usize| down.iter().filter(|g| g[axis].abs() > 0.9).map(|g| g[axis] > 0.0).collect::<Vec<_>>();
        assert_eq!((ends(0), ends(2)), (vec![true, false], vec![true, false]), "{line} {down:?}");
    }
}

/// The two of a symmetric pair have one h, however fast they turn: γ orders them.
#[test]
fn symmetric_pairs_are_sorted_by_gamma() {
    let fast = "--A 4677/5000,0.245,0.8197483 --r 0,577/500,0 --l 1780306.261344";
    for body in ["--A 1,2,3 --r 0,0,0 --l 2", "--A 1,2,3 --r 0,0,0 --l=-2", fast] {
        let found = bifdiag(&format!("critical {body} --json")).succeeds().json();
        let list = found["critical"].as_array().unwrap();
        let keys: Vec<[f64; 4]> = list
            .iter()
            .map(|p| [number(&p["h"]), number(&p["gamma"][0]), number(&p["gamma"][1]), number(&p["gamma"][2])])
            .collect();
        assert!(keys.is_sorted(), "{body}: {keys:?}");
    }
}

/// Where several axes are as near, one alone is not the nearest; of a circle of axes each is reported to be one.
#[test]
fn ties_and_circles_of_axes_are_reported() {
    let body = "--A 1,2,3 --r 0,0,0 --axis 1,1,1";
    let spins = bifdiag(&format!("critical-spin {body}")).succeeds();
    spins.printing("the nearest permanent axis is (0, 0, 1), 54.7° away\nalso at this angle: (1, 0, 0), (0, 1, 0)\n");
    let state = bifdiag(&format!("state {body} --spin")).and("1 rad/s").succeeds();
    state.printing("equally near: (").printing("; what follows refers to the first");
    let alone = bifdiag("critical-spin --A 1,2,3 --r 0,0,0 --axis 1,1,2").succeeds().stdout();
    assert!(!alone.contains("at this angle"), "{alone}");
    let circle = "it is one of a circle of permanent axes, which are judged as a whole";
    bifdiag("critical-spin --A 1,1,2 --r 0,0,0 --axis x").succeeds().printing(circle);
    bifdiag("critical-spin --A 1,1,2 --r 0,0,0").succeeds().printing(circle);
    let alone = bifdiag("critical-spin --A 1,1,2 --r 0,0,0 --axis z").succeeds().stdout();
    assert!(!alone.contains("circle"), "{alone}");
}

/// With C = 2A = 2B both pairs agree at every spin, whether they are real or imaginary.
#[test]
fn double_pairs_are_called_so_on_every_line() {
    let reply = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z").succeeds();
    reply
        .printing("+axis up double-real, -axis up double-elliptic (local minimum)")
        .printing("double-real  double-elliptic (local minimum)");
    let state = bifdiag("state --A 1,1,2 --r 0,0,1 --axis=-z --spin").and("1 rad/s").succeeds();
    state.printing("stable (minimum of energy): double-elliptic");
    let free = bifdiag("critical-spin --A 1,2,3 --r 0,0,0 --axis z").succeeds();
    free.printing("+axis up double-elliptic (local minimum), -axis up double-elliptic (local minimum)");
    let parts = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z --tolerance 1%").succeeds();
    parts.printing("-axis up, each of these parts is elliptic (local minimum) at every spin");
}

/// By how many degrees a path of an SVG turns at most, written as a place and relative steps in tenths of a pixel; those that
/// are hardly longer than what they are rounded to have no direction.
fn sharpest(path: &str) -> f64 {
    let steps = path.split(['l', '"']).nth(1).unwrap_or("").replace('-', " -");
    let numbers: Vec<f64> = steps.split_whitespace().map(|number| number.parse().unwrap()).collect();
    let steps = numbers.chunks(2).filter(|step| step[0].abs() + step[1].abs() > 6.0);
    let directions: Vec<f64> = steps.map(|step| libm::atan2(step[1], step[0]).to_degrees()).collect();
    directions.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max)
}

/// At a range of spins: a table with the angle from the centre of mass, a line of JSON for each spin, and a picture.
#[test]
fn steady_axes_over_the_spin_are_a_table_and_a_picture() {
    let directory = tempfile::tempdir().unwrap();
    let run = |more: &str| {
        bifdiag(&format!("critical --body paper {more} --spin")).and("0:60:13 rpm").inside(directory.path())
    };
    let csv = run("").succeeds().stdout();
    assert!(csv.starts_with("spin_index,spin_rpm,axis1,axis2,axis3,angle_deg,l,h,gamma1,"), "{csv}");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let count = |index: &str| rows.iter().filter(|row| row[0] == index).count();
    // Folds at 14.15 rpm and a fork at 23.9 rpm; at rest the body hangs or stands.
    assert_eq!(["0", "2", "3", "4", "5", "12"].map(count), [2, 2, 4, 4, 6, 6]);
    let angle = |row: usize| rows[row][5].parse::<f64>().unwrap();
    assert!((angle(0) - 180.0).abs() < 1e-12 && angle(1).abs() < 1e-12, "{rows:?}");
    let lines = run("--json").succeeds().json_lines();
    assert_eq!(lines.len(), 13);
    let one = bifdiag("critical --body paper --json --spin").and("15 rpm").succeeds().json();
    assert_eq!((&lines[3]["axes"], &lines[3]["command"]), (&one["axes"], &one["command"]));
    run("--out axes.svg")
        .succeeds()
        .printing("5 families of steady axes over this range of spins or a part of it")
        .printing("written: axes.svg");
    // Of its five families two are there at slow spins, of which one hangs and one stands.
    let few =
        bifdiag("critical --body paper --out few.svg --spin").and("0:3:4 rpm").inside(directory.path()).succeeds();
    few.printing("2 families of steady axes over this range of spins or a part of it");
    let picture = std::fs::read_to_string(directory.path().join("few.svg")).unwrap();
    assert!(!picture.contains(">S2<") && !picture.contains("stable without friction"), "{picture}");
    let picture = std::fs::read_to_string(directory.path().join("axes.svg")).unwrap();
    for text in [
        "spin in rpm",
        "in degrees",
        "unstable",
        "stable, with friction too",
        "stable without friction",
        ">G2<",
        ">S2<",
    ] {
        assert!(picture.contains(text), "{text}");
    }
    // Also where axes appear, and their lines are vertical, pieces turn little: they turned by forty degrees there.
    let sharpest = picture.split("<path d=\"M").skip(1).filter(|path| path.contains("stroke-width=\"2")).map(sharpest);
    let sharpest = sharpest.fold(0.0, f64::max);
    assert!(sharpest > 0.0 && sharpest < 25.0, "{sharpest} degrees");
    bifdiag("critical --body paper --out axes.svg --spin").and("2 rpm").refused().telling("a picture needs a range");
    bifdiag("critical --body euler --out axes.svg --spin").and("0:2:3 rpm").refused().telling("without weight");
    bifdiag("critical --body paper --spin").and("5:2:3 rpm").refused().telling("write the smaller spin first");
    bifdiag("critical --body paper --spin").and("0:2:3").refused().telling("has none of the units");
}

/// Within half a degree of a permanent axis that axis is followed; the given one may be steady at a spin of its own.
#[test]
fn an_axis_beside_a_permanent_one_is_followed() {
    let (body, directory) = ("--A 1,2,3 --r 0,0,1", tempfile::tempdir().unwrap());
    let beside = bifdiag(&format!("critical-spin {body} --axis 1e-3,1e-3,1 --json")).succeeds().json();
    let exact = bifdiag(&format!("critical-spin {body} --axis z --json")).succeeds().json();
    assert_eq!((&beside["permanent"], &beside["changes"]), (&json!(true), &exact["changes"]));
    assert_eq!((&beside["nearest"]["axis"], &beside["steady"]), (&json!([0.0, 0.0, 1.0]), &json!([])));
    assert!(near(number(&beside["nearest"]["angle_deg"]), 0.081_028_5, 1.0), "{beside}");
    let own = bifdiag(&format!("critical-spin {body} --axis 1e-3,0,1")).succeeds();
    own.printing("0.0573° from the one given").printing("the given axis itself is steady at one spin only");
    let far = bifdiag(&format!("critical-spin {body} --axis 0.01,0,1 --json")).succeeds().json();
    assert_eq!(far["permanent"], json!(false), "0.57 degrees away");
    let run = bifdiag(&format!("campbell {body} --axis 1e-3,0,1 --no-plot --to")).and("2 rad/s");
    run.inside(directory.path()).succeeds().printing("following the nearest permanent axis").printing(
        "saddle to \
    saddle-centre",
    );
}

/// Without --axis all steady axes are listed: the permanent one as by name, the others from where they begin.
#[test]
fn without_an_axis_all_of_them_are_listed() {
    let body = "--A 1,2,3 --r 0,0,-2";
    let named = bifdiag(&format!("critical-spin {body} --axis=-z --json")).succeeds().json();
    let all = bifdiag(&format!("critical-spin {body} --json")).succeeds().json();
    let [permanent] = all["permanent"].as_array().unwrap().as_slice() else { panic!("{all}") };
    assert_eq!(
        (&permanent["axis"], &permanent["changes"], &permanent["slow"]),
        (&named["axis"], &named["changes"], &named["slow"])
    );
    // The pairs over the two other axes leave the hanging axis at Ω² = 2/(3 − A).
    let forks: Vec<f64> = all["families"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|family| family["start"] == "fork")
        .map(|family| number(&family["stretches"][0]["from"]["spin"]["rad_per_s"]))
        .collect();
    assert!(near(forks[0], 1.0, 1.0) && near(forks[1], 2.0_f64.sqrt(), 1.0), "{forks:?}");
    let counts: Vec<&Value> = all["counts"].as_array().unwrap().iter().map(|count| &count["axes"]).collect();
    assert_eq!(counts, [2, 4, 6]);
    let text = bifdiag(&format!("critical-spin {body}")).succeeds();
    text.printing("permanent axis (0, 0, -1)").printing("(fork)").printing("number of steady axes");
    let paper = bifdiag("critical-spin --body paper").succeeds();
    paper.printing("no axis is permanent at every spin").printing("(fold)").printing("by energy");
    let free = bifdiag("critical-spin --body euler").succeeds();
    assert_eq!(free.stdout().matches("permanent axis").count(), 3);
    let ball = bifdiag("critical-spin --A 1,1,1 --r 0,0,0").succeeds();
    assert_eq!(ball.stdout().matches("rotation about every axis").count(), 1, "{}", ball.stdout());
    bifdiag("critical-spin --body paper --tolerance 1%").refused().telling("no axis of this body is permanent");
}

/// Each range of a family is what `critical --spin` says inside it; a part's axes are in its own frame.
#[test]
fn families_are_the_axes_at_their_spins() {
    let part = "--inertia-com 3.1,2.6,4.2,0.02,0.015,-0.01 --products integral --com 0,0,-0.0002 --mass 50 --g 9.80665";
    let all = bifdiag(&format!("critical-spin {part} --json")).succeeds().json();
    let mut compared = 0;
    for family in all["families"].as_array().unwrap() {
        for (number_of, stretch) in family["stretches"].as_array().unwrap().iter().enumerate() {
            let from = stretch["from"]["spin"]["rpm"].as_f64().unwrap_or(0.0);
            let next = family["stretches"]
                .get(number_of + 1)
                .map_or(2.0 * from + 1.0, |next| number(&next["from"]["spin"]["rpm"]));
            let spin = format!("{:?} rpm", 0.5 * (from + next));
            let at = bifdiag(&format!("critical {part} --json --spin")).and(&spin).succeeds().json();
            let branch = format!("{}.", family["branch"].as_str().unwrap());
            let here = |axis: &&Value| {
                axis["branch"].as_str().unwrap().starts_with(&branch)
                    && axis["stability"] == stretch["stability"]
                    && (axis["stable"] == stretch["stable"] || stretch["stable"] == json!("spectrum"))
            };
            assert!(at["axes"].as_array().unwrap().iter().any(|axis| here(&axis)), "{spin} {stretch} {at}");
            compared += 1;
        }
    }
    assert!(compared >= 6, "{compared}");
}

/// All axes in the plane of two equal moments are principal, and steady at no spin unless r lies on them.
#[test]
fn the_nearest_axis_of_a_symmetric_body_is_steady_at_a_spin() {
    let text = bifdiag("critical-spin --A 1,1,1.5 --r 0.3,0,0.5 --axis=0.2,1,0.1").succeeds();
    text.printing("the nearest axis of a steady rotation is (0.894427, 0, 0.447214), 77.4");
}

/// ω² = 1/2 there, ½ · 2 · ½ − ½.
#[test]
fn the_energy_of_a_threshold_is_zero_where_it_is_exactly() {
    for (line, end) in [
        ("critical-spin --A 2,2,3 --r 0.3,0.4,0", "-axis"),
        ("critical-spin --A 3,2,2 --r 0,1,1", "-axis"),
        ("critical-spin --A 2e9,2e9,3e9 --r 3e8,4e8,0", "-axis"),
    ] {
        let text = bifdiag(line).succeeds().stdout();
        let row = text.lines().find(|row| row.starts_with(end) && row.contains("fork")).unwrap();
        assert_eq!(row.split_whitespace().rev().nth(2), Some("0"), "{text}");
    }
}

/// Staude's cone also holds the principal axes off the centre of mass, about which rotation is steady at no spin.
#[test]
fn a_principal_axis_on_the_cone_is_not_called_permanent() {
    let body = "--A 3,2,4 --r 0,0,1";
    let near = bifdiag(&format!("critical-spin {body} --axis 1,0.3,0")).succeeds();
    near.printing(
        "the nearest axis of Staude's cone is (1, 0, 0), 16.7° away: it is principal, and rotation about it is",
    );
    bifdiag(&format!("critical-spin {body} --axis 1,2,9")).succeeds().printing("axis of a steady rotation is");
    bifdiag("critical-spin --A 3,2,4 --r 0,0,0 --axis 0,1,9")
        .succeeds()
        .printing("the nearest permanent axis is (0, 0, 1)");
}

/// Of a symmetric body the plane of equal moments belongs to Staude's cone, and is nearer.
#[test]
fn the_plane_of_equal_moments_is_named_as_such() {
    let found = bifdiag("critical-spin --A 2,2,1 --r 0.3,0.3,1 --axis 1,-1,0.01").succeeds();
    found.printing("the nearest axis of Staude's cone outside the plane of equal moments is (0, 0, 1), 89.6° away");
    // Nearest to this one is the axis of the centre of mass.
    let rests = bifdiag("critical-spin --A 2,2,1 --r 0.3,0.3,1 --axis 0.6,0,1").succeeds();
    rests.printing("21.3° away: the body rests with either end up, but rotation about it is steady at no spin");
}

/// r_1 (A_3 − A_2) = r_2 (A_1 − A_3) = r_3 (A_2 − A_1): two axes of infinitely many were listed as equally near.
#[test]
fn all_axes_of_a_circular_cone_are_equally_near() {
    let circular = "Staude's cone is circular about the axis that was given: all of its axes are equally near";
    let of = |body: &str| bifdiag(&format!("critical-spin {body}")).succeeds().stdout();
    let found = of("--A 2,3,4 --r=2,-1,2 --axis 1,1,1");
    assert!(found.contains(circular) && !found.contains("equally near: "), "{found}");
    let nearly = of("--A 2,3,4 --r=2,-1,2.000000000001 --axis 1,1,1");
    assert!(!nearly.contains(circular), "{nearly}");
}
