//! Verdicts on stability wherever a user meets them: the same everywhere, and what they rest on; and what friction leaves.

use serde_json::{Value, json};

use crate::builder::bifdiag;

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
            let [p, q] = [0, 1].map(|k| number(&point["eigenvalues"][k][1]).powi(2));
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

/// The sleeping top of Lagrange: stable for l² > 4 a r; with friction exactly if A₃ > A₁ and l² > A₃² r/(A₃ − A₁).
#[test]
fn friction_wakes_a_slender_sleeping_top() {
    let slender = bifdiag("critical-spin --A 2,2,1 --r 0,0,1 --axis z --json").succeeds().json();
    let upright: Vec<&Value> = list(&slender["stretches"]).iter().filter(|one| one["up"] == json!("+axis")).collect();
    let told: Vec<_> = upright.iter().map(|one| (&one["nonlinear"]["why"], &one["friction"]["conserving_l"])).collect();
    let (spectrum, integral, lost) = (json!("spectrum"), json!("integral"), json!("lost"));
    assert_eq!(told, [(&spectrum, &lost), (&integral, &lost)], "{slender}");
    let flat = bifdiag("critical-spin --A 1,1,1.8 --r 0,0,1 --axis z --json").succeeds().json();
    let last = list(&flat["stretches"]).iter().rfind(|one| one["up"] == json!("+axis")).unwrap();
    assert_eq!((&last["nonlinear"]["why"], &last["friction"]["conserving_l"]), (&json!("energy"), &json!("survives")));
    // A₃Ω² = r·A₃/(A₃ − A₁)/A₃.
    let from = number(&last["from"]["rad_per_s"]);
    assert!((from - (1.0 / 0.8_f64).sqrt()).abs() < 1e-12, "{flat}");
}

/// A flat top that stands: with falling l it leaves the axis at a pitchfork, precesses, falls at a cusp, and hangs in the end.
#[test]
fn a_rotation_that_slows_down_ends_at_rest() {
    let found = bifdiag("spin-down --A 2,2,3 --r 0,0,1 --from L-.2 --l 6 --json").succeeds().json();
    let path = list(&found["path"]);
    let first = &path[0];
    assert_eq!((&first["curve"], number(&first["l"][0])), (&json!("L-.2"), 6.0), "{found}");
    assert_eq!(path.last().unwrap()["event"], json!("rest"), "{found}");
    // It hangs with the energy −|r|, and each stretch begins where the one before it ends.
    assert!((number(&path.last().unwrap()["h"][1]) + 1.0).abs() < 1e-12, "{found}");
    assert!(path.windows(2).all(|pair| pair[0]["l"][1] == pair[1]["l"][0]), "{found}");
    // No minimum: lost at once.
    let lost = bifdiag("spin-down --body paper --from G0.1 --l 3.25 --json").succeeds().json();
    assert_eq!(lost["path"][0]["event"], json!("start"), "{lost}");
    bifdiag("spin-down --body paper --from G0.1 --l 3.25").succeeds().printing("no minimum: falls");
    bifdiag("spin-down --body paper --from R5").refused().telling("the body has no such curve");
    bifdiag("spin-down --body paper --from G2.1 --l -1").succeeds();
}
