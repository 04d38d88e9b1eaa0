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

#[test]
fn the_way_of_a_slowdown_is_drawn_over_the_diagram() {
    let place = tempfile::tempdir().unwrap();
    let line = format!("spin-down --body paper --from G1.3 --l 2.6 --out {}", place.path().display());
    bifdiag(&line).succeeds().printing("spin-down.svg");
    let picture = std::fs::read_to_string(place.path().join("spin-down.svg")).unwrap();
    assert!(picture.contains("\"main-way\"") && picture.contains("the way"));
    bifdiag(&format!("{line} --width 86mm")).succeeds();
    let picture = std::fs::read_to_string(place.path().join("spin-down.svg")).unwrap();
    assert!(picture.contains("width=\"86mm\""));
    let without = bifdiag("spin-down --body paper --from G1.3 --l 2.6").succeeds().stdout();
    assert!(!without.contains("written"), "{without}");
}

type Vector = [f64; 3];

fn cross([a, b, c]: Vector, [x, y, z]: Vector) -> Vector {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn dot(p: Vector, q: Vector) -> f64 {
    (0..3).map(|k| p[k] * q[k]).sum()
}

/// A damped top: inner friction −δA(ω − Ωγ), which conserves l, and friction −εω at the pivot, which takes it.
struct Damped {
    a: Vector,
    r: Vector,
    inner: f64,
    pivot: f64,
}

impl Damped {
    fn omega(&self, momentum: Vector) -> Vector {
        [0, 1, 2].map(|k| momentum[k] / self.a[k])
    }

    /// γ' = γ × ω, **l**' = **l** × ω − γ × r − friction.
    fn field(&self, [gamma, momentum]: [Vector; 2]) -> [Vector; 2] {
        let omega = self.omega(momentum);
        let j: f64 = (0..3).map(|k| self.a[k] * gamma[k] * gamma[k]).sum();
        let steady = dot(gamma, momentum) / j;
        let (turn, weight) = (cross(momentum, omega), cross(gamma, self.r));
        let friction = |k: usize| self.inner * self.a[k] * (omega[k] - steady * gamma[k]) + self.pivot * omega[k];
        [cross(gamma, omega), [0, 1, 2].map(|k| turn[k] - weight[k] - friction(k))]
    }

    /// One step of Runge and Kutta's method.
    fn step(&self, state: [Vector; 2], t: f64) -> [Vector; 2] {
        let moved = |by: [Vector; 2], t: f64| [0, 1].map(|n| [0, 1, 2].map(|k| state[n][k] + t * by[n][k]));
        let first = self.field(state);
        let second = self.field(moved(first, t / 2.0));
        let third = self.field(moved(second, t / 2.0));
        let fourth = self.field(moved(third, t));
        [0, 1].map(|n| {
            [0, 1, 2]
                .map(|k| state[n][k] + t / 6.0 * (first[n][k] + 2.0 * second[n][k] + 2.0 * third[n][k] + fourth[n][k]))
        })
    }

    fn energy(&self, [gamma, momentum]: [Vector; 2]) -> f64 {
        0.5 * dot(momentum, self.omega(momentum)) - dot(gamma, self.r)
    }
}

/// The way of the paper's body from G1.3, integrated with inner friction and three small rates at the pivot: it falls at the
/// cusp, the later the faster l is lost, by the ⅔ power of the rate (a passage through a fold), and goes on along G2.1.
#[test]
fn a_damped_motion_falls_where_spin_down_says() {
    let found = bifdiag("spin-down --body paper --from G1.3 --l 2.6 --json").succeeds().json();
    let path = list(&found["path"]);
    assert_eq!((&path[0]["event"], &path[1]["curve"]), (&json!("cusp"), &json!("G2.1")), "{found}");
    let cusp = number(&path[0]["l"][1]);
    let vector = |value: &Value| -> Vector { [0, 1, 2].map(|k| number(&value[k])) };
    let at = |l: f64, branch: &str| {
        let all = bifdiag(&format!("critical --body paper --l {l} --json")).succeeds().json();
        list(&all["critical"]).iter().find(|point| point["branch"] == json!(branch)).unwrap().clone()
    };
    let start = at(2.6, "G1.3");
    let a: Vector = [2.0, 1.1, 1.0];
    let gamma = vector(&start["gamma"]);
    let begin = [gamma, [0, 1, 2].map(|k| number(&start["omega"]) * a[k] * gamma[k])];
    let target = number(&at(1.2, "G2.1")["h"]);
    let falls: Vec<f64> = [4e-3, 2e-3, 1e-3]
        .into_iter()
        .map(|pivot| {
            let top = Damped { a, r: [0.94868, 0.0, 0.61623], inner: 0.4, pivot };
            let (mut state, mut fall) = (begin, None);
            loop {
                state = top.step(state, 0.04);
                let l = dot(state[0], state[1]);
                // Half-way down to G2.1, whose energy there is about −0.03.
                if fall.is_none() && top.energy(state) < 0.75 {
                    fall = Some(l);
                }
                if l < 1.2 {
                    assert!((top.energy(state) - target).abs() < 1e-3, "{pivot} {}", top.energy(state));
                    return fall.unwrap();
                }
            }
        })
        .collect();
    let late = falls.iter().map(|l| cusp - l).collect::<Vec<_>>();
    assert!(late.iter().all(|late| *late > 0.0) && late[2] < 0.1, "{late:?}");
    let ratio = late[1] / late[2];
    assert!((ratio - libm::pow(2.0, 2.0 / 3.0)).abs() < 0.1, "{late:?} {ratio}");
}

/// The default start is the end of the curve, whatever the rounding of its l.
#[test]
fn a_spin_down_begins_at_the_end_of_its_curve() {
    let curves = [
        ("2,3,4", "1,0,0", "L+.1"),
        ("2,3,4", "0,0,-1", "L-.1"),
        ("2,3,4", "0,0,-1", "S1.1"),
        ("2.3,2.7,1.5", "0,-.8,-.2", "G1.2"),
    ];
    for (moments, center, curve) in curves {
        let line = format!("spin-down --A {moments} --r {center} --from={curve} --json");
        let found = bifdiag(&line).succeeds().json();
        assert!(!found["path"].as_array().unwrap().is_empty(), "{line}");
    }
    // At a pitchfork that is a minimum the rotation goes on as one of the pair; elsewhere the regions are those beside it.
    for (moments, curve, next) in [("2,2,3", "L-.1", "S12.1"), ("1,2,3", "L-.2", "S2.1")] {
        let line = format!("spin-down --A {moments} --r 0,0,1 --from={curve} --json");
        let path = bifdiag(&line).succeeds().json()["path"].clone();
        assert_eq!(
            (path[0]["curve"].as_str(), path[0]["event"].as_str() == Some("start")),
            (Some(next), false),
            "{path}"
        );
    }
    // Where a pair of saddles closes upon a minimum of larger l, the point is a saddle.
    bifdiag("spin-down --A 2,2.5,3 --r 0,0,1 --from=L-.2").succeeds().printing("no minimum: falls, to L+.1");
    let lost = bifdiag("spin-down --body kovalevskaya --from L-.1 --json").succeeds().json();
    assert_eq!(lost["path"][0]["regions"], json!(["R1", "R4"]), "{lost}");
    bifdiag("spin-down --A 2,3,4 --r 1,0,0 --from L+.1").succeeds().printing("hangs at rest");
    bifdiag("spin-down --A 1,2,3 --r 0,0,0 --from S3.1").succeeds().printing("comes to rest");
}

/// A verdict by Arnold's theorem between two changes is one with isolated exceptions, and says so.
#[test]
fn a_range_of_spins_admits_its_isolated_exceptions() {
    let line = "critical-spin --A 1.71,2.63,2.11 --r 0,0,1 --axis z";
    let told = bifdiag(line).succeeds().printing("by Arnold's theorem: at each of these spins but\n");
    told.printing("  +axis up: 13.087694 rpm (1:2 resonance): stable (Arnold's theorem)\n")
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
