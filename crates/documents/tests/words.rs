//! What is said where a way through the plane goes over curves.

use bifdiag_body::Preset;
use bifdiag_documents::{DocumentOptions, words};
use bifdiag_equilibria::critical::critical;
use bifdiag_exact::Accuracy;
use bifdiag_numbers::Number;

/// The sentences from below everything to above everything at one l, and on the way back.
fn words_of(body: &str, l: f64) -> [Vec<String>; 2] {
    let body = Preset::find(body).unwrap().body();
    let atlas = bifdiag_exact::atlas(&body, Accuracy::Exact).unwrap();
    let heights: Vec<f64> = critical(&body, &Number::from_f64(l).unwrap()).unwrap().list.iter().map(|e| e.h).collect();
    let (low, high) =
        (heights.iter().copied().fold(f64::MAX, f64::min), heights.iter().copied().fold(f64::MIN, f64::max));
    let document = bifdiag_documents::atlas::document(&atlas, &DocumentOptions::default());
    let ends = [[low - 1.0, l], [high + 1.0, l]];
    [[0, 1], [1, 0]].map(|[from, to]| {
        let passages = atlas.passages(ends[from], ends[to]).unwrap();
        passages.iter().map(|passage| words::passage(&atlas, &document, passage)).collect()
    })
}

#[test]
fn lagranges_top_has_circles_and_poles_on_critical_curves() {
    let [up, down] = words_of("lagrange", 2.1);
    assert_eq!(
        up,
        [
            "the forbidden region → R1 across L+.1, at the pole +r̂: a disc of U appears, and with it a three-sphere of E \
             (empty to D2).",
            "R1 → R3 across S23.1: an annulus of U appears (D2 to D2 + S2-2D2).",
            "R3 → R4 across L-.1, at the pole -r̂: a hole of U closes (D2 + S2-2D2 to D2 + D2).",
            "R4 → R2 across S23.2: along a whole circle of maxima U closes (D2 + D2 to S2).",
        ]
    );
    assert_eq!(down[0], "R2 → R4 across S23.2: along a whole circle of maxima U opens (S2 to D2 + D2).");
    assert_eq!(down.len(), up.len());
}

#[test]
fn every_way_begins_with_a_birth_and_ends_with_the_whole_sphere() {
    for preset in Preset::all() {
        for l in [0.3, 1.0, 1.9, 3.1] {
            let [up, down] = words_of(preset.name(), l);
            assert!(up[0].starts_with("the forbidden region → R"), "{}: {up:?}", preset.name());
            assert!(up.last().unwrap().contains(" to S2)."), "{}: {up:?}", preset.name());
            assert_eq!(up.len(), down.len(), "{}", preset.name());
        }
    }
}
