//! Relative equilibria with their eigenvalues, against 60 digits from the whole Euler–Poisson linearisation.

use std::collections::BTreeMap;

use bifdiag_body::Body;
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, critical};
use bifdiag_equilibria::curves::{CriticalSet, CurveName};
use bifdiag_equilibria::nonlinear::Reason;
use bifdiag_equilibria::stability::{LinearType, LinearTypes, StabilityChangeKind, StabilitySpan};
use serde::Deserialize;

#[derive(Deserialize)]
struct Case {
    #[serde(rename = "A")]
    moments: [String; 3],
    #[serde(rename = "r")]
    center: [String; 3],
    l: String,
    points: Vec<Point>,
}

#[derive(Deserialize)]
struct Point {
    h: String,
    #[serde(rename = "type")]
    kind: String,
    eigenvalues: [[String; 2]; 2],
}

/// The cases of the repository, or those of the file that STABILITY_CASES names.
fn cases() -> Vec<Case> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/oracles/stability.jsonl");
    let path = std::env::var("STABILITY_CASES").unwrap_or_else(|_| path.to_owned());
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn found(a: &[String; 3], r: &[String; 3], l: &str) -> Vec<Equilibrium> {
    let equilibria = critical(&Body::parse(a, r).unwrap(), &l.parse().unwrap()).unwrap();
    assert!(equilibria.complete, "{a:?} {r:?} {l}");
    equilibria.list
}

/// The word of the oracle, which sees a circle's equilibria one by one: their pair across it lies beside a zero pair.
fn expected_word(point: &Point, found: &Equilibrium) -> String {
    if found.multiplicity != Multiplicity::Circle && found.multiplicity != Multiplicity::Sphere {
        return point.kind.clone();
    }
    assert_eq!(point.kind, "zero");
    let [re, im] = point.eigenvalues[0].each_ref().map(|x| x.parse::<f64>().unwrap());
    if re > 0.0 {
        "saddle"
    } else if im > 0.0 {
        "elliptic"
    } else {
        "zero"
    }
    .to_owned()
}

#[test]
fn types_and_eigenvalues_are_those_of_the_whole_linearisation() {
    let mut seen = BTreeMap::new();
    let (mut bodies, mut worst) = (0, 0.0_f64);
    for case in cases() {
        let list = found(&case.moments, &case.center, &case.l);
        let label = format!("{:?} {:?} l = {}", case.moments, case.center, case.l);
        assert_eq!(list.len(), case.points.len(), "{label}: {list:?}");
        bodies += 1;
        for (point, expected) in list.iter().zip(&case.points) {
            let h: f64 = expected.h.parse().unwrap();
            assert!((point.h - h).abs() <= 1e-12 * (1.0 + h.abs()), "{label}: {point:?}, h = {h}");
            let word = expected_word(expected, point);
            assert_eq!(point.stability.word(), word, "{label}: {point:?}");
            *seen.entry(word).or_insert(0) += 1;
            let size = point.eigenvalues.pairs.as_flattened().iter().fold(0.0_f64, |m, x| m.max(*x));
            worst = worst.max(point.eigenvalues.error / size.max(f64::MIN_POSITIVE));
            for (pair, expected) in point.eigenvalues.pairs.iter().zip(&expected.eigenvalues) {
                for (part, expected) in pair.iter().zip(expected) {
                    let expected: f64 = expected.parse().unwrap();
                    let allowed = point.eigenvalues.error + f64::EPSILON * expected;
                    assert!((part - expected).abs() <= allowed, "{label}: {point:?}, {expected}");
                }
            }
        }
    }
    assert!(bodies > 600 && (seen.len() == 7 || std::env::var_os("STABILITY_CASES").is_some()), "{bodies} {seen:?}");
    assert!(worst < 1e-6, "{worst:e}");
    println!("{bodies} cases, {seen:?}, largest relative error bound {worst:e}");
}

fn lagrange(l: &str) -> Vec<Equilibrium> {
    let body = ["2", "1", "1"].map(str::to_owned);
    found(&body, &["1", "0", "0"].map(str::to_owned), l)
}

#[test]
fn the_standing_lagrange_top_sleeps_from_its_threshold_on() {
    // A1 = 2 A2: the gyroscopic term vanishes and both pairs agree at every l.
    let standing = |l: &str| lagrange(l).into_iter().find(|point| point.gamma[0] == -1.0).unwrap();
    for (l, kind, verdict) in [
        ("0", LinearType::DoubleReal, Reason::Spectrum),
        ("1.9", LinearType::DoubleReal, Reason::Spectrum),
        ("1.9999999999999999999", LinearType::DoubleReal, Reason::Spectrum),
        ("2", LinearType::Zero, Reason::Energy),
        ("2.0000000000000000001", LinearType::DoubleElliptic, Reason::Energy),
        ("50", LinearType::DoubleElliptic, Reason::Energy),
    ] {
        let point = standing(l);
        assert_eq!((point.stability, point.nonlinear.why), (kind, verdict), "{l}: {point:?}");
        let hanging = lagrange(l).into_iter().find(|point| point.gamma[0] == 1.0).unwrap();
        assert_eq!(hanging.nonlinear.why, Reason::Energy, "{l}: {hanging:?}");
    }
    let [first, second] = standing("1.9").eigenvalues.pairs;
    assert_eq!(first, second);
    assert!((first[0] - 0.0975_f64.sqrt()).abs() < 1e-15 && first[1] == 0.0);
}

#[test]
fn a_slender_top_sleeps_by_its_integral_only() {
    let verdict = |l: &str| {
        let list = found(&["1", "1", "1/2"].map(str::to_owned), &["0", "0", "1"].map(str::to_owned), l);
        let standing = list.into_iter().find(|point| point.gamma[2] == -1.0).unwrap();
        (standing.index, standing.stability, standing.nonlinear.why)
    };
    assert_eq!(verdict("1.999999999999999999"), (2, LinearType::Complex, Reason::Spectrum));
    assert_eq!(verdict("2"), (2, LinearType::DoubleElliptic, Reason::Integral));
    assert_eq!(verdict("2.000000000000000001"), (2, LinearType::Elliptic, Reason::Integral));
}

#[test]
fn cusps_and_pitchforks_are_counted_exactly() {
    // Kovalevskaya: the pair leaves the standing rotation at l = 2 and is born in a cusp at l^2 = 16√3/9.
    let count = |l: &str| {
        let list = found(&["2", "2", "1"].map(str::to_owned), &["1", "0", "0"].map(str::to_owned), l);
        let degenerate = list.iter().filter(|point| point.multiplicity == Multiplicity::Points(2)).count();
        (list.len(), degenerate)
    };
    // √(16√3/9) = 1.754765350603323…
    assert_eq!(count("1.7547653506033"), (2, 0));
    assert_eq!(count("1.7547653506034"), (6, 0));
    assert_eq!(count("1.99999999999999999999"), (6, 0));
    assert_eq!(count("2"), (4, 1));
    assert_eq!(count("2.00000000000000000001"), (4, 0));
}

/// A change of type between two momenta, by the words of `critical` alone.
fn word_at(body: &Body, curve: &str, l: f64) -> Option<LinearType> {
    let l = l.to_string().parse().unwrap();
    let list = critical(body, &l).unwrap().list;
    list.into_iter()
        .find(|point| point.curve.is_some_and(|name| name.to_string() == curve))
        .map(|point| point.stability)
}

#[test]
fn changes_of_stability_are_all_that_a_dense_scan_sees() {
    let bodies: [([&str; 3], [&str; 3]); 7] = [
        (["2", "1.1", "1"], ["0.94868", "0", "0.61623"]),
        (["2", "2", "1"], ["1", "0", "0"]),
        (["1", "1", "0.5"], ["0", "0", "1"]),
        (["0.57847392", "0.53739099", "1"], ["0.00595273", "0.00176367", "-0.99998073"]),
        (["1.3", "0.9", "0.7"], ["0.1", "-0.4", "0.8"]),
        (["1", "1.001", "0.6"], ["0.02", "0.01", "1"]),
        (["1", "0.7", "0.5"], ["1", "0", "0"]),
    ];
    let mut hopf = 0;
    for (a, r) in bodies {
        let body = Body::parse(&a, &r).unwrap();
        let set = CriticalSet::new(body.frame()).unwrap();
        let types = LinearTypes::exact(&body, &set);
        let changes = types.changes();
        hopf += changes.iter().filter(|change| change.kind == StabilityChangeKind::HamiltonianHopf).count();
        for id in set.curves.ids().filter(|&id| set.curves[id].is_critical()) {
            let name = CurveName::of(&set, id).to_string();
            let spans = types.spans(id).unwrap();
            let mut l = 0.01;
            for _ in 0..600 {
                l *= 1.012;
                let Some(kind) = word_at(&body, &name, l) else { continue };
                let inside = |span: &&StabilitySpan| l > span.l_from && span.l_to.is_none_or(|to| l < to);
                let span = spans.iter().find(inside);
                assert_eq!(span.map(|span| span.stability), Some(kind), "{a:?} {r:?} {name} l = {l}: {spans:?}");
            }
            // Each border of two spans is listed, with both types, and both sides of it are as said.
            for pair in spans.windows(2) {
                let at = pair[1].l_from;
                let listed =
                    changes.iter().find(|change| change.curve == id && change.l == at && change.onto.is_none());
                let change = listed.unwrap_or_else(|| panic!("{name} l = {at}: {changes:?}"));
                assert_eq!((change.from, change.to), (pair[0].stability, pair[1].stability));
                let reach = 1e-9 * at + change.error_bound;
                assert_eq!(word_at(&body, &name, at - reach), Some(change.from));
                assert_eq!(word_at(&body, &name, at + reach), Some(change.to));
            }
        }
    }
    assert!(hopf >= 4, "{hopf}");
}

#[test]
fn lagranges_threshold_is_exact() {
    for (a, r) in
        [(["1", "1", "0.5"], ["0", "0", "1"]), (["9", "4", "9"], ["0", "-16", "0"]), (["3", "7", "7"], ["5", "0", "0"])]
    {
        let body = Body::parse(&a, &r).unwrap();
        let set = CriticalSet::new(body.frame()).unwrap();
        let changes = LinearTypes::exact(&body, &set).changes();
        let hopf: Vec<_> =
            changes.iter().filter(|change| change.kind == StabilityChangeKind::HamiltonianHopf).collect();
        assert_eq!(hopf.len(), 1, "{changes:?}");
        let across: f64 = a.iter().zip(r).find(|(_, r)| *r == "0").unwrap().0.parse().unwrap();
        let weight = r.iter().map(|r| r.parse::<f64>().unwrap().abs()).sum::<f64>();
        // l² = 4 A r
        let l = (4.0 * across * weight).sqrt();
        assert!((hopf[0].l - l).abs() <= hopf[0].error_bound + f64::EPSILON * l, "{:?} {l}", hopf[0]);
        assert!(hopf[0].error_bound < 1e-14 * (1.0 + l * l));
    }
}
