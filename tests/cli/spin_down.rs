//! `spin-down`: the way of a rotation that friction slows down, against the motion itself.

use serde_json::{Value, json};

use crate::builder::bifdiag;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value}"))
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
    let backwards = bifdiag("spin-down --body paper --from G2.1 --l=-1").succeeds();
    backwards.telling("the path is that of l = 1, with the signs of l and omega reversed");
    bifdiag("spin-down --body paper --from G2.1 --l 1").succeeds().telling_nothing();
}

#[test]
fn the_way_of_a_slowdown_is_drawn_over_the_diagram() {
    let place = tempfile::tempdir().unwrap();
    let line = format!("spin-down --body paper --from G1.3 --l 2.6 --out {}", place.path().display());
    bifdiag(&line).succeeds().printing("spin-down.svg");
    let picture = std::fs::read_to_string(place.path().join("spin-down.svg")).unwrap();
    assert!(picture.contains("\"main-way\"") && picture.contains("the path"));
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

    /// The power that inner friction takes less that at the pivot.
    fn excess(&self, [gamma, momentum]: [Vector; 2]) -> f64 {
        let omega = self.omega(momentum);
        let j: f64 = (0..3).map(|k| self.a[k] * gamma[k] * gamma[k]).sum();
        let steady = dot(gamma, momentum) / j;
        let inner: f64 = (0..3).map(|k| self.a[k] * omega[k] * (omega[k] - steady * gamma[k])).sum();
        self.inner * inner - self.pivot * dot(omega, omega)
    }

    fn energy(&self, [gamma, momentum]: [Vector; 2]) -> f64 {
        0.5 * dot(momentum, self.omega(momentum)) - dot(gamma, self.r)
    }
}

/// The limit of a quantity at rates that are halved twice, with an error of these two powers of the rate.
fn extrapolated([first, second, third]: [f64; 3], [low, high]: [f64; 2]) -> f64 {
    let limit = |far: f64, near: f64, power: f64| near + (near - far) / (libm::pow(2.0, power) - 1.0);
    limit(limit(first, second, low), limit(second, third, low), high)
}

/// What one damped motion shows.
struct Slowed {
    /// l and h where the friction inside takes more than that at the pivot: it falls.
    event: [f64; 2],
    /// h at an l before.
    before: f64,
}

/// The way of the paper's body from G1.3, integrated with inner friction and three small rates at the pivot. Before the cusp its
/// energy is that of the curve but for the square of the rate; it falls beyond it, by the ⅔ power of the rate (a passage through
/// a fold). In the limit l and h of the event are those of `spin-down`, and the motion goes on along G2.1.
#[test]
fn a_damped_motion_falls_where_spin_down_says() {
    const BEFORE: f64 = 2.3;
    let found = bifdiag("spin-down --body paper --from G1.3 --l 2.6 --json").succeeds().json();
    let path = list(&found["path"]);
    assert_eq!((&path[0]["event"], &path[1]["curve"]), (&json!("cusp"), &json!("G2.1")), "{found}");
    let cusp = [number(&path[0]["l"][1]), number(&path[0]["h"][1])];
    let vector = |value: &Value| -> Vector { [0, 1, 2].map(|k| number(&value[k])) };
    let at = |l: f64, branch: &str| {
        let all = bifdiag(&format!("critical --body paper --l {l} --json")).succeeds().json();
        list(&all["critical"]).iter().find(|point| point["branch"] == json!(branch)).unwrap().clone()
    };
    let start = at(2.6, "G1.3");
    let a: Vector = [2.0, 1.1, 1.0];
    let gamma = vector(&start["gamma"]);
    let begin = [gamma, [0, 1, 2].map(|k| number(&start["omega"]) * a[k] * gamma[k])];
    let [target, before] = [at(1.2, "G2.1"), at(BEFORE, "G1.3")].map(|point| number(&point["h"]));
    let slowed = [1e-3, 5e-4, 2.5e-4].map(|pivot| {
        let top = Damped { a, r: [0.94868, 0.0, 0.61623], inner: 0.4, pivot };
        let (mut state, mut seen, mut fallen) = (begin, None, None);
        let reply = |state: [Vector; 2]| [dot(state[0], state[1]), top.energy(state)];
        loop {
            let next = top.step(state, 0.04);
            let ([l, h], [next_l, next_h]) = (reply(state), reply(next));
            let between = |share: f64| [l + share * (next_l - l), h + share * (next_h - h)];
            if next_l < BEFORE && seen.is_none() {
                seen = Some(between((l - BEFORE) / (l - next_l))[1]);
            }
            let [excess, next_excess] = [state, next].map(|state| top.excess(state));
            // Twice while the motion settles down at the start it is so, too.
            if l < BEFORE && excess < 0.0 && next_excess >= 0.0 && fallen.is_none() {
                fallen = Some(between(excess / (excess - next_excess)));
            }
            if next_l < 1.2 {
                assert!((next_h - target).abs() < 1e-3, "{pivot} {next_h}");
                return Slowed { event: fallen.unwrap(), before: seen.unwrap() };
            }
            state = next;
        }
    });
    let apart = slowed.each_ref().map(|slowed| slowed.before - before);
    assert!(apart[2].abs() < 1e-6 && (apart[1] / apart[2] - 4.0).abs() < 0.1, "{apart:?}");
    for n in 0..2 {
        let late = slowed.each_ref().map(|slowed| cusp[n] - slowed.event[n]);
        assert!(late.iter().all(|late| *late > 0.0) && late[2] > 1e-2, "{late:?}");
        let ratio = late[1] / late[2];
        assert!((ratio - libm::pow(2.0, 2.0 / 3.0)).abs() < 0.15, "{late:?} {ratio}");
        let limit = extrapolated(slowed.each_ref().map(|slowed| slowed.event[n]), [2.0 / 3.0, 1.0]);
        assert!((limit - cusp[n]).abs() < [1e-3, 2e-3][n], "{n}: {limit} {cusp:?}");
    }
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

/// A fall at fixed l loses energy, so it stays in its component of {U_l ≤ h}: the barriers at these l, found by `critical`, are
/// higher than where it begins, and the body cannot hang at once.
/// At l = 2 a pair meets the axis, beside another fork at the same l: no region is left between the curves.
#[test]
fn regions_of_no_width_are_not_named() {
    for from in ["S3.1", "L-.1"] {
        let line = format!("spin-down --A 3,2,1 --r 0,1,0 --from {from} --json");
        let found = bifdiag(&line).succeeds().json();
        assert_eq!(found["path"][0]["regions"], json!(["R1", "R4"]), "{from}");
    }
}

#[test]
fn a_body_does_not_fall_over_a_barrier() {
    for (line, onto, barrier, hanging) in [
        ("--A 1.96,1.17,1.16 --r -0.79,0,0 --l 1.95", "S2.1", "S2.2", "L+.1"),
        ("--A 4/3,5,3/2 --r 0,0.7,0 --l 2.19", "S3.1", "S3.2", "L+.1"),
    ] {
        let way = bifdiag(&format!("spin-down {line} --from L-.2 --json")).succeeds().json();
        let first = &list(&way["path"])[0];
        assert_eq!(first["onto"], json!([onto]), "{line} {way}");
        let all = bifdiag(&format!("critical {line} --json")).succeeds().json();
        let height = |curve: &str| {
            let found = list(&all["critical"]).iter().find(|point| point["branch"] == json!(curve));
            number(&found.unwrap_or_else(|| panic!("{curve} {all}"))["h"])
        };
        assert!(height(hanging) < height(onto) && height(onto) < height("L-.2") && height("L-.2") < height(barrier));
    }
}

/// At a cusp the region between the curves that begin there has no height yet.
#[test]
fn a_way_that_begins_at_a_cusp_names_the_regions_beside_it() {
    for (body, curves) in [("14,13,6", ["S3.1", "S3.2"]), ("14,6,5", ["S2.1", "S2.2"])] {
        for curve in curves {
            bifdiag(&format!("spin-down --A {body} --r 1,0,0 --from {curve} --l 4")).succeeds().printing("R1, R1");
        }
    }
}

/// The minima that can be reached are the same up to the pitchfork, where their energies come closer than doubles can tell.
#[test]
fn what_a_rotation_falls_to_is_the_same_up_to_a_pitchfork() {
    for (body, from, momenta, onto) in [
        ("--A 2,2,3 --r 0,0,1", "L-.1", ["2.99", "2.99999", "2.999999999", "2.9999999999"], "S12.1"),
        ("--A 2,2,1 --r 0,0,1", "L+.2", ["1.01", "1.0000001", "1.00000001", "1.000000001"], "S12.1"),
        ("--A 1.49,1.02,1.07 --r 0.98,0,0", "L-.2", ["2.275", "2.276", "2.27601", "2.276012"], "S3.1"),
        ("--A 0.52,0.59,1.26 --r 0,0,-0.7", "L-.2", ["1.28786", "1.28789", "1.287899", "1.2878999"], "S2.1"),
    ] {
        for l in momenta {
            let way = bifdiag(&format!("spin-down {body} --from {from} --l {l} --json")).succeeds().json();
            assert_eq!(list(&way["path"])[0]["onto"], json!([onto]), "{body} {l}");
        }
    }
}

/// Squares of l leave the range of doubles: NaN was printed.
#[test]
fn momenta_beyond_doubles_are_refused() {
    for l in ["1e100", "1e-80"] {
        let refused = bifdiag("spin-down --A 1,2,2.9 --r 0.3,0.1,0.5 --from G0.1 --l").and(l).refused();
        refused.telling("leaves f64 for this body; |l| from");
    }
}
