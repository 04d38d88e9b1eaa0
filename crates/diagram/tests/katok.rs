//! Tops with r on a principal axis: the classes of Katok (1972) and Kovalevskaya's exact values.

use bifdiag_body::{Body, Preset};
use bifdiag_diagram::arrangement::Change;
use bifdiag_equilibria::critical::{Multiplicity, critical};
use bifdiag_equilibria::stability::LinearType;

/// What tells a class: the regions' components with their poles, and the kinds of events by rising l.
type Fingerprint = (Vec<String>, Vec<&'static str>);

fn fingerprint(body: &Body) -> Fingerprint {
    let (found, decided) = fingerprint_and_certainty(body).unwrap_or_else(|| panic!("no atlas of {body:?}"));
    assert!(decided, "{body:?}");
    found
}

/// The fingerprint and whether all of it is decided: beside a border events are closer than f64 tells apart.
fn fingerprint_and_certainty(body: &Body) -> Option<(Fingerprint, bool)> {
    let atlas = bifdiag_diagram::fast::atlas(body).ok()?;
    support::sanity::check_arrangement(atlas.arrangement()).unwrap();
    let mut regions: Vec<String> = atlas.regions().iter().map(|region| format!("{:?}", region.components)).collect();
    regions.sort();
    let mut events: Vec<&str> = atlas.arrangement().events.iter().map(|event| kind(event.change)).collect();
    events.sort_unstable();
    let decided =
        atlas.arrangement().undecided.is_empty() && atlas.regions().iter().all(|region| region.components.is_ok());
    Some(((regions, events), decided))
}

fn kind(change: Change) -> &'static str {
    match change {
        Change::Birth(_) | Change::Death(_) => "cusp",
        Change::Open { .. } | Change::Close { .. } => "pitchfork",
        Change::Swap(_) => "crossing",
    }
}

/// A = (1, A2, A3), r = (1, 0, 0).
fn katok(second: f64, third: f64) -> Body {
    Body::from_f64([1.0, second, third], [1.0, 0.0, 0.0]).unwrap()
}

/// One body of each class, in the numbering of this crate.
const CLASSES: [[f64; 2]; 7] =
    [[1.3, 1.1], [1.2, 0.85], [1.2, 0.6], [0.95, 0.82], [0.9, 0.55], [0.7, 0.65], [0.56, 0.54]];

#[test]
fn the_seven_classes_are_told_apart_by_their_atlases() {
    let all: Vec<Fingerprint> = CLASSES.iter().map(|[second, third]| fingerprint(&katok(*second, *third))).collect();
    for (n, one) in all.iter().enumerate() {
        println!("class {}: {} regions, {:?}", n + 1, one.0.len(), one.1);
        for (m, other) in all.iter().enumerate().skip(n + 1) {
            assert_ne!(one, other, "classes {} and {}", n + 1, m + 1);
        }
    }
    // 6 and 7 are told apart by 4(1/√k2 − 1) > 1/k3 and <.
    for (class, sign) in [(5, 1.0), (6, -1.0)] {
        let [k2, k3] = CLASSES[class].map(|moment| 1.0 - moment);
        assert!(sign * (4.0 * (1.0 / k2.sqrt() - 1.0) - 1.0 / k3) > 0.0);
    }
    // The order of the names does not matter.
    for [second, third] in CLASSES {
        assert_eq!(fingerprint(&katok(second, third)), fingerprint(&katok(third, second)));
    }
}

#[test]
fn presets_lie_in_the_seven_classes() {
    for (n, [second, third]) in CLASSES.iter().enumerate() {
        let body = Preset::find(&format!("katok:{}", n + 1)).unwrap().body();
        assert_eq!(fingerprint(&body), fingerprint(&katok(*second, *third)), "katok:{}", n + 1);
    }
}

/// Where the fingerprint changes, by bisection from bodies on both sides that are decided.
fn border(mut inside: f64, mut outside: f64, body: impl Fn(f64) -> Body) -> f64 {
    let start = fingerprint(&body(inside));
    assert_ne!(start, fingerprint(&body(outside)));
    while (outside - inside).abs() > 1e-9 {
        let middle = 0.5 * (inside + outside);
        match fingerprint_and_certainty(&body(middle)) {
            None => return middle,
            Some((found, _)) if found == start => inside = middle,
            Some(_) => outside = middle,
        }
    }
    0.5 * (inside + outside)
}

#[test]
fn class_borders_are_found_by_bisection_on_the_atlas() {
    let mut worst = 0.0_f64;
    let mut check = |found: f64, expected: f64| {
        worst = worst.max((found - expected).abs());
        assert!((found - expected).abs() < 1e-6, "{found} for {expected}");
    };
    for third in [0.31, 0.6, 0.83, 1.21] {
        check(border(1.07, 0.93, |second| katok(second, third)), 1.0);
        check(border(0.93, 1.07, |second| katok(second, third)), 1.0);
    }
    for third in [0.86, 1.21] {
        check(border(0.79, 0.71, |second| katok(second, third)), 0.75);
        check(border(0.71, 0.79, |second| katok(second, third)), 0.75);
    }
    // Below 3/4: 4(1/√k2 − 1) = 1/k3 with k2 < k3.
    for second in [0.74, 0.7, 0.66, 0.6, 0.56] {
        let k2 = 1.0 - second;
        let expected = 1.0 - 0.25 / (1.0 / f64::sqrt(k2) - 1.0);
        // A3 = A2, where the classes are mirrored, is close.
        let step = (0.5 * (second - expected)).min(0.01);
        check(border(expected + step, expected - step, |third| katok(second, third)), expected);
        check(border(expected - step, expected + step, |third| katok(second, third)), expected);
    }
    println!("borders found to {worst:e}");
}

#[test]
fn kovalevskayas_cusp_crossing_and_pitchfork() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    let atlas = bifdiag_diagram::fast::atlas(&body).unwrap();
    let frame = &atlas.arrangement().set.frame;
    let found: Vec<(&str, f64, f64)> = atlas
        .arrangement()
        .events
        .iter()
        .map(|e| (kind(e.change), (2.0 * e.x).sqrt() * frame.momentum_unit, e.h * frame.energy_unit))
        .collect();
    let expected = [
        ("cusp", (16.0 * 3.0_f64.sqrt() / 9.0).sqrt(), 3.0_f64.sqrt()),
        ("crossing", (8.0 * 2.0_f64.sqrt() - 8.0).sqrt(), 2.0 * 2.0_f64.sqrt() - 1.0),
        ("pitchfork", 2.0, 2.0),
    ];
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(found.0, expected.0);
        assert!((found.1 - expected.1).abs() < 1e-12 && (found.2 - expected.2).abs() < 1e-12, "{found:?} {expected:?}");
    }
}

/// At exactly l = 2 Kovalevskaya's pitchfork: the point that the pair leaves is listed once, as degenerate.
#[test]
fn the_degenerate_point_of_a_pitchfork_is_listed() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    let found = critical(&body, &"2".parse().unwrap()).unwrap();
    assert!(found.complete);
    let degenerate: Vec<_> = found.list.iter().filter(|point| point.multiplicity == Multiplicity::Points(2)).collect();
    assert_eq!(degenerate.len(), 1);
    assert_eq!((degenerate[0].h, degenerate[0].gamma, degenerate[0].omega), (2.0, [-1.0, 0.0, 0.0], 1.0));
    assert_eq!(degenerate[0].stability, LinearType::ZeroReal);
}
