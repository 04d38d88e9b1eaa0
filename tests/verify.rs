//! `verify` confirms certified atlases and refuses false ones.

use documents::{DocumentOptions, certified_atlas, seal};
use proof::CertifiedAtlas;
use schema::{AtlasDocument, BodyDocument, ComponentDocument};
use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;
use top::atlas::Atlas;
use top::body::{Body, Preset};
use top::topology::latitude;
use verify::{Refused, cross_check, verify};

fn preset(name: &str) -> Body {
    Preset::find(name).expect("a preset").body()
}

fn document(body: &Body) -> AtlasDocument {
    let atlas = CertifiedAtlas::new(body).unwrap();
    let options = DocumentOptions { polylines: false, ..DocumentOptions::default() };
    certified_atlas(&atlas, &atlas.drawn().unwrap(), &options).unwrap()
}

#[test]
fn random_bodies_of_every_stratum_are_verified() {
    let mut confirmed = 0;
    for stratum in STRATA {
        let body = random_body(&mut SplitMix64::new(4), stratum);
        let report = verify(&document(&body)).unwrap_or_else(|error| panic!("{stratum:?} {body:?}: {error}"));
        assert!(report.proof);
        confirmed += report.regions;
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

/// A certificate with one false claim, hashed anew.
fn mutated(change: impl Fn(&mut AtlasDocument)) -> Result<(), Refused> {
    let mut document = document(&preset("paper"));
    let before = document.clone();
    change(&mut document);
    assert_ne!(document, before, "the mutation changes nothing");
    seal(&mut document).unwrap();
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

/// What is written twice or under another name: a source of an event, a cusp, a stretch.
#[test]
fn nothing_is_counted_twice() {
    let certificate = |d: &mut AtlasDocument, change: &dyn Fn(&mut schema::CertificateDocument)| {
        change(d.certificate.as_mut().unwrap());
    };
    let renamed = mutated(|d| {
        certificate(d, &|c| {
            let source = c.events.iter_mut().flat_map(|event| &mut event.sources).find(|s| *s == "cusp:0").unwrap();
            *source = "cusp:00".to_owned();
        });
    });
    assert!(matches!(renamed, Err(Refused::Event { .. })), "{renamed:?}");
    let repeated = mutated(|d| {
        certificate(d, &|c| {
            let again = c.events[0].clone();
            c.events.push(again);
        });
    });
    assert!(matches!(repeated, Err(Refused::Event { .. })), "{repeated:?}");
    let repeated = mutated(|d| {
        certificate(d, &|c| {
            let again = c.pairs[0].clone();
            c.pairs.push(again);
        });
    });
    assert!(matches!(repeated, Err(Refused::Pair { .. })), "{repeated:?}");
}

/// The second method for an atlas without certificate.
fn sweep(body: &BodyDocument, h: f64, l: f64) -> Option<Vec<ComponentDocument>> {
    let frame = Body::parse(&body.moments, &body.center).ok()?.frame();
    let found = latitude::components(&frame, h / frame.energy_unit, l / frame.momentum_unit).ok()?;
    Some(found.iter().map(documents::component).collect())
}

#[test]
fn an_atlas_without_certificate_is_cross_checked_and_not_proved() {
    let atlas = Atlas::new(&preset("paper")).unwrap();
    let options = DocumentOptions { polylines: false, ..DocumentOptions::default() };
    let mut standard = documents::atlas::document(&atlas, &options);
    assert!(matches!(verify(&standard), Err(Refused::Certificate { present: false, .. })));
    let report = cross_check(&standard, sweep).unwrap();
    assert!(!report.proof && report.regions == 9 && report.open.is_empty());
    // Where the second method has no answer the region is open.
    let report = cross_check(&standard, |body, h, l| sweep(body, h, l).filter(|found| found.len() == 1)).unwrap();
    assert_eq!((report.regions, report.open.len()), (6, 3));
    standard.regions[2].components = standard.regions[0].components.clone();
    assert!(matches!(cross_check(&standard, sweep), Err(Refused::Topology { .. })));
    standard.body.moments[1] = "0".to_owned();
    assert!(matches!(cross_check(&standard, sweep), Err(Refused::Body { axis: 2, .. })));
    // A certified atlas is proved, not compared.
    let certified = document(&preset("paper"));
    assert!(matches!(cross_check(&certified, sweep), Err(Refused::Certificate { present: true, .. })));
}
