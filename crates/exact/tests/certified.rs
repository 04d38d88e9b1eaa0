//! The certified atlas: numbers that are known, agreement with the standard atlas.

use std::cell::RefCell;

use bifdiag_body::{Body, Number, Preset};
use bifdiag_diagram::atlas::Atlas;
use bifdiag_diagram::spin_down::spin_down;
use bifdiag_diagram::topology::Answer;
use bifdiag_diagram::topology::{Component, signature};
use bifdiag_exact::{CertifiedAtlas, classify_exactly};
use proptest::prelude::*;

use support::property::holds_for_bodies;
use support::strata::STRATA;

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
    let body = preset("kovalevskaya");
    let at = |h: &str| classify_exactly(&body, &h.parse().unwrap(), &"1.84".parse().unwrap()).unwrap();
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
        assert_eq!(
            signatures(&certified),
            standard_signatures(&bifdiag_diagram::fast::atlas(&body).unwrap()),
            "{}",
            preset.name()
        );
    }
}

#[test]
fn bodies_of_every_stratum_agree_with_the_standard_atlas_and_contradict_no_theorem() {
    let (proved, refused) = (RefCell::new(0), RefCell::new(0));
    for stratum in STRATA {
        holds_for_bodies(stratum, 4, |body| {
            let Ok(certified) = CertifiedAtlas::new(body) else {
                prop_assert!(stratum.is_planted(), "not proved");
                *refused.borrow_mut() += 1;
                return Ok(());
            };
            *proved.borrow_mut() += 1;
            let drawn = certified.to_atlas();
            if let Ok(Err(contradiction)) = drawn.as_ref().map(support::sanity::check) {
                return Err(TestCaseError::fail(contradiction.to_string()));
            }
            let Ok(standard) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
            if standard.arrangement().undecided.is_empty() {
                prop_assert_eq!(certified.region_count(), standard.regions().len());
                let open = standard.regions().iter().any(|region| region.components.is_err());
                let [proved, rounded] = [signatures(&certified), standard_signatures(&standard)];
                prop_assert!(open || proved.contains(&"?".to_owned()) || proved == rounded, "{proved:?} {rounded:?}");
            }
            Ok(())
        });
    }
    let (proved, refused) = (proved.into_inner(), refused.into_inner());
    println!("{proved} proved, {refused} refused");
    assert!(refused * 5 <= proved, "{refused} refused, {proved} proved");
}

#[test]
fn points_are_proved_to_lie_in_their_regions() {
    let number = |text: &str| text.parse::<Number>().unwrap();
    let at = |h: &str, l: &str| classify_exactly(&preset("paper"), &number(h), &number(l)).unwrap();
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
    let critical = classify_exactly(&preset("kovalevskaya"), &number("2"), &number("2")).unwrap();
    assert!(matches!(&critical.answer, Answer::Critical(candidates) if candidates.len() == 3), "{critical:?}");
}

/// Between events that are proved to be at one l there is no slab: places beside them are found all the same, and ways past them
/// go on.
#[test]
fn events_at_one_l_have_no_slab_between_them() {
    for moments in [["3", "2", "1"], ["7", "5", "3"], ["4", "3", "2"]] {
        let body = Body::parse(&moments, &["0", "1", "0"]).unwrap();
        let proved = CertifiedAtlas::new(&body).unwrap().to_atlas().unwrap();
        let fast = bifdiag_diagram::fast::atlas(&body).unwrap();
        let (slabs, events) = (proved.arrangement().slabs.len(), proved.arrangement().events.len());
        assert_eq!((slabs, fast.arrangement().slabs.len()), (events, events + 1), "{moments:?}");
        let at = proved.momentum(proved.arrangement().events.iter().last().unwrap().x);
        for l in [at, at.next_up(), at.next_down(), 1.001 * at, 0.999 * at, 3.0 * at] {
            for k in -20..40 {
                let h = 0.37 * f64::from(k);
                let [found, expected] = [&proved, &fast].map(|atlas| atlas.locate(h, l).unwrap().place);
                assert!(
                    found == expected || (l / at - 1.0).abs() < 1e-15,
                    "{moments:?} {h} {l}: {found:?} {expected:?}"
                );
            }
        }
        for curve in proved.arrangement().set.curves.ids() {
            let x = proved.arrangement().set.curves[curve].x()[1].min(20.0);
            let [found, expected] = [&proved, &fast].map(|atlas| spin_down(atlas.arrangement(), curve, x).len());
            assert_eq!(found, expected, "{moments:?} {curve:?}");
        }
    }
}
