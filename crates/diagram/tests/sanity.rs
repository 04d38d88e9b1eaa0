//! The checks of every atlas see what they are made for.

use bifdiag_body::Preset;
use bifdiag_diagram::arrangement::{Arrangement, Change, RegionId, SlabId};
use bifdiag_diagram::atlas::{Atlas, Region};
use bifdiag_diagram::fast;
use bifdiag_diagram::topology::{Component, Poles};
use bifdiag_numbers::table::{Id, Table};
use support::sanity::{Contradiction, InvariantError, check};

fn preset(name: &str) -> Atlas {
    fast::atlas(&Preset::find(name).unwrap().body()).unwrap()
}

/// The atlas with other regions.
fn with_regions(atlas: &Atlas, change: impl FnOnce(&mut Table<RegionId, Region>)) -> Atlas {
    let mut regions = atlas.regions().clone();
    change(&mut regions);
    Atlas::of_parts(atlas.body().clone(), atlas.arrangement().clone(), regions)
}

/// The atlas with another arrangement.
fn with_arrangement(atlas: &Atlas, change: impl FnOnce(&mut Arrangement)) -> Atlas {
    let mut arrangement = atlas.arrangement().clone();
    change(&mut arrangement);
    Atlas::of_parts(atlas.body().clone(), arrangement, atlas.regions().clone())
}

#[test]
fn every_preset_is_sane() {
    for preset in Preset::all() {
        check(&fast::atlas(&preset.body()).unwrap()).unwrap_or_else(|e| panic!("{}: {e}", preset.name()));
    }
}

#[test]
fn a_sphere_without_three_discs_and_without_a_pole_is_impossible() {
    let atlas = preset("kovalevskaya");
    let three = Component { boundary_circles: 3, poles: Some(Poles { plus: true, minus: false }) };
    let region = atlas.regions().pairs().find(|(_, region)| region.components == Ok(vec![three])).unwrap().0;
    for poles in [Poles::default(), Poles { plus: false, minus: true }] {
        let components = vec![Component { poles: Some(poles), ..three }];
        let changed = with_regions(&atlas, |regions| regions[region].components = Ok(components.clone()));
        assert_eq!(check(&changed), Err(Contradiction::Impossible { region, components }));
    }
    let components = vec![Component { boundary_circles: 6, ..three }];
    let changed = with_regions(&atlas, |regions| regions[region].components = Ok(components.clone()));
    assert_eq!(check(&changed), Err(Contradiction::Impossible { region, components }));
}

#[test]
fn any_region_with_the_components_of_another_contradicts_the_curves() {
    let atlas = preset("paper");
    for (region, own) in atlas.regions().pairs() {
        for other in atlas.regions().iter().filter(|other| other.components != own.components) {
            let changed = with_regions(&atlas, |regions| regions[region].components = other.components.clone());
            assert!(
                matches!(check(&changed), Err(Contradiction::Curves { region: found, .. }) if found == region),
                "{region}: {:?}",
                other.components
            );
        }
    }
}

#[test]
fn an_event_that_is_missing_breaks_eulers_formula() {
    let atlas = preset("paper");
    let events = atlas.arrangement().events.as_slice().to_vec();
    let crossing = events.iter().position(|event| matches!(event.change, Change::Swap(_))).unwrap();
    let others = events.iter().enumerate().filter(|(k, _)| *k != crossing).map(|(_, e)| *e);
    let changed = with_arrangement(&atlas, |arrangement| arrangement.events = others.collect());
    assert!(matches!(check(&changed), Err(Contradiction::Arrangement(InvariantError::Euler { .. }))));
}

#[test]
fn curves_in_the_wrong_order_are_seen() {
    let atlas = preset("paper");
    let slab = SlabId::at(2);
    let order = &atlas.arrangement().slabs[slab].order;
    let [upper, lower] = [order[0], order[1]];
    let changed = with_arrangement(&atlas, |arrangement| arrangement.slabs[slab].order.swap(0, 1));
    let wrong = InvariantError::Order { slab, lower, upper };
    assert_eq!(check(&changed), Err(Contradiction::Arrangement(wrong)));
}
