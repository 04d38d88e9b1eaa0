//! The sweep over latitudes against the oracle file, the paper, exact values and a flood fill.

mod common;

use std::collections::BTreeMap;

use bifdiag::body::{Body, Number};
use bifdiag::topology::latitude::{self, Arcs, Latitudes, SweepError};
use bifdiag::topology::{Component, Poles, signature};
use common::bodies::{STRATA, Stratum, random_body, random_point};
use common::flood_fill;
use common::random::SplitMix64;
use serde::Deserialize;

/// Components at (h, l) in the body's own units.
fn sweep(body: &Body, h: f64, l: f64) -> Result<Vec<Component>, SweepError> {
    let frame = body.frame();
    latitude::components(&frame, h / frame.energy_unit, l / frame.momentum_unit)
}

/// (boundary circles, number of poles) of each component.
fn types(components: &[Component]) -> Vec<(u32, u32)> {
    components.iter().map(|c| (c.boundary_circles, c.poles.map_or(0, Poles::count))).collect()
}

#[derive(Deserialize)]
struct Case {
    #[serde(rename = "A")]
    moments: [Number; 3],
    r: [Number; 3],
    h: f64,
    l: f64,
    components: Vec<CaseComponent>,
}

#[derive(Deserialize)]
struct CaseComponent {
    boundary_circles: u32,
    poles: u32,
    genus: u32,
}

#[test]
fn every_case_of_the_oracle_file() {
    let text = include_str!("../data/cases/classify.jsonl");
    let mut count = 0;
    for line in text.lines() {
        let case: Case = serde_json::from_str(line).unwrap();
        let body = Body::new(case.moments, case.r).unwrap();
        let found = sweep(&body, case.h, case.l).unwrap_or_else(|error| panic!("{error}: {line}"));
        let expected: Vec<_> = case.components.iter().map(|c| (c.boundary_circles, c.poles)).collect();
        assert_eq!(types(&found), expected, "{line}");
        let genera: Vec<_> = case.components.iter().map(|c| Some(c.genus)).collect();
        assert_eq!(found.iter().map(Component::genus).collect::<Vec<_>>(), genera, "{line}");
        count += 1;
    }
    assert_eq!(count, 80);
}

#[test]
fn the_nine_regions_of_the_papers_body() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    let disc = (1, 0);
    for (h, l, expected, section) in [
        (1.8, 3.25, vec![disc], "S2"),
        (2.6, 3.25, vec![(1, 1)], "T2"),
        (3.8, 3.25, vec![disc, (1, 1)], "S2+T2"),
        (4.45, 3.25, vec![(1, 1), (1, 1)], "T2+T2"),
        (4.675, 3.25, vec![(2, 2)], "M3"),
        (5.3, 3.25, vec![(1, 2)], "M2"),
        (6.5, 3.25, vec![(0, 2)], "T2"),
        (3.1486, 2.72, vec![(2, 1)], "M2"),
        (14.0, 7.2, vec![disc, disc], "S2+S2"),
    ] {
        let found = sweep(&body, h, l).unwrap();
        assert_eq!(types(&found), expected, "({h}, {l})");
        assert_eq!(signature(&found).as_deref(), Some(section));
    }
}

#[test]
fn kovalevskayas_body() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    for (h, expected) in [
        (-0.16, vec![]),
        (-0.15, vec![(1, 1)]),
        (1.83, vec![(1, 1)]),
        (1.84, vec![(3, 1)]),
        (1.85, vec![(2, 2)]),
        (1.86, vec![(0, 2)]),
    ] {
        let found = sweep(&body, h, 1.84).unwrap();
        let found: Vec<_> = found.iter().map(|c| (c.boundary_circles, c.poles.unwrap().count())).collect();
        assert_eq!(found, expected, "h = {h}");
    }
}

#[test]
fn random_points_agree_with_a_flood_fill() {
    let mut rng = SplitMix64::new(2008);
    let mut tally: BTreeMap<Stratum, [u32; 3]> = BTreeMap::new();
    let mut seen: BTreeMap<Vec<(u32, u32)>, u32> = BTreeMap::new();
    let mut disagreements = Vec::new();
    for n in 0..SAMPLES {
        let stratum = STRATA[n % STRATA.len()];
        let body = random_body(&mut rng, stratum);
        let (h, l) = random_point(&mut rng, &body);
        let counts = tally.entry(stratum).or_default();
        counts[0] += 1;
        let Ok(found) = sweep(&body, h, l) else {
            counts[1] += 1;
            continue;
        };
        let coarse = flood_fill::components(&body, h, l, 48);
        if coarse != flood_fill::components(&body, h, l, 67) {
            continue;
        }
        counts[2] += 1;
        *seen.entry(types(&found)).or_default() += 1;
        if coarse != found {
            disagreements.push((stratum, body, h, l, found, coarse));
        }
    }
    println!("points, undecided, compared: {tally:?}\ntypes: {seen:?}");
    for disagreement in &disagreements {
        println!("{disagreement:?}");
    }
    assert!(disagreements.is_empty());
}

const SAMPLES: usize = 3300;
