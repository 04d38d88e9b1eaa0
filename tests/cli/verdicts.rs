//! Verdicts on stability wherever a user meets them: the same everywhere, and what they rest on; and what friction leaves.

use serde_json::{Value, json};

use crate::builder::{bifdiag, plain};

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value}"))
}

/// `stable` is the verdict in one word, the distances to the resonances follow from the eigenvalues, and friction counts the
/// index.
#[test]
fn every_relative_equilibrium_has_a_verdict_with_its_reason() {
    let mut by_arnold = 0;
    for (body, l) in [("paper", "3.25"), ("paper", "2.2"), ("kovalevskaya", "3"), ("katok:4", "1.1"), ("lagrange", "2")]
    {
        let found = bifdiag(&format!("critical --body {body} --l {l} --json")).succeeds().json();
        for point in list(&found["critical"]) {
            let (nonlinear, friction) = (&point["nonlinear"], &point["friction"]);
            let word = match (nonlinear["verdict"].as_str().unwrap(), nonlinear["why"].as_str().unwrap()) {
                ("unstable", _) => json!(false),
                ("stable", why) => json!(why),
                _ => panic!("{point}"),
            };
            assert_eq!((&point["stable"], &nonlinear["proved"]), (&word, &json!(true)), "{point}");
            assert_eq!(friction["growing"], point["index"], "{point}");
            let survives = if point["index"] == json!(0) { "survives" } else { "lost" };
            assert_eq!(friction["conserving_l"], json!(survives), "{point}");
            for rate in list(&friction["rates"]) {
                assert!(list(&point["eigenvalues"]).contains(&rate[0]), "{point}");
            }
            if nonlinear["why"] != json!("arnold") {
                assert!(nonlinear["D4_over_s"].is_null() && nonlinear["near"].is_null(), "{point}");
                continue;
            }
            by_arnold += 1;
            assert!(number(&nonlinear["D4_over_s"]).abs() > number(&nonlinear["D4_error"]), "{point}");
            let [p, q] = [0, 1].map(|k| number(&point["eigenvalues"][k][1])).map(|frequency| frequency * frequency);
            let (b, c) = (p + q, p * q);
            for (name, m, n) in [("1:1", 1.0, 4.0), ("1:2", 4.0, 25.0), ("1:3", 9.0, 100.0)] {
                let expected = (m * b * b - n * c) / (b * b);
                assert!((number(&nonlinear["near"][name]) - expected).abs() < 1e-9, "{name} {point}");
            }
            // One pair of each Krein sign: friction lets one grow and damps the other.
            let rates: Vec<f64> = list(&friction["rates"]).iter().map(|rate| number(&rate[1])).collect();
            assert!(rates.len() == 2 && rates[0] * rates[1] < 0.0, "{point}");
        }
    }
    assert!(by_arnold >= 3, "{by_arnold}");
}

#[test]
fn the_table_tells_verdicts_and_what_friction_leaves() {
    bifdiag("critical --body paper --l 3.25")
        .succeeds()
        .printing("G0.1   elliptic       stable (Arnold)")
        .printing("G2.1   elliptic       stable (energy)")
        .printing(
            "with friction that conserves l:\n  stable on G2.1, G1.3\n  unstable in 1 direction on S2.1\n  unstable in 2",
        );
}

/// `state`, `critical --spin` and the atlas say what `critical` says.
#[test]
fn a_verdict_is_the_same_from_every_door() {
    let all = bifdiag("critical --body paper --json --spin").and("6 rad/s").succeeds().json();
    let atlas = bifdiag("--body paper --json --no-drawing").succeeds().json();
    for axis in list(&all["axes"]) {
        let text: Vec<String> = list(&axis["axis"]).iter().map(|x| format!("{:?}", number(x))).collect();
        let state = format!("state --body paper --axis={} --json --spin", text.join(","));
        let state = bifdiag(&state).and("6 rad/s").succeeds().json();
        let same = |value: &Value| ["verdict", "why"].map(|name| value["nonlinear"][name].clone());
        assert_eq!(same(&state["steady"]), same(axis), "{state}");
        assert_eq!(state["steady"]["friction"]["growing"], axis["friction"]["growing"], "{state}");
        let curve = list(&atlas["curves"]).iter().find(|curve| curve["id"] == axis["branch"]).unwrap();
        let l = number(&axis["l"]);
        let inside = |span: &&Value| number(&span["l_from"]) <= l && span["l_to"].as_f64().is_none_or(|to| l <= to);
        let span = list(&curve["stability"]).iter().find(inside).unwrap();
        assert_eq!(same(span), same(axis), "{curve}");
        assert_eq!(span["friction"]["conserving_l"], axis["friction"]["conserving_l"], "{curve}");
    }
}

/// Every atlas of the whole plane lists where the hypotheses of Arnold's theorem fail, and `verify` confirms it.
#[test]
fn resonances_are_listed_where_arnolds_theorem_fails() {
    let text = bifdiag("--body paper --certificate --no-drawing --json").succeeds().stdout();
    let atlas: Value = serde_json::from_str(&text).unwrap();
    let changes = list(&atlas["verdict_changes"]);
    assert!(!changes.is_empty() && changes.iter().all(|change| change["proved"] == json!(true)), "{changes:?}");
    assert!(changes.is_sorted_by(|p, q| number(&p["l"]) <= number(&q["l"])), "{changes:?}");
    let hopf = list(&atlas["stability_changes"]).iter().filter(|one| one["kind"] == json!("hamiltonian-hopf"));
    for change in hopf {
        let same = |one: &&Value| one["kind"] == json!("1:1") && one["curve"] == change["curve"];
        let found = changes.iter().find(same).unwrap_or_else(|| panic!("{changes:?}"));
        assert!((number(&found["l"]) - number(&change["l"])).abs() < 1e-9, "{found} {change}");
    }
    let verified = bifdiag("verify -").reading(text).succeeds().stdout();
    assert!(!verified.contains("not checked"), "{verified}");
    let quick = bifdiag("--body paper --no-drawing --json").succeeds().json();
    assert_eq!(quick["verdict_changes"], atlas["verdict_changes"]);
    let part = bifdiag("--body paper --window=2:4,2:3 --no-drawing --json").succeeds().json();
    let kinds: Vec<&Value> = list(&part["verdict_changes"]).iter().map(|change| &change["kind"]).collect();
    assert_eq!(kinds, [&json!("1:2"), &json!("D4")]);
    let fast = bifdiag("--body paper --accuracy fast --no-drawing --json").succeeds().json();
    assert_eq!(fast.get("verdict_changes"), None, "{fast}");
    bifdiag("show G0.1 --body paper").succeeds().printing("  at l = ");
}

/// The sleeping top of Lagrange: stable for l² > 4 a r; with friction exactly if A₃ > A₁ and l² > A₃² r/(A₃ − A₁).
#[test]
fn friction_wakes_a_slender_sleeping_top() {
    let slender = bifdiag("critical-spin --A 2,2,1 --r 0,0,1 --axis z --json").succeeds().json();
    let upright: Vec<&Value> = list(&slender["stretches"]).iter().filter(|one| one["up"] == json!("+axis")).collect();
    let reply: Vec<_> =
        upright.iter().map(|one| (&one["nonlinear"]["why"], &one["friction"]["conserving_l"])).collect();
    let (spectrum, integral, lost) = (json!("spectrum"), json!("integral"), json!("lost"));
    assert_eq!(reply, [(&spectrum, &lost), (&integral, &lost)], "{slender}");
    let flat = bifdiag("critical-spin --A 1,1,1.8 --r 0,0,1 --axis z --json").succeeds().json();
    let last = list(&flat["stretches"]).iter().rfind(|one| one["up"] == json!("+axis")).unwrap();
    assert_eq!((&last["nonlinear"]["why"], &last["friction"]["conserving_l"]), (&json!("energy"), &json!("survives")));
    // A₃Ω² = r·A₃/(A₃ − A₁)/A₃.
    let from = number(&last["from"]["rad_per_s"]);
    assert!((from - (1.0 / 0.8_f64).sqrt()).abs() < 1e-12, "{flat}");
}

/// A verdict by Arnold's theorem between two changes is one with isolated exceptions, and says so.
#[test]
fn a_range_of_spins_admits_its_isolated_exceptions() {
    let line = "critical-spin --A 1.71,2.63,2.11 --r 0,0,1 --axis z";
    let reply = bifdiag(line).succeeds().printing("by Arnold's theorem; spins at which its usual conditions fail:\n");
    reply
        .printing("  +axis up: 13.087694 rpm (1:2 resonance): stable (Arnold's theorem)\n")
        .printing(" rpm (1:3 resonance): stable\n")
        .printing(" rpm (D4 = 0): stable (Arnold's theorem)\n");
    let found = bifdiag(&format!("{line} --json")).succeeds().json();
    let by_arnold: Vec<&Value> = found["stretches"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|stretch| stretch["nonlinear"]["why"] == json!("arnold"))
        .collect();
    assert!(!by_arnold.is_empty() && by_arnold.iter().all(|stretch| stretch["nonlinear"]["proved"] == json!(false)));
    bifdiag("show L-.1 --A 1.71,2.63,2.11 --r 0,0,1").succeeds().printing("alone (D4 = 0): stable (Arnold's theorem)");
}

/// The three exceptions lie within 10⁻¹³ of each other in l, beside a cusp: l does not tell their spins apart, their own
/// enclosures do. The spin of the 1:3 resonance is from 60 digits of another program.
#[test]
fn isolated_exceptions_beside_a_cusp_keep_their_spins() {
    let line = "critical-spin --A 5/6,2/29,1/18 --r=0.5942,0.6329,-0.4894";
    let found = bifdiag(&format!("{line} --json")).succeeds().json();
    let family = list(&found["families"]).iter().find(|family| family["branch"] == json!("G0")).unwrap();
    let near = |one: &&Value| (number(&one["spin"]["rad_per_s"]) - 0.912_959).abs() < 1e-5;
    let isolated: Vec<&Value> =
        list(&family["stretches"]).iter().flat_map(|one| list(&one["isolated"])).filter(near).collect();
    let kinds: Vec<&str> = isolated.iter().map(|one| one["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["1:2", "D4", "1:3"]);
    assert!((number(&isolated[2]["spin"]["rad_per_s"]) - 0.912_959_693_544).abs() < 1e-12, "{isolated:?}");
    // As many as along the curve.
    let atlas = bifdiag("--A 5/6,2/29,1/18 --r=0.5942,0.6329,-0.4894 --json --no-drawing").succeeds().json();
    let along =
        list(&atlas["verdict_changes"]).iter().filter(|one| (number(&one["l"]) - 0.166_881_703_85).abs() < 1e-10);
    assert_eq!(along.filter(|one| one["kind"] != json!("1:1")).count(), 3);
}

/// Two forks within the rounding of a spin are two changes, and so are two crossings.
#[test]
fn changes_at_nearly_one_spin_are_each_reported() {
    let found = bifdiag("critical-spin --A 1,1.0000000000000001,2 --r 0,0,1 --axis z --json").succeeds().json();
    let events: Vec<&str> = list(&found["changes"]).iter().filter_map(|change| change["event"].as_str()).collect();
    assert_eq!(events, ["crossing", "crossing", "fork", "fork"]);
    let reply = bifdiag("critical-spin --A 1,1.0000000001,1.5 --r 0,0,1 --axis z").succeeds();
    reply.printing("+axis  13.504744742   13.504744744   unstable");
}

/// The principal axes of the part are no decimals: no point of doubles is on the axis's curve, and what lies beside it is known.
#[test]
fn regions_beside_a_rotation_about_irrational_axes_are_named() {
    let part = "--inertia 2,2,3.5,-0.5,0,0 --products tensor --com 0.1,0.1,0 --mass 1 --g 10";
    let reply = bifdiag(&format!("state {part} --axis 1,1,0 --spin 3rad/s")).succeeds();
    reply.printing("regions beside it: R1 below, R2 above in h");
    let permanent = "--inertia 2,2,2,-0.5,-0.5,-0.5 --products tensor --com 0.1,0.1,0.1 --mass 1 --g 10 --axis 1,1,1";
    let reply = bifdiag(&format!("critical-spin {permanent}")).succeeds().stdout();
    assert!(!reply.contains("from the one given"), "{reply}");
}

/// At one spin a curve can be met twice, at a cusp and elsewhere: each sentence says which of the two is meant.
#[test]
fn points_of_one_curve_at_one_spin_are_reported_apart() {
    let reply = bifdiag("critical --A 1,1.5,2 --r=0.4,0,0.3 --spin").and("1 rad/s").succeeds();
    reply.printing("  stable on G2.1, G1.3 (l = 1.547228505)\n").printing("  unstable on G1.3 (l = 1.36)\n");
}

/// All verdict changes of the paper's curve G0.1: beside each the distance from the resonance, or D₄, has opposite signs, and
/// there are no others between them.
#[test]
fn verdicts_of_the_papers_curve_change_where_its_normal_form_says() {
    let atlas = bifdiag("--body paper --json --no-drawing").succeeds().json();
    let changes: Vec<&Value> =
        list(&atlas["verdict_changes"]).iter().filter(|change| change["curve"] == json!("G0.1")).collect();
    let reply: Vec<_> = changes.iter().map(|one| (one["kind"].as_str().unwrap(), number(&one["l"]))).collect();
    let expected = [("1:1", 1.947_890_544), ("1:2", 2.236_708_031), ("D4", 2.327_799_985), ("1:3", 3.030_861_365)];
    assert_eq!(reply.len(), expected.len(), "{reply:?}");
    let at = |l: f64| {
        let found = bifdiag(&format!("critical --body paper --l {l} --json")).succeeds().json();
        list(&found["critical"]).iter().find(|point| point["branch"] == json!("G0.1")).unwrap().clone()
    };
    let of = |point: &Value, kind: &str| match kind {
        "D4" => number(&point["nonlinear"]["D4_over_s"]),
        kind => number(&point["nonlinear"]["near"][kind]),
    };
    for ((change, (kind, l)), (expected_kind, near)) in changes.iter().zip(&reply).zip(expected) {
        assert!(*kind == expected_kind && (l - near).abs() < 1e-6, "{reply:?}");
        let there = at(*l);
        assert!((number(&there["h"]) - number(&change["h"])).abs() < 1e-12, "{change} {there}");
        if *kind == "1:1" {
            // Below it no pair is imaginary.
            assert_eq!(
                (&at(l - 1e-6)["stability"], &at(l + 1e-6)["stability"]),
                (&json!("complex"), &json!("elliptic"))
            );
            continue;
        }
        let [below, above] = [l - 1e-6, l + 1e-6].map(|l| of(&at(l), kind));
        assert!(below * above < 0.0 && below.abs().max(above.abs()) < 1e-3, "{kind} {below} {above}");
    }
    // At the resonance 1:2 D₄ has a pole.
    for kind in ["1:2", "1:3", "D4"] {
        let mut signs: Vec<f64> = (0..120).map(|k| of(&at(1.95 + 0.05 * f64::from(k)), kind).signum()).collect();
        signs.dedup();
        assert_eq!(signs.len(), if kind == "D4" { 3 } else { 2 }, "{kind}");
    }
}

/// The picture says what its lines mean.
#[test]
fn the_legend_tells_what_solid_thin_and_dashed_lines_mean() {
    let place = tempfile::tempdir().unwrap();
    bifdiag(&format!("--body paper --out {}", place.path().display())).succeeds();
    let picture = plain(&std::fs::read_to_string(place.path().join("diagram.svg")).unwrap());
    for reply in ["solid: stable, with friction too", "thin: stable without friction", "dashed: unstable"] {
        assert!(picture.contains(reply), "{reply}");
    }
}

/// Over Ω², D₄ is an inverse moment of inertia: the body is the same, in other units of mass and of time.
#[test]
fn arnolds_determinant_is_in_the_units_of_the_body() {
    let determinants = |moments: &str, center: &str, l: &str| -> Vec<f64> {
        let found = bifdiag(&format!("critical --A {moments} --r {center} --l {l} --json")).succeeds().json();
        let all = list(&found["critical"]).iter().map(|point| &point["nonlinear"]["D4_over_s"]);
        all.filter(|value| !value.is_null()).map(number).collect()
    };
    let one = determinants("2,1.1,1", "0.94868,0,0.61623", "3.25");
    assert_eq!(one.len(), 2, "{one:?}");
    for (factor, body) in [
        (0.5, ["1,0.55,0.5", "0.47434,0,0.308115", "1.625"]),
        (2.0, ["4,2.2,2", "1.89736,0,1.23246", "6.5"]),
        (4.0, ["8,4.4,4", "3.79472,0,2.46492", "13"]),
        (10.0, ["20,11,10", "9.4868,0,6.1623", "32.5"]),
        // Twice as fast.
        (1.0, ["2,1.1,1", "3.79472,0,2.46492", "6.5"]),
    ] {
        let found = determinants(body[0], body[1], body[2]);
        assert_eq!(found.len(), one.len(), "{body:?}");
        for (found, one) in found.iter().zip(&one) {
            assert!((found * factor / one - 1.0).abs() < 1e-9, "{body:?} {found} {one}");
        }
    }
}

/// At the cusp of a circle U_l has an inflection across it and falls on one side. The third component of ω keeps the
/// motion without friction; with it the body falls, as `spin-down` says.
#[test]
fn the_cusp_of_a_circle_is_no_minimum() {
    for line in [
        "critical --A 3,3,7 --r 0,0,2 --l 4",
        "critical --A 27,27,52 --r 0,0,15 --l 36",
        "critical --A 27,27,52 --r 0,0,15 --spin 1rad/s",
    ] {
        let text = bifdiag(line).succeeds().stdout();
        assert!(text.contains("S12.1  elliptic  stable (integral)"), "{line}: {text}");
        assert!(text.contains("\n  unstable on S12.1\n"), "{line}: {text}");
    }
    bifdiag("state --A 27,27,52 --r 0,0,15 --omega .8,0,.6 --vertical .8,0,.6")
        .succeeds()
        .printing("stable (a further integral)")
        .printing("with friction that conserves l: unstable");
}
