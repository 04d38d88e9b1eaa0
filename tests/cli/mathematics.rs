//! What a mathematician asks for: integrable cases, two bodies compared, one point with its proof.

use serde_json::{Value, json};

use crate::builder::bifdiag;

/// A body, its case, for which motions the integral is constant, and a part of its formula.
const CASES: [(&str, &str, &str, &str); 7] = [
    ("--body euler", "euler", "always", "⟨L,L⟩"),
    ("--body lagrange", "lagrange", "always", "ω1"),
    ("--A 1,1,1 --r 0.3,1,2", "lagrange", "always", "⟨L,r⟩"),
    ("--body kowalevski", "kovalevskaya", "always", "2ω1ω2"),
    ("--A 1,2,2 --r 0,-3,1", "kovalevskaya", "always", "2ω2ω3"),
    ("--body goryachev-chaplygin", "goryachev-chaplygin", "where l = 0", "ω3(ω1² + ω2²)"),
    ("--A 1/2,1/3,1/7 --r 1,0,2", "hess-appelrot", "where it is 0", "⟨L,r⟩"),
];

#[test]
fn integrable_cases_are_named_with_their_further_integral() {
    for (body, case, holds, formula) in CASES {
        let atlas = bifdiag(&format!("{body} --json --no-drawing")).succeeds().json();
        let [found] = &atlas["body"]["integrable"].as_array().unwrap()[..] else { panic!("{body}") };
        assert_eq!((&found["case"], &found["holds"]), (&json!(case), &json!(holds)), "{body}");
        let integral = found["integral"].as_str().unwrap();
        assert!(integral.contains(formula), "{integral}");
        bifdiag("explain").and(case).succeeds();
    }
    for body in ["--body paper", "--body katok:1", "--body ten", "--A 3,3,1 --r 1,0,0"] {
        let atlas = bifdiag(&format!("{body} --json --no-drawing")).succeeds().json();
        assert_eq!(atlas["body"].get("integrable"), None, "{body}");
    }
    let place = tempfile::tempdir().unwrap();
    let reply = bifdiag("--body kovalevskaya --no-plot").inside(place.path()).succeeds();
    reply.printing("Kovalevskaya's case: further integral (ω1² − ω2² + (r1γ1 − r2γ2)/A3)²");
}

#[test]
fn a_part_is_recognised_whatever_its_axes() {
    // (2E − q qᵀ) for q = (2, −2, 1)/3: the moments 2, 2, 1, and the centre of mass across q.
    let part = "--inertia 14/9,14/9,17/9,4/9,-2/9,2/9 --products tensor --com 1,1,0 --mass 1 --unphysical";
    let body = bifdiag(&format!("body {part} --json")).succeeds().json();
    assert_eq!(body["integrable"][0]["case"], "kovalevskaya", "{body}");
    bifdiag(&format!("body {part}")).succeeds().printing("Kovalevskaya's case");
}

/// Along an orbit the integral stays as it is, where it is one.
#[test]
fn a_further_integral_is_followed_along_orbits() {
    let start = "--gamma 0.48,-0.6,0.64 --omega 0.7,1.1,-0.9 --times 0:50:101 --json";
    for (body, case, holds, _) in CASES {
        let found = bifdiag(&format!("orbit {body} {start}")).succeeds().json();
        let integral = &found["integrals"][0];
        assert_eq!(integral["case"], case, "{body}");
        let drift = integral["drift"].as_f64().unwrap();
        let is_kept = holds == "always";
        assert_eq!(integral["kept"], is_kept, "{body}");
        assert_eq!(drift < 1e-11, is_kept, "{body}: {drift}");
    }
    // ⟨γ,L⟩ = 0.
    let level = "orbit --body goryachev-chaplygin --gamma 0,0,1 --l-vector 1,2,0 --times 0:50:101";
    let found = bifdiag(&format!("{level} --json")).succeeds().json();
    assert_eq!(found["integrals"][0]["kept"], true);
    assert!(found["integrals"][0]["drift"].as_f64().unwrap() < 1e-12, "{}", found["integrals"]);
    bifdiag(level).succeeds().printing("Goryachev–Chaplygin's case").printing("largest deviation");
    // ⟨L,r⟩ = 0.
    let plane = "orbit --A 1/2,1/3,1/7 --r 1,0,2 --gamma 0,0.6,0.8 --l-vector 2,1,-1 --times 0:2:41 --json";
    let found = bifdiag(plane).succeeds().json();
    assert_eq!((&found["integrals"][0]["kept"], &found["integrals"][0]["at_start"]), (&json!(true), &json!(0.0)));
    assert!(found["integrals"][0]["drift"].as_f64().unwrap() < 1e-11, "{}", found["integrals"]);
    let section = "section --body kovalevskaya --region R2 --orbits 3 --crossings 50 --json";
    let found = bifdiag(section).succeeds().json();
    assert!(found["integrals"][0]["drift"].as_f64().unwrap() < 1e-11, "{}", found["integrals"]);
    assert_eq!(
        bifdiag("section --body paper --region R2 --orbits 1 --crossings 5 --json").succeeds().json().get("integrals"),
        None
    );
}

#[test]
fn two_bodies_are_compared() {
    let found = bifdiag("compare paper katok:1 --json").succeeds().telling_nothing().json();
    let class =
        |body: &str| bifdiag(&format!("classes --at --body {body} --lines 1 --json")).succeeds().json()["name"].clone();
    let atlases =
        ["paper", "katok:1"].map(|body| bifdiag(&format!("--body {body} --json --no-drawing")).succeeds().json());
    for (number, body) in ["paper", "katok:1"].into_iter().enumerate() {
        let (reply, atlas) = (&found["bodies"][number], &atlases[number]);
        assert_eq!(reply["class"], class(body));
        assert_eq!((&reply["regions"], &reply["events"]), (&atlas["summary"]["regions"], &atlas["summary"]["events"]));
        // Every region stands in the table once, beside those with the same components.
        let mut ids: Vec<&str> = Vec::new();
        for kind in found["regions"].as_array().unwrap() {
            for id in kind["regions"][number].as_array().unwrap() {
                let region = atlas["regions"].as_array().unwrap().iter().find(|region| region["id"] == *id).unwrap();
                assert_eq!(region["components"], kind["components"]);
                ids.push(id.as_str().unwrap());
            }
        }
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), atlas["regions"].as_array().unwrap().len());
        let count = |list: &str| -> u64 {
            found[list].as_array().unwrap().iter().map(|kind| kind["counts"][number].as_u64().unwrap()).sum()
        };
        assert_eq!(json!(count("events")), atlas["summary"]["events"]);
        let changes = atlas["stability_changes"].as_array().unwrap().len();
        assert_eq!(json!(count("stability_changes")), json!(changes));
    }
    // The borders lead from one class to the other, each beginning where the last has ended.
    let borders = found["path"]["borders"].as_array().unwrap();
    assert_eq!((&found["same_class"], &found["path"]["complete"]), (&json!(false), &json!(true)));
    assert_eq!(borders[0]["classes"][0], found["bodies"][0]["class"]);
    assert_eq!(borders[borders.len() - 1]["classes"][1], found["bodies"][1]["class"]);
    let places: Vec<f64> = borders.iter().map(|border| border["at"].as_f64().unwrap()).collect();
    assert!(places.is_sorted() && places.iter().all(|at| (0.0..=1.0).contains(at)), "{places:?}");
}

/// The one border between these two is the one that `scan border` finds.
#[test]
fn the_border_between_two_bodies_is_the_known_one() {
    let found = bifdiag("compare katok:2").and("A=1,1.4,0.7;r=1,0,0").arguments("--json").succeeds().json();
    let [border] = &found["path"]["borders"].as_array().unwrap()[..] else { panic!("{found}") };
    let known = bifdiag("scan border --body katok:2 --vary A3=0.7:0.875 --json").succeeds().json();
    let mut classes: Vec<&Value> = border["classes"].as_array().unwrap().iter().collect();
    let known: Vec<&Value> = known["borders"][0]["classes"].as_array().unwrap().iter().collect();
    classes.reverse();
    assert_eq!(classes, known);
    // A3/A1 = 3/4 on the path in standard units.
    let end = |which: usize, axis: usize| -> f64 {
        let text = found["path"]["ends"][which]["A"][axis].as_str().unwrap();
        let (above, below) = text.split_once('/').unwrap_or((text, "1"));
        above.parse::<f64>().unwrap() / below.parse::<f64>().unwrap()
    };
    let t = border["at"].as_f64().unwrap();
    let at = |axis| (1.0 - t) * end(0, axis) + t * end(1, axis);
    assert!((at(0) / at(1) - 0.75).abs() < 1e-9, "{t}");
}

#[test]
fn a_body_is_given_in_three_ways() {
    let place = tempfile::tempdir().unwrap();
    let atlas = bifdiag("--body paper --json --no-drawing").succeeds().stdout();
    std::fs::write(place.path().join("paper.json"), &atlas).unwrap();
    let by = |body: &str| {
        let found = bifdiag("compare").and(body).arguments("euler --json").inside(place.path()).succeeds().json();
        (found["regions"].clone(), found["path"].clone(), found["command"].clone())
    };
    let by_name = by("paper");
    for body in [
        "paper.json",
        "A=2,1.1,1;r=0.94868,0,0.61623",
        "A=2,1.1,1&r=0.94868,0,0.61623",
        "A=2, 1.1, 1; r=0.94868, 0, 0.61623",
    ] {
        assert_eq!(by(body), by_name, "{body}");
    }
    bifdiag("compare - paper").reading(atlas).succeeds().printing("both belong to the same class");
    // On the way the pitchfork goes from one side of G1 to the other, past its cusp; an axially symmetric body has a circle.
    bifdiag("compare paper A=0.533,0.721,0.746;r=0.107,0.0,0.994")
        .succeeds()
        .printing("the pitchfork of G1 and S2 meets the cusp of G1");
    let alike = bifdiag("compare A=1,2,2;r=1,0,0 A=1,2.1,2.1;r=1,0,0").succeeds();
    alike
        .printing("kinds of events: both have the same one")
        .printing("kinds of changes of stability: both have the same one");
    // Two components of r leave 0 at once, and in one class the number of relative equilibria at one l differs.
    bifdiag("compare A=1.4,2.3,3.5;r=0.31,0.52,-0.83 A=3,5,8;r=0,1,0")
        .succeeds()
        .printing("r1 and r3 are 0 there: only there the body has the symmetries");
    bifdiag("compare A=3,5,8;r=0,1,0 A=2,3,4;r=0,1,0")
        .succeeds()
        .printing("at most 8 relative equilibria")
        .printing("at most 6 relative equilibria")
        .printing("lengths, stability and the order of unrelated events may differ");
    bifdiag("compare lagrange isotropic").succeeds().printing("the cusp of S12 reaches its pitchfork");
    // Ids of a part of the plane are those of the whole.
    let body = "--A 2.7,1.9,1.4 --r 0.4,-0.2,0.3 --no-plot";
    let all = bifdiag(&format!("atlas {body}")).succeeds().stdout();
    let row = all.lines().find(|line| line.starts_with("E5 ")).unwrap().split_whitespace().collect::<Vec<_>>();
    let part = bifdiag(&format!("atlas {body} --window 4:8,4:5")).succeeds().stdout();
    let found =
        part.lines().map(|line| line.split_whitespace().collect::<Vec<_>>()).find(|words| words.first() == Some(&"E5"));
    assert_eq!(found.unwrap(), row);
    bifdiag("compare paper nobody").refused().telling("BODY nobody: it is not a named body").telling("atlas.json");
    bifdiag("compare paper A=1,2,3").refused().telling("A=2,1.1,1;r=0.94868,0,0.61623");
    bifdiag("compare paper A=1,2,3;r=0,x,1").refused().telling("r2: `x` is not a number");
    bifdiag("compare paper missing.json").refused().telling("missing.json");
    bifdiag("compare paper").refused().telling("<BODY>");
}

#[test]
fn the_proof_of_a_point_is_verified() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("point.json");
    for (body, h, l, reply) in [
        ("--body paper", "3.8", "3.25", "lies in R5"),
        ("--body paper", "3.8", "-13/4", "lies in R5"),
        ("--body paper", "-2", "1/3", "is forbidden"),
        ("--body lagrange", "2", "1", "lies in R"),
        (
            "--inertia 0.30,0.21,0.17,0.01,0,-0.02 --products tensor --com 0,0.02,0.15 --mass 2.5 --g 9.80665",
            "5",
            "0.5",
            "lies in R",
        ),
    ] {
        let line = format!("classify {body} --h={h} --l={l}");
        let proof = bifdiag(&format!("{line} --certificate")).succeeds();
        std::fs::write(&file, proof.stdout()).unwrap();
        bifdiag("verify").and(&file).succeeds().telling_nothing().printing(reply).printing("of curves");
        let (proof, plain) = (proof.json(), bifdiag(&format!("{line} --json")).succeeds().json());
        assert_eq!((&proof["region"], &proof["status"]), (&plain["region"], &plain["status"]));
        assert_eq!(proof["components"], plain["components"]);
        let command = proof["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap();
        assert_eq!(bifdiag(command).succeeds().json(), proof);
    }
    // Another text is another document: the bytes must be those that the program writes.
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replacen("\"regular\"", "\"forbidden\"", 1)).unwrap();
    bifdiag("verify").and(&file).fails().telling("status is not what this check finds");
    std::fs::write(&file, text.replace(": ", ":  ")).unwrap();
    bifdiag("verify").and(&file).fails().telling("its bytes are not those");
    bifdiag("classify --body paper --h 3.8 --l 0 --certificate").fails().telling("an atlas proves l > 0 only");
    bifdiag("classify --body lagrange --h 1 --l 2 --certificate --batch -").refused().telling("leave --batch out");
    bifdiag("classify --body paper --h 1 --l 2 --certificate --accuracy fast").refused().telling("--accuracy fast");
    bifdiag("classify --body kovalevskaya --h 0 --l 1 --certificate").succeeds();
    bifdiag("classify --A 1,1,1 --r 0,0,1 --h=-1/2 --l 1 --certificate").fails().telling("lies on a curve");
}

#[test]
fn a_special_body_is_reported_with_the_generic_classes_beside_it() {
    let found = bifdiag("classes --at --body paper --lines 2 --json").succeeds().json();
    assert_eq!(found["stratum"], "r in the plane of axes 1 and 3");
    let [generic] = &found["generic"].as_array().unwrap()[..] else { panic!("{found}") };
    let beside = bifdiag("classes --at --A 2,1.1,1 --r 0.94868,1e-7,0.61623 --lines 1 --json").succeeds().json();
    assert_eq!((&generic["class"], &generic["share"]), (&beside["name"], &json!(1.0)));
    assert_eq!((beside.get("stratum"), beside.get("generic")), (None, None));
    let reply = bifdiag("classes --at --body paper --lines 2").succeeds();
    reply
        .printing("a special body: r in the plane of axes 1 and 3")
        .printing("random generic bodies within 1e-6 of it");
}
