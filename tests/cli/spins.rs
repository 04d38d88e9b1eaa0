//! Steady rotations: `state`, `critical-spin`, `campbell` and `critical` say the same.

use bifdiag_body::{Body, Number};
use serde_json::{Value, json};
use support::property::holds_for_bodies;
use support::strata::STRATA;

use crate::builder::bifdiag;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn near(p: f64, q: f64, size: f64) -> bool {
    (p - q).abs() <= 1e-6 * size
}

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
fn a_free_part_is_told_its_principal_axes() {
    let part = "critical-spin --inertia 3,2.6,4.2,0.2,-0.1,0.15 --products tensor --com 0,0,0 --mass 50 --g 9.8";
    let told = bifdiag(&format!("{part} --tolerance 1%")).refused().stderr();
    assert!(!told.contains("--axis x, y or z"), "{told}");
    let axes: Vec<&str> = told.split("--axis=").skip(1).map(|rest| rest.split([' ', ';']).next().unwrap()).collect();
    assert_eq!(axes.len(), 3, "{told}");
    for axis in axes {
        let found = bifdiag(&format!("{part} --axis={} --json", axis.trim_end_matches(','))).succeeds().json();
        assert_eq!(found["permanent"], json!(true), "{axis}");
    }
}

/// The message gave the momentum that nobody asked for.
#[test]
fn a_spin_out_of_range_is_refused_as_a_spin() {
    for (spin, size) in [("1e100 rad/s", "too fast"), ("1e-100 rad/s", "too slow")] {
        let told = bifdiag("critical --body paper --spin").and(spin).refused().telling(size).stderr();
        assert!(told.contains("rad/s, or 0, is possible") && !told.contains("l ="), "{told}");
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

/// Where several axes are as near, one alone is not the nearest; of a circle of axes each is told to be one.
#[test]
fn ties_and_circles_of_axes_are_told() {
    let body = "--A 1,2,3 --r 0,0,0 --axis 1,1,1";
    let spins = bifdiag(&format!("critical-spin {body}")).succeeds();
    spins.printing("at this angle are (1, 0, 0), (0, 1, 0), (0, 0, 1)");
    let state = bifdiag(&format!("state {body} --spin")).and("1 rad/s").succeeds();
    state.printing("as near are (").printing("; what follows is of the first");
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
    let told = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z").succeeds();
    told.printing("+axis up double-real, -axis up double-elliptic (local minimum)")
        .printing("double-real  double-elliptic (local minimum)");
    let state = bifdiag("state --A 1,1,2 --r 0,0,1 --axis=-z --spin").and("1 rad/s").succeeds();
    state.printing("stable (minimum of energy): double-elliptic");
    let free = bifdiag("critical-spin --A 1,2,3 --r 0,0,0 --axis z").succeeds();
    free.printing("+axis up double-elliptic (local minimum), -axis up double-elliptic (local minimum)");
    let parts = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z --tolerance 1%").succeeds();
    parts.printing("-axis up, each of these parts is elliptic (local minimum) at every spin");
}

/// The vertical is the direction of the question: it has no end called -axis.
#[test]
fn a_vertical_that_has_to_point_down_is_told_so() {
    let told = bifdiag("state --body paper --axis=-1,0,0.2 --spin").and("2 rad/s").succeeds().stdout();
    assert!(told.contains("rpm, with its other end up") && !told.contains("-axis"), "{told}");
}

/// Of what is degenerate and of circles the table says what they stand for.
#[test]
fn degenerate_points_and_circles_are_explained() {
    let fork = bifdiag("critical --A 1,2,3 --r 0,0,1 --l 3").succeeds();
    fork.printing("mult 2: degenerate; at a cusp two critical points meet in it, at a pitchfork three");
    bifdiag("critical --body lagrange --l 3").succeeds().printing("circle: a whole circle of relative equilibria");
    bifdiag("critical --A 1,2,2 --r 0,0,0 --l 1").succeeds().printing("circle: a whole circle");
    let none = bifdiag("critical --body paper --l 3.25").succeeds().stdout();
    assert!(!none.contains("mult 2") && !none.contains("circle"), "{none}");
}

/// Off the principal axes no rotation is permanent: bounds hold for the one that moves with the spin, and every part of the box
/// that is tried has it there, with the type that is told.
#[test]
fn tolerances_off_the_principal_axes_have_bounds() {
    let part = |tensor: [f64; 6], com: [f64; 3], within: bool| {
        let text = |list: &[f64], share: f64| {
            let one = |x: &f64| if within { format!("{x:?}±{:?}", x.abs() * share + 1e-6) } else { format!("{x:?}") };
            list.iter().map(one).collect::<Vec<_>>().join(",")
        };
        format!(
            "--inertia-com={} --com={} --mass 2 --products tensor --g 9.81",
            text(&tensor, 0.002),
            text(&com, 0.002)
        )
    };
    let (tensor, com) = ([0.03, 0.024, 0.017, 0.002, -0.001, 0.0015], [0.01, 0.02, 0.05]);
    let found = bifdiag(&format!("critical-spin {} --axis z --json", part(tensor, com, true))).succeeds().json();
    assert_eq!((&found["permanent"], &found["tolerance"]["moving"]), (&json!(false), &json!(true)));
    let ranges = found["tolerance"]["ranges"].as_array().unwrap();
    assert!(ranges.iter().any(|range| range["to"] != json!(null)), "{found}");
    let tilt = number(&found["tolerance"]["tilt_deg"]);
    assert!(tilt < 5.0, "{tilt}");
    assert_eq!(found["families"].as_array().unwrap().len(), 2);
    // Fast, the type of both families of some corners of the box is that which is told.
    for corner in 0..4 {
        let side = |k: usize| if corner >> (k % 2) & 1 == 0 { 0.998 } else { 1.002 };
        let moved: [f64; 6] = std::array::from_fn(|k| tensor[k] * side(k));
        let one = bifdiag(&format!("critical-spin {} --axis z --json", part(moved, com.map(|x| x * side(1)), false)));
        let one = one.succeeds().json();
        for (end, up) in ["+axis", "-axis"].into_iter().enumerate() {
            let stretches = one["families"][end]["stretches"].as_array().unwrap();
            let here = ranges.iter().filter(|range| range["up"] == json!(up));
            for range in here.filter(|range| !range["to"].is_null()) {
                let after = number(&range["rpm"][1]) * 1.0001;
                let at =
                    stretches.iter().rfind(|stretch| stretch["from"]["spin"]["rpm"].as_f64().unwrap_or(0.0) <= after);
                let told = range["to"].as_str().unwrap().split(' ').next().unwrap();
                assert_eq!(at.unwrap()["stability"], json!(told), "{range} {one}");
            }
        }
    }
    let share = bifdiag("critical-spin --body paper --axis 1,0,0 --tolerance 0.1%").succeeds();
    share.printing("of that of the nominal part at this spin").printing("components of r");
    bifdiag("critical-spin --body paper --axis 1,0,0 --tolerance axis=1%")
        .succeeds()
        .printing("give one share for all");
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
    run("--out axes.svg").succeeds().printing("5 families of steady axes").printing("written: axes.svg");
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
    bifdiag("critical --body paper --spin").and("5:2:3 rpm").refused().telling("write a smaller spin first");
    bifdiag("critical --body paper --spin").and("0:2:3").refused().telling("has no unit");
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
    own.printing("0.0573° from the one given, is followed")
        .printing("the given axis itself is steady at one spin only");
    let far = bifdiag(&format!("critical-spin {body} --axis 0.01,0,1 --json")).succeeds().json();
    assert_eq!(far["permanent"], json!(false), "0.57 degrees away");
    let run = bifdiag(&format!("campbell {body} --axis 1e-3,0,1 --no-plot --to")).and("2 rad/s");
    run.inside(directory.path()).succeeds().printing("is followed").printing("saddle to saddle-centre");
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
    bifdiag("critical --A 1,2,3 --r 0,0,0 --l 0").succeeds().printing("at rest every orientation is an equilibrium");
    bifdiag("critical --A 2,2,2 --r 0,0,0 --l 1").succeeds().printing("rotation about every axis is a relative equil");
    let turning = bifdiag("state --A 2,2,2 --r 0,0,0 --axis 1,1,1 --spin").and("1 rpm").succeeds();
    turning.printing("rotation about every axis is steady");
}

/// Which axis is meant, and at which spin and with which end up the nearest one turns steadily.
#[test]
fn another_axis_than_the_given_one_is_told() {
    let state =
        |axis: &str| bifdiag(&format!("state --A 1,2,3 --r 0,0,1 --axis={axis} --spin")).and("3 rad/s").succeeds();
    state("1e-8,0,1").printing("the nearest steady rotation, about (0, 0, 1), 5.73e-7° away, is taken");
    assert!(!state("z").stdout().contains("is taken"));
    state("1e-3,0,1").printing("the motion is no steady rotation about the vertical");
    let cone = "--A 2,3,1 --r 1,2,0";
    let off = bifdiag(&format!("state {cone} --axis 1,1,0 --spin")).and("5 rad/s").succeeds();
    off.printing("rotation about the vertical is steady at one spin only: 11.356091 rpm, with this end up");
    let never = bifdiag(&format!("state {cone} --axis 1,2,3 --spin")).and("5 rad/s").succeeds();
    never.printing("rotation about the vertical is steady at no spin");
    for (axis, up) in [("1,1.01,0.1", "+axis"), ("-1,-1.01,-0.1", "-axis")] {
        let found = bifdiag(&format!("critical-spin {cone} --axis={axis} --json")).succeeds().json();
        assert_eq!(found["nearest"]["up"], json!(up), "{found}");
        assert!(number(&found["nearest"]["spin"]["rad_per_s"]) > 1.0, "{found}");
    }
    let told = bifdiag(&format!("critical-spin {cone} --axis=-1,-1.01,-0.1")).succeeds();
    told.printing(" rpm only, with its other end up");
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
    let csv = std::fs::read_to_string(directory.path().join("bifdiag-out/campbell.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!((&rows[0][1..3], rows[399][1]), (&["NaN", "NaN"][..], "NaN"));
    assert!(rows[399][2].parse::<f64>().unwrap() > 0.08, "{:?}", rows[399]);
}

#[test]
fn the_spins_of_campbells_diagram_are_checked() {
    let directory = tempfile::tempdir().unwrap();
    let run = |to: &str| {
        let run = bifdiag("campbell --A 1,2,3 --r 0,0,1 --axis z --to").and(to);
        run.inside(directory.path()).refused().printing_nothing()
    };
    run("0 rpm").telling("the largest spin must be greater than 0");
    run("-10 rpm").telling("the largest spin must be greater than 0");
    run("1e149 rad/s").telling("leave the range of numbers");
    let other = bifdiag("campbell --A 1,2,3 --r 0,1,0 --axis 0,1,0.1 --to").and("1 Hz").refused();
    other.telling("the nearest axis that has them is (0, 1, 0), 5.71° away");
}

/// What is said of all parts within a tolerance was decided.
#[test]
fn sentences_about_all_parts_are_true() {
    let told = |line: &str| bifdiag(&format!("critical-spin {line} --tolerance 1%")).succeeds().stdout();
    let middle = told("--A 1,2,3 --r 0,1,0 --axis y");
    assert!(middle.contains("+axis up, each of these parts is unstable at every spin outside the ranges"), "{middle}");
    assert!(middle.contains("the ranges are those of the type; regions and frequencies may change at other spins"));
    assert!(!middle.contains("at no spin"), "{middle}");
    let free = told("--A 1,2,3 --r 0,0,0 --axis y");
    assert!(free.contains("+axis up, each of these parts is saddle-centre at every spin: all are unstable"), "{free}");
    let fast = told("--A 1,2,3 --r 0,0,0 --axis z");
    assert!(
        fast.contains("each of these parts is elliptic (local minimum) at every spin: none is linearly unstable"),
        "{fast}"
    );
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
    sphere("--A 2,2,1 --r 0,0,1 --h 1.5 --l 1").printing("U changes here");
    sphere("--A 2,1,1 --r 0,0,0 --h 0.25 --l 1").printing("U changes here");
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
    // Rounded numbers are told to be, with a minus sign.
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
    let text = bifdiag(state).succeeds().printing("the motion is no steady rotation about the vertical");
    text.printing("(0, -1, 0), 45° from the vertical");
    assert!(bifdiag(&format!("{state} --json")).succeeds().json()["steady"].is_null());
}

/// All axes in the plane of two equal moments are principal, and steady at no spin unless r lies on them.
#[test]
fn the_nearest_axis_of_a_symmetric_body_is_steady_at_a_spin() {
    let text = bifdiag("critical-spin --A 1,1,1.5 --r 0.3,0,0.5 --axis=0.2,1,0.1").succeeds();
    text.printing("the nearest permanent axis is (0.894427, 0, 0.447214), 77.4");
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
            .printing(&format!("that tends to {end} at fast spins"));
    }
    let circle = bifdiag("critical-spin --A 2,2,3.5 --r 0,0,0.4 --axis x --json").succeeds().json();
    assert_eq!(circle["families"].as_array().unwrap().len(), 1);
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

/// Where moments of all parts are exactly equal, no range comes from their rounding: C = A = B, C = A and A = B, with a weight,
/// a distance and a mass that are not exact.
#[test]
fn equal_moments_of_a_part_make_no_ranges() {
    let part = |rest: &str| {
        let line = format!("critical-spin --units kg,m,s --axis z {rest}");
        let found = bifdiag(&line).succeeds();
        let json = bifdiag(&format!("{line} --json")).succeeds().json();
        let ranges = json["tolerance"]["ranges"].as_array().unwrap();
        (found.stdout(), ranges.iter().map(|range| range["up"].as_str().unwrap().to_owned()).collect::<Vec<_>>())
    };
    let (text, ends) = part("--inertia-com 0.03,0.03,0.05,0,0,0 --com 0,0,0.1 --mass 2 --g 9.81±0.5%");
    assert_eq!(ends, ["+axis"], "{text}");
    assert!(text.contains("-axis up, each of these parts is elliptic (local minimum) at every spin"), "{text}");
    assert!(text.contains("none of these parts is linearly unstable from 119.936 rpm on"), "{text}");
    let (text, ends) = part("--inertia 0.05,0.05,0.05,0,0,0 --com 0,0,0.1±1% --mass 2±1% --g 9.81");
    assert_eq!(ends, ["+axis"], "{text}");
    let (text, ends) = part("--inertia-com 0.03,0.03,0.058,0,0,0 --com 0,0,0.1±1% --mass 2±1% --g 9.81");
    assert_eq!(ends, ["+axis", "+axis"], "{text}");
    let (text, ends) = part("--inertia 0.05,0.06,0.05,0,0,0 --com 0,0,0.1 --mass 2±1% --g 9.81");
    assert_eq!(ends, ["+axis", "+axis", "-axis"], "{text}");
    // K_B = ρ + s (C − B): Ω² = 1.962 / 0.01 ± 1%.
    assert!(text.contains("133.087 .. 134.426"), "{text}");
    // C = A while B is open: there is no root of K_A. About the centre of mass m z² = 0.02 is added to A and B.
    for rest in
        ["--inertia 0.05,0.06±1%,0.05,0,0,0 --com 0,0,0.1", "--inertia-com 0.03,0.04±1%,0.05,0,0,0 --com 0,0,0.1"]
    {
        let (text, ends) = part(&format!("{rest} --mass 2 --g 9.81"));
        assert_eq!(ends, ["+axis", "+axis", "-axis"], "{text}");
        assert!(!text.contains(".. inf"), "{text}");
    }
    let (text, ends) = part("--inertia 0.05,0.06±1%,0.05,0,0,0 --com 0,0,0 --mass 2 --g 9.81");
    assert!(ends.is_empty() && text.contains("+axis up, each of these parts is elliptic at every spin"), "{text}");
    let (text, _) =
        part("--inertia-com 0.05,0.06,0.07,0.001±1%,0,0 --products integral --com 0,0,0.1 --mass 2 --g 9.81");
    assert!(text.contains("Ixy -0.001 ± 0.00001 (products as entries of the tensor; bounds"), "{text}");
}

/// Only what has a tolerance is named.
#[test]
fn tolerances_of_zero_are_not_told_as_such() {
    let text = bifdiag("critical-spin --A 1,1,1 --r 0,0,1 --tolerance weight=1%").succeeds();
    text.printing("every part within 1 ± 0.01 of the weight (bounds, not samples; what is not named is exact):");
    let text = bifdiag("critical-spin --A 1,1,2 --r 0,0,1 --axis z --tolerance axis=1%,across=2%").succeeds();
    text.printing("within 1 ± 0.01 of the moment about the axis, 1 ± 0.02 of the others (bounds");
}
