//! Single claims that are false are refused by the mathematics, each for its reason.

use bifdiag_documents::seal;
use bifdiag_schema::{
    Accuracy, AtlasDocument, CertifiedNode, DrawingDocument, EnclosureDocument, EventDocument, EventKind, Failing,
    MarginDocument, NonlinearVerdict, PlaceDocument, Reason, VerdictChangeDocument,
};
use bifdiag_verify::{Refused, Report, verify};
use dashu_ratio::RBig;

use crate::made::{body, document, exact, forged, of_tilted_part, preset, whole};

fn mutated(change: impl Fn(&mut AtlasDocument)) -> Result<Report, Refused> {
    forged(&document(&preset("paper")), change)
}

#[test]
fn a_flipped_byte_is_caught_by_the_checksum() {
    let mut document = document(&preset("paper"));
    document.regions[0].sample.h += 1e-9;
    assert_eq!(verify(&document), Err(Refused::Checksum));
}

#[test]
fn false_claims_are_refused_by_the_mathematics() {
    let certificate = |d: &mut AtlasDocument, change: &dyn Fn(&mut bifdiag_schema::CertificateDocument)| {
        change(d.certificate.as_mut().unwrap());
    };
    // Wrong genus.
    let refused = mutated(|d| {
        let components = d.regions[6].components.clone();
        d.regions[5].components = components;
        d.regions[5].signature = d.regions[6].signature.clone();
    });
    assert!(matches!(refused, Err(Refused::Topology { .. })), "{refused:?}");
    // A genus that its own U contradicts.
    let refused = mutated(|d| d.regions[5].components[0].genus = Some(7));
    assert!(matches!(refused, Err(Refused::Region { .. })), "{refused:?}");
    // A cell given to another region.
    let refused = mutated(|d| certificate(d, &|c| c.slabs[3].curves[2].region = "R1".to_owned()));
    assert!(matches!(refused, Err(Refused::Entry { what: "slab", .. })), "{refused:?}");
    // A missing root, and a missing cusp.
    let refused = mutated(|d| certificate(d, &|c| drop(c.meetings.pop())));
    assert!(matches!(refused, Err(Refused::Count { what: "meetings with pole lines", .. })), "{refused:?}");
    let refused = mutated(|d| certificate(d, &|c| drop(c.cusps.pop())));
    assert!(matches!(refused, Err(Refused::Count { what: "cusps", .. })), "{refused:?}");
    // An invented root.
    let refused = mutated(|d| {
        certificate(d, &|c| {
            let again = c.cusps[0].clone();
            c.cusps.push(again);
        });
    });
    assert!(matches!(refused, Err(Refused::Entry { why: "its range does not isolate it", .. })), "{refused:?}");
    // An isolating range that misses its root.
    let refused = mutated(|d| certificate(d, &|c| c.cusps[0].place.y[1] = c.cusps[0].place.y[0].clone()));
    assert!(matches!(refused, Err(Refused::Entry { why: "its range does not isolate it", .. })), "{refused:?}");
    // An enclosure that is too narrow.
    let refused = mutated(|d| certificate(d, &|c| c.events[0].x[1] = c.events[0].x[0].clone()));
    assert!(matches!(refused, Err(Refused::Entry { what: "event", .. })), "{refused:?}");
    // Curves in the wrong order.
    let refused = mutated(|d| certificate(d, &|c| c.slabs[2].curves.swap(1, 2)));
    assert!(matches!(refused, Err(Refused::Entry { what: "slab", .. })), "{refused:?}");
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
    assert!(matches!(refused, Err(Refused::Entry { why: "its range does not isolate it", .. })), "{refused:?}");
}

/// The box of a crossing with both its ends on one side of it: the gap of the curves has the right sign at one end alone.
/// Where Arnold's theorem fails: a verdict that is turned round, a point that is left out, invented, moved, or of another kind.
#[test]
fn false_verdicts_are_refused() {
    let points = |d: &mut AtlasDocument, change: &dyn Fn(&mut Vec<VerdictChangeDocument>)| {
        change(d.verdict_changes.as_mut().unwrap());
    };
    let refusal = Err(Refused::Field { field: "verdict_changes" });
    for body in [preset("paper"), body([["1.7", "2.9", "3.1"], ["0.3", "0", "0"]])] {
        let true_one = document(&body);
        assert_eq!(verify(&true_one).unwrap().unproved, Vec::<String>::new());
        let changes = true_one.verdict_changes.as_ref().unwrap();
        assert!(changes.len() >= 3 && changes.iter().all(|change| change.proved));
        for n in 0..changes.len() {
            type Forgery<'a> = &'a dyn Fn(&mut Vec<VerdictChangeDocument>);
            let forgeries: [Forgery<'_>; 7] = [
                &|list| {
                    list[n].verdict = match list[n].verdict {
                        NonlinearVerdict::Stable => NonlinearVerdict::Unstable,
                        _ => NonlinearVerdict::Stable,
                    };
                },
                &|list| drop(list.remove(n)),
                &|list| list.insert(n, list[n].clone()),
                &|list| list[n].l += 1e-11,
                &|list| list[n].h -= 1e-11,
                &|list| {
                    list[n].kind =
                        if list[n].kind == Failing::Determinant { Failing::Resonance13 } else { Failing::Determinant };
                },
                &|list| list[n].changes = !list[n].changes,
            ];
            for (number, forgery) in forgeries.into_iter().enumerate() {
                assert_eq!(forged(&true_one, |d| points(d, forgery)), refusal, "{number} of {n}");
            }
        }
        // Along a curve.
        let refused = forged(&true_one, |d| {
            let spans = d.curves.iter_mut().flat_map(|curve| &mut curve.stability);
            for span in spans.filter(|span| span.nonlinear.why == Reason::Arnold) {
                span.nonlinear.verdict = NonlinearVerdict::Unstable;
            }
        });
        assert_eq!(refused, Err(Refused::Field { field: "curves.stability.nonlinear" }));
    }
}

/// Every claim of special bodies, too, is confirmed.
#[test]
fn verdicts_of_special_bodies_are_confirmed() {
    for given in [
        [["1", "2", "3"], ["1", "1", "1"]],
        [["1.7", "2.9", "3.1"], ["0", "0", "1"]],
        [["1.7", "1.7", "3.1"], ["0.3", "0", "0.4"]],
        [["1.7", "3.1", "3.1"], ["0.3", "0", "0.4"]],
        [["1.7", "1.7", "3.1"], ["0.3", "0", "0"]],
        [["1.15", "2.29", "1.24"], ["0", "0.65", "0.12"]],
        [["0.80", "2.17", "2.47"], ["0.22", "0.74", "0.30"]],
        [["2", "2", "1"], ["1", "0", "0"]],
        [["2", "2", "1"], ["0.3", "0", "0.4"]],
        // A pair has its cusp at its pitchfork, on an axis and off it.
        [["1", "0.75", "1.75"], ["1", "0", "0"]],
        [["12", "15", "22"], ["3", "0", "14"]],
    ] {
        let document = document(&body(given));
        let changes = document.verdict_changes.as_ref().unwrap();
        assert!(!changes.is_empty() && changes.iter().all(|change| change.proved), "{given:?}");
        assert_eq!(verify(&document).unwrap().unproved, Vec::<String>::new(), "{given:?}");
    }
}

#[test]
fn a_crossing_beside_its_box_is_refused() {
    let true_one = document(&body([["1", "5/9", "0.5001"], ["1", "0", "0"]]));
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
        nodes[1 - kept] = CertifiedNode { x: Some(bifdiag_numbers::decimal::exact(&moved)), places: Some(places) };
        seal(&mut forged).unwrap();
        let refused = verify(&forged);
        assert!(matches!(refused, Err(Refused::Pair { .. })), "kept {kept}: {refused:?}");
    }
}

/// The place that holds two.
/// On the border of Katok's classes 6 and 7 the pair over axis 2 crosses the line of −r̂ where the pair over axis 3 leaves it.
#[test]
fn a_crossing_at_a_pitchfork_names_the_curve_that_crosses() {
    let true_one = document(&body([["18", "10", "9"], ["1", "0", "0"]]));
    verify(&true_one).unwrap();
    let is_there = |event: &EventDocument| event.kind == EventKind::Crossing && event.l == 6.0;
    let at = true_one.events.iter().position(is_there).unwrap();
    assert_eq!(true_one.events[at].curves, ["L-.1", "S2.2"]);
    for other in ["S3.1", "L-.2", "S2.1"] {
        let refused = forged(&true_one, |atlas| atlas.events[at].curves[1] = other.to_owned());
        assert!(matches!(refused, Err(Refused::Entry { .. })), "{other}: {refused:?}");
    }
}

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
            place.y = [low + &step, high + step].map(|y| bifdiag_numbers::decimal::exact(&y));
            seal(&mut forged).unwrap();
            let refused = verify(&forged);
            assert!(matches!(refused, Err(Refused::Place { .. })), "slab {slab}, curve {level}, {side}: {refused:?}");
        }
    }
}

/// What is written twice or under another name: a source of an event, a cusp, a stretch.
#[test]
fn nothing_is_counted_twice() {
    let certificate = |d: &mut AtlasDocument, change: &dyn Fn(&mut bifdiag_schema::CertificateDocument)| {
        change(d.certificate.as_mut().unwrap());
    };
    let renamed = mutated(|d| {
        certificate(d, &|c| {
            let source = c.events.iter_mut().flat_map(|event| &mut event.sources).find(|s| *s == "cusp:0").unwrap();
            *source = "cusp:00".to_owned();
        });
    });
    assert!(matches!(renamed, Err(Refused::Entry { what: "event", .. })), "{renamed:?}");
    let repeated = mutated(|d| {
        certificate(d, &|c| {
            let again = c.events[0].clone();
            c.events.push(again);
        });
    });
    assert!(matches!(repeated, Err(Refused::Entry { what: "event", .. })), "{repeated:?}");
    let repeated = mutated(|d| {
        certificate(d, &|c| {
            let again = c.pairs[0].clone();
            c.pairs.push(again);
        });
    });
    assert!(matches!(repeated, Err(Refused::Pair { .. })), "{repeated:?}");
}

/// The command of another body or with other options, and versions that are none.
#[test]
fn the_command_is_that_of_the_document() {
    let command = document(&preset("paper")).head.command;
    assert_eq!(command, "bifdiag atlas --A 2,1.1,1 --r 0.94868,0,0.61623 --certificate --no-drawing --json");
    for other in [
        command.replace("1.1", "1.2"),
        command.replace(" --certificate", ""),
        command.replace(" --no-drawing", ""),
        command.replace("--no-drawing", "--no-polygons"),
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
    assert!(mutated(|d| "1.2.3-beta.1".clone_into(&mut d.head.version)).is_ok());
}

/// What is claimed about a part, forged together with the command that names it.
#[test]
fn a_part_is_that_of_its_body() {
    let true_one = of_tilted_part();
    assert!(true_one.body.part.as_ref().is_some_and(|part| !part.exact && part.physical));
    let refused = |change: &dyn Fn(&mut bifdiag_schema::PartDocument)| {
        let mut forged = true_one.clone();
        let part = forged.body.part.as_mut().unwrap();
        let texts = |part: &bifdiag_schema::PartDocument| {
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

/// Regions thinner than doubles are apart, where energies are of order 10¹⁵, and regions of a generic body: a margin is the one
/// of the sample within its bound, and that is no larger than rounding.
#[test]
fn false_margins_of_samples_are_refused() {
    let refusal = |id: &str| Refused::Region { region: id.to_owned(), why: "the margin of its sample is another" };
    for body in [body([["1", "1.000000000000001", "1.7"], ["0.3", "0.2", "1e-8"]]), preset("paper")] {
        let document = document(&body);
        verify(&document).unwrap();
        for (k, region) in document.regions.iter().enumerate() {
            let margin = &region.sample.margin;
            let other = document.certificate.as_ref().unwrap().slabs.iter().flat_map(|slab| &slab.curves);
            let other = other.map(|height| &height.curve).find(|id| **id != margin.nearest).unwrap();
            let forge = |change: &dyn Fn(&mut MarginDocument)| {
                let refused = forged(&document, |d| change(&mut d.regions[k].sample.margin)).unwrap_err();
                assert_eq!(refused, refusal(&region.id), "{margin:?}");
            };
            let scale = 2.0 * margin.error_bound + margin.h;
            forge(&|m| m.h += scale);
            forge(&|m| m.h += 1e5 * scale);
            forge(&|m| m.h = -m.h);
            forge(&|m| m.error_bound = 0.0);
            forge(&|m| m.error_bound *= 0.25);
            forge(&|m| m.error_bound = 1e-3 + 16.0 * f64::EPSILON * region.sample.h.abs());
            forge(&|m| m.error_bound = f64::INFINITY);
            forge(&|m| m.nearest.clone_from(other));
        }
    }
}

/// The square of l is compared with that of the certificate: its sign is, too, wherever an l stands.
#[test]
fn a_negative_l_is_refused() {
    let true_one = whole(&preset("paper"));
    let refused = |what: &str, change: &dyn Fn(&mut AtlasDocument)| {
        assert!(forged(&true_one, change).is_err(), "{what}");
    };
    // At 0 the sign alone would change, which makes no other document.
    let is_positive = |l: [Option<f64>; 2]| l.iter().flatten().any(|l| *l > 0.0);
    for region in 0..true_one.regions.len() {
        refused("sample", &|d| d.regions[region].sample.l *= -1.0);
        if !is_positive(true_one.regions[region].l_range) {
            continue;
        }
        refused("range", &|d| d.regions[region].l_range = d.regions[region].l_range.map(|l| l.map(|l| -l)));
    }
    for event in 0..true_one.events.len() {
        refused("event", &|d| d.events[event].l *= -1.0);
    }
    for change in 0..true_one.stability_changes.len() {
        refused("change", &|d| d.stability_changes[change].l *= -1.0);
    }
    for curve in 0..true_one.curves.len() {
        if !is_positive(true_one.curves[curve].l_range) {
            continue;
        }
        refused("range of a curve", &|d| d.curves[curve].l_range = d.curves[curve].l_range.map(|l| l.map(|l| -l)));
        if true_one.curves[curve].stability.first().is_some_and(|span| span.l_from > 0.0) {
            refused("span", &|d| d.curves[curve].stability[0].l_from *= -1.0);
        }
    }
}

/// Proved bounds that say nothing, that are a little wider than those of the certificate, or begin below l = 0.
#[test]
fn a_wide_enclosure_of_an_event_is_refused() {
    let true_one = document(&preset("paper"));
    for number in 0..true_one.events.len() {
        let EventDocument { l, h, .. } = true_one.events[number];
        let refused = |change: &dyn Fn(&mut EnclosureDocument)| {
            let refused = forged(&true_one, |d| change(d.events[number].enclosure.as_mut().unwrap()));
            assert!(matches!(refused, Err(Refused::Entry { what: "event", .. })), "{number}: {refused:?}");
        };
        let text = |x: f64| bifdiag_numbers::decimal::exact(&RBig::try_from(x).unwrap());
        refused(&|e| e.l = [text(-l - 1.0), text(l + 1.0)]);
        refused(&|e| e.l[0] = "-1".to_owned());
        refused(&|e| e.l[0] = "0".to_owned());
        for aside in [1.0, 1e-12] {
            refused(&|e| e.l[1] = text(l * (1.0 + aside)));
            refused(&|e| e.h[0] = text(h - (h.abs() + 1.0) * aside));
            refused(&|e| e.h[1] = text(h + (h.abs() + 1.0) * aside));
        }
    }
}

/// Numbers in another form than that in which they are written.
#[test]
fn numbers_in_another_form_are_refused() {
    for unit in ["1e0", "-0.0", "10e-1", "2/2", "1.0"] {
        let refused = mutated(|d| unit.clone_into(&mut d.certificate.as_mut().unwrap().units.moment));
        assert_eq!(refused, Err(Refused::Number { text: unit.to_owned() }));
        let refused = mutated(|d| unit.clone_into(&mut d.certificate.as_mut().unwrap().units.energy));
        assert_eq!(refused, Err(Refused::Number { text: unit.to_owned() }));
    }
    let refused = mutated(|d| d.certificate.as_mut().unwrap().slabs[1].x.push_str("e0"));
    assert!(matches!(refused, Err(Refused::Number { .. })), "{refused:?}");
    for change in [
        |d: &mut AtlasDocument| d.curves.iter_mut().for_each(|c| c.l_range[0] = c.l_range[0].map(|l| -l)),
        |d: &mut AtlasDocument| d.regions[0].l_range[0] = Some(-0.0),
        |d: &mut AtlasDocument| d.regions[0].cells[0].l_range[0] = Some(-0.0),
    ] {
        let mut other = document(&preset("paper"));
        change(&mut other);
        seal(&mut other).unwrap();
        assert!(verify(&other).is_err());
    }
}

/// A change of a certificate.
type Change = fn(&mut bifdiag_schema::CertificateDocument);

/// Lists that no body has are refused by their length, without any work for their entries.
#[test]
fn lists_longer_than_the_body_allows_are_refused_by_their_length() {
    let many = |text: &'static str, refused: Result<Report, Refused>| match refused {
        Err(Refused::TooMany { what, .. }) => assert_eq!(what, text),
        other => panic!("{text}: {other:?}"),
    };
    let lists: [(&str, Change); 6] = [
        ("cusps", |c| c.cusps = vec![c.cusps[0].clone(); 1000]),
        ("meetings", |c| c.meetings = vec![c.meetings[0].clone(); 1000]),
        ("pairs", |c| c.pairs = vec![c.pairs[0].clone(); 1000]),
        ("stretches of a pair", |c| c.pairs[0].stretches = vec![c.pairs[0].stretches[0].clone(); 10_000]),
        ("events", |c| c.events = vec![c.events[0].clone(); 1000]),
        ("slabs", |c| c.slabs = vec![c.slabs[0].clone(); 1000]),
    ];
    for (what, change) in lists {
        many(what, mutated(|d| change(d.certificate.as_mut().unwrap())));
    }
}

/// What a refusal quotes cannot control a terminal, and is cut.
#[test]
fn refusals_quote_texts_without_control_and_cut_them() {
    let message = |text: &str| {
        let refused = mutated(|d| text.clone_into(&mut d.certificate.as_mut().unwrap().units.moment));
        refused.unwrap_err().to_string()
    };
    assert_eq!(message("\u{1b}[32m1\u{9b}\u{202e}"), r"`\u{1b}[32m1\u{9b}\u{202e}` is not a number, or out of range");
    assert!(message(&"7".repeat(3_000_000)).len() < 200);
}

/// Whatever a drawing shows, and without one, the mathematics is confirmed.
#[test]
fn the_drawing_is_no_part_of_the_proof() {
    let true_one = whole(&preset("paper"));
    let drawn = |change: &dyn Fn(&mut DrawingDocument)| {
        assert!(forged(&true_one, |d| change(d.drawing.as_mut().unwrap())).is_ok());
    };
    drawn(&|drawing| drawing.view.main.h[1] += 1.0);
    drawn(&|drawing| drawing.curves.clear());
    drawn(&|drawing| drawing.regions.values_mut().for_each(|region| region.h_width = Some(7.0)));
    drawn(&|drawing| drawing.regions.values_mut().for_each(|region| region.polygon.clear()));
    assert!(document(&preset("paper")).drawing.is_none());
    // The command tells whether there is one.
    assert_eq!(forged(&true_one, |d| d.drawing = None), Err(Refused::Field { field: "command" }));
}
