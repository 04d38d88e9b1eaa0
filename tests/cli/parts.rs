//! Real parts: the same part in many forms, spins against closed forms and another program, and twenty wrong inputs.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::builder::bifdiag;

/// A box of 2 × 4 × 6 and 48 units of mass, hung at the middle of an edge.
pub const BOX: &str = "v 0 0 0\nv 2 0 0\nv 2 4 0\nv 0 4 0\nv 0 0 6\nv 2 0 6\nv 2 4 6\nv 0 4 6\n\
                   f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A box moved by (1, 1, 1), its corners numbered from `corners` + 1 on.
fn moved(text: &str, corners: usize) -> String {
    let line = |line: &str| {
        let (kind, numbers) = line.split_at(1);
        let step = if kind == "v" { 1 } else { corners };
        let moved: Vec<String> =
            numbers.split_whitespace().map(|n| (n.parse::<usize>().unwrap() + step).to_string()).collect();
        format!("{kind} {}\n", moved.join(" "))
    };
    text.lines().map(line).collect()
}

fn atlas(options: &str, directory: &Path) -> Value {
    bifdiag(&format!("{options} --g 9.80665 --json")).inside(directory).succeeds().json()
}

/// What does not depend on units and axes: signatures, boundaries and neighbours of every region.
fn shape(atlas: &Value) -> Value {
    let region = |region: &Value| {
        let neighbours =
            region["neighbours"].as_array().unwrap().iter().map(|n| n["region"].clone()).collect::<Vec<_>>();
        json!([region["signature"], region["components"], region["bounded"], neighbours])
    };
    let kinds: Vec<&Value> = atlas["events"].as_array().unwrap().iter().map(|event| &event["kind"]).collect();
    json!([atlas["regions"].as_array().unwrap().iter().map(region).collect::<Vec<_>>(), kinds])
}

#[test]
fn one_part_in_every_form_has_one_diagram() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("box.obj"), BOX).unwrap();
    // m (b² + c²)/12 = 208, 160, 80 about (1, 2, 3); the pivot is (1, 1, 0).
    let forms = [
        "--part box.obj --density 1 --pivot 1,1,0 --units kg,m,s",
        "--part box.obj --mass 48 --pivot 1,1,0",
        "--inertia-com 208,160,80,0,0,0 --com 1,2,3 --pivot 1,1,0 --mass 48",
        "--inertia-com 208,160,80,0,0,0 --com 0,1,3 --mass 48",
        "--inertia 688,592,128,0,0,-144 --products tensor --com 0,1,3 --mass 48",
        "--inertia 688,592,128,0,0,144 --products integral --com 0,1,3 --mass 48",
    ];
    let all: Vec<Value> = forms.iter().map(|form| atlas(form, directory.path())).collect();
    for other in &all[1..] {
        assert_eq!(other, &all[0]);
    }
    assert_eq!(all[0]["body"]["part"]["exact"], false);
    // In g and mm: other numbers, the same diagram.
    let small = "--inertia-com 208e9,160e9,80e9,0,0,0 --com 0,1e3,3e3 --mass 48e3 --units g,mm,s";
    let small = atlas(small, directory.path());
    assert_eq!(shape(&small), shape(&all[0]));
    for (p, q) in small["events"].as_array().unwrap().iter().zip(all[0]["events"].as_array().unwrap()) {
        for key in ["h", "l"] {
            let (p, q) = (p[key].as_f64().unwrap() * 1e-9, q[key].as_f64().unwrap());
            assert!((p - q).abs() <= 1e-12 * q.abs(), "{key}: {p} {q}");
        }
    }
}

/// diag(0.1, 0.2, 0.25) about the pivot, turned by 3-4-5 about z and then about x: exactly the same body.
#[test]
fn a_tilted_part_is_its_principal_form() {
    let directory = tempfile::tempdir().unwrap();
    let principal = "--inertia 0.4,0.5,0.45,0,0,0 --com 0.125,0,0.25 --mass 2";
    // Rows of the rotation: (3, -4, 0)/5, (4, 3, 0)/5, e3.
    let tilted = "--inertia 0.464,0.436,0.45,-0.048,0,0 --products tensor --com 0.075,0.1,0.25 --mass 2";
    let [principal, tilted] = [principal, tilted].map(|form| atlas(form, directory.path()));
    assert_eq!(shape(&tilted), shape(&principal));
    assert_eq!(tilted["body"]["part"]["exact"], true);
    let numbers = |atlas: &Value| -> Vec<Value> {
        let samples = atlas["regions"].as_array().unwrap().iter().map(|region| &region["sample"]);
        samples.map(|sample| json!([sample["h"], sample["l"], sample["margin"]["h"]])).collect()
    };
    assert_eq!(numbers(&tilted), numbers(&principal));
}

/// A point on a pole line of a tilted part is on it, exactly, although A and r are rounded: J_r and |r|² are rational.
#[test]
fn a_point_on_a_pole_line_of_a_tilted_part_is_critical() {
    // r = m g c = (0, 3, 4) with m = g = 1, |r| = 5; A = [[2, 1, 0], [1, 30, 0], [0, 0, 31]]: J_r = (9·30 + 16·31)/25.
    let part = "--inertia 2,30,31,1,0,0 --products tensor --com 0,3,4 --mass 1 --g 1 --unphysical";
    let classify = |h: &str| bifdiag(&format!("classify {part} --h={h} --l 1 --json -q")).succeeds().json();
    assert_eq!(classify("7585/1532")["part"]["exact"], false);
    // h = 1/(2 J_r) ± 5 = 25/1532 ± 5.
    assert_eq!(classify("7685/1532")["status"], "critical");
    assert_eq!(classify("-7635/1532")["status"], "critical");
    assert_eq!(classify("7684/1532")["status"], "regular");
}

#[test]
fn a_brass_gyroscope_sleeps_from_its_closed_form_on() {
    let part = "--inertia-com 29625,29625,56250,0,0,0 --com 0,0,40 --mass 180 --units g,mm,s --g 9.80665";
    let found = bifdiag(&format!("critical-spin {part} --axis z --json")).succeeds().json();
    assert_eq!(found["permanent"], true);
    let up: Vec<&Value> = found["changes"].as_array().unwrap().iter().filter(|c| c["up"] == "+axis").collect();
    let awake: Vec<&&Value> = up.iter().filter(|c| c["kind"] != "region").collect();
    assert_eq!(awake.len(), 1, "{found}");
    let threshold = 2.0 * (317_625.0_f64 * 70_607_880.0).sqrt() / 56_250.0;
    let spin = &awake[0]["spin"];
    let bound = awake[0]["error_bound"].as_f64().unwrap();
    assert!((spin["rad_per_s"].as_f64().unwrap() - threshold).abs() <= bound + 1e-13 * threshold);
    assert!((spin["rpm"].as_f64().unwrap() - threshold * 30.0 / std::f64::consts::PI).abs() < 1e-9);
    assert_eq!((&awake[0]["from"], &awake[0]["to"]), (&json!("complex"), &json!("elliptic")));
    let state =
        |spin: &str| bifdiag(&format!("state {part} --axis z --json")).and("--spin").and(spin).succeeds().json();
    assert_eq!(state("3000 rpm")["steady"]["stable"], "integral");
    assert_eq!(state("1500 rpm")["steady"]["stable"], false);
    assert!((state("1500 rpm")["steady"]["above"]["spin"]["rpm"].as_f64().unwrap() - 1608.0).abs() < 1.0);
    let [rpm, hertz, radians] = ["3000 rpm", "50 Hz", "314.1592653589793 rad/s"].map(state);
    assert_eq!(rpm["spin"], hertz["spin"]);
    assert!((rpm["l"].as_f64().unwrap() - radians["l"].as_f64().unwrap()).abs() < 1e-9 * rpm["l"].as_f64().unwrap());
}

/// A spin, its error bound, and the types below and above.
type Change = (f64, f64, String, String);

/// 100 tilted asymmetric parts: the spins at which the eigenvalues of the whole linearised flow change their type, as found by
/// data/oracles/spins.py with 60 digits, and no other that its steps could show.
/// A gyroscope with an error in every number: the closed form of each of its symmetric corners lies in a range, the text of
/// `command` makes the same document, and + - stands for ±.
#[test]
fn a_part_with_errors_in_its_numbers_has_bounds() {
    let options = "--inertia-com 29625±1%,29625+-1%,56250+/-281.25,0±50,0±50,0±50 --com 0±0.05,0±0.05,40±0.1 --mass 180±0.5 \
                   --units g,mm,s --g 9.80665 --axis z --json";
    let document = bifdiag(&format!("critical-spin {options}")).succeeds().json();
    let tolerance = &document["tolerance"];
    let names: Vec<&str> =
        tolerance["inputs"].as_array().unwrap().iter().map(|x| x["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz", "com x", "com y", "com z", "mass"]);
    assert_eq!(tolerance["inputs"][2], json!({"name": "Izz", "value": "56250", "within": "281.25"}));
    let ranges = tolerance["ranges"].as_array().unwrap();
    let awake = |range: &&Value| range["up"] == "+axis" && range["to"] == "elliptic";
    let [low, high] = [0, 1].map(|end| ranges.iter().find(awake).unwrap()["rpm"][end].as_f64().unwrap());
    let sign = |corner: u32, bit: u32| if (corner >> bit) & 1 == 0 { -1.0_f64 } else { 1.0 };
    for corner in 0..16 {
        let (across, along) = (29625.0 * (1.0 + 0.01 * sign(corner, 0)), 56250.0 + 281.25 * sign(corner, 1));
        let (mass, arm) = (180.0 + 0.5 * sign(corner, 2), 40.0 + 0.1 * sign(corner, 3));
        let rpm =
            2.0 * ((across + mass * arm * arm) * mass * 9806.65 * arm).sqrt() / along * 30.0 / std::f64::consts::PI;
        assert!(low <= rpm && rpm <= high, "{low} {rpm} {high}");
    }
    // The corners need 24 rpm on each side.
    assert!(high - low < 250.0, "{low} {high}");
    assert!(names.contains(&ranges.iter().find(awake).unwrap()["most"].as_str().unwrap()));
    assert!(tolerance["tilt_deg"].as_f64().unwrap() < 10.0);
    let command = document["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap().to_owned();
    assert_eq!(bifdiag(&command).succeeds().json(), document);

    for (options, messages) in [
        ("critical --inertia 4±1,4,2,0,0,0 --com 0,0,1 --mass 1 --l 1", &["only `bifdiag critical-spin`"][..]),
        ("body --inertia 4±1,4,2,0,0,0 --com 0,0,1 --mass 1", &["only `bifdiag critical-spin`"]),
        (
            "critical-spin --inertia 4±1,4,2,0,0,0 --com 0,0,1 --mass 1 --axis z --tolerance 1%",
            &["--tolerance and ±", "leave out one"],
        ),
        ("critical-spin --inertia 4,4,2,0,0,0 --com 0,0,1 --mass 1±2 --axis z", &["--mass", "greater than zero"]),
        ("critical-spin --inertia 4±-1,4,2,0,0,0 --com 0,0,1 --mass 1 --axis z", &["--inertia", "Ixx", "2±1%"]),
        ("critical-spin --inertia 4±x,4,2,0,0,0 --com 0,0,1 --mass 1 --axis z", &["--inertia", "Ixx"]),
    ] {
        let done = bifdiag(&format!("{options} --g 9.81")).refused();
        messages.iter().fold(done, |done, message| done.telling(message));
    }
}

#[test]
fn critical_spins_of_tilted_parts_are_those_of_the_whole_linearisation() {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/data/oracles/spins.jsonl")).unwrap();
    let mut compared = 0;
    for line in text.lines() {
        let part: Value = serde_json::from_str(line).unwrap();
        let option = |key: &str| part[key].as_str().unwrap().to_owned();
        let run = bifdiag("critical-spin --products tensor --g 9.80665 --json")
            .and(format!("--inertia-com={}", option("inertia_com")))
            .and(format!("--com={}", option("com")))
            .and(format!("--mass={}", option("mass")))
            .and(format!("--axis={}", option("axis")));
        let found = run.succeeds().json();
        assert_eq!(found["permanent"], true, "{line}");
        let fastest: f64 = option("fastest").parse().unwrap();
        for up in ["+axis", "-axis"] {
            let changes: Vec<Change> = found["changes"]
                .as_array()
                .unwrap()
                .iter()
                .filter(|c| c["up"] == up && c["kind"] != "region")
                .map(|c| {
                    let word = |key: &str| c[key].as_str().unwrap().split(' ').next().unwrap().to_owned();
                    (
                        c["spin"]["rad_per_s"].as_f64().unwrap(),
                        c["error_bound"].as_f64().unwrap(),
                        word("from"),
                        word("to"),
                    )
                })
                // From a minimum to a maximum the eigenvalues stay imaginary.
                .filter(|(spin, _, from, to)| from != to && *spin < fastest)
                .collect();
            let wanted = part[up].as_array().unwrap();
            let matches = |change: &Change, wanted: &Value| {
                let place: f64 = wanted[0].as_str().unwrap().parse().unwrap();
                (change.0 - place).abs() <= change.1 + f64::EPSILON * place
            };
            for wanted in wanted {
                assert!(
                    changes.iter().any(|change| matches(change, wanted)),
                    "{wanted} is missing\n{line}\n{changes:?}"
                );
                compared += 1;
            }
            // The oracle looks at 2000 spins in geometric progression, from a ten-thousandth of the fastest on: it cannot see
            // two changes between two of them, nor one below the first.
            let (slowest, ratio) = (1e-4 * fastest, 1.004_616);
            let seen = |change: &&Change| wanted.iter().any(|wanted| matches(change, wanted));
            let unseen: Vec<f64> = changes.iter().filter(|c| !seen(c) && c.0 > slowest).map(|c| c.0).collect();
            assert!(unseen.len().is_multiple_of(2), "{line}\n{changes:?}");
            assert!(unseen.chunks(2).all(|pair| pair[1] < ratio * pair[0]), "{line}\n{changes:?}");
        }
    }
    assert!(compared > 150, "{compared}");
}

#[test]
fn a_part_is_shown_and_drawn_as_it_was_understood() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("box.obj"), BOX).unwrap();
    let run = bifdiag("body --part box.obj --density 1 --pivot 1,1,0 --g 9.81 --out p").inside(directory.path());
    run.succeeds().printing("the part can exist").printing("208").printing("written: p/part.svg");
    assert!(fs::read_to_string(directory.path().join("p/part.svg")).unwrap().contains("fixed point"));
    // Also one that cannot exist.
    let run = bifdiag("body --inertia-com 3,1,1,0,0,0 --com 0,0,1 --mass 1 --g 9.81");
    run.succeeds().printing(
        "the part cannot exist: about its centre of mass the two smaller principal moments add up to less than the largest: 1 + 1 < 3, 1 is missing",
    );
}

/// The tensor of a turned inertial block has fractions of hundreds of digits: decimals are printed.
#[test]
fn a_turned_tensor_is_printed_in_decimals() {
    let directory = tempfile::tempdir().unwrap();
    let inertial = "<origin xyz='0 0 0.1' rpy='0.1 0.2 0.3'/><mass value='2'/>\
                    <inertia ixx='0.01' iyy='0.02' izz='0.015' ixy='0.001' ixz='0' iyz='0'/>";
    let arm = format!("<robot name='a'><link name='leg'><inertial>{inertial}</inertial></link></robot>");
    fs::write(directory.path().join("arm.urdf"), arm).unwrap();
    let reply = bifdiag("body --part arm.urdf --link leg --g 9.81").inside(directory.path()).succeeds();
    assert!(reply.stdout().lines().all(|line| line.len() < 120), "{}", reply.stdout());
    reply.printing("0.0304800");
}

/// An inertial block is in metres, and the pivot in the units that are asked for, or in its own.
#[test]
fn the_pivot_of_an_inertial_block_is_in_the_units_of_the_part() {
    let directory = tempfile::tempdir().unwrap();
    let inertial = "<origin xyz='0 0.02 0.15'/><mass value='2.5'/>\
                    <inertia ixx='0.024' iyy='0.022' izz='0.0045' ixy='0' ixz='0' iyz='0'/>";
    let arm = format!("<robot name='a'><link name='upper'><inertial>{inertial}</inertial></link></robot>");
    fs::write(directory.path().join("arm.urdf"), arm).unwrap();
    for (pivot, units) in [("0,0,10", "g,mm,s"), ("0,0,10mm", "g,mm,s"), ("0,0,0.01m", "g,mm,s")] {
        let line = format!("body --part arm.urdf --g 9.81 --units {units} --pivot {pivot}");
        bifdiag(&line).inside(directory.path()).succeeds().printing("(0, 20, 140) mm");
    }
    let metres = bifdiag("body --part arm.urdf --g 9.81 --pivot 0,0,10mm").inside(directory.path()).succeeds();
    metres.printing("(0, 0.02, 0.14) m");
}

/// A motion is printed in the units of the part, and says in which; a body in numbers has none.
#[test]
fn motions_of_parts_say_their_units() {
    let part = "--inertia-com 0.03,0.04,0.05,0,0,0 --com 0,0,0.1 --mass 2 --g 9.81 --units kg,m,min";
    let units = "times in min, angular velocities in rad/min";
    for command in ["orbit --gamma 0,0.1,1 --omega 0,0,6 --times 0:0.01:2", "spin-down --from L+.1"] {
        bifdiag(command).arguments(part).succeeds().printing(units);
    }
    let of_numbers = bifdiag("orbit --body paper --gamma 0,0.1,1 --omega 0,0,6 --times 0:1:2").succeeds().stdout();
    assert!(!of_numbers.contains("times in"), "{of_numbers}");
}

/// Units behind numbers: the same part, whatever `--units` are.
#[test]
fn numbers_with_units_are_the_same_part() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("box.obj"), BOX).unwrap();
    let shown = |options: &str| bifdiag(&format!("body {options} --json")).inside(directory.path()).succeeds().json();
    let plain = shown("--part box.obj --density 0.0000027 --units kg,mm,s --g 9.81 --pivot 1,1,0");
    for options in [
        "--part box.obj --density 2.7g/cm3 --units kg,mm,s --g 9.81m/s2 --pivot 1,1,0mm",
        "--part box.obj --density 2700kg/m^3 --units kg,mm,s --g 981cm/s2 --pivot 0.1cm,1mm,0",
        "--part box.obj --mass 129.6mg --units kg,mm,s --g 9.81 --pivot 1,1,0",
    ] {
        assert_eq!(shown(options)["inertia"], plain["inertia"], "{options}");
        assert_eq!(shown(options)["g"], plain["g"], "{options}");
        assert_eq!(shown(options)["com"], plain["com"], "{options}");
    }
    let metres = shown("--inertia-com 208,160,80,0,0,0kg*m2 --com 1,2,3 --mass 48 --g 9.81");
    let grams = shown("--inertia-com 2.08e11,160e9,8e10,0,0,0 --com 1,2,3m --mass 48kg --units g,mm,s --g 9.81");
    assert_eq!((&grams["mass"], &grams["com"][2]), (&json!("48000"), &json!("3000")));
    assert_eq!(grams["principal"]["axes"], metres["principal"]["axes"]);
    let wrong = |options: &str| bifdiag(&format!("body {options} --g 9.81")).inside(directory.path()).refused();
    wrong("--part box.obj --density 2.7kg").telling("--density").telling("one such as g/cm3");
    wrong("--part box.obj --mass 5stone").telling("`stone` is no unit").telling("slug");
    wrong("--inertia-com 2,3,4,0,0,0 --com 1m,2,3cm --mass 1").telling("--com").telling("some have none");
    wrong("--part bracket.STEP --density 1").telling("STEP files are not read").telling("export the solid");
    wrong("--part bracket.igs --density 1").telling("IGES").telling("--inertia-com");
}

/// A file in mm that is read in metres, and moments in g mm² that are read in kg m².
#[test]
fn improbable_parts_are_reported_which_unit_would_make_sense() {
    let directory = tempfile::tempdir().unwrap();
    let bracket: String = BOX
        .lines()
        .map(|line| match line.split_once(' ') {
            Some(("v", numbers)) => format!(
                "v {}\n",
                numbers.split(' ').map(|x| (x.parse::<i32>().unwrap() * 10).to_string()).collect::<Vec<_>>().join(" ")
            ),
            _ => format!("{line}\n"),
        })
        .collect();
    fs::write(directory.path().join("bracket.obj"), bracket).unwrap();
    let reply =
        |options: &str| bifdiag(&format!("body {options} --g 9.81")).inside(directory.path()).succeeds().stderr();
    let large = reply("--part bracket.obj --density 2.7g/cm3");
    assert!(large.contains("the part is 60 m across: is the file in mm? then give --units kg,mm,s"), "{large}");
    assert_eq!(reply("--part bracket.obj --density 2.7g/cm3 --units kg,mm,s"), "");
    let plain = reply("--part bracket.obj --density 2700");
    assert!(plain.contains("--units kg,mm,s and the density as 2700kg/m3"), "{plain}");
    let gyroscope = "--inertia-com 29625,29625,56250,0,0,0 --com 0,0,40 --mass 180";
    assert!(reply(gyroscope).contains("are the numbers in g,mm? then give --units g,mm,s"));
    assert_eq!(reply(&format!("{gyroscope} --units g,mm,s")), "");
}

/// Fractions are shown as decimals; in JSON they are exact.
#[test]
fn numbers_of_a_part_are_shown_as_decimals() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(
        directory.path().join("wedge.obj"),
        "v 0 0 0\nv 7 0 0\nv 0 5 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    )
    .unwrap();
    let run = |more: &str| {
        bifdiag(&format!("body --part wedge.obj --mass 1/3 --g 9.81 -q {more}")).inside(directory.path()).succeeds()
    };
    let text = run("").stdout();
    assert!(!text.contains("17/15") && text.contains("1.13333333…") && text.contains("(1.75, 1.25, 0.75)"), "{text}");
    assert_eq!(run("--json").json()["inertia"][0][0], json!("17/15"));
    let head = bifdiag("critical --part wedge.obj --mass 1/3 --g 9.81 --l 1 -q").inside(directory.path()).succeeds();
    assert!(!head.stdout().lines().take(2).any(|line| line.contains('/')), "{}", head.stdout());
}

/// A tolerance of the fixed point or of gravity, and of a file's density, on which no spin depends.
#[test]
fn tolerances_stand_at_every_number_of_a_part() {
    let directory = tempfile::tempdir().unwrap();
    fs::write(directory.path().join("box.obj"), BOX).unwrap();
    let run = |options: &str| {
        bifdiag(&format!("critical-spin {options} --axis z --json")).inside(directory.path()).succeeds()
    };
    let names = |document: &Value| -> Vec<Value> {
        document["tolerance"]["inputs"].as_array().unwrap().iter().map(|input| input["name"].clone()).collect()
    };
    let gravity = run("--part box.obj --density 1 --pivot 1,2,0 --g 9.81±0.1").json();
    assert_eq!(names(&gravity), ["g"]);
    let pivot = run("--part box.obj --density 1 --pivot 1±0.001,2±0.001,0 --g 9.81").json();
    assert_eq!(names(&pivot), ["pivot x", "pivot y"]);
    let moved = run("--inertia-com 208,160,80,0,0,0 --com 1,2,3 --mass 48 --pivot 1±0.001,2±0.001,0 --g 9.81").json();
    assert_eq!(moved["tolerance"], pivot["tolerance"]);
    // What is not exact is named as it was given, with the value that was given, and the document's command says the same.
    let both = run("--inertia-com 208,160,80,0,0,0 --com 1±0.1,2,3 --mass 48 --pivot 0.5±0.1,1±0.1,3 --g 9.81").json();
    let inputs = &both["tolerance"]["inputs"];
    assert_eq!(names(&both), ["com x - pivot x", "pivot y"]);
    assert_eq!((&inputs[0]["value"], &inputs[0]["within"]), (&"0.5".into(), &"0.2".into()), "{inputs}");
    assert_eq!((&inputs[1]["value"], &inputs[1]["within"]), (&"1".into(), &"0.1".into()), "{inputs}");
    let again = both["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap();
    assert_eq!(bifdiag(again).succeeds().json(), both);
    // Ω² grows with g: the least spin of the range is below that of the least g.
    let [range, change] = [&gravity["tolerance"]["ranges"][0]["rpm"], &gravity["changes"][0]["spin"]["rpm"]];
    let change = change.as_f64().unwrap();
    assert!(range[0].as_f64().unwrap_or(0.0) < change * (9.71_f64 / 9.81).sqrt() * 1.000_01, "{gravity}");
    assert!(range[1].as_f64().unwrap() > change * (9.91_f64 / 9.81).sqrt() * 0.999_99, "{gravity}");
    let density = run("--part box.obj --density 1±5% --pivot 1,2,0 --g 9.81");
    assert_eq!(density.json().get("tolerance"), None);
    assert!(density.stderr().contains("--density ±") && density.stderr().contains("no spin depends on it"));
    bifdiag("classify --part box.obj --density 1±5% --g 9.81 --h 1 --l 1")
        .inside(directory.path())
        .refused()
        .telling("±");
}

/// What goes wrong with parts in the trackers of other programs: each refused with what would help.
#[test]
fn wrong_parts_are_refused_with_a_message_that_helps() {
    let directory = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| fs::write(directory.path().join(name), text).unwrap();
    file("box.obj", BOX);
    file("open.obj", &BOX.replace("f 5 6 7 8\n", ""));
    file(
        "inverted.obj",
        &BOX.replace("f 1 4 3 2", "f 2 3 4 1")
            .replace("f 5 6 7 8", "f 8 7 6 5")
            .replace("f 1 2 6 5", "f 5 6 2 1")
            .replace("f 2 3 7 6", "f 6 7 3 2")
            .replace("f 3 4 8 7", "f 7 8 4 3")
            .replace("f 4 1 5 8", "f 8 5 1 4"),
    );
    file("mixed.obj", &BOX.replace("f 5 6 7 8", "f 8 7 6 5"));
    file("cutting.obj", &format!("{BOX}{}", moved(BOX, 8)));
    file("empty.obj", "v 0 0 0\n");
    file("notes.txt", "");
    file("broken.stl", "solid x\nfacet normal 0 0 zero\n");
    file("two.urdf", "<robot><link name='a'><inertial/></link><link name='b'><inertial/></link></robot>");
    let refused: [(&str, &[&str]); 23] = [
        // The sign of the products, and both readings.
        (
            "--inertia-com 2,3,4,0.5,0,0 --com 0,0,1 --mass 1",
            &["--products is missing", "1.792893, 3.207107, 4", "tensor|integral"][..2],
        ),
        // The reference point.
        ("--inertia 0.1,0.1,0.15,0,0,0 --com 0,0,1 --mass 1", &["cannot exist", "give it as --inertia-com"]),
        ("--inertia 2,2,1,0,0,0 --com 0,0,1 --pivot 0,0,1 --mass 1", &["already about the fixed point"]),
        // Meshes.
        ("--part open.obj --density 1", &["the mesh is open", "4 edges", "watertight"]),
        ("--part inverted.obj --density 1", &["the mesh is inverted", "-48", "outward"]),
        ("--part mixed.obj --density 1", &["mixed orientation", "4 edges"]),
        ("--part cutting.obj --density 1", &["the mesh cuts itself", "unite the bodies"]),
        ("--part empty.obj --density 1", &["the mesh is empty"]),
        ("--part box.obj", &["a mesh has no mass", "--density", "--mass"]),
        ("--part box.obj --density 1 --mass 2", &["one of them is enough"]),
        ("--part broken.stl --density 1", &["--part broken.stl", "STL"]),
        ("--part notes.txt --density 1", &[".stl, .obj, .ply"]),
        ("--part missing.stl --density 1", &["--part missing.stl", "No such file"]),
        ("--part box.obj --density 1 --com 0,0,1", &["--com has no effect with --part"]),
        // Blocks of links.
        ("--part two.urdf", &["more than one link", "a, b", "--link NAME"]),
        ("--part two.urdf --link c", &["--link c", "a, b"]),
        ("--part two.urdf --link a", &["<mass> of link a has no value"]),
        // Flat and thin, with too few digits.
        (
            "--inertia-com 0.333333,0.333333,0.666667,0,0,0 --com 0,0,1 --mass 1",
            &["cannot exist", "1e-06 is missing"][..1],
        ),
        ("--inertia-com 1,1,-1e-9,0,0,0 --com 0,0,1 --mass 1", &["not positive definite", "-4e-9"]),
        // Units.
        ("--inertia-com 2,3,4,0,0,0 --com 0,0,1 --mass 1 --units kg,mm", &["2 units given", "kg,mm,s"]),
        ("--inertia-com 2,3,4,0,0,0 --com 0,0,1 --mass 1 --units mm,kg,s", &["`mm` is no unit of mass", "slug"]),
        ("--inertia-com 2,3,4,0,0,0 --com 0,0,1 --mass -1", &["greater than zero"]),
        // A rod on its own axis has no moment there.
        ("--inertia-com 1,1,0,0,0,0 --com 0,0,1 --mass 1", &["not positive definite", "about the fixed point"]),
    ];
    for (options, messages) in refused {
        let done = bifdiag(&format!("critical {options} --l 1 --g 9.81")).inside(directory.path()).refused();
        messages.iter().fold(done, |done, message| done.telling(message));
    }
    bifdiag("state --body paper --axis z --spin 3000").refused().telling("rpm, Hz, rad/s and deg/s");
}

/// The axes of the table are not by rising moments, so the inequality names none; a negative moment has no radius.
#[test]
fn a_part_that_cannot_exist_is_reported_without_names_of_axes() {
    let part = bifdiag("body --inertia 1,5,2,0,0,0 --com 0,0,0.1 --mass 2 --g 9.8").succeeds().stdout();
    assert!(
        part.contains("the two smaller principal moments add up to less than the largest: 0.98 + 2 < 4.98"),
        "{part}"
    );
    let negative = bifdiag("body --inertia 3,1,1,0,0,0 --com 0.1,0,0 --mass 200 --g 9.8").succeeds().stdout();
    let row = negative.lines().find(|line| line.contains("     -1      ")).unwrap();
    assert!(row.trim_end().ends_with(" -"), "{negative}");
}

/// Ranges of spins that two descriptions of the same part have: up, types and ends in rpm.
fn ranges(found: &Value) -> Vec<(String, String, [f64; 2])> {
    let range = |range: &Value| {
        let [low, high] = [0, 1].map(|end| range["rpm"][end].as_f64().unwrap());
        (range["up"].to_string(), format!("{} {}", range["from"], range["to"]), [low, high])
    };
    found["tolerance"]["ranges"].as_array().unwrap().iter().map(range).collect()
}

/// Mass and gravity enter r = m g c alone: what they leave open is that of the same tolerance on the weight.
#[test]
fn a_tolerance_of_the_mass_is_one_of_the_weight() {
    for part in [
        "--inertia 0.30,0.21,0.17,0,0,0 --com 0,0,0.15 --axis z",
        "--inertia 0.30,0.21,0.17,0,0,0 --com 0,0.1,0 --axis=-y",
        "--inertia 0.33,0.30,0.17,0.02,0,0 --products tensor --com 0,0,0.15 --axis z",
        "--inertia 0.464,0.436,0.45,-0.048,0,0 --products tensor --com 0.075,0.1,0 --axis 3,4,0",
    ] {
        let of = |options: &str| bifdiag(&format!("critical-spin {part} {options} --json")).succeeds().json();
        let weight = ranges(&of("--mass 2.5 --g 9.80665 --tolerance weight=2%"));
        assert!(!weight.is_empty(), "{part}");
        for options in ["--mass 2.5±2% --g 9.80665", "--mass 2.5 --g 9.80665±2%"] {
            let found = of(options);
            assert!(found["tolerance"]["tilt_deg"].is_null(), "{part} {options}");
            let found = ranges(&found);
            assert_eq!(found.len(), weight.len(), "{part} {options}\n{found:?}\n{weight:?}");
            for ((up, types, [low, high]), (other_up, other_types, [other_low, other_high])) in
                found.iter().zip(&weight)
            {
                assert_eq!((up, types), (other_up, other_types), "{part} {options}");
                let width = other_high - other_low;
                assert!((low - other_low).abs() + (high - other_high).abs() < 1e-6 * width, "{part} {options}");
            }
        }
    }
}

/// About the centre of mass the mass moves tensor and weight together. Each corner changes inside the ranges, which are at most
/// three times as wide as the corners need.
#[test]
fn mass_and_arm_are_used_together() {
    let part = |inertia: [f64; 3], arm: f64, mass: f64| {
        format!(
            "--inertia-com {},{},{},0,0,0 --com 0,0,{arm} --mass {mass} --g 9.81 --axis z",
            inertia[0], inertia[1], inertia[2]
        )
    };
    let inertia = [0.03, 0.024, 0.04];
    let text = part(inertia, 0.1, 2.0).replace("--mass 2", "--mass 2±3%").replace("0,0,0.1", "0,0,0.1±1%");
    let found = bifdiag(&format!("critical-spin {text} --json")).succeeds().json();
    assert!(found["tolerance"]["tilt_deg"].is_null());
    let ranges = ranges(&found);
    let mut ends: Vec<[f64; 2]> = vec![[f64::INFINITY, 0.0]; ranges.len()];
    for corner in 0..9 {
        let step = |k: i32| f64::from(k % 3 - 1);
        let (mass, arm) = (2.0 * (1.0 + 0.03 * step(corner)), 0.1 * (1.0 + 0.01 * step(corner / 3)));
        let one = bifdiag(&format!("critical-spin {} --json", part(inertia, arm, mass))).succeeds().json();
        for change in one["changes"].as_array().unwrap().iter().filter(|change| change["from"] != change["to"]) {
            let rpm = change["spin"]["rpm"].as_f64().unwrap();
            let change_up = change["up"].to_string();
            let holds =
                |(up, _, [low, high]): &(String, String, [f64; 2])| *up == change_up && *low <= rpm && rpm <= *high;
            let at = ranges.iter().position(holds).unwrap_or_else(|| panic!("{change} {ranges:?}"));
            ends[at] = [ends[at][0].min(rpm), ends[at][1].max(rpm)];
        }
    }
    for ((.., [low, high]), [least, most]) in ranges.iter().zip(&ends) {
        assert!(high - low < 3.0 * (most - least), "{ranges:?} {ends:?}");
    }
}

/// A range of the centre of mass that holds the fixed point leaves it on the axis.
#[test]
fn an_axis_is_permanent_on_both_sides_of_the_fixed_point() {
    for part in [
        "--inertia-com 0.021,0.034,0.047,0,0,0 --com 0,0,-0.08±0.08 --mass 1.5 --g 9.80665",
        "--inertia-com 0.02,0.02,0.01,0,0,0 --com 0,0,0±0.01 --mass 1 --g 9.81",
    ] {
        let found = bifdiag(&format!("critical-spin {part} --axis z")).succeeds();
        found.printing("all of them have this permanent axis");
    }
}

/// Corners of a PLY file are counted from 0.
#[test]
fn corners_that_are_not_there_are_named() {
    let directory = tempfile::tempdir().unwrap();
    let ply = |corner: &str| {
        let text = format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face \
             1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 {corner}\n"
        );
        fs::write(directory.path().join("a.ply"), text).unwrap();
        bifdiag("body --part a.ply --density 1 --g 9.81").inside(directory.path()).refused()
    };
    ply("-1").telling("a face names corner -1 (the first one is 0), but there are 3");
    ply("3").telling("a face names corner 3 (the first one is 0), but there are 3");
}

#[test]
fn orientations_and_names_of_bodies_are_as_in_mjcf() {
    let directory = tempfile::tempdir().unwrap();
    let refused = |blocks: &[&str], options: &str| {
        let bodies: Vec<String> = blocks.iter().map(|block| format!("<body {block}/></body>")).collect();
        let bodies = bodies.concat();
        fs::write(directory.path().join("a.xml"), format!("<mujoco><worldbody>{bodies}</worldbody></mujoco>")).unwrap();
        bifdiag(&format!("body --part a.xml --g 9.81 {options}")).inside(directory.path()).refused()
    };
    let block = |name: &str, rest: &str| format!("{name}><inertial pos='0 0 0.1' mass='1' {rest}");
    let whole = block("name='a'", "diaginertia='1 1 1'");
    refused(&[&block("name='a'", "diaginertia='1 1 1' zaxis='0 0 1'")], "")
        .telling("body a: the orientation zaxis is not read");
    refused(&[&block("name='a'", "fullinertia='1 1 1 0 0 0' quat='1 1 0 0'")], "")
        .telling("body a: quat and fullinertia exclude each other");
    refused(&[&block("name='a'", "fullinertia='1'")], "").telling("fullinertia=\"1\" of body a has 1 number, not 6");
    refused(&[&whole, &block("name='b'", "diaginertia='1 1 1'")], "")
        .telling("more than one body with an inertial block");
    refused(&[&whole, &whole], "--link a").telling("more than one body with an inertial block is called so");
}

/// A number with its unit is out of range, not its exponent a unit; and the units of other programs are none of ours.
#[test]
fn wrong_numbers_and_units_are_named_as_they_are() {
    let part = "--inertia-com 2,3,4,0,0,0 --com 0,0,1 --g 9.81";
    let mass = |text: &str| bifdiag(&format!("critical-spin {part} --axis z --mass")).and(text).refused();
    mass("1e400kg").telling("`1e400` is out of range");
    mass("1/0 kg").telling("`1/0` has denominator zero");
    mass("1±2").telling("its ± reaches down to -1: a mass must be greater than zero");
    bifdiag(&format!("state {part} --mass 1 --axis z --spin"))
        .and("3 kHz")
        .refused()
        .telling("none of the units rpm, Hz");
    bifdiag(&format!("body {part} --mass")).and("1±0.1kg").refused().telling("leave out ± and the number after it");
    bifdiag(&format!("body {part} --mass 1 --units kg")).refused().telling("1 unit given");
}

/// A density of which 1.89e13 was said, and more than the part has: 1.8858e13.
#[test]
fn the_least_density_is_rounded_down() {
    let dense = |moment: &str| {
        let line = format!("body --inertia-com {moment},{moment},{moment},0,0,0 --com 0,0,0.15 --mass 2.5 --g 9.8");
        bifdiag(&line).succeeds()
    };
    dense("1e-9").telling("the density of the part reaches at least 1.88e13 kg/m³: check --units");
    // Other --units would leave these as they are.
    let own = dense("0.001gmm2").telling("check the units of tensor and mass").stderr();
    assert!(!own.contains("--units"), "{own}");
}

/// The centre of mass is 7.6e-6° off the axis.
#[test]
fn a_small_angle_to_the_centre_of_mass_is_not_nothing() {
    let part = bifdiag("body --inertia-com 0.24,0.15,0.17,0,0,0 --com 0,0.00000002,0.15 --mass 2.5 --g 9.8").succeeds();
    part.printing("  8e-6°  ");
}
