//! `periodic`: all periodic orbits with few crossings at one point.

use crate::builder::bifdiag;

/// At h = 2.6, l = 3.25 the paper's body has two orbits with two crossings, both stable and symmetric, and none with four; the
/// first one at least is proved.
#[test]
fn the_orbits_at_a_point_are_found_and_proved() {
    let list = bifdiag("periodic --body paper --h 2.6 --l 3.25 --crossings 4 --json").succeeds().json();
    let orbits = list["orbits"].as_array().unwrap();
    assert_eq!(orbits.len(), 2);
    assert_eq!((&list["h"], &list["l"], &list["crossings"]), (&"2.6".into(), &"3.25".into(), &4.into()));
    for (orbit, period) in orbits.iter().zip([2.981_163_46, 4.279_876_66]) {
        assert!((orbit["period"].as_f64().unwrap() - period).abs() < 1e-8, "{orbit}");
        assert_eq!(orbit["crossings"], 2, "{orbit}");
        assert_eq!((&orbit["stability"], &orbit["symmetric"]), (&"elliptic".into(), &true.into()), "{orbit}");
        assert_eq!(orbit["proved"] == true, orbit.get("enclosure").is_some(), "{orbit}");
        if orbit["proved"] == false {
            continue;
        }
        // What was computed lies close to what was proved.
        let ends = |value: &serde_json::Value| [0, 1].map(|k| value[k].as_str().unwrap().parse::<f64>().unwrap());
        let [lo, hi] = ends(&orbit["enclosure"]["period"]);
        assert!(lo < hi && hi - lo < 1e-6 && lo - 1e-9 < period && period < hi + 1e-9, "{lo} {hi}");
        for i in 0..3 {
            for name in ["gamma", "omega"] {
                let ([lo, hi], x) = (ends(&orbit["enclosure"][name][i]), orbit[name][i].as_f64().unwrap());
                assert!(hi - lo < 1e-10 && (x - lo).abs() < 1e-10, "{name} {lo} {hi} {x}");
            }
        }
    }
    assert_eq!(orbits[0]["proved"], true);
    assert_eq!((&list["complete"], &list["index_sums"]), (&true.into(), &serde_json::json!([2, 2])));
    assert!(list["why"].as_str().unwrap().starts_with("evidence, not a proof: "));
}

#[test]
fn the_table_tells_what_was_found() {
    bifdiag("periodic --body paper --h 2.6 --l 3.25")
        .succeeds()
        .printing("2.98116")
        .printing("elliptic")
        .printing("complete:\n  evidence, not a proof");
}

/// A list says that nothing checks its proofs again, and `verify` takes none, be it whole or with an orbit less.
#[test]
fn a_list_at_a_point_says_that_it_is_not_checked() {
    let place = tempfile::tempdir().unwrap();
    let mut list = bifdiag("periodic --body paper --h 2.6 --l 3.25 --json").succeeds().json();
    assert!(list["why"].as_str().unwrap().ends_with("; `bifdiag verify` does not check this list"), "{}", list["why"]);
    for name in ["whole.json", "less.json"] {
        std::fs::write(place.path().join(name), list.to_string()).unwrap();
        bifdiag(&format!("verify {name}"))
            .inside(place.path())
            .refused()
            .telling("neither an atlas nor the proof of a point");
        list["orbits"].as_array_mut().unwrap().pop();
    }
}

/// Close to a curve no square fits P: the list names the curve and its distance, which is the margin that `classify` finds.
#[test]
fn a_list_beside_a_curve_says_which_one_is_too_near() {
    let [list, point] = ["periodic --json", "classify --no-region --json"]
        .map(|command| bifdiag(&format!("{command} --body paper --h 1.6397 --l 3.25")).succeeds().json());
    assert_eq!((&list["complete"], &point["margin"]["nearest"]), (&false.into(), &"G2.1".into()));
    let margin = point["margin"]["h"].as_f64().unwrap();
    let why = list["why"].as_str().unwrap();
    let expected = format!("P is singular on the curve G2.1, which is {margin:.2e} away in h (choose h farther away)");
    assert!(why.contains(&expected), "{why}\n{expected}");
}

/// A regular precession is a periodic orbit that lies in P.
#[test]
fn regular_precessions_are_said_to_be_left_out() {
    bifdiag("periodic --A 1.5,1,1 --r 1,0,0 --h 0.2 --l 1")
        .succeeds()
        .printing("that cross P, at most 2 times in a period:\n\nnone that is isolated")
        .printing("precessions lie in P, do not cross it");
    let paper = bifdiag("periodic --body paper --h 2.6 --l 3.25").succeeds().stdout();
    assert!(!paper.contains("regular precessions"), "{paper}");
}

#[test]
fn points_without_a_section_and_odd_crossings_are_refused() {
    bifdiag("periodic --body paper --h 2.6").refused().telling("--l is missing");
    bifdiag("periodic --body paper --l 2.6").refused().telling("--h is missing");
    bifdiag("periodic --body paper --h 2.6 --l 3.25 --crossings 3").refused().telling("inward as often as outward");
    bifdiag("periodic --body paper --h 2.6 --l 3.25 --crossings 0").refused().telling("--crossings 0");
    bifdiag("periodic --body paper --h 0.1 --l 3.25").refused().telling("1.63");
    bifdiag("periodic --body euler --h 2.6 --l 1").refused().telling("r = 0");
}

/// The manifolds of an equilibrium are asked for by its curve and l; its energy is its own.
#[test]
fn manifolds_of_an_equilibrium_are_asked_for_by_its_curve() {
    let asked = "periodic manifolds --A 2,1.5,1.2 --r 0.3,0.5,0.8 --from g0.1 --l 0.5 --length 3 --json";
    let found = bifdiag(asked).succeeds().json();
    let critical = bifdiag("critical --A 2,1.5,1.2 --r 0.3,0.5,0.8 --l 0.5 --json").succeeds().json();
    let upright = critical["critical"].as_array().unwrap().last().unwrap();
    assert_eq!(found["equilibria"][0], *upright);
    assert_eq!(found["h"], format!("{:?}", upright["h"].as_f64().unwrap()));
    assert_eq!((&found["orbits"], &found["crossings"]), (&serde_json::json!([]), &0.into()));
    let kinds: Vec<&str> = found["manifolds"].as_array().unwrap().iter().map(|m| m["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["unstable", "stable"]);
    // The command that stands in it gives the same.
    let command = found["command"].as_str().unwrap().strip_prefix("bifdiag ").unwrap();
    assert_eq!(bifdiag(command).succeeds().json(), found);
}

#[test]
fn manifolds_of_other_equilibria_are_refused() {
    let of = |rest: &str| bifdiag(&format!("periodic manifolds {rest}")).refused();
    of("--body paper --from G2.1 --l 2").telling("type elliptic");
    of("--body paper --from G1.2 --l 0.5").telling("has no equilibrium there");
    of("--body paper --from G9.1 --l 1").telling("no such curve");
    of("--body paper --from G0.1").telling("--l is missing");
    of("--body paper --from G0.1 --l 1 --h 2").telling("--h");
    of("--body lagrange --from S23.2 --l 4").telling("not isolated");
    of("--body euler --from S2.1 --l 1").telling("r = 0");
}

/// Without vertical angular momentum every motion runs back where **l** is turned around: the two orbits with a period of their
/// own pass through rest; the other two are each other's images.
#[test]
fn orbits_through_rest_are_symmetric() {
    for h in ["0", "-0.3"] {
        let list = bifdiag(&format!("periodic --A 3,2.3,1.4 --r 0.4,-0.7,0.5 --h={h} --l 0 --crossings 4 --json"));
        let list = list.succeeds().json();
        let symmetric: Vec<bool> =
            list["orbits"].as_array().unwrap().iter().map(|orbit| orbit["symmetric"] == true).collect();
        assert_eq!(symmetric, [false, false, true, true], "{h}");
    }
}
