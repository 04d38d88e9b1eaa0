//! Bodies and points of an attack that were answered wrongly once, or not at all.

use serde_json::{Value, json};

use crate::builder::bifdiag;

fn classified(line: &str) -> Value {
    bifdiag(&format!("classify {line} --json")).succeeds().json()
}

/// The classes that a critical point names, as signatures; `forbidden` for none.
fn candidates(document: &Value) -> Vec<String> {
    let section = |component: &Value| component["section"].as_str().unwrap().to_owned();
    let class = |candidate: &Value| match candidate["status"].as_str().unwrap() {
        "regular" => candidate["components"].as_array().unwrap().iter().map(section).collect::<Vec<_>>().join("+"),
        other => other.to_owned(),
    };
    let mut found: Vec<String> = document["candidates"].as_array().unwrap().iter().map(class).collect();
    found.sort();
    found
}

/// Where f64 makes no atlas, a class was offered that no body has, and the truth was not.
#[test]
fn points_in_thin_cells_are_decided() {
    let near_axis = "--A 1.2268999252988841,0.21015454706989597,1.2268999067158415 \
                     --r=-1.5404249988253296e-09,1.0,1.0582905332252536e-08 \
                     --h=1.000000038737586816573450309527131260653 --l=1.276e-04";
    let far_out = "--A 1.3,1,0.7 --r 1,1e-16,2e-16 --h 105783887850000000000000000000002623321e-38 --l 0.38779";
    for line in [near_axis, far_out] {
        assert_eq!(classified(line)["status"], "regular", "{line}");
    }
}

/// A pole line far above the minimum: the empty region does not meet there.
#[test]
fn a_point_on_a_pole_line_names_the_two_classes_beside_it() {
    let document = classified("--A 2,1,3 --r 1,2,2 --h=-11999999/4000000 --l 1/1000");
    assert_eq!(document["status"], "critical");
    let found = candidates(&document);
    assert!(found.len() == 2 && !found.contains(&"forbidden".to_owned()), "{found:?}");
}

/// l within 1e-12 of a cusp's, h far from every curve.
#[test]
fn far_above_a_cusp_nothing_is_open() {
    let document = classified("--body paper --h 5 --l 2.011434659319437");
    assert_eq!(document["status"], "regular");
    assert!((document["margin"]["h"].as_f64().unwrap() - 2.26).abs() < 0.01);
}

/// Three curves meet nearly: the nearest of them is named, and the pole line 1 % away is not.
#[test]
fn the_margin_names_the_curve_that_is_nearest() {
    let body = "--A 543854/68355,589424/68355,288662/68355 --r 26000000/9,5000000/3,400000";
    let document = classified(&format!("{body} --h 81119800000/13671 --l 261299200/41013"));
    assert_ne!(document["margin"]["nearest"], json!("P-"));
}

/// A right question is no wrong input, in a batch and alone.
#[test]
fn a_refusal_is_not_counted_as_a_wrong_line() {
    let (body, point) = ("--A 7,7.000000001,15/4 --r 0,0,8/9", "--h 3242/135 --l 41/3");
    assert_eq!(classified(&format!("{body} {point}"))["status"], "critical");
    let line = r#"{"A":["7","7.000000001","15/4"],"r":["0","0","8/9"],"h":"3242/135","l":"41/3"}"#;
    bifdiag("classify --batch -").reading(line).succeeds().telling_nothing();
}

/// An id became a part of a path.
#[test]
fn regions_of_a_file_name_no_other_folder() {
    let place = tempfile::tempdir().unwrap();
    let atlas = bifdiag("--body paper --json").succeeds().stdout();
    std::fs::write(place.path().join("a.json"), atlas.replace("\"R6\"", "\"R6/../../escaped\"")).unwrap();
    let section = "section --atlas a.json --orbits 1 --crossings 3 --no-plot --data o.npz";
    bifdiag(section).inside(place.path()).refused().telling("R6/../../escaped");
    assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 1);
}

/// What clap quotes reached the terminal raw.
#[test]
fn control_characters_of_arguments_are_escaped() {
    for option in ["--body=", "--A=", "--window="] {
        bifdiag("").and(format!("{option}pa\u{1b}]0;x\u{7}")).refused().telling(r"pa\u{1b}]0;x\u{7}");
    }
}

#[test]
fn a_circle_that_leaves_a_curve_is_no_pair() {
    bifdiag("show E3 --body lagrange").succeeds().printing("pitchfork: a circle of relative equilibria leaves a curve");
}

#[test]
fn a_curve_at_which_nothing_is_said_to_change_leads_to_one() {
    let reply = bifdiag("show P+ --body kovalevskaya").succeeds().stdout();
    assert!(
        reply.contains("no region is listed as a neighbour across it; show ") && !reply.contains("with rising h"),
        "{reply}"
    );
}

/// Without weight every region reaches h = l = 0; only the forbidden one was reported.
#[test]
fn a_free_body_at_rest_lies_where_all_regions_meet() {
    let found = bifdiag("classify --A 1.3,2.1,1.6 --r 0,0,0 --h 0 --l 0").succeeds();
    found.printing("the forbidden region").printing("region R1").printing("region R2").printing("region R3");
}

/// The numbers of the search are rounded, and lay beyond the border: the body's own class was the one beyond.
#[test]
fn a_body_on_a_border_has_another_class_beyond() {
    for body in ["--A 1.3,2.1,1.575 --r 0,1,0", "--A 8,7,6 --r 1,0,0"] {
        let document = bifdiag(&format!("classes --at {body} --json")).succeeds().json();
        let name = &document["name"];
        let beyond = document["borders"].as_array().unwrap();
        assert!(beyond.iter().all(|border| border["class"] != *name), "{body}: {document}");
    }
}
