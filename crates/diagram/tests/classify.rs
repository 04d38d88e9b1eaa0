//! `classify` against flood-fill oracles and the paper's points, on cold and on prepared bodies.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::atlas::Place;
use bifdiag_diagram::fast::{classify, classify_in};
use bifdiag_diagram::topology::{Answer, Classification};
use bifdiag_diagram::topology::{Component, Poles, signature as join};
use serde_json::Value;

fn number(value: &Value) -> Number {
    serde_json::from_value(value.clone()).unwrap()
}

fn body(case: &Value) -> Body {
    let triple = |key: &str| -> [Number; 3] { serde_json::from_value(case[key].clone()).unwrap() };
    Body::new(triple("A"), triple("r")).unwrap()
}

/// (boundary circles, number of poles) of each component, sorted.
fn circles_and_poles(answer: &Classification) -> Vec<(u64, u64)> {
    let components = answer.components().unwrap_or_else(|| panic!("not decided: {answer:?}"));
    let mut found: Vec<(u64, u64)> = components
        .iter()
        .map(|c| (u64::from(c.boundary_circles), u64::from(c.poles.map_or(0, Poles::count))))
        .collect();
    found.sort_unstable();
    found
}

/// `data/cases/classify.jsonl`: flood fill on two grids and the Euler characteristic.
#[test]
fn flood_fill_oracles_agree() {
    for line in support::data("cases/classify.jsonl").lines() {
        let case: Value = serde_json::from_str(line).unwrap();
        let mut expected: Vec<(u64, u64)> = case["components"]
            .as_array()
            .unwrap()
            .iter()
            .map(|c| (c["boundary_circles"].as_u64().unwrap(), c["poles"].as_u64().unwrap()))
            .collect();
        expected.sort_unstable();
        let (body, h, l) = (body(&case), number(&case["h"]), number(&case["l"]));
        let cold = classify(&body, &h, &l).unwrap();
        assert_eq!(circles_and_poles(&cold), expected, "{line}");
        let prepared = classify_in(&bifdiag_diagram::fast::atlas(&body).unwrap(), &h, &l).unwrap().0;
        assert_eq!(prepared.components(), cold.components(), "{line}");
    }
}

fn signature(a: [&str; 3], r: [&str; 3], h: &str, l: &str) -> String {
    let body = Body::parse(&a, &r).unwrap();
    let (h, l) = (h.parse().unwrap(), l.parse().unwrap());
    let cold = classify(&body, &h, &l).unwrap();
    let prepared = classify_in(&bifdiag_diagram::fast::atlas(&body).unwrap(), &h, &l).unwrap().0;
    assert_eq!(cold.components(), prepared.components());
    match cold.answer {
        Answer::Forbidden => "forbidden".to_owned(),
        Answer::Regular(components) => join(&components).unwrap(),
        open => panic!("{open:?}"),
    }
}

/// The nine regions of Fig. BifGen.
#[test]
fn the_papers_nine_points_have_the_papers_types() {
    let paper = |h: &str, l: &str| signature(["2", "1.1", "1"], ["0.94868", "0", "0.61623"], h, l);
    assert_eq!(paper("1.8", "3.25"), "S2");
    assert_eq!(paper("2.6", "3.25"), "T2");
    assert_eq!(paper("3.8", "3.25"), "S2+T2");
    assert_eq!(paper("4.45", "3.25"), "T2+T2");
    assert_eq!(paper("4.675", "3.25"), "M3");
    assert_eq!(paper("5.3", "3.25"), "M2");
    assert_eq!(paper("6.5", "3.25"), "T2");
    assert_eq!(paper("3.1486", "2.72"), "M2");
    assert_eq!(paper("14.0", "7.2"), "S2+S2");
    assert_eq!(paper("1.6", "-3.25"), "forbidden");
}

/// Kovalevskaya's top along l = 1.84: empty, disc, disc with two holes, with one hole, S².
#[test]
fn kovalevskayas_five_types() {
    let body = Body::parse(&["2", "2", "1"], &["1", "0", "0"]).unwrap();
    let regions: Vec<String> = ["-0.2", "0", "1.84", "1.85", "3"]
        .iter()
        .map(|h| {
            let found = classify(&body, &h.parse().unwrap(), &"1.84".parse().unwrap()).unwrap();
            found.components().unwrap().iter().map(Component::accessible_region).collect::<Vec<_>>().join("+")
        })
        .collect();
    assert_eq!(regions, ["", "D2", "S2-3D2", "S2-2D2", "S2"]);
}

/// Two events of this body are settled against the order of their rounded l; a point between them was a panic.
#[test]
fn points_at_events_that_rounding_has_put_out_of_order_are_answered() {
    let a = ["821353/500000", "769697/1000000", "1/5"];
    let r = ["1291/125000", "23/5000000000000000", "3/500000000000"];
    let atlas = bifdiag_diagram::fast::atlas(&Body::parse(&a, &r).unwrap()).unwrap();
    assert!(atlas.arrangement().slabs.iter().any(|slab| slab.x[0] > slab.x[1]), "the body shows it no more");
    for event in &atlas.arrangement().events {
        let found = atlas.locate(atlas.energy(event.h), atlas.momentum(event.x)).unwrap();
        assert!(matches!(&found.place, Place::Undecided(places) if places.len() > 1), "{event:?}: {found:?}");
    }
}

/// Where f64 leaves it open whether −r̂ or two curves come first, it must not name a component that no body shows.
#[test]
fn no_region_shows_what_no_body_does() {
    let moments = ["12957/20000", "51828000000000012957/80000000000000000000", "1/5"];
    let body = Body::parse(&moments, &["0", "17/5000000000000", "1549/40000"]).unwrap();
    let atlas = bifdiag_diagram::fast::atlas(&body).unwrap();
    let shown = atlas.regions().iter().filter_map(|region| region.components.as_ref().ok()).flatten();
    let impossible = |c: &Component| c.boundary_circles >= 3 && c.poles.is_some_and(|poles| !poles.plus);
    assert_eq!(shown.filter(|component| impossible(component)).count(), 0);
    assert!(atlas.regions().iter().any(|region| region.components.is_err()));
}
