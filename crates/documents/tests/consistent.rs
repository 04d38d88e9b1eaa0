//! Atlas documents of bodies of all strata: read back, unique ids, neighbours on both sides, samples in their regions, names
//! that follow from circles and poles.

use std::collections::BTreeSet;

use bifdiag_body::Number;
use bifdiag_diagram::atlas::Atlas;
use bifdiag_documents::{DocumentOptions, Drawn};
use bifdiag_schema::{AtlasDocument, ComponentDocument, RegionDocument};
use proptest::prelude::*;
use support::property::{Verdict, holds_for_bodies};
use support::strata::STRATA;

fn number(x: f64) -> Number {
    Number::from_f64(x).unwrap()
}

#[test]
fn atlas_documents_are_consistent() {
    for stratum in STRATA {
        holds_for_bodies(stratum, 12, |body| {
            let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
            is_consistent(&atlas, Drawn::Nothing)
        });
        holds_for_bodies(stratum, 1, |body| {
            let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
            is_consistent(&atlas, Drawn::Everything)
        });
    }
}

fn is_consistent(atlas: &Atlas, drawing: Drawn) -> Verdict {
    let document =
        bifdiag_documents::atlas::document(atlas, &DocumentOptions { drawing, ..DocumentOptions::default() });
    let text = serde_json::to_string(&document).unwrap();
    let back: Result<AtlasDocument, _> = serde_json::from_str(&text);
    // A number that is not finite is written as null.
    let place = back.as_ref().err().map_or(0, serde_json::Error::column);
    prop_assert!(back.is_ok(), "cannot be read back after {:?}", &text[place.saturating_sub(200)..place]);
    let back = back.unwrap();
    prop_assert_eq!(&back, &document);
    prop_assert_eq!(serde_json::to_string(&back).unwrap(), text);

    let curves: BTreeSet<&str> = document.curves.iter().map(|curve| curve.id.as_str()).collect();
    prop_assert_eq!(curves.len(), document.curves.len(), "curve ids are unique");
    prop_assert_eq!(document.summary.events, document.events.len());
    prop_assert_eq!(document.summary.regions, document.regions.len());
    prop_assert_eq!(document.summary.signatures.values().sum::<usize>(), document.regions.len());
    // Events within rounding of each other stand in the order that gluing has settled.
    prop_assert!(document.events.is_sorted_by(|p, q| p.l - p.l_error <= q.l + q.l_error), "events by rising l");
    for event in &document.events {
        prop_assert!(event.curves.iter().all(|id| curves.contains(id.as_str())), "{event:?}");
    }
    let mut starts = Vec::new();
    for (k, region) in document.regions.iter().enumerate() {
        prop_assert_eq!(&region.id, &format!("R{}", k + 1));
        starts.push(region.l_range[0].unwrap());
        let from = |cell: &bifdiag_schema::CellDocument| cell.l_range[0].unwrap_or(0.0);
        prop_assert!(region.cells.is_sorted_by(|p, q| from(p) <= from(q) * (1.0 + 1e-12)), "{}", region.id);
        let known = region.boundary.iter().all(|id| curves.contains(id.as_str()) || id == "P+" || id == "P-");
        prop_assert!(known, "{:?}", region.boundary);
        neighbours_know_it(region, &document)?;
        region.components.iter().try_for_each(names_follow)?;
        let sample = &region.sample;
        let found =
            bifdiag_diagram::fast::classify_in(atlas, &number(sample.h), &number(sample.l)).map(|(found, _)| found);
        let thin = sample.margin.h <= 4.0 * sample.margin.error_bound + 1e-13 * sample.h.abs();
        let found = found.ok().and_then(|found| found.components().map(bifdiag_documents::components));
        // Where f64 proves no topology the region has none either.
        let open = region.components.is_empty() || found.is_none();
        prop_assert!(thin || open || found.as_ref() == Some(&region.components), "{}: {found:?}", region.id);
    }
    prop_assert!(starts.is_sorted_by(|p, q| *p <= q * (1.0 + 1e-12)), "regions by first appearance {starts:?}");
    Ok(())
}

fn neighbours_know_it(region: &RegionDocument, document: &AtlasDocument) -> Verdict {
    for neighbour in &region.neighbours {
        prop_assert!(region.boundary.contains(&neighbour.curve), "{neighbour:?}");
        let Some(id) = &neighbour.region else { continue };
        let other = document.regions.iter().find(|other| other.id == *id).expect("a region of the atlas");
        let back =
            |n: &bifdiag_schema::NeighbourDocument| n.region.as_ref() == Some(&region.id) && n.curve == neighbour.curve;
        prop_assert!(other.neighbours.iter().any(back), "{} and {id} across {}", region.id, neighbour.curve);
    }
    Ok(())
}

/// Theorem 10.6, Proposition 10.7, and the bounds of Theorem 11.1 and Proposition 11.8.
fn names_follow(component: &ComponentDocument) -> Verdict {
    let k = component.boundary_circles;
    let accessible = match k {
        0 => "S2".to_owned(),
        1 => "D2".to_owned(),
        _ => format!("S2-{k}D2"),
    };
    prop_assert_eq!(&component.accessible_region, &accessible);
    let Some(poles) = &component.poles else {
        prop_assert_eq!((component.genus, &component.section), (None, &None));
        return Ok(());
    };
    let genus = k + u32::try_from(poles.len()).unwrap() - 1;
    let section = ["S2", "T2"].get(genus as usize).map_or_else(|| format!("M{genus}"), |name| (*name).to_owned());
    prop_assert_eq!((component.genus, &component.section), (Some(genus), &Some(section)));
    prop_assert!(k <= 5 && (k < 3 || poles.iter().any(|pole| pole == "+")), "{component:?}");
    Ok(())
}
