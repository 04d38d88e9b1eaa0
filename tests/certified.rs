//! The certified atlas: numbers of regions that are known, and agreement with the standard atlas.

use bifdiag::atlas::Atlas;
use bifdiag::body::{Body, Preset};
use bifdiag::certified::CertifiedAtlas;
use bifdiag::topology::signature;

#[path = "common/mod.rs"]
mod common;

fn preset(name: &str) -> Body {
    Preset::find(name).expect("a preset").body()
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
    assert_eq!(
        signatures(&atlas),
        ["M2", "M2", "M3", "S2", "S2+S2", "S2+T2", "T2", "T2", "T2+T2"].map(str::to_owned)
    );
}

#[test]
fn every_preset_agrees_with_the_standard_atlas() {
    for preset in Preset::all() {
        let body = preset.body();
        let certified = CertifiedAtlas::new(&body).unwrap_or_else(|error| panic!("{}: {error}", preset.name()));
        assert_eq!(signatures(&certified), standard_signatures(&Atlas::new(&body).unwrap()), "{}", preset.name());
    }
}
