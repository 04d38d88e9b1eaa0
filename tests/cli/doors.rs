//! One verdict for one steady rotation, from whichever door a user comes: `critical`, `state`, `campbell`, `critical-spin`, the
//! atlas; and what `verify` says of those that a certificate leaves unproved. (The page calls the function of `critical`:
//! `web/test/module/guest.test.ts` holds their bytes equal.)

use bifdiag::documents::reading::{Claim, claim};
use bifdiag::documents::{layout, seal};
use bifdiag::schema::{NonlinearDocument, NonlinearVerdict, Reason};
use serde_json::{Value, json};
use support::bodies::{Stratum, random_body};
use support::random::SplitMix64;

use crate::builder::bifdiag;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value}"))
}

/// Verdict, reason and what friction leaves.
fn judged(of: &Value) -> [Value; 3] {
    [&of["nonlinear"]["verdict"], &of["nonlinear"]["why"], &of["friction"]["conserving_l"]].map(Clone::clone)
}

/// The steady rotations at a spin that is no threshold.
fn at_spin(body: &str, spin: &str) -> Vec<Value> {
    let all = bifdiag(&format!("critical {body} --json --spin")).and(spin).succeeds().json();
    list(&all["axes"]).to_vec()
}

/// `critical` at the l of a rotation, on its branch.
fn at_its_momentum(body: &str, axis: &Value) -> Value {
    let l = number(&axis["l"]);
    let found = bifdiag(&format!("critical {body} --l {l:?} --json")).succeeds().json();
    let here = list(&found["critical"]).iter().filter(|point| point["branch"] == axis["branch"]);
    let far = |point: &&Value| (number(&point["h"]) - number(&axis["h"])).abs();
    here.min_by(|p, q| far(p).total_cmp(&far(q))).unwrap_or_else(|| panic!("{body} {axis}")).clone()
}

/// The last row of Campbell's diagram about an axis, if there is one: both frequencies, growth, stability, friction.
fn last_of_campbell(body: &str, direction: &str, spin: &str) -> Option<[f64; 5]> {
    let place = tempfile::tempdir().unwrap();
    let line = format!("campbell {body} --axis={direction} --no-plot --out {} --to", place.path().display());
    bifdiag(&line).and(spin).succeeds_unless_refused()?;
    let text = std::fs::read_to_string(place.path().join("campbell.csv")).unwrap();
    let row: Vec<f64> = text.lines().last().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    Some(std::array::from_fn(|k| row[k + 1]))
}

#[test]
fn a_verdict_is_one_from_every_door_in_every_stratum() {
    let mut rng = SplitMix64::new(3907);
    let strata = [
        Stratum::Generic,
        Stratum::Generic,
        Stratum::Plane,
        Stratum::Axis,
        Stratum::NearAxis,
        Stratum::Symmetric,
        Stratum::TinyR,
        Stratum::NearEqual,
        Stratum::Lagrange,
    ];
    let (mut compared, mut drawn) = (0, 0);
    for stratum in strata {
        let body = random_body(&mut rng, stratum);
        let numbers = |list: [f64; 3]| list.map(|x| format!("{x:?}")).join(",");
        let (a, r) = (body.moments_f64(), body.center_f64());
        let size = r.iter().fold(0.0_f64, |size, x| size.max(x.abs())) / a.iter().fold(0.0_f64, |size, x| size.max(*x));
        let line = format!("--A={} --r={}", numbers(a), numbers(r));
        let atlas = bifdiag(&format!("{line} --json --no-drawing")).succeeds().json();
        let families = bifdiag(&format!("critical-spin {line} --json")).succeeds().json();
        for factor in [0.7, 1.9] {
            let omega = factor * size.sqrt();
            let spin = format!("{omega:?} rad/s");
            let all = at_spin(&line, &spin);
            let axes: Vec<&Value> = all.iter().filter(|axis| axis["multiplicity"].is_u64()).collect();
            for axis in &axes {
                let expected = judged(axis);
                assert_eq!(judged(&at_its_momentum(&line, axis)), expected, "{line} {axis}");
                let up: Vec<String> = list(&axis["axis"]).iter().map(|x| format!("{:?}", number(x))).collect();
                let state = bifdiag(&format!("state {line} --axis={} --json --spin", up.join(",")));
                let state = state.and(&spin).succeeds().json();
                assert_eq!(judged(&state["steady"]), expected, "{line} {axis} {state}");
                let curve = list(&atlas["curves"]).iter().find(|curve| curve["id"] == axis["branch"]).unwrap();
                let l = number(&axis["l"]);
                let inside =
                    |span: &&Value| number(&span["l_from"]) <= l && span["l_to"].as_f64().is_none_or(|to| l <= to);
                let span = list(&curve["stability"]).iter().find(inside).unwrap();
                assert_eq!(judged(span), expected, "{line} {axis} {curve}");
                compared += 1;
            }
            // The families of `critical-spin` at this spin are these axes.
            let stretch = |family: &Value| {
                let begins = |stretch: &&Value| {
                    stretch["from"].is_null() || number(&stretch["from"]["spin"]["rad_per_s"]) <= omega
                };
                list(&family["stretches"]).iter().rfind(begins).cloned()
            };
            let mut reply: Vec<[String; 2]> = list(&families["families"])
                .iter()
                .filter(|family| family["axes"].is_u64())
                .flat_map(|family| {
                    let count = usize::try_from(family["axes"].as_u64().unwrap()).unwrap();
                    let reply = stretch(family)
                        .map(|at| [family["branch"].as_str().unwrap().to_owned(), at["stable"].to_string()]);
                    std::iter::repeat_n(reply, count).flatten()
                })
                .collect();
            let branch = |axis: &&Value| axis["branch"].as_str().unwrap().split('.').next().unwrap().to_owned();
            let mut known: Vec<[String; 2]> =
                axes.iter().map(|axis| [branch(axis), axis["stable"].to_string()]).collect();
            reply.sort();
            known.sort();
            assert_eq!(reply, known, "{line} {spin}");
            // Campbell's diagram ends with one of them, which its frequencies name.
            for direction in ["x", "y", "z", "-x", "-y", "-z"] {
                let Some([first, second, growth, stable, survives]) = last_of_campbell(&line, direction, &spin) else {
                    continue;
                };
                let is_it = |axis: &&Value| {
                    let pairs: Vec<[f64; 2]> = list(&axis["eigenvalues"])
                        .iter()
                        .map(|pair| [number(&pair[0]), number(&pair[1]) / std::f64::consts::TAU])
                        .collect();
                    let near = |p: f64, q: f64| (p - q).abs() < 1e-9 * omega;
                    let has = |frequency: f64| frequency.is_nan() || pairs.iter().any(|pair| near(pair[1], frequency));
                    let fastest = pairs.iter().fold(0.0_f64, |fastest, pair| fastest.max(pair[0]));
                    has(first) && has(second) && near(fastest, growth)
                };
                let mine: Vec<&Value> = all.iter().filter(is_it).collect();
                assert!(!mine.is_empty(), "{line} {spin} {direction}: {first} {second} {growth}");
                for axis in mine {
                    let is_stable = axis["nonlinear"]["verdict"] == json!("stable");
                    assert_eq!(stable > 0.5, is_stable, "{line} {spin} {direction} {axis}");
                    let lasts = is_stable && axis["friction"]["conserving_l"] == json!("survives");
                    assert_eq!(survives > 0.5, lasts, "{line} {spin} {direction} {axis}");
                    drawn += 1;
                }
            }
        }
    }
    println!("{compared} rotations, {drawn} of them in Campbell's diagrams");
    assert!(compared >= 40 && drawn >= 50, "{compared} {drawn}");
}

/// A verdict that its certificate leaves unproved claims nothing: `verify` confirms the rest and names the curve. One that claims
/// to be proved, or to be none where there is a proof, is refused.
#[test]
fn verify_names_the_verdicts_that_it_does_not_check() {
    let text = bifdiag("--body paper --certificate --no-drawing --json").succeeds().stdout();
    bifdiag("verify -").reading(text.clone()).succeeds().printing("verified: ");
    let changed = |curves: &[&str], change: &dyn Fn(&mut NonlinearDocument)| {
        let Ok(Claim::Atlas(mut atlas)) = claim(&text, "-") else { panic!("no atlas") };
        for curve in atlas.curves.iter_mut().filter(|curve| curves.contains(&curve.id.as_str())) {
            let by_arnold = curve.stability.iter_mut().filter(|span| span.nonlinear.why == Reason::Arnold);
            by_arnold.for_each(|span| change(&mut span.nonlinear));
        }
        seal(&mut atlas).unwrap();
        layout::text(&atlas).unwrap()
    };
    let open = |proved| NonlinearDocument::along(NonlinearVerdict::Open, Reason::Degenerate, proved);
    let line = "not checked (\"proved\": false): verdicts by Arnold's theorem on";
    let one = bifdiag("verify -").reading(changed(&["G0.1"], &|known| *known = open(false))).succeeds();
    one.printing("verified: ").printing(&format!("{line} G0.1\n"));
    let both = bifdiag("verify -").reading(changed(&["G0.1", "G1.1"], &|known| *known = open(false))).succeeds();
    both.printing(&format!("{line} G0.1, G1.1\n"));
    for wrong in [
        changed(&["G0.1"], &|known| *known = open(true)),
        changed(&["G0.1"], &|known| known.proved = false),
        changed(&["G0.1"], &|known| known.verdict = NonlinearVerdict::Unstable),
    ] {
        bifdiag("verify -").reading(wrong).fails().telling("curves.stability.nonlinear");
    }
}
