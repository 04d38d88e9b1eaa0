//! `verify` confirms atlases with certificates and refuses false ones.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};

use dashu_ratio::RBig;
use documents::{DocumentOptions, Subject, certified_atlas, certified_atlas_of, seal};
use numbers::symmetric::Symmetric;
use part::{MassProperties, Part};
use proof::CertifiedAtlas;
use proptest::prelude::*;
use schema::{Accuracy, AtlasDocument, CertifiedNode, PlaceDocument};
use serde_json::Value;
use support::property::{body_text, holds_for_bodies};
use support::strata::STRATA;
use top::body::{Body, Number, Preset};
use verify::{Refused, verify};

fn preset(name: &str) -> Body {
    Preset::find(name).expect("a preset").body()
}

fn document(body: &Body) -> AtlasDocument {
    certified(&CertifiedAtlas::new(body).unwrap())
}

fn certified(atlas: &CertifiedAtlas) -> AtlasDocument {
    let options = DocumentOptions { polylines: false, ..DocumentOptions::default() };
    certified_atlas(atlas, &atlas.drawn().unwrap(), &options).unwrap()
}

#[test]
fn bodies_of_every_stratum_are_verified() {
    let unproved = RefCell::new(Vec::new());
    for stratum in STRATA {
        holds_for_bodies(stratum, 2, |body| {
            match CertifiedAtlas::new(body) {
                Ok(atlas) => {
                    verify(&certified(&atlas)).map_err(|refused| TestCaseError::fail(refused.to_string()))?;
                }
                // Two curves of a planted body may lie closer than the prover's bits tell.
                Err(_) if stratum.is_planted() => unproved.borrow_mut().push(body_text(body)),
                Err(error) => return Err(TestCaseError::fail(error.to_string())),
            }
            Ok(())
        });
    }
    assert!(unproved.borrow().len() <= 1, "not proved: {unproved:?}");
}

#[test]
fn the_presets_are_verified() {
    for preset in Preset::all() {
        let report = verify(&document(&preset.body())).unwrap_or_else(|error| panic!("{}: {error}", preset.name()));
        assert!(report.regions > 0, "{}", preset.name());
    }
    let border = Body::parse(&["1", "5/9", "1/2"], &["1", "0", "0"]).unwrap();
    assert!(verify(&document(&border)).unwrap().regions > 0);
}

/// A distance ε from the triple point of Katok's borders, two of its events are 2ε² apart: their enclosures are written
/// with as many digits as it takes.
#[test]
fn events_next_to_a_triple_point_are_verified() {
    for exponent in [22, 50] {
        let third = format!("0.5{}1", "0".repeat(exponent - 2));
        let body = Body::parse(&["1", "5/9", &third], &["1", "0", "0"]).unwrap();
        let report = verify(&document(&body)).unwrap_or_else(|refused| panic!("1e-{exponent}: {refused}"));
        assert_eq!((report.regions, report.events), (7, 7), "1e-{exponent}");
    }
}

/// A certificate with one false claim, hashed anew.
/// Two families over moments that differ by 10⁻¹², each with a cusp.
#[test]
fn families_beside_each_other_on_an_axis_are_verified() {
    let mut document = document(&Body::parse(&["2", "1.000000000001", "1"], &["1", "0", "0"]).unwrap());
    verify(&document).unwrap();
    // The order that one lemma gives all along, the other way round.
    let pairs = &mut document.certificate.as_mut().unwrap().pairs;
    let at_once =
        pairs.iter_mut().flat_map(|pair| &mut pair.stretches).find(|s| s.from.x.is_none() && s.to.x.is_none());
    let stretch = at_once.unwrap();
    stretch.sign = -stretch.sign;
    seal(&mut document).unwrap();
    assert!(matches!(verify(&document), Err(Refused::Pair { .. })));
}

/// Moments that differ by 10⁻¹², r as near an axis or a plane, and a rod: the order follows from Lemma 7.8.
#[test]
fn curves_side_by_side_are_verified() {
    for (a, r) in [
        (["1.26", "1.26000000000126", "1.56"], ["38e-14", "68e-14", "0.11"]),
        (["2", "1.000000000001", "1"], ["1", "1e-12", "0"]),
        (["1e-9", "1.74", "1.74000000174"], ["0.89", "0", "1e-11"]),
    ] {
        let document = document(&Body::parse(&a, &r).unwrap());
        verify(&document).unwrap_or_else(|refused| panic!("{a:?} {r:?}: {refused}"));
    }
}

/// The slope turns at a moment itself, on no branch; an event lies at h = 0, up to the least double; the slope of one
/// branch turns over a chord of another.
#[test]
fn coincidences_of_plain_bodies_are_verified() {
    for (a, r) in [
        (["3", "2", "1"], ["1", "1", "1"]),
        (["6", "2", "1"], ["2", "3", "1"]),
        (["3", "2", "1"], ["0", "1", "0"]),
        (["0.513", "0.187", "1.62"], ["-2", "-1", "-1.98"]),
    ] {
        let document = document(&Body::parse(&a, &r).unwrap());
        verify(&document).unwrap_or_else(|refused| panic!("{a:?} {r:?}: {refused}"));
    }
}

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
    assert!(matches!(refused, Err(Refused::NotIsolated { .. })), "{refused:?}");
    // An isolating range that misses its root.
    let refused = mutated(|d| certificate(d, &|c| c.cusps[0].place.y[1] = c.cusps[0].place.y[0].clone()));
    assert!(matches!(refused, Err(Refused::NotIsolated { .. })), "{refused:?}");
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
    let refused = mutated(|d| {
        d.body.given.moments[1] = "1.2".parse().unwrap();
        d.head.command = d.head.command.replace("1.1", "1.2");
    });
    assert!(matches!(refused, Err(Refused::NotIsolated { .. })), "{refused:?}");
}

/// The box of a crossing with both its ends on one side of it: the gap of the curves has the right sign at one end alone.
#[test]
fn a_crossing_beside_its_box_is_refused() {
    let true_one = document(&Body::parse(&["1", "5/9", "0.5001"], &["1", "0", "0"]).unwrap());
    for kept in 0..2 {
        let mut forged = true_one.clone();
        let certificate = forged.certificate.as_mut().unwrap();
        let mut stretches = certificate.pairs.iter_mut().flat_map(|pair| &mut pair.stretches);
        let nodes = stretches.find_map(|stretch| stretch.crossing.as_mut()).expect("a crossing");
        let x = nodes.each_ref().map(|node| exact(node.x.as_ref().unwrap()));
        let thousandth = (&x[1] - &x[0]) / RBig::from(1000);
        let moved = if kept == 0 { &x[0] + thousandth } else { &x[1] - thousandth };
        let both = nodes.each_ref().map(|node| node.places.clone().unwrap());
        let places = [0, 1].map(|curve| around(&both[0][curve], &both[1][curve]));
        nodes[1 - kept] = CertifiedNode { x: Some(numbers::decimal::exact(&moved)), places: Some(places) };
        seal(&mut forged).unwrap();
        let refused = verify(&forged);
        assert!(matches!(refused, Err(Refused::Pair { .. })), "kept {kept}: {refused:?}");
    }
}

fn exact(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

/// The place that holds two.
fn around(p: &PlaceDocument, q: &PlaceDocument) -> PlaceDocument {
    let (low, high) = if exact(&p.y[0]) < exact(&q.y[0]) { (p, q) } else { (q, p) };
    PlaceDocument { y: [low.y[0].clone(), high.y[1].clone()], ..low.clone() }
}

/// A place moved to either side by a hundred times its width and a millionth.
#[test]
fn a_place_beside_its_abscissa_is_refused() {
    let true_one = document(&preset("paper"));
    let slabs = &true_one.certificate.as_ref().unwrap().slabs;
    for (slab, level) in slabs.iter().enumerate().flat_map(|(n, slab)| (0..slab.curves.len()).map(move |k| (n, k))) {
        for side in [-1, 1] {
            let mut forged = true_one.clone();
            let height = &mut forged.certificate.as_mut().unwrap().slabs[slab].curves[level];
            let Some(place) = &mut height.place else { continue };
            let [low, high] = place.y.each_ref().map(|y| exact(y));
            let step = ((&high - &low) * RBig::from(100) + &low / RBig::from(1_000_000)) * RBig::from(side);
            place.y = [low + &step, high + step].map(|y| numbers::decimal::exact(&y));
            seal(&mut forged).unwrap();
            let refused = verify(&forged);
            assert!(matches!(refused, Err(Refused::Place { .. })), "slab {slab}, curve {level}, {side}: {refused:?}");
        }
    }
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

/// Documents of a generic body, of one with a pitchfork where a pole line meets it, and of a tilted part.
fn whole_documents() -> [AtlasDocument; 3] {
    let whole = |body: &Body| {
        let atlas = CertifiedAtlas::new(body).unwrap();
        certified_atlas(&atlas, &atlas.drawn().unwrap(), &DocumentOptions::default()).unwrap()
    };
    [whole(&preset("paper")), whole(&preset("katok:6")), of_tilted_part()]
}

fn of_tilted_part() -> AtlasDocument {
    let tensor = Symmetric::new(["0.1", "0.2", "0.25", "0.01", "0", "-0.02"].map(exact));
    let properties = MassProperties::about_com(exact("2.5"), ["0.01", "0.02", "0.15"].map(exact), tensor).unwrap();
    let part = Part { properties, gravity: exact("9.80665"), units: "kg,cm,s".parse().unwrap() };
    let subject = Subject::of_part(&part).unwrap();
    let atlas = CertifiedAtlas::new(&subject.body).unwrap();
    certified_atlas_of(&subject, &atlas, &atlas.drawn().unwrap(), &DocumentOptions::default()).unwrap()
}

/// A document with another value at a place, sealed anew: whether it is refused. What is no document is.
fn is_refused(document: &Value, pointer: &str, forgery: Value) -> bool {
    let mut forged = document.clone();
    *forged.pointer_mut(pointer).unwrap() = forgery;
    let Ok(mut forged) = serde_json::from_value::<AtlasDocument>(forged) else { return true };
    seal(&mut forged).unwrap();
    verify(&forged).is_err()
}

/// Every field of the document, forged once and sealed anew, is refused: a field that is added cannot be forgotten.
#[test]
fn every_field_is_refused_when_it_is_forged() {
    let mut known = BTreeSet::new();
    for document in whole_documents() {
        verify(&document).unwrap();
        let document = serde_json::to_value(document).unwrap();
        let mut fields = BTreeMap::new();
        leaves(&document, "", "", &mut fields);
        // By its form, and what the seal replaces.
        for field in ["version", "certificate.checksum"] {
            fields.remove(field).expect(field);
        }
        for (field, pointer) in fields.into_iter().filter(|(field, _)| known.insert(field.clone())) {
            for forgery in forgeries(document.pointer(&pointer).unwrap()) {
                assert!(is_refused(&document, &pointer, forgery), "{field} at {pointer}");
            }
        }
    }
}

/// Every list of the document with an entry left out, one told twice or two exchanged, in three places where it first stands,
/// sealed anew, is refused. Of points of pictures three of four are left out: without one a chord may be as good as others.
#[test]
fn every_list_is_refused_when_it_is_forged() {
    let mut known = BTreeSet::new();
    for document in whole_documents() {
        let document = serde_json::to_value(document).unwrap();
        let mut fields = BTreeMap::new();
        lists(&document, "", "", &mut fields);
        assert!(fields.len() > 30, "{}", fields.len());
        // Corners of outlines may be left out.
        fields.retain(|field, _| !field.contains("polygon"));
        for (field, pointers) in fields {
            let middle = pointers.len() / 2;
            let chosen = if known.insert(field.clone()) { [0, middle, pointers.len() - 1] } else { [middle; 3] };
            for pointer in BTreeSet::from(chosen).into_iter().map(|number| &pointers[number]) {
                let list = document.pointer(pointer).unwrap().as_array().unwrap();
                for (what, forgery) in forged_lists(list) {
                    assert!(is_refused(&document, pointer, Value::Array(forgery)), "{what}: {field} at {pointer}");
                }
            }
        }
    }
}

/// Names exchanged wherever they stand are not those of their places.
#[test]
fn names_are_those_of_their_places() {
    let true_one = serde_json::to_string(&whole_documents()[0]).unwrap();
    for [p, q] in [["R1", "R2"], ["R3", "R7"], ["G1.1", "G1.2"], ["G0.1", "G3.1"], ["P+", "P-"], ["R9", "R10"]] {
        let quoted = |name: &str| format!("\"{name}\"");
        let exchanged =
            true_one.replace(&quoted(p), "\"?\"").replace(&quoted(q), &quoted(p)).replace("\"?\"", &quoted(q));
        assert_ne!(exchanged, true_one);
        let mut forged: AtlasDocument = serde_json::from_str(&exchanged).unwrap();
        seal(&mut forged).unwrap();
        assert!(verify(&forged).is_err(), "{p} and {q}");
    }
}

/// The command of another body or with other options, and versions that are none.
#[test]
fn the_command_is_that_of_the_document() {
    let command = document(&preset("paper")).head.command;
    assert_eq!(command, "bifdiag atlas --A 2,1.1,1 --r 0.94868,0,0.61623 --certificate --json");
    for other in [
        command.replace("1.1", "1.2"),
        command.replace(" --certificate", ""),
        command.replace(" --json", " --no-polygons --json"),
        command.replace("atlas", "scan"),
        format!("{command} --window 0:1,0:1"),
    ] {
        let refused = mutated(|d| d.head.command.clone_from(&other));
        assert_eq!(refused, Err(Refused::Field { field: "command" }), "{other}");
    }
    for version in ["", "1", "1.2", "1.2.x", "1.2.3.4", "v1.2.3", "1.2.3 4"] {
        let refused = mutated(|d| version.clone_into(&mut d.head.version));
        assert_eq!(refused, Err(Refused::Field { field: "version" }), "{version}");
    }
    assert_eq!(mutated(|d| "1.2.3-beta.1".clone_into(&mut d.head.version)), Ok(()));
}

/// What is told of a part, forged together with the command that names it.
#[test]
fn a_part_is_that_of_its_body() {
    let true_one = of_tilted_part();
    assert!(true_one.body.part.as_ref().is_some_and(|part| !part.exact && part.physical));
    let refused = |change: &dyn Fn(&mut schema::PartDocument)| {
        let mut forged = true_one.clone();
        let part = forged.body.part.as_mut().unwrap();
        let texts = |part: &schema::PartDocument| {
            let [[xx, xy, _], ..] = &part.inertia;
            let [x, y, z] = &part.com;
            [
                format!("{xx},"),
                format!(",{xy},"),
                format!("{x},{y},{z}"),
                part.mass.clone(),
                part.g.clone(),
                part.units.clone(),
            ]
        };
        let before = texts(part);
        change(part);
        for (old, new) in before.iter().zip(texts(part)).filter(|(old, new)| *old != new) {
            forged.head.command = forged.head.command.replacen(old, &new, 1);
        }
        if !part.physical {
            forged.head.command = forged.head.command.replace(" --certificate", " --unphysical --certificate");
        }
        seal(&mut forged).unwrap();
        match verify(&forged) {
            Err(Refused::Field { field }) => field,
            other => panic!("{other:?}"),
        }
    };
    let numbers = "body.part: inertia, com, mass, g, units or exact";
    assert_eq!(refused(&|part| part.mass = "2.6".to_owned()), numbers);
    assert_eq!(refused(&|part| part.g = "9.8".to_owned()), numbers);
    assert_eq!(refused(&|part| part.com[1] = "0.021".to_owned()), numbers);
    assert_eq!(refused(&|part| part.units = "kg,mm,s".to_owned()), numbers);
    assert_eq!(refused(&|part| part.units = "kg,fathom,s".to_owned()), "body.part.units");
    assert_eq!(refused(&|part| part.exact = true), numbers);
    assert_eq!(refused(&|part| part.physical = false), "body.part.physical");
    assert_eq!(refused(&|part| part.inertia[0][0].push('1')), numbers);
    assert_eq!(refused(&|part| part.principal.axes[1][2] += 1e-9), "body.part.principal");
    assert_eq!(refused(&|part| part.principal_com.moments[0] *= 1.0 + 1e-9), "body.part.principal_com");
    assert_eq!(refused(&|part| part.moments.swap(0, 1)), "body.part: A or r");
}

/// Two points of every polyline, a corner of every outline, every end of a window and every width, a little aside; a region
/// without its outline or of no end.
#[test]
fn pictures_that_are_a_little_wrong_are_refused() {
    for name in ["paper", "kovalevskaya"] {
        let atlas = CertifiedAtlas::new(&preset(name)).unwrap();
        let true_one = certified_atlas(&atlas, &atlas.drawn().unwrap(), &DocumentOptions::default()).unwrap();
        let refused = |field, change: &dyn Fn(&mut AtlasDocument)| {
            let mut forged = true_one.clone();
            change(&mut forged);
            seal(&mut forged).unwrap();
            assert_eq!(verify(&forged).unwrap_err(), Refused::Field { field }, "{name}");
        };
        for (curve, number) in true_one.curves.iter().zip(0..) {
            let last = curve.polyline.len() - 1;
            refused("curves.polyline", &|d| d.curves[number].polyline[last / 2][0] += 1e-6);
            refused("curves.polyline", &|d| d.curves[number].polyline[last][1] += 1e-6);
        }
        for (region, number) in true_one.regions.iter().zip(0..) {
            let outlines = region.polygon.as_ref().unwrap();
            let inside = |h: f64| true_one.view.everything.h.iter().all(|border| (h - border).abs() > 1e-3);
            let corner = outlines.iter().flatten().position(|corner| inside(corner[0])).unwrap();
            let mut forged = true_one.clone();
            forged.regions[number].polygon.iter_mut().flatten().flatten().nth(corner).unwrap()[0] += 1e-6;
            seal(&mut forged).unwrap();
            assert!(matches!(verify(&forged), Err(Refused::Region { .. })), "{name} {}", region.id);
            let mut forged = true_one.clone();
            forged.regions[number].polygon = Some(Vec::new());
            seal(&mut forged).unwrap();
            assert!(matches!(verify(&forged), Err(Refused::Region { .. })), "{name} {}: no outline", region.id);
            let others = match region.h_width {
                Some(width) => vec![Some(width * 1.000_01), Some(width * 0.999_99), None],
                None => vec![Some(1e6)],
            };
            for other in others {
                let mut forged = true_one.clone();
                forged.regions[number].h_width = other;
                seal(&mut forged).unwrap();
                assert!(matches!(verify(&forged), Err(Refused::Region { .. })), "{name} {}: {other:?}", region.id);
            }
        }
        for end in 0..2 {
            refused("view", &|d| d.view.everything.h[end] += 1e-3);
            refused("view", &|d| d.view.main.h[end] += 1e-3);
            refused("view", &|d| d.view.everything.l[end] += 1e-3);
            refused("view", &|d| d.view.main.l[end] += 1e-3);
        }
    }
}

/// Two pitchforks whose places are one double, on axes whose moments differ by 1e-18, and a width that lies inside a cell
/// above which another is higher at an end.
#[test]
fn what_doubles_take_for_one_is_told_apart() {
    for (a, r) in [
        (["0.8", "1", "0.999999999999999999"], ["1", "0", "0"]),
        (["0.8", "0.999999999999999999", "1"], ["-1", "0", "0"]),
        (["1", "0.8", "1.000000000000000001"], ["0", "1", "0"]),
        (["0.77", "1.05", "0.76"], ["0.4", "0.052", "-0.9"]),
        (["0.45", "0.91", "0.46"], ["-0.9625", "0.1094", "0.925"]),
    ] {
        let atlas = CertifiedAtlas::new(&Body::parse(&a, &r).unwrap()).unwrap();
        let document = certified_atlas(&atlas, &atlas.drawn().unwrap(), &DocumentOptions::default()).unwrap();
        assert!(verify(&document).is_ok(), "{a:?} {r:?}: {:?}", verify(&document));
    }
}

/// Widths of a body that are reached but exceeded elsewhere: those of unbounded regions at finite places.
#[test]
fn widths_that_are_exceeded_far_out_are_refused() {
    let body = Body::parse(&["1", "2", "3"], &["0.4", "0.5", "0.77"]).unwrap();
    let atlas = CertifiedAtlas::new(&body).unwrap();
    let true_one = certified_atlas(&atlas, &atlas.drawn().unwrap(), &DocumentOptions::default()).unwrap();
    verify(&true_one).unwrap();
    let mut forged_ones = 0;
    for (region, number) in true_one.regions.iter().zip(0..) {
        let (Some(width), [Some(from), None]) = (region.h_width, region.l_range) else { continue };
        let curve = |id: &String| true_one.curves.iter().find(|curve| curve.id == *id).unwrap();
        let height = |id: &String, l: f64| {
            let line = &curve(id).polyline;
            let after = line.iter().position(|point| point[1] >= l)?.max(1);
            let [p, q] = [line[after - 1], line[after]];
            Some(p[0] + (q[0] - p[0]) * (l - p[1]) / (q[1] - p[1]))
        };
        let cell = region.cells.last().unwrap();
        for l in [1.01, 1.5, 2.0, 3.0].map(|share| share * from.max(0.1)) {
            let gap = height(cell.upper.as_ref().unwrap(), l).zip(height(&cell.lower, l)).map(|(high, low)| high - low);
            if let Some(gap) = gap.filter(|gap| *gap < width * (1.0 - 1e-4)) {
                let mut forged = true_one.clone();
                forged.regions[number].h_width = Some(gap);
                seal(&mut forged).unwrap();
                assert!(matches!(verify(&forged), Err(Refused::Region { .. })), "{}: {gap} of {width}", region.id);
                forged_ones += 1;
            }
        }
    }
    assert!(forged_ones > 3, "{forged_ones}");
}

/// The first place of each field that has a value.
fn leaves(value: &Value, field: &str, pointer: &str, found: &mut BTreeMap<String, String>) {
    match value {
        Value::Object(entries) => {
            for (name, entry) in entries {
                let field = if field.is_empty() { name.clone() } else { format!("{field}.{name}") };
                leaves(entry, &field, &format!("{pointer}/{name}"), found);
            }
        }
        Value::Array(entries) => {
            for (number, entry) in entries.iter().enumerate() {
                leaves(entry, field, &format!("{pointer}/{number}"), found);
            }
        }
        _ => {
            found.entry(field.to_owned()).or_insert_with(|| pointer.to_owned());
        }
    }
}

/// Where the lists of each field stand that are not empty.
fn lists(value: &Value, field: &str, pointer: &str, found: &mut BTreeMap<String, Vec<String>>) {
    match value {
        Value::Object(entries) => {
            for (name, entry) in entries {
                lists(entry, &format!("{field}.{name}"), &format!("{pointer}/{name}"), found);
            }
        }
        Value::Array(entries) if !entries.is_empty() => {
            found.entry(field.to_owned()).or_default().push(pointer.to_owned());
            for (number, entry) in entries.iter().enumerate() {
                lists(entry, &format!("{field}[]"), &format!("{pointer}/{number}"), found);
            }
        }
        _ => {}
    }
}

/// A list with an entry left out, one told twice, two exchanged.
fn forged_lists(list: &[Value]) -> Vec<(&'static str, Vec<Value>)> {
    let at = list.len() / 2;
    let is_point = |entry: &Value| entry.as_array().is_some_and(|pair| pair.len() == 2 && pair[0].is_f64());
    let mut shorter = list.to_vec();
    if list.len() > 8 && list.iter().all(is_point) {
        shorter = list.iter().step_by(4).chain(&list[list.len() - 1..]).cloned().collect();
        shorter.dedup();
    } else {
        shorter.remove(at);
    }
    let mut longer = list.to_vec();
    longer.insert(at, list[at].clone());
    let mut exchanged = list.to_vec();
    exchanged.swap(at, (at + 1) % list.len());
    let mut forged = vec![("left out", shorter), ("twice", longer), ("exchanged", exchanged)];
    forged.retain(|(_, forgery)| forgery != list);
    forged
}

/// Other values of the same type; what is none of a list of words is no document.
fn forgeries(value: &Value) -> Vec<Value> {
    match value {
        Value::Bool(b) => vec![Value::Bool(!b)],
        Value::Number(n) => {
            vec![n.as_i64().map_or_else(|| (n.as_f64().unwrap() * 1.001 + 1e-3).into(), |n| (n + 1).into())]
        }
        Value::String(text) => {
            let others =
                ["crossing", "cusp", "elliptic", "saddle", "fast", "generic", "pair", "zero", "real-collision"];
            let words = others.into_iter().filter(|word| word != text).map(Value::from);
            std::iter::once(Value::from(format!("{text}1"))).chain(words).collect()
        }
        Value::Null => vec![1.5.into(), "R1".into(), 1.into()],
        Value::Array(_) | Value::Object(_) => Vec::new(),
    }
}

#[test]
fn an_atlas_without_certificate_is_not_confirmed() {
    let mut atlas = document(&preset("paper"));
    atlas.certificate = None;
    assert_eq!(verify(&atlas), Err(Refused::NoCertificate));
    assert!(Refused::NoCertificate.to_string().contains("--certificate"));
}

#[test]
fn a_certificate_is_exact() {
    assert_eq!(mutated(|d| d.accuracy = Accuracy::Fast), Err(Refused::Accuracy));
}
