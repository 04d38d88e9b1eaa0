//! `bifdiag scan border`: where classes end on the way from one body to another.

use serde_json::Value;

use crate::builder::bifdiag;

#[test]
fn katoks_borders_come_out_exactly() {
    let k2: f64 = 1.0 - 0.7;
    let cases = [
        ("--body katok:2 --vary A3=0.7:0.8", "A3", 0.75, "cusp-at-pitchfork", "the cusp of S3 reaches its pitchfork"),
        ("--body katok:4 --vary A2=0.93:1.07", "A2", 1.0, "pitchfork-at-infinity", "a pitchfork goes through infinity"),
        ("--body katok:1 --vary A3=0.9:1.2", "A3", 1.0, "pitchfork-at-infinity", "a pitchfork goes through infinity"),
        (
            "--A 1,0.7,0.6 --r 1,0,0 --vary A3=0.62:0.698",
            "A3",
            1.0 - 0.25 / (1.0 / k2.sqrt() - 1.0),
            "pitchfork-on-curve",
            "the pitchfork of L- and S3 passes through S2",
        ),
        ("--A 2,1.1,1 --r 1,0,0 --vary A2=1.3:1.9", "A2", 1.5, "cusp-at-pitchfork", "S2"),
    ];
    for (line, parameter, expected, kind, text) in cases {
        let found = bifdiag(&format!("scan border {line} --json")).succeeds().json();
        let border = &found["borders"][0];
        assert_eq!(border["at"][0]["parameter"], parameter, "{line}");
        let value = border["at"][0]["value"].as_f64().unwrap();
        assert!((value - expected).abs() < 1e-10, "{line}: {value} for {expected}");
        assert_eq!((&border["reached"], &border["kind"]), (&Value::Bool(true), &Value::from(kind)), "{line}");
        assert!(border["text"].as_str().unwrap().contains(text), "{line}: {}", border["text"]);
    }
    let reply = bifdiag("scan border --body katok:2 --vary A3=0.7:0.8").succeeds();
    reply.printing("A3 = 0.75, exactly").printing("at h = 3, l = 2,");
}

#[test]
fn a_border_at_a_special_body_says_what_becomes_special() {
    let cases = [
        (
            "--A 1,1,2 --r 0.3,0.4,0.5 --vary A3=0.5:2",
            1.0,
            "moments-equal",
            "the moments A1, A2 and A3 are equal there",
        ),
        ("--A 1,1,1 --r 1,2,3 --vary A3=0.5:2", 1.0, "moments-equal", "the moments A1, A2 and A3 are equal there"),
        (
            "--A 1,1,2 --r 0,0.4,0.5 --vary A3=0.7:1.3",
            1.0,
            "moments-equal",
            "the moments A1, A2 and A3 are equal there",
        ),
        ("--A 1,1,1 --r 1,0,0 --vary A1=1:2", 1.0, "moments-equal", "the moments A1, A2 and A3 are equal there"),
        ("--body paper --vary A2=1:1.1", 1.0, "moments-equal", "the moments A2 and A3 are equal there"),
        ("--A 2,1.5,1 --r 0,0,0 --vary r1=0:1", 0.0, "weight-vanishes", "r is 0 there: the body has no weight"),
        (
            "--A 1,1.4,0.8 --r 1,0,0 --vary r2=0:0.5",
            0.0,
            "symmetry-broken",
            "r2 is 0 there: only there the body has the symmetry",
        ),
        // At the upper end r3 does not leave 0, it comes there.
        (
            "--A 2,1.1,1 --r 0.94868,0,0.6 --vary r3=-1e-6:0",
            0.0,
            "symmetry-broken",
            "r3 is 0 there: only there the body has the symmetry",
        ),
    ];
    for (line, expected, kind, text) in cases {
        let found = bifdiag(&format!("scan border {line} --json")).succeeds().json();
        let border = &found["borders"][0];
        assert_eq!((&border["kind"], &border["text"]), (&Value::from(kind), &Value::from(text)), "{line}");
        assert!((border["at"][0]["value"].as_f64().unwrap() - expected).abs() < 1e-15, "{line}: {}", border["at"]);
        assert_eq!((&border["reached"], &border["h"]), (&Value::Bool(true), &Value::Null), "{line}");
    }
}

/// Beside A1 = A2 with r3 = 0 the pitchfork of L+ opens into a cusp: none goes through infinity.
#[test]
fn a_symmetry_broken_at_equal_moments_sends_no_pitchfork_to_infinity() {
    let text = bifdiag("compare A=1,1,2;r=1,0,0 A=5,7,10;r=1,0,1").succeeds().stdout();
    assert!(text.contains("the moments A1 and A2 are equal there"), "{text}");
    assert!(!text.contains("a pitchfork goes through infinity"), "{text}");
}

#[test]
fn a_border_at_the_end_of_its_way_is_exact() {
    let found = bifdiag("scan border --A 1,1.4,0.75 --r 1,0,0 --vary A3=0.7:0.75").succeeds();
    found.printing("A3 = 0.75, exactly").printing("at h = 3, l = 2,");
}

/// A body that is looked at lies on a border, J_r = A2 or A3 = 4: those beyond it show their events all the same.
#[test]
fn bodies_on_borders_hide_no_others() {
    let document = |line: &str| bifdiag(&format!("scan events {line} --json")).succeeds().json();
    let ats = |document: &Value| {
        let mut ats: Vec<f64> = Vec::new();
        for event in document["events"].as_array().unwrap() {
            ats.extend(event["at"].as_array().unwrap().iter().map(|at| at.as_f64().unwrap()));
        }
        ats.sort_by(f64::total_cmp);
        ats.dedup();
        ats
    };
    let found = document("--A 3,3,4 --r 0,0,1 --vary A3=3.1:5.5:25");
    assert_eq!(found["passed"], 1, "{found}");
    // Every body but A3 = 4, and two beside it.
    assert_eq!(ats(&found).len(), 26, "{found}");
    let found = document("--A 2,1.1,1 --r 0.94868,0,0.61623 --vary A2=0.9:1.2:7");
    let [bodies, passed] = ["bodies", "passed"].map(|name| found[name].as_u64().unwrap());
    // Two beside each that is left out.
    assert_eq!((ats(&found).len() as u64, bodies), (7 + passed, 7), "{found}");
    for line in ["--A 5,3,4 --r 1,2,-0.5 --vary A1=3.5:7:36", "--A 1,1.6,0.7 --r 1,0,0 --vary A2=0.6:1.6:11"] {
        let found = document(line);
        assert!(found["passed"].as_u64().unwrap() <= 8, "{line}: {found}");
    }
    // Of five bodies two lie on borders, where J_r passes the middle moment: these and A2 = A3, A1 = A3 are found all the same.
    let places = |bodies: u32| -> Vec<f64> {
        let found = document(&format!("--A 2,1.5,1 --r 1,1,1 --vary A3=1:4:{bodies}"));
        let place = |border: &Value| border["at"][0]["value"].as_f64().unwrap();
        found["borders"].as_array().unwrap().iter().map(place).collect()
    };
    let fine = places(41);
    for bodies in [5, 7, 13] {
        let found = places(bodies);
        for known in [1.5, 1.75, 2.0, 2.5] {
            assert!(found.iter().any(|at| (at - known).abs() < 1e-9), "{bodies}: {known}: {found:?}");
        }
        assert!(found.windows(2).all(|pair| pair[0] < pair[1]), "{found:?}");
        assert!(found.iter().all(|at| fine.iter().any(|known| (at - known).abs() < 1e-8)), "{found:?} {fine:?}");
    }
    let found = bifdiag("scan events --A 5,3,4 --r 1,2,1 --vary A3=3.2:3.6:5").succeeds();
    found.printing("A3 = 3.4: J_r passes A3").printing("at a border or special body, which is not, it may be infinite");
}

/// A2 = 1 and A2 = 3 are special, and the class changes once between 2 and 3.
#[test]
fn borders_beside_special_ends_are_found() {
    for range in ["2:3:2", "1:3:3", "2.01:3:2"] {
        let found =
            bifdiag(&format!("scan events --A 3,2,1 --r 0.3,0.4,0.5 --vary A2={range} --json")).succeeds().json();
        let last = found["borders"].as_array().unwrap().last().expect("a border")["at"][0]["value"].as_f64().unwrap();
        assert!((last - 2.065_799).abs() < 1e-5, "{range}: {last}");
        // Beyond it there is no crossing of G2 and P+.
        let crossings =
            found["events"].as_array().unwrap().iter().filter(|one| one["event"] == "crossing of G2 and P+");
        let ends: Vec<f64> =
            crossings.map(|one| one["at"].as_array().unwrap().last().unwrap().as_f64().unwrap()).collect();
        assert!(!ends.is_empty() && ends.iter().all(|end| *end < last), "{range}: {ends:?}");
    }
    let line = "scan events --A 3,2,1 --r 0.3,0.4,0.5 --no-plot --vary";
    bifdiag(line)
        .and("A2=2:3:2")
        .succeeds()
        .printing("2 bodies; 1 border or special body between them\n1 of them is left out");
    // As many bodies as were asked for.
    bifdiag(line).and("A2=1:3:2").succeeds().printing("A2 from 1 to 3: 2 bodies;");
    let found = bifdiag(line).and("A2=1:3:2").and("--json").succeeds().json();
    let counts = [&found["vary"]["steps"], &found["bodies"], &found["passed"]].map(|count| count.as_u64().unwrap());
    assert_eq!(counts, [2, 2, 2], "{found}");
}

/// The border is A1 = 4 A2/3: the error that is printed holds the rounding of the value.
#[test]
fn the_error_of_a_border_holds_the_exact_value() {
    for (body, vary, [above, below]) in [
        ("10,17,3", "A1=18:30", [68.0, 3.0]),
        ("5,4.1,3", "A1=5.2:6", [82.0, 15.0]),
        ("5,2.2,1", "A1=2.5:3.5", [44.0, 15.0]),
        ("5,4,3", "A1=4.5:5.5", [16.0, 3.0]),
        ("1,7,2", "A1=7.1:10", [28.0, 3.0]),
    ] {
        let found = bifdiag(&format!("scan border --A {body} --r 1,0,0 --vary {vary} --json")).succeeds().json();
        let at = &found["borders"][0]["at"][0];
        let (value, error) = (at["value"].as_f64().unwrap(), at["error"].as_f64().unwrap());
        // The product is exact but for one rounding.
        let off = value.mul_add(below, -above).abs() / below;
        assert!(off <= error && error < 1e-13, "{body}: {value} {off:e} {error:e}");
    }
}
