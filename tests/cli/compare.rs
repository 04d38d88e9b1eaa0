//! `bifdiag compare`: what two bodies have in common and where they differ.

use serde_json::{Value, json};

use crate::builder::bifdiag;

/// The entries of a list whose counts differ between the two bodies.
fn differing(compared: &Value, list: &str) -> Vec<Value> {
    let entries = compared[list].as_array().unwrap();
    entries.iter().filter(|entry| entry["counts"][0] != entry["counts"][1]).cloned().collect()
}

#[test]
fn a_rotated_reflected_permuted_or_scaled_body_differs_in_nothing() {
    for (first, second) in [
        ("A=2,1.1,1;r=0.94868,0,0.61623", "A=1,2,1.1;r=-0.61623,0.94868,0"),
        ("A=2,1.1,1;r=3,1,2", "A=10,20,11;r=4,-6,2"),
        ("A=1,1,2;r=0.3,0.4,0.5", "A=2,1,1;r=0.5,-0.5,0"),
        ("A=1,2,2;r=0.5,0.3,0.4", "A=2,2,1;r=0,0.5,0.5"),
        ("A=1,1,1;r=3,4,12", "A=2,2,2;r=0,0,1"),
        ("A=2,2,1;r=1,0,0", "A=1,2,2;r=0,3,4"),
    ] {
        let found = bifdiag("compare").and(first).and(second).arguments("--json").succeeds().json();
        assert_eq!(found["same_class"], json!(true), "{first} {second}");
        for list in ["events", "stability_changes"] {
            assert_eq!(differing(&found, list), [] as [Value; 0], "{first} {second} {list}");
        }
        for kind in found["regions"].as_array().unwrap() {
            let counts = [0, 1].map(|which: usize| kind["regions"][which].as_array().unwrap().len());
            assert_eq!(counts[0], counts[1], "{first} {second} {kind}");
        }
    }
}

/// With equal moments there are fewer branches, and they have other numbers: G1 of one body is what G2 is of the other.
#[test]
fn branches_of_bodies_with_other_strata_are_not_reported_by_their_numbers() {
    let symmetric = "A=1,1,2;r=0.3,0.4,0.5";
    let found =
        bifdiag("compare").and(symmetric).and("A=1,1.001,2;r=0.3,0.4,0.5").arguments("--json").succeeds().json();
    let text = format!("{} {}", found["events"], found["stability_changes"]);
    assert!(!text.contains("G1") && !text.contains("G2"), "{text}");
    let both = |list: &str, branch: &str| {
        let entries = found[list].as_array().unwrap();
        entries.iter().any(|e| e.to_string().contains(branch) && e["counts"][0] == e["counts"][1])
    };
    assert!(both("events", "between axes 2 and 3") && both("stability_changes", "from −r̂"), "{text}");
    // Of the ways of turning r about the axis of symmetry, the one that leads to the other body.
    let near = bifdiag("compare").and(symmetric).and("A=1,1.1,2;r=0.5,0.1,0.5").arguments("--json").succeeds().json();
    assert_eq!(near["path"]["ends"][0]["r"], json!(["4/5", "3/5", "1"]));
    assert_eq!(near["path"]["turned"], json!([true, false]));
    let reply = bifdiag("compare").and(symmetric).and("A=1,1.1,2;r=0.5,0.1,0.5").succeeds();
    reply.printing("1 has equal moments: its r is turned among their axes");
}

/// A ball has no axes of its own: its r is turned to that of the other body, so that no symmetry is broken on the way.
#[test]
fn a_ball_is_turned_to_the_other_body() {
    let reply = bifdiag("compare").and("A=1,1,1;r=3,4,12").and("A=1,1.2,1.3;r=0,0,1").succeeds().stdout();
    assert!(!reply.contains("the body has the symmetry"), "{reply}");
    assert!(reply.contains("the moments A1, A2 and A3 are equal there") && reply.contains("r is turned"), "{reply}");
    let other = bifdiag("compare").and("A=1,1.2,1.3;r=0.1,0.2,1").and("A=1,1,1;r=3,4,12").arguments("--json");
    let path = other.succeeds().json()["path"].clone();
    assert_eq!((&path["ends"][0]["r"], &path["turned"]), (&path["ends"][1]["r"], &json!([false, true])));
}

/// From a body without weight, of which no moment carries r, to one of which all do.
#[test]
fn the_path_may_begin_without_weight() {
    for first in ["A=3,2,1;r=0,0,0", "A=2,2,1;r=0,0,0"] {
        let found = bifdiag("compare").and(first).and("A=2,1.1,1;r=0.5,-0.2,0.7").succeeds();
        found.printing("r is 0 there: the body has no weight");
    }
}

/// The document knows bodies, not the names or files by which they were asked for.
#[test]
fn the_document_is_the_same_however_a_body_is_named() {
    let named = bifdiag("compare paper katok:1 --json").succeeds().stdout();
    let given = bifdiag("compare --json").and("A=2,1.1,1;r=0.94868,0,0.61623").and("A=1,1.6,1.3;r=1,0,0").succeeds();
    assert_eq!(named, given.stdout());
}
