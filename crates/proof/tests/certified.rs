//! The certified atlas: numbers that are known, agreement with the standard atlas.

use proof::CertifiedAtlas;
use top::atlas::Atlas;
use top::body::{Body, Number, Preset};
use top::classify::Answer;
use top::topology::{Component, signature};

use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;

fn preset(name: &str) -> Body {
    Preset::find(name).expect("a preset").body()
}

fn signatures(atlas: &CertifiedAtlas) -> Vec<String> {
    let mut all: Vec<String> = atlas
        .region_ids()
        .map(|region| atlas.components(region).map_or("?".to_owned(), |c| signature(c).unwrap_or_default()))
        .collect();
    all.sort();
    all
}

fn standard_signatures(atlas: &Atlas) -> Vec<String> {
    let mut all: Vec<String> = atlas
        .regions()
        .ids()
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
    assert_eq!(at("-0.154").answer, Answer::Forbidden);
    for (h, region) in
        [("-0.153", "D2"), ("1.8320", "D2"), ("1.8323", "S2-3D2"), ("1.8466", "S2-2D2"), ("1.8594", "S2")]
    {
        let found = at(h);
        let components = found.components().unwrap();
        assert_eq!(components.iter().map(Component::accessible_region).collect::<Vec<_>>(), [region], "{h}");
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
fn random_bodies_of_every_stratum_agree() {
    for stratum in STRATA {
        let mut rng = SplitMix64::new(4);
        let body = random_body(&mut rng, stratum);
        let certified = CertifiedAtlas::new(&body).unwrap_or_else(|error| panic!("{body:?}: {error}"));
        let standard = Atlas::new(&body).unwrap();
        if standard.arrangement().undecided.is_empty() {
            assert_eq!(certified.region_count(), standard.regions().len(), "{body:?}");
        }
    }
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
        assert_eq!(at(h, l).components().and_then(signature).as_deref(), Some(expected), "({h}, {l})");
    }
    // Where f64 leaves the point undecided, 30 digits decide.
    assert!(matches!(at("4.645784643886435", "3.25").answer, Answer::Regular(_)));
    // On the pitchfork of Kovalevskaya's body three regions meet.
    let kovalevskaya = CertifiedAtlas::new(&preset("kovalevskaya")).unwrap();
    let critical = kovalevskaya.classify(&number("2"), &number("2"));
    assert!(matches!(&critical.answer, Answer::Critical(candidates) if candidates.len() == 3), "{critical:?}");
}
