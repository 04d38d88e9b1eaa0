//! Atlas documents of random bodies: read back, unique ids, neighbours on both sides, samples in their regions.

use std::collections::BTreeSet;

use documents::{DocumentOptions, candidate};
use schema::AtlasDocument;
use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;
use top::atlas::Atlas;
use top::body::Number;

fn number(x: f64) -> Number {
    Number::from_f64(x).unwrap()
}

#[test]
fn atlas_documents_are_consistent() {
    let mut rng = SplitMix64::new(1_750);
    for n in 0..STRATA.len() * 12 {
        let stratum = STRATA[n % STRATA.len()];
        let body = random_body(&mut rng, stratum);
        let head = format!("{stratum:?} A={:?} r={:?}", body.moments_f64(), body.center_f64());
        let atlas = Atlas::new(&body).unwrap();
        let polylines = n < STRATA.len();
        let document = documents::atlas::document(&atlas, &DocumentOptions { polylines, ..DocumentOptions::default() });
        let text = serde_json::to_string(&document).unwrap();
        let back: AtlasDocument = serde_json::from_str(&text).unwrap();
        assert_eq!(back, document, "{head}");
        assert_eq!(serde_json::to_string(&back).unwrap(), text, "{head}");

        let curves: BTreeSet<&str> = document.curves.iter().map(|curve| curve.id.as_str()).collect();
        assert_eq!(curves.len(), document.curves.len(), "curve ids are unique: {head}");
        assert_eq!(document.summary.events, document.events.len());
        assert_eq!(document.summary.regions, document.regions.len());
        assert_eq!(document.summary.signatures.values().sum::<usize>(), document.regions.len());
        assert!(document.events.is_sorted_by(|p, q| p.l <= q.l), "events by rising l: {head}");
        for event in &document.events {
            assert!(event.curves.iter().all(|id| curves.contains(id.as_str())), "{event:?}: {head}");
        }
        let mut starts = Vec::new();
        for (k, region) in document.regions.iter().enumerate() {
            assert_eq!(region.id, format!("R{}", k + 1), "{head}");
            starts.push(region.l_range[0].unwrap());
            assert!(region.cells.is_sorted_by(|p, q| p.l_range[0] <= q.l_range[0]), "{head}");
            let known = region.boundary.iter().all(|id| curves.contains(id.as_str()) || id == "P+" || id == "P-");
            assert!(known, "{:?}: {head}", region.boundary);
            for neighbour in &region.neighbours {
                assert!(region.boundary.contains(&neighbour.curve), "{head}");
                let Some(id) = &neighbour.region else { continue };
                let other = document.regions.iter().find(|other| other.id == *id).expect("a region of the atlas");
                assert!(
                    other
                        .neighbours
                        .iter()
                        .any(|n| n.region.as_ref() == Some(&region.id) && n.curve == neighbour.curve),
                    "{} and {id} across {}: {head}",
                    region.id,
                    neighbour.curve
                );
            }
            let sample = &region.sample;
            let found = atlas.classify(&number(sample.h), &number(sample.l)).unwrap();
            let thin = sample.margin.h <= 4.0 * sample.margin.error_bound + 1e-13 * sample.h.abs();
            assert!(
                thin || found.components().map(candidate).as_ref() == Some(&region.components),
                "{}: {head}",
                region.id
            );
        }
        assert!(starts.is_sorted(), "regions by first appearance {starts:?}: {head}");
    }
}
