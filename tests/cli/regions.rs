//! One name for each thing: regions in answers, candidates, pictures and words.

use std::fs;
use std::io::{Cursor, Read};

use serde_json::{Value, json};

use crate::builder::bifdiag;

/// The words of a command that a document says, without the name of the program.
fn command(document: &Value) -> String {
    let text = document["command"].as_str().expect("a document has a command");
    text.strip_prefix("bifdiag ").expect("it is a command of bifdiag").to_owned()
}

#[test]
fn the_command_of_a_document_makes_the_same_bytes() {
    for line in [
        "classify --body paper --h 3.8 --l -3.25 --json",
        "classify --A 2,11/10,1 --r=-1,0,1/2 --h=-1/4 --l 1 --no-region --accuracy fast --json",
        "critical --body katok:6 --l 7/3 --json",
        "atlas --body kovalevskaya --window 0:4,0:3 --no-drawing --json",
        "state --A 1,2,3 --r 1,0,0 --omega=-1/3,0,0 --vertical=-1,0,0 --json",
        "section --body paper --region R8 --orbits 2 --crossings 3 --seed 7 --condition angular-momentum --json",
        "orbit --body paper --gamma 0,0.6,0.8 --omega 1,0,1 --times 0:1:3 --json",
        "find --type M2 --search --samples 64 --json",
        "bodies --json",
    ] {
        let done = bifdiag(line).succeeds();
        assert_eq!(bifdiag(&command(&done.json())).succeeds().stdout(), done.stdout(), "{line}");
        assert_eq!(done.json()["version"], env!("CARGO_PKG_VERSION"), "{line}");
    }
}

#[test]
fn every_sample_lies_in_its_region_and_its_polygon() {
    for body in ["paper", "katok:6", "lagrange"] {
        let atlas = bifdiag(&format!("--body {body} --json")).succeeds().json();
        let view = &atlas["drawing"]["view"]["everything"];
        for region in atlas["regions"].as_array().unwrap() {
            let [h, l] = ["h", "l"].map(|key| region["sample"][key].as_f64().unwrap());
            let drawn = &atlas["drawing"]["regions"][region["id"].as_str().unwrap()];
            let found = bifdiag(&format!("classify --body {body} --h={h} --l={l} --json")).succeeds().json();
            assert_eq!(found["region"], region["id"], "{body}");
            let outlines: Vec<Vec<[f64; 2]>> = serde_json::from_value(drawn["polygon"].clone()).unwrap();
            assert!(outlines.iter().all(|outline| outline.first() == outline.last()), "{body} {}", region["id"]);
            let inside = |key: &str, x: f64| view[key][0].as_f64().unwrap() < x && x < view[key][1].as_f64().unwrap();
            if inside("h", h) && inside("l", l) {
                assert!(winds_around(&outlines, [h, l]), "{body} {}", region["id"]);
            }
        }
    }
}

/// The even-odd rule.
fn winds_around(outlines: &[Vec<[f64; 2]>], [h, l]: [f64; 2]) -> bool {
    let crosses = |pair: &[[f64; 2]]| {
        let ([ha, la], [hb, lb]) = (pair[0], pair[1]);
        (la > l) != (lb > l) && h < ha + (l - la) / (lb - la) * (hb - ha)
    };
    outlines.iter().map(|outline| outline.windows(2).filter(|pair| crosses(pair)).count()).sum::<usize>() % 2 == 1
}

#[test]
fn candidates_are_the_regions_that_meet() {
    // Kovalevskaya's top: γ = e1 is critical with h = l²/4 − 1, an exact equality.
    let document = bifdiag("classify --body kovalevskaya --h=-3/4 --l 1 --json").succeeds().json();
    assert_eq!((&document["status"], &document["region"]), (&json!("critical"), &Value::Null));
    let candidates = document["candidates"].as_array().unwrap();
    assert_eq!(candidates[0], json!({"region": null, "status": "forbidden", "components": []}));
    assert_eq!((&candidates[1]["region"], &candidates[1]["status"]), (&json!("R1"), &json!("regular")));
    assert_eq!(candidates.len(), 2, "{document}");
    let bare = bifdiag("classify --body kovalevskaya --h=-3/4 --l 1 --no-region --json").succeeds().json();
    assert!(bare["candidates"].as_array().unwrap().iter().all(|candidate| candidate["region"].is_null()));
}

#[test]
fn a_grid_says_what_points_say() {
    let place = tempfile::tempdir().unwrap();
    let line = "classify --body kovalevskaya --grid -2:4:7,0:3:4 --out grid.npz";
    bifdiag(line).inside(place.path()).succeeds().printing("written: grid.npz");
    let mut zip = zip::ZipArchive::new(Cursor::new(fs::read(place.path().join("grid.npz")).unwrap())).unwrap();
    let mut data = |name: &str| {
        let mut bytes = Vec::new();
        zip.by_name(name).unwrap().read_to_end(&mut bytes).unwrap();
        bytes.split_off(10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]])))
    };
    let codes: Vec<i32> =
        data("region.npy").chunks(4).map(|word| i32::from_le_bytes(word.try_into().unwrap())).collect();
    assert_eq!(codes.len(), 28);
    for (row, l) in (0..4).enumerate() {
        for (column, h) in (-2..5).enumerate() {
            let found = bifdiag(&format!("classify --body kovalevskaya --h={h} --l {l} --json")).succeeds().json();
            let wanted = match found["status"].as_str().unwrap() {
                "forbidden" => -1,
                "critical" => -2,
                _ => found["region"].as_str().unwrap()[1..].parse::<i32>().unwrap() - 1,
            };
            assert_eq!(codes[7 * row + column], wanted, "h = {h}, l = {l}");
        }
    }
    assert!(codes.contains(&-1) && codes.contains(&-2) && codes.iter().any(|code| *code > 0));
    bifdiag(&line.replace("npz", "png")).inside(place.path()).succeeds();
    assert!(fs::read(place.path().join("grid.png")).unwrap().starts_with(b"\x89PNG"));
    bifdiag("classify --body paper --grid 0:1:2,0:1:2").refused().telling("--grid needs --out FILE.npz");
    bifdiag("classify --body paper --grid 0:1,0:1:2 --out g.npz").refused().telling("a grid is written hmin:hmax:n");
    bifdiag("classify --body paper --grid 0:1:2,0:1:2 --out g.csv").refused().telling("give FILE.npz or FILE.png");
}

#[test]
fn things_are_shown_in_words() {
    let region = bifdiag("show R5 --body paper").succeeds().telling_nothing();
    let region = region.printing("region R5, sections S2+T2").printing("P: T2, a torus").printing("its boundaries:");
    region.printing("components of U");
    bifdiag("show P+ --body paper").succeeds().printing("the pole +r̂ enters U");
    bifdiag("show E1 --body paper").succeeds().printing("regions that meet there: R");
    bifdiag("show R99 --body paper").refused().telling("it has the regions R1 to R9").telling("E1 to E5");
}

#[test]
fn forms_that_are_nearly_right_are_answered_with_the_right_one() {
    bifdiag("--A 2 1.1 1 --r 1,0,0").refused().telling("--A 2,1.1,1");
    bifdiag("classify --A 2,1.1,1 --r -1 0 0 --h 1 --l 1").refused().telling("--r -1,0,0");
    bifdiag("paper").refused().telling("bifdiag --body paper");
}

#[test]
fn no_picture_of_another_body_is_left() {
    let place = tempfile::tempdir().unwrap();
    bifdiag("--body paper --out o").inside(place.path()).succeeds();
    assert!(place.path().join("o/diagram.svg").exists());
    bifdiag("--body euler --out o --no-plot").inside(place.path()).succeeds();
    assert!(!place.path().join("o/diagram.svg").exists());
    assert!(place.path().join("o/atlas.json").exists());
}

/// In doubles the sample of such a region lies in another one: no picture of that is made under the wanted name.
#[test]
fn a_region_that_doubles_do_not_meet_is_not_drawn() {
    let place = tempfile::tempdir().unwrap();
    for (body, region) in [
        ("--A 1,1.000000000000001,1.6 --r=0,0,1", "R3"),
        ("--A 2,1.2000000000000002,1.2 --r=0.6,0.5,0", "R8"),
        ("--A 1.7,1.2,0.8 --r=0.3,1e-17,0.5", "R9"),
    ] {
        for command in ["sphere", "section --orbits 1 --crossings 2"] {
            let line = format!("{command} {body} --region {region}");
            bifdiag(&line).inside(place.path()).refused().telling("rounded to doubles, its sample lies outside it");
        }
        bifdiag(&format!("show {region} {body}"))
            .succeeds()
            .printing("~ rounded to doubles, the sample lies outside its region");
    }
    bifdiag("sphere --body paper --region R5 --out pictures").inside(place.path()).succeeds();
}

#[test]
fn a_sample_that_lies_elsewhere_is_marked() {
    let shown = bifdiag("show R3 --A 2.00001,2,1 --r 1,0.00001,0").succeeds();
    shown.printing("sample: ~h = 1.37").printing("~ rounded to doubles, the sample lies outside its region");
    // What doubles alone found is in doubt, and what they know to lie inside is not.
    let fast = bifdiag("--A 2.00001,2,1 --r 1,0.00001,0 --no-plot --accuracy fast").succeeds();
    fast.printing("~(2.00002").printing("~(1.99999").printing(" (0.19245, 0.87738) ").printing("may lie outside it");
}

/// A cusp on the line of a pole, which crosses there: both events are at one point.
#[test]
fn the_same_regions_meet_at_events_of_one_point() {
    for event in ["E1", "E2"] {
        let shown = bifdiag(&format!("show {event} --A 3,5.5,8 --r 0,1,0.5")).succeeds();
        shown.printing("regions that meet there: R2, R3, R5, R6");
    }
}

#[test]
fn another_section_condition_has_no_signature() {
    let line = "section --body paper --h 5.3 --l 3.25 --orbits 1 --crossings 2 --json";
    assert_eq!(bifdiag(line).succeeds().json()["signature"], "M2");
    let other = format!("{line} --condition angular-momentum");
    assert!(bifdiag(&other).succeeds().json()["signature"].is_null());
    let place = tempfile::tempdir().unwrap();
    let text = |line: &str| {
        bifdiag(&line.replace("--json", "--no-plot")).inside(place.path()).succeeds().printing("\nU = ").stdout()
    };
    assert!(text(line).contains("\nP = M2\n") && !text(&other).contains("\nP = "));
}

/// Off a permanent axis the pole enters at another energy than the extremum of U_l, though both begin at l = 0.
#[test]
fn a_point_at_rest_has_the_same_classes_with_and_without_regions() {
    for (body, points) in [
        ("--A 3,4,5 --r 3,0,4", &["--h 5", "--h=-5"][..]),
        ("--A 3,4,5 --r 0,0,1", &["--h 1", "--h=-1"]),
        ("--A 2,2,1 --r 1,1,1/2", &["--h 1.5", "--h=-1.5"]),
        ("--A 3,2,1 --r 0,0,0", &["--h 0"]),
        ("--A 2,1,1 --r 0,0,0", &["--h 0"]),
        ("--A 2,2,1 --r 0,0,0", &["--h 0"]),
        ("--A 1,1,1 --r 0,0,0", &["--h 0"]),
    ] {
        for point in points {
            let classes = |flag: &str| {
                let found = bifdiag(&format!("classify {body} {point} --l 0 --json {flag}")).succeeds().json();
                let list = found["candidates"].as_array().unwrap().clone();
                list.into_iter().map(|one| one["components"].clone()).collect::<Vec<_>>()
            };
            assert_eq!(classes(""), classes("--no-region"), "{body} {point}");
        }
    }
}

/// Where the regions of a body cannot be told apart in f64 and several curves are near, the candidates lacked the answer.
#[test]
fn fast_refuses_what_it_cannot_bracket() {
    let line = "classify --A 18,10,9 --r 1,0,0 --h 2.0000000000000001 --l 6";
    bifdiag(line).succeeds().printing("S2-2D2");
    bifdiag(line).and("--accuracy").and("fast").fails().telling("cannot be told apart in f64");
}

/// The curve on which a point lies exactly is the one that is named, and what is beside it is not said where another is as near.
#[test]
fn fast_names_the_pole_line_on_which_a_point_lies() {
    let at = |body: &str, h: &str| {
        let line = format!("classify {body} --l 1/2 --h={h} --accuracy");
        ["fast", "exact"].map(|accuracy| bifdiag(&line).and(accuracy).succeeds().stdout())
    };
    let at_rest = |body: &str, h: &str| {
        let line = format!("classify {body} --l 0 --h={h} --accuracy");
        ["fast", "exact"].map(|accuracy| bifdiag(&line).and(accuracy).succeeds().stdout())
    };
    // |r| = 1 and J_r = 34/25.
    for answer in at("--A 2,11/10,1 --r 3/5,0,4/5", "-247/272") {
        assert!(
            answer.contains("critical: exactly on a curve") && answer.contains("0 in h to P+ (error bound 0)"),
            "{answer}"
        );
    }
    // A principal axis carries r: its curve is the pole line.
    for answer in at("--A 2,11/10,1 --r 0,0,1", "9/8") {
        assert!(answer.contains("0 in h to L-.1 (error bound 0)"), "{answer}");
    }
    // At rest all that is listed meets.
    for answer in at_rest("--A 1,2,3 --r 0.6,0.8,0", "-1") {
        assert!(answer.contains("critical: exactly on a curve, where these meet"), "{answer}");
    }
    // r is so near to axis 1 that a curve runs within rounding of the pole line.
    let body = "--A 2,11/10,1 --r 9999999999999999/10000000000000000,1/50000000,0";
    let h = "1062500000000000132500000000000012625000000000001/1000000000000000020000000000000010000000000000000";
    let [fast, exact] = at(body, h);
    assert!(exact.contains("0 in h to P- (error bound 0)") && !exact.contains("region R4"), "{exact}");
    assert!(
        fast.contains("where all or some of these meet") && fast.contains("region R4") && fast.contains("0 in h to P-"),
        "{fast}"
    );
}

/// Where f64 does not decide all events its regions have other numbers, which is said.
#[test]
fn regions_that_fast_numbers_otherwise_are_said_to_be() {
    let point = |body: &str, rest: &str| bifdiag(&format!("classify {body} {rest}")).succeeds();
    let body = "--A 0.5509846155438964,0.5618428335204717,0.8871725509356319 \
                --r 0.00014355195477903674,0.02687475197781329,0.9996387983161554";
    point(body, "--h 162.25 --l 13.4375").printing("region R14");
    let fast = point(body, "--h 162.25 --l 13.4375 --accuracy fast");
    fast.printing("region R12").printing("regions are numbered as by bifdiag atlas --accuracy fast");
    let forbidden = point(body, "--h -100 --l 1 --accuracy fast").stdout();
    assert!(!forbidden.contains("numbered"), "{forbidden}");
    let decided = point("--body paper", "--h 3.8 --l 3.25 --accuracy fast").stdout();
    assert!(!decided.contains("numbered"), "{decided}");
}
