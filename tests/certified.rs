//! The certified atlas: numbers that are known, agreement with the standard atlas, and what `verify` refuses.

use documents::DocumentOptions;
use proof::{CertifiedAtlas, checksum};
use schema::{AtlasDocument, Status};
use top::atlas::Atlas;
use top::body::{Body, Number, Preset};
use top::topology::signature;
use verify::{Refused, verify};

#[path = "common/mod.rs"]
mod common;

use common::bodies::{STRATA, random_body};
use common::random::SplitMix64;

fn preset(name: &str) -> Body {
    Preset::find(name).expect("a preset").body()
}

fn document(body: &Body) -> AtlasDocument {
    let atlas = CertifiedAtlas::new(body).unwrap();
    let options = DocumentOptions { polylines: false, ..DocumentOptions::default() };
    atlas.document(&atlas.drawn().unwrap(), &options).unwrap()
}

fn signatures(atlas: &CertifiedAtlas) -> Vec<String> {
    let mut all: Vec<String> = (0..atlas.region_count())
        .map(|region| atlas.components(region).map_or("?".to_owned(), |c| signature(c).unwrap_or_default()))
        .collect();
    all.sort();
    all
}

fn standard_signatures(atlas: &Atlas) -> Vec<String> {
    let mut all: Vec<String> = (0..atlas.regions().len())
        .map(|region| atlas.components(region).map_or("?".to_owned(), |c| signature(c).unwrap_or_default()))
        .collect();
    all.sort();
    all
}

#[test]
fn the_papers_body_has_nine_regions() {
    let atlas = CertifiedAtlas::new(&preset("paper")).unwrap();
    assert_eq!((atlas.region_count(), atlas.event_count()), (9, 5));
    let expected = ["M2", "M2", "M3", "S2", "S2+S2", "S2+T2", "T2", "T2", "T2+T2"];
    assert_eq!(signatures(&atlas), expected.map(str::to_owned));
}

/// Kovalevskaya's body: empty, disc, disc with two holes, disc with one hole, sphere at l = 1.84 (five types).
#[test]
fn kovalevskayas_body_has_its_types_at_the_known_heights() {
    let atlas = CertifiedAtlas::new(&preset("kovalevskaya")).unwrap();
    let at = |h: &str| atlas.classify(&h.parse().unwrap(), &"1.84".parse().unwrap());
    assert_eq!(at("-0.154").status, Status::Forbidden);
    for (h, region) in
        [("-0.153", "D2"), ("1.8320", "D2"), ("1.8323", "S2-3D2"), ("1.8466", "S2-2D2"), ("1.8594", "S2")]
    {
        let components = at(h).components.unwrap();
        assert_eq!(components.iter().map(|c| c.accessible_region.as_str()).collect::<Vec<_>>(), [region], "{h}");
    }
}

#[test]
fn every_preset_agrees_with_the_standard_atlas() {
    for preset in Preset::all() {
        let body = preset.body();
        let certified = CertifiedAtlas::new(&body).unwrap_or_else(|error| panic!("{}: {error}", preset.name()));
        assert_eq!(signatures(&certified), standard_signatures(&Atlas::new(&body).unwrap()), "{}", preset.name());
    }
}

#[test]
fn random_bodies_of_every_stratum_agree_and_verify() {
    let mut confirmed = 0;
    for stratum in STRATA {
        let mut rng = SplitMix64::new(4);
        for _ in 0..1 {
            let body = random_body(&mut rng, stratum);
            let certified = CertifiedAtlas::new(&body).unwrap_or_else(|error| panic!("{body:?}: {error}"));
            let standard = Atlas::new(&body).unwrap();
            if standard.arrangement().undecided.is_empty() {
                assert_eq!(certified.region_count(), standard.regions().len(), "{body:?}");
            }
            let report = verify(&document(&body)).unwrap_or_else(|error| panic!("{stratum:?} {body:?}: {error}"));
            assert!(report.proof);
            confirmed += report.regions;
        }
    }
    assert!(confirmed > 50, "{confirmed}");
}

#[test]
fn the_presets_are_verified() {
    for preset in Preset::all() {
        let report = verify(&document(&preset.body())).unwrap_or_else(|error| panic!("{}: {error}", preset.name()));
        assert!(report.proof, "{}", preset.name());
    }
    let border = Body::parse(&["1", "5/9", "1/2"], &["1", "0", "0"]).unwrap();
    assert!(verify(&document(&border)).unwrap().proof);
}

#[test]
fn points_are_proved_to_lie_in_their_regions() {
    let atlas = CertifiedAtlas::new(&preset("paper")).unwrap();
    let number = |text: &str| text.parse::<Number>().unwrap();
    let at = |h: &str, l: &str| atlas.classify(&number(h), &number(l));
    for (h, l, expected) in [
        ("1.8", "3.25", "S2"),
        ("3.8", "3.25", "S2+T2"),
        ("4.45", "3.25", "T2+T2"),
        ("4.675", "3.25", "M3"),
        ("5.3", "3.25", "M2"),
        ("6.5", "3.25", "T2"),
        ("3.1486", "2.72", "M2"),
        ("14.0", "7.2", "S2+S2"),
    ] {
        assert_eq!(at(h, l).signature.as_deref(), Some(expected), "({h}, {l})");
    }
    // Where f64 leaves the point undecided, 30 digits decide.
    assert_eq!(at("4.645784643886435", "3.25").status, Status::Regular);
    // On the pitchfork of Kovalevskaya's body three regions meet.
    let kovalevskaya = CertifiedAtlas::new(&preset("kovalevskaya")).unwrap();
    let critical = kovalevskaya.classify(&number("2"), &number("2"));
    assert_eq!((critical.status, critical.candidates.len()), (Status::Critical, 3));
}

/// A certificate with one false claim, hashed anew.
fn mutated(change: impl Fn(&mut AtlasDocument)) -> Result<(), Refused> {
    let mut document = document(&preset("paper"));
    let before = document.clone();
    change(&mut document);
    assert_ne!(document, before, "the mutation changes nothing");
    let sum = checksum(&document).unwrap();
    document.certificate.as_mut().unwrap().checksum = sum;
    verify(&document).map(|_| ())
}

#[test]
fn a_flipped_byte_is_caught_by_the_checksum() {
    let mut document = document(&preset("paper"));
    document.regions[0].sample.h += 1e-9;
    assert_eq!(verify(&document), Err(Refused::Checksum));
}

#[test]
fn false_claims_are_refused_by_the_mathematics() {
    let certificate = |d: &mut AtlasDocument, change: &dyn Fn(&mut schema::CertificateDocument)| {
        change(d.certificate.as_mut().unwrap());
    };
    // Wrong genus.
    let refused = mutated(|d| {
        let components = d.regions[6].components.clone();
        d.regions[5].components = components;
        d.regions[5].signature = d.regions[6].signature.clone();
    });
    assert!(matches!(refused, Err(Refused::Topology { .. })), "{refused:?}");
    // A cell given to another region.
    let refused = mutated(|d| certificate(d, &|c| c.slabs[3].curves[2].region = "R1".to_owned()));
    assert!(matches!(refused, Err(Refused::Slab { .. })), "{refused:?}");
    // A missing root, and a missing cusp.
    let refused = mutated(|d| certificate(d, &|c| drop(c.meetings.pop())));
    assert!(matches!(refused, Err(Refused::MeetingCount { .. })), "{refused:?}");
    let refused = mutated(|d| certificate(d, &|c| drop(c.cusps.pop())));
    assert!(matches!(refused, Err(Refused::CuspCount { .. })), "{refused:?}");
    // An invented root.
    let refused = mutated(|d| {
        certificate(d, &|c| {
            let again = c.cusps[0].clone();
            c.cusps.push(again);
        });
    });
    assert!(refused.is_err());
    // An isolating range that misses its root.
    let refused = mutated(|d| certificate(d, &|c| c.cusps[0].place.y[1] = c.cusps[0].place.y[0].clone()));
    assert!(refused.is_err());
    // An enclosure that is too narrow.
    let refused = mutated(|d| certificate(d, &|c| c.events[0].x[1] = c.events[0].x[0].clone()));
    assert!(matches!(refused, Err(Refused::Event { .. })), "{refused:?}");
    // Curves in the wrong order.
    let refused = mutated(|d| certificate(d, &|c| c.slabs[2].curves.swap(1, 2)));
    assert!(matches!(refused, Err(Refused::Slab { .. })), "{refused:?}");
    // A pair with the wrong sign, one that is missing, and one with a gap.
    let refused = mutated(|d| certificate(d, &|c| c.pairs[0].stretches[0].sign *= -1));
    assert!(matches!(refused, Err(Refused::Pair { .. })), "{refused:?}");
    let refused = mutated(|d| certificate(d, &|c| drop(c.pairs.pop())));
    assert!(matches!(refused, Err(Refused::Pair { .. })), "{refused:?}");
    // A swapped neighbour.
    let refused = mutated(|d| {
        let other = d.regions[0].neighbours[0].region.clone();
        d.regions[4].neighbours[0].region = if other == d.regions[4].neighbours[0].region { None } else { other };
    });
    assert!(matches!(refused, Err(Refused::Region { .. })), "{refused:?}");
    // A sample outside its region.
    let refused = mutated(|d| {
        certificate(d, &|c| {
            let h = c.samples[0].h.clone();
            c.samples[1].h = h;
            c.samples[1].slab = c.samples[0].slab;
        });
    });
    assert!(matches!(refused, Err(Refused::Region { .. })), "{refused:?}");
    // A region too few.
    let refused = mutated(|d| d.summary.regions = 8);
    assert!(matches!(refused, Err(Refused::Summary { .. })), "{refused:?}");
    // Another body.
    let refused = mutated(|d| d.body.moments[1] = "1.2".parse().unwrap());
    assert!(refused.is_err());
}

#[test]
fn a_standard_atlas_is_cross_checked_and_not_proved() {
    let atlas = Atlas::new(&preset("paper")).unwrap();
    let mut document =
        documents::atlas::document(&atlas, &DocumentOptions { polylines: false, ..DocumentOptions::default() });
    let report = verify(&document).unwrap();
    assert!(!report.proof && report.regions == 9);
    document.regions[2].components = document.regions[0].components.clone();
    assert!(matches!(verify(&document), Err(Refused::Topology { .. })));
}
