//! What the terminal shows, and how the body may be given.

use serde_json::{Value, json};

use crate::builder::bifdiag;

#[test]
fn numbers_are_read_exactly_and_echoed_as_given() {
    let done = bifdiag("classify --A 2,11/10,1e0 --r=-1e-3,0,+1/3 --h -1e-3 --l -13/4 --json").succeeds();
    let document = done.json();
    assert_eq!(document["A"], json!(["2", "11/10", "1e0"]));
    assert_eq!(document["r"], json!(["-1e-3", "0", "+1/3"]));
    assert_eq!((&document["h"], &document["l"]), (&json!("-1e-3"), &json!("-13/4")));
}

#[test]
fn values_that_start_with_a_hyphen_need_no_equals_sign() {
    bifdiag("critical --A 2,1,1 --r -1,-2,-3 --l -1").succeeds().printing("r = (-1, -2, -3)").printing("l = -1");
}

#[test]
fn the_body_is_shown_above_the_tables() {
    bifdiag("classify --body paper --h 3.8 --l 3.25").succeeds().printing("A = (2, 1.1, 1)").printing("h = 3.8");
    bifdiag("critical --body paper --l 3.25")
        .succeeds()
        .printing("gamma")
        .printing("small motions")
        .printing("l = 3.25");
}

#[test]
fn a_diagonal_part_is_the_same_as_its_principal_body() {
    let part = "--inertia 0.3,0.1,0.25,0,0,0 --com 0.05,0,-1/8 --mass 2 --g 9.81";
    let given = bifdiag(&format!("classify {part} --h 1 --l 0.2 --json")).succeeds().json();
    assert_eq!(given["A"], json!(["0.3", "0.1", "0.25"]));
    assert_eq!(given["r"], json!(["0.981", "0", "-2.4525"]));
    let part = &given["part"];
    assert_eq!(part["principal"]["axes"], json!([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]));
    assert_eq!((&part["exact"], &part["physical"]), (&json!(true), &json!(true)));
    assert_eq!((&part["com"], &part["units"]), (&json!(["0.05", "0", "-0.125"]), &json!("kg,m,s")));
    assert_eq!(part["inertia"], json!([["0.3", "0", "0"], ["0", "0.1", "0"], ["0", "0", "0.25"]]));
    let principal = bifdiag("classify --A 0.3,0.1,0.25 --r 0.981,0,-2.4525 --h 1 --l 0.2 --json").succeeds().json();
    for key in ["status", "components", "margin", "signature"] {
        assert_eq!(given[key], principal[key], "{key}");
    }
}

#[test]
fn a_part_tells_its_axes_and_units() {
    let part = "--inertia 0.30,0.21,0.17,0.01,0,-0.02 --products tensor --com 0,0.02,0.15 --mass 2.5 --g 9.80665";
    bifdiag(&format!("critical {part} --l 1")).succeeds().printing("A in kg m^2").printing("principal axes");
    let atlas = bifdiag(&format!("{part} --json")).succeeds().json();
    let part = &atlas["body"]["part"];
    assert_eq!((&part["exact"], &part["A"]), (&json!(false), &atlas["body"]["A"]));
    // 130 digits and more.
    assert!(atlas["body"]["A"][0].as_str().unwrap().len() > 130);
}

#[test]
fn strange_bodies_are_accepted_with_a_warning() {
    let warning = "warning: no mass distribution has these moments and this centre of mass";
    bifdiag("critical --A 9,1,1 --r 1,0,0 --l 1").succeeds().telling(warning);
    bifdiag("critical --A 9,1,1 --r 1,0,0 --l 1 -q").succeeds().telling_nothing();
    bifdiag("critical --A 0.3,0.1,0.2 --r 0,1,0 --l 1").succeeds().telling_nothing();
    let central = "--inertia 0.4,0.4,0.4,0,0,0 --com 0,0,1 --mass 1 --g 9.81";
    bifdiag(&format!("critical {central} --l 1 --unphysical")).succeeds().telling("no mass distribution");
    let flags = bifdiag("--A 9,1,1 --r 1,0,0 --json -q").succeeds().json();
    assert_eq!(flags["body"]["unphysical"], true);
}

#[test]
fn a_turned_plate_is_a_plate_although_its_moments_are_rounded() {
    let part = "--inertia 0.164,0.136,0.3,0.05,0,0 --products tensor --com 0,0,0 --mass 1 --g 9.81";
    let body = bifdiag(&format!("{part} --json")).succeeds().telling_nothing().json()["body"].clone();
    assert_eq!(
        (&body["plate"], &body["unphysical"], &body["part"]["exact"]),
        (&json!(true), &json!(false), &json!(false))
    );
}

#[test]
fn timings_go_to_stderr_and_change_nothing() {
    let plain = bifdiag("--body paper --json").succeeds().telling_nothing().stdout();
    let timed = bifdiag("--body paper --json --timings -v").succeeds().telling("timing: total").telling("info: ");
    assert_eq!(timed.stdout(), plain);
    bifdiag("--timings classify --body paper --h 1 --l 1").succeeds().telling("timing: classify");
    // Closer to a curve than f64 tells: seven heights, each by intervals.
    let near = "--timings classify --body paper --h 4.645784643886435 --l 3.25";
    bifdiag(near).succeeds().telling("work: point").telling("further").telling("64 bits             7");
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    for line in
        ["--body paper --json", "critical --body ten --l 1.45 --json", "classify --body plate --h 1 --l 1 --json"]
    {
        assert_eq!(bifdiag(line).succeeds().stdout(), bifdiag(line).succeeds().stdout());
    }
}

#[test]
fn a_window_is_echoed() {
    let atlas = bifdiag("--body paper --json --window -1:6,0:7/2").succeeds().json();
    assert_eq!(atlas["window"], json!({"h": [-1.0, 6.0], "l": [0.0, 3.5]}));
    // How many relative equilibria there are is said of the half-plane alone: here it is 6, and in the window 2.
    let body = "atlas --A 3,2,1 --r 0.3,0.4,0.5 --no-plot";
    bifdiag(body).succeeds().printing(" events, at most 6 relative equilibria at one l\n");
    bifdiag(body)
        .arguments("--window 0:1,0:1")
        .succeeds()
        .printing("\n* cut by the window: width and l-range are those of the whole region\n")
        .printing("\n3 regions, 0 events\nonly what lies in the window is listed");
}

/// Two of the paper's nine regions, as the contract prints them.
#[test]
fn a_point_of_the_paper_is_classified() {
    let document = bifdiag("classify --body paper --h 3.8 --l 3.25 --json").succeeds().telling_nothing().json();
    assert_eq!((&document["status"], &document["signature"]), (&json!("regular"), &json!("S2+T2")));
    let expected = |section: &str, genus: u32, poles: &[&str]| {
        json!({"boundary_circles": 1, "poles": poles, "accessible_region": "D2", "energy_surface": "S3",
               "section": section, "genus": genus})
    };
    assert_eq!(document["components"], json!([expected("S2", 0, &[]), expected("T2", 1, &["+"])]));
    // The nearest curve is the second minimum at 3.484722441 (to 1e-9).
    assert!((document["margin"]["h"].as_f64().unwrap() - 0.315_277_559).abs() < 1e-9);
    bifdiag("classify --body paper --h 3.8 --l -3.25").succeeds().printing("regular").printing("D2  S3  T2  1      +");
    bifdiag("classify --body paper --h -5 --l 1").succeeds().printing("forbidden");
    bifdiag("classify --body euler --h 9 --l 1").succeeds().printing("note: r = 0");
}

#[test]
fn newton_continuation_gives_the_list_of_the_closed_form() {
    for body in ["--body paper --l 3.25", "--body ten --l 1.45", "--body lagrange --l=-5", "--body paper --l 0"] {
        let list = |method: &str| {
            let document = bifdiag(&format!("critical {body} --json{method}")).succeeds().json();
            document["critical"].as_array().unwrap().clone()
        };
        let (closed, followed) = (list(""), list(" --method newton"));
        assert_eq!(followed.len(), closed.len(), "{body}");
        for (one, other) in followed.iter().zip(&closed) {
            assert_eq!([&one["branch"], &one["index"]], [&other["branch"], &other["index"]], "{body}");
            assert!((one["h"].as_f64().unwrap() - other["h"].as_f64().unwrap()).abs() < 1e-12, "{body}");
        }
    }
    bifdiag("critical --body paper --l 0:1:3 --method newton").refused().telling("follows the curves to one momentum");
}

#[test]
fn a_point_on_a_line_is_critical_with_its_candidates() {
    // Kovalevskaya's top: γ = e1 is critical with h = l²/4 − 1, an exact equality.
    let document = bifdiag("classify --body kovalevskaya --h=-3/4 --l 1 --json").succeeds().json();
    assert_eq!(document["status"], "critical");
    assert!(document["candidates"].as_array().unwrap().len() >= 2);
    assert!(document["components"].is_null());
    bifdiag("classify --body kovalevskaya --h=-3/4 --l 1")
        .succeeds()
        .printing("the forbidden region")
        .printing("region R1");
}

#[test]
fn a_momentum_beyond_f64_is_refused_or_an_error_in_place() {
    bifdiag("classify --body paper --h 1 --l 1e140").refused().telling("--l: l = 1e140 is too large");
    let answers = bifdiag("classify --body paper --batch -")
        .reading("{\"h\":1,\"l\":\"1e-140\"}\n{\"h\":1,\"l\":1}\n")
        .succeeds()
        .telling("1 of 2 lines")
        .json_lines();
    assert!(answers[0]["error"].as_str().unwrap().contains("is too small"));
    assert_eq!(answers[0]["line"], 1);
    assert_eq!(answers[1]["h"], "1");
}

#[test]
fn an_atlas_of_version_1_names_the_command_that_makes_it_anew() {
    let old =
        r#"{"schema_version": "1", "accuracy": "certified", "body": {"A": ["2", "1.1", "1"], "r": ["1", "0", "0"]}}"#;
    let wanted = "bifdiag atlas --A 2,1.1,1 --r 1,0,0 --certificate";
    for line in ["verify -", "section --atlas - --no-plot"] {
        bifdiag(line).reading(old).refused().telling("version 1").telling(wanted).printing_nothing();
    }
}

#[test]
fn an_atlas_of_version_2_names_its_own_command() {
    let old = r#"{"schema_version": "2", "command": "bifdiag atlas --A 2,1.1,1 --r=1,0,0 --no-polygons --json"}"#;
    let wanted = "bifdiag atlas --A 2,1.1,1 --r=1,0,0 --no-drawing --json";
    for line in ["verify -", "section --atlas - --no-plot"] {
        bifdiag(line).reading(old).refused().telling("version 2").telling(wanted).printing_nothing();
    }
}

#[test]
fn an_atlas_without_its_drawing_is_verified() {
    bifdiag("--body katok:1 --no-polygons --json").refused().telling("--no-drawing").printing_nothing();
    let whole = bifdiag("--body katok:1 --certificate --json").succeeds().stdout();
    let bare = bifdiag("--body katok:1 --certificate --no-drawing --json").succeeds();
    assert!(bare.json().get("drawing").is_none());
    let verified = |atlas: String| bifdiag("verify -").reading(atlas).succeeds().stdout();
    let first = verified(bare.stdout());
    assert!(first.starts_with("verified: ") && !first.contains("drawing"), "{first}");
    let (counts, rest) = first.split_once('\n').unwrap();
    assert_eq!(verified(whole), format!("{counts} (drawing not part of the proof)\n{rest}"));
}

/// A file that is refused cannot write `verified` in green, turn the line round or flood the terminal.
#[test]
fn messages_escape_what_controls_a_terminal() {
    let escape = "\\u001b[2K\\u001b[32mverified\\u009b0m\\u202e";
    let atlas = bifdiag("--body katok:1 --certificate --json").succeeds().stdout();
    let unmarked = |said: String| assert!(!said.contains(['\u{1b}', '\u{9b}', '\u{202e}']), "{said:?}");
    let run = |forged: String| bifdiag("verify -").reading(forged);
    unmarked(run(format!(r#"{{"schema_version": "{escape}", "command": "{escape}"}}"#)).refused().stderr());
    unmarked(run(format!(r#"{{"schema_version": "3", "accuracy": "{escape}"}}"#)).refused().stderr());
    unmarked(run(atlas.replace(r#""R1""#, &format!(r#""{escape}""#))).fails().stderr());
    let digits = "7".repeat(300_000);
    let long = atlas.replacen(r#""A": ["1""#, &format!(r#""A": ["{digits}""#), 1);
    assert_ne!(long, atlas);
    assert!(bifdiag("verify -").reading(long).fails().stderr().len() < 1000);
}

#[test]
fn an_atlas_without_certificate_is_not_confirmed() {
    let atlas = bifdiag("--body katok:1 --json").succeeds().stdout();
    bifdiag("verify -").reading(atlas).fails().telling("--certificate");
}

#[test]
fn a_certificate_adds_itself_and_its_atlas_is_verified() {
    let proved = bifdiag("--body katok:1 --json --certificate").succeeds().stdout();
    assert!(bifdiag("verify -").reading(proved.as_str()).succeeds().stdout().starts_with("verified: "));
    let document: Value = serde_json::from_str(&proved).unwrap();
    assert_eq!((&document["accuracy"], &document["schema_version"]), (&Value::from("exact"), &Value::from("3")));
}
