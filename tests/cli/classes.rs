//! The classes of bodies: the list, one of them, and where a body stands.

use serde_json::Value;
use tempfile::tempdir;

use crate::builder::bifdiag;

/// The most frequent class of bodies that exist.
const FREQUENT: &str = "01036ac4a504";

#[test]
fn the_list_is_the_published_one() {
    let printed = bifdiag("classes --json").succeeds().telling_nothing().json();
    let published: Value = serde_json::from_str(&support::data("classes.json")).unwrap();
    assert_eq!(printed, published);
    let all = printed["classes"].as_array().unwrap();
    let physical = bifdiag("classes --physical --json").succeeds().json();
    let physical = physical["classes"].as_array().unwrap();
    assert!(physical.iter().eq(all.iter().filter(|class| class["physical"] == true)));
    let text = format!("{} classes, {} of them of physical bodies", all.len(), physical.len());
    bifdiag("classes").succeeds().printing(&text).printing(FREQUENT);
}

#[test]
fn a_class_is_reported_in_words_with_the_picture_of_its_witness() {
    let place = tempdir().unwrap();
    let json = bifdiag(&format!("class {FREQUENT} --json")).inside(place.path()).succeeds().json();
    let list = bifdiag("classes --json").succeeds().json();
    assert!(list["classes"].as_array().unwrap().contains(&json));
    assert!(place.path().read_dir().unwrap().next().is_none());
    let neighbour = json["neighbours"][0]["class"].as_str().unwrap();
    bifdiag(&format!("class {FREQUENT}")).inside(place.path()).succeeds().printing(neighbour).printing("written: ");
    let picture = place.path().join(format!("bifdiag-out/class-{FREQUENT}.svg"));
    assert!(std::fs::read_to_string(picture).unwrap().contains("<svg"));
    // The beginning of its name is enough, and --no-plot writes nothing.
    let other = tempdir().unwrap();
    bifdiag("class 01036 --no-plot").inside(other.path()).succeeds().printing(&format!("class {FREQUENT}"));
    assert!(other.path().read_dir().unwrap().next().is_none());
}

#[test]
fn a_witness_stands_in_its_class_as_far_from_its_borders_as_is_said() {
    let class = bifdiag(&format!("class {FREQUENT} --json")).succeeds().json();
    let list = |name: &str| {
        let numbers = class["witness"][name].as_array().unwrap();
        numbers.iter().map(|number| number.as_str().unwrap()).collect::<Vec<_>>().join(",")
    };
    let line = format!("classes --at --A {} --r {} --physical --lines 6", list("A"), list("r"));
    let found = bifdiag(&format!("{line} --json")).succeeds().json();
    assert_eq!((&found["name"], &found["known"]), (&class["name"], &Value::from(true)));
    let borders = found["borders"].as_array().unwrap();
    assert!(!borders.is_empty());
    let distances: Vec<f64> = borders.iter().map(|border| border["distance"].as_f64().unwrap()).collect();
    assert!(distances.is_sorted() && distances[0] >= 0.99 * class["distance"].as_f64().unwrap(), "{distances:?}");
    // Each border is reported from the other side, too.
    let neighbours = class["neighbours"].as_array().unwrap();
    for border in borders {
        let reply = |n: &&Value| n["class"] == border["class"] && n["event"] == border["event"];
        assert!(neighbours.iter().any(|n| reply(&n)), "{border}");
    }
    bifdiag(&line).succeeds().printing(&format!("class {FREQUENT}")).printing("what happens on the border");
    assert_eq!(bifdiag(&format!("{line} --json --threads 1")).succeeds().json(), found);
}

#[test]
fn a_special_body_keeps_what_is_special_about_it() {
    // r in a principal plane: its class is that of the plane's bodies, and so are the classes beside it.
    let found = bifdiag("classes --at --body paper --lines 4 --json").succeeds().json();
    assert_eq!(found["name"], "4b99dc25201f");
    for border in found["borders"].as_array().unwrap() {
        assert_eq!(border["r"].as_array().unwrap().iter().filter(|x| x.as_f64() == Some(0.0)).count(), 1, "{border}");
    }
    // Nothing about a ball can change.
    let ball = bifdiag("classes --at --A 1,1,1 --r 0,0,1 --json").succeeds().json();
    assert!(ball["name"].is_string() && ball["borders"].as_array().unwrap().is_empty());
}

#[test]
fn a_body_beside_a_border_or_on_it_is_reported_so() {
    // J_r = A1 = 1, and the cusp of S3 reaches its pitchfork at A3 = 0.75: for A with the sum 2 the way there is at most
    // that on which A3 alone changes, and a little less.
    let nearest = |third: &str| {
        let found = bifdiag(&format!("classes --at --A 1,1.4,{third} --r 1,0,0 --lines 6 --json")).succeeds().json();
        found["borders"][0]["distance"].as_f64().expect("there is a border")
    };
    let straight = 2.0 * 1e-5 / 3.15 * 1.25;
    let beside = nearest("0.74999");
    assert!(0.2 * straight < beside && beside < straight, "{beside} {straight}");
    assert!(nearest("0.75") < 1e-15);
    let reply = bifdiag("classes --at --A 1,1.4,0.75 --r 1,0,0 --lines 6").succeeds();
    reply.printing("distance at most").printing("\n1e-13           ").printing("axes by rising moments");
}

/// Borders that whole bisection found, without the two bodies that take longest.
const KNOWN_BORDERS: [(&str, &[(&str, f64)]); 8] = [
    ("--body katok:1", &[]),
    ("--body katok:6", &[("aada7735f947", 0.036_608_512_1), ("09327658d519", 0.109_261_111_7)]),
    ("--body kovalevskaya", &[("b2ed0aa3d328", 0.178_144_708_6)]),
    ("--body goryachev-chaplygin", &[("b2ed0aa3d328", 0.395_877_130_1)]),
    ("--A 1,1,2 --r 0.3,0.4,0.5", &[("4d2d3c8a9332", 0.457_942_540_7)]),
    ("--A 3,2,1 --r 0,0.7,0.1", &[("578b047db931", 0.000_767_603_481_6), ("d44a57eae85d", 0.036_149_179_78)]),
    ("--A 2,1.7,1 --r 0.4,0.5,0.6", &[("4ba1a9867682", 0.036_741_440_54), ("2c8e792e0880", 0.316_680_868_7)]),
    (
        "--A 1.3,1.1,1 --r 0.2,0.9,0.3",
        &[("7b9223626649", 0.003_406_714_996), ("01036ac4a504", 0.041_463_086_22), ("1aa01b2480c4", 0.333_450_357_6)],
    ),
];

/// The search goes to zeros of functions in place of bisecting on classes: it finds the same borders, as near as before;
/// what its own diagram does not suggest, random lines find.
#[test]
fn borders_are_those_that_bisection_found() {
    /// The search finds the nearest place in coordinates, in which angles are a little longer.
    const STRETCH: f64 = 0.005;
    for (body, known) in KNOWN_BORDERS {
        let nearest = |lines: &str| {
            let found = bifdiag(&format!("classes --at {body}{lines} --json")).succeeds().json();
            let borders = found["borders"].as_array().unwrap().clone();
            borders
                .into_iter()
                .map(|border| (border["class"].as_str().unwrap().to_owned(), border["distance"].as_f64().unwrap()))
                .collect::<Vec<_>>()
        };
        let (alone, lines) = (nearest(""), nearest(" --lines 48"));
        // The nearest one is found without lines.
        for ((class, distance), (name, again)) in alone.iter().zip(&lines).take(1) {
            assert!(class == name && (distance / again - 1.0).abs() < STRETCH, "{body} {alone:?} {lines:?}");
        }
        assert_eq!(alone.is_empty(), lines.is_empty(), "{body}");
        for (class, distance) in known {
            let found =
                lines.iter().find(|(name, _)| name == class).unwrap_or_else(|| panic!("{body} {class} {lines:?}"));
            assert!(found.1 <= distance * (1.0 + STRETCH), "{body} {found:?}");
        }
    }
}

/// Beside a body on a border lies the class of its other side, whichever side has its own.
#[test]
fn a_body_on_a_border_has_both_of_its_classes() {
    // The cusp of the pair over axis b reaches its pitchfork where r lies on axis c and 3 (c − b) = b.
    for (body, beyond) in [
        ("--A 4,4,3 --r 1,0,0", "68a872a3c6e2"),
        ("--A 1,1,3/4 --r 0,1,0", "68a872a3c6e2"),
        ("--A 4,3.5,3 --r 1,0,0", "aada7735f947"),
        ("--A 4,2,3 --r 1,0,0", "3038266a24cb"),
        ("--A 1.3,2.1,1.575 --r 0,1,0", "3038266a24cb"),
    ] {
        let found = bifdiag(&format!("classes --at {body}")).succeeds();
        found
            .printing(&format!("\n1e-13             {beyond}  the cusp of "))
            .printing("the body is on a border of its class");
    }
}

/// J_r = A₂: one of the two bodies is on the border itself.
#[test]
fn a_border_may_be_at_a_body() {
    bifdiag("compare A=2,3,4;r=1,1,1 A=2,3,4;r=1,1,1.001").succeeds().printing("\n0   7b9223626649  J_r passes A2");
    for body in ["--A 2,3,4 --r 1,1,1", "--A 1,2,3 --r 1,1,1", "--A 3,4,5 --r 1,0,1", "--A 3,5,7 --r 2,1,2"] {
        let standing = bifdiag(&format!("classes --at {body}")).succeeds();
        standing.printing("\n1e-13  ").printing("J_r passes A2").printing("the body is on a border of its class");
    }
    for (z, distance) in
        [("1.00000000001", "1.659e-12"), ("1.000000000001", "1.658e-13"), ("0.99999999999", "1.659e-12")]
    {
        let line = format!("classes --at --A 2,3,4 --r 1,1,{z}");
        bifdiag(&line).succeeds().printing(distance).printing("J_r passes A2");
    }
}

/// Where a moment without weight on its axis passes one with it, the classes end on both sides.
#[test]
fn the_border_at_equal_moments_of_a_special_body_is_listed_from_both_sides() {
    for (body, beyond, distance) in [
        ("--A 4,2,3.9 --r 1,0,0", "efc655840cb4", 0.1 / 9.9 * 2_f64.sqrt()),
        ("--A 4,2,4.1 --r 1,0,0", "aada7735f947", 0.1 / 10.1 * 2_f64.sqrt()),
        ("--A 5,3,4 --r 1,0,0", "efc655840cb4", 1.0 / 12.0 * 2_f64.sqrt()),
        ("--A 3,2.9,2 --r 1,0,1", "578b047db931", 0.1 / 7.9 * 2_f64.sqrt()),
    ] {
        let found = bifdiag(&format!("classes --at --json {body}")).succeeds().json();
        let border = found["borders"].as_array().unwrap().iter().find(|border| border["class"] == beyond).unwrap();
        assert!((border["distance"].as_f64().unwrap() / distance - 1.0).abs() < 1e-6, "{body} {border}");
    }
}

/// 3 = 2 + 1 is a flat body, if its centre of mass lies in its plane.
#[test]
fn a_centre_of_mass_off_the_plane_is_the_reason_of_a_refusal() {
    bifdiag("classes --at --A 3,2,1 --r 1,1,1 --physical").refused().telling("or Ai + Aj = Ak with rk = 0");
    bifdiag("classes --at --A 3,2,1 --r 0,1,1 --physical").succeeds();
}

/// On the way from a flat to a long symmetric body lies the ball.
#[test]
fn the_ball_is_the_border_of_symmetric_bodies() {
    let found = bifdiag("classes --at --A 1.009,1.009,1.686 --r 0.969,0.726,0.528").succeeds();
    found.printing("the moments A1, A2 and A3 are equal there");
}

/// Beside a more special body, nearer than doubles tell it, no borders are named: they would be those of that one.
#[test]
fn borders_beside_a_more_special_body_are_not_sought() {
    let at = |second: &str| bifdiag(&format!("classes --at --A 1,{second},1.5 --r 0,0,1")).succeeds();
    for second in ["1.00000000000000000001", "1.0000000000000001", "1.00000000000001", "1.00000001", "1.00000001999"] {
        at(second).printing("its borders are not sought: a more special body is within 1e-8 of it");
    }
    for second in ["1", "1.0000001", "1.0001"] {
        at(second).printing("distance at most");
    }
    bifdiag("classes --at --A 5,7,9 --r 1e-12,1,2").succeeds().printing("its borders are not sought");
}

/// The class that is listed is the next one on the line through the body and the border, though f64 does not tell it.
#[test]
fn the_class_beyond_is_that_beside_the_border() {
    let found = bifdiag("classes --at --A 5,7,9 --r 0,1e-7,2 --json").succeeds().json();
    let borders = found["borders"].as_array().unwrap();
    assert!(!borders.is_empty());
    let numbers =
        |value: &Value| -> Vec<f64> { value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect() };
    for border in borders {
        let beyond = |from: [f64; 3], to: &Value| {
            let entries = from.iter().zip(numbers(to)).map(|(x, y)| (y + 1e-4 * (y - x)).to_string());
            entries.collect::<Vec<_>>().join(",")
        };
        let [a, r] =
            [beyond([10.0 / 21.0, 14.0 / 21.0, 18.0 / 21.0], &border["A"]), beyond([0.0, 5e-8, 1.0], &border["r"])];
        let there = bifdiag(&format!("classes --at --lines 1 --A {a} --r {r} --json")).succeeds().json();
        assert_eq!(there["name"], border["class"], "{border}");
    }
}
