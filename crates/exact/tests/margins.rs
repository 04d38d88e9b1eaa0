//! Margins beside events: within their bounds, and at the exact level of the curve that is nearest.

use bifdiag_body::{Body, Number};
use bifdiag_diagram::arrangement::Change;
use bifdiag_diagram::topology::{Classification, Margin};
use bifdiag_exact::{Accuracy, CertifiedAtlas, Solver, classify, classify_exactly};
use dashu_ratio::RBig;
use proptest::prelude::*;
use support::property::{Verdict, holds_for_bodies};
use support::strata::Stratum;

fn body(a: [&str; 3], r: [&str; 3]) -> Body {
    Body::parse(&a, &r).unwrap()
}

fn margins(body: &Body, h: &Number, l: &Number, accuracy: Accuracy) -> [Margin; 2] {
    let cold = classify(body, h, l, accuracy).unwrap();
    let prepared = Solver::new(body.clone(), accuracy).classify(h, l).unwrap();
    [cold, prepared].map(|found: Classification| found.margin)
}

/// classify --A 1,1,1.324 --r 0,0,0.149 --l 0.8978599797350879 --h 0.45343826707056156 lies 1.5e-14 beyond the pitchfork of L-:
/// the line is h = l²/(2 · 1.324) + 0.149.
#[test]
fn beside_a_pitchfork_the_distance_is_that_at_l_and_the_curve_that_of_its_side() {
    let lagrange = body(["1", "1", "1.324"], ["0", "0", "0.149"]);
    let [h, l]: [Number; 2] = ["0.45343826707056156", "0.8978599797350879"].map(|text| text.parse().unwrap());
    let moment = RBig::from_parts(1324.into(), 1000u32.into());
    let line = l.value() * l.value() / (RBig::from(2) * moment) + RBig::from_parts(149.into(), 1000u32.into());
    let distance = (line - h.value()).to_f64().value();
    for accuracy in [Accuracy::Exact, Accuracy::Fast] {
        for margin in margins(&lagrange, &h, &l, accuracy) {
            assert!((margin.h - distance).abs() <= margin.error_bound + 1e-24, "{accuracy:?}: {margin:?}");
            assert!(margin.error_bound < 1e-14, "{accuracy:?}: {margin:?}");
            if accuracy == Accuracy::Exact {
                assert_eq!(margin.nearest.unwrap().to_string(), "L-.2");
            }
        }
    }
}

/// classify --A 26/21,2,25/19 --r=-1/4,-1,-7/2 --l 4.332241802377272677581976227
/// --h 2.4425067105195891828931702056880122552613084
#[test]
fn beside_a_cusp_the_distance_is_that_at_l() {
    let generic = body(["26/21", "2", "25/19"], ["-1/4", "-1", "-7/2"]);
    let texts = ["2.4425067105195891828931702056880122552613084", "4.332241802377272677581976227"];
    let [h, l]: [Number; 2] = texts.map(|text| text.parse().unwrap());
    for accuracy in [Accuracy::Exact, Accuracy::Fast] {
        for margin in margins(&generic, &h, &l, accuracy) {
            assert!((margin.h - 1.051_431_370_829_997_9e-7).abs() <= margin.error_bound, "{accuracy:?}: {margin:?}");
        }
    }
}

/// classify --A 1,2,3 --r 0,0,1 --l 0.5 between the lines h = 1/24 ∓ 1, a little off their middle.
#[test]
fn between_two_curves_the_nearer_one_is_named() {
    let on_axis = body(["1", "2", "3"], ["0", "0", "1"]);
    let l: Number = "0.5".parse().unwrap();
    let middle = RBig::from_parts(1.into(), 24u32.into());
    let small = |exponent: isize| RBig::ONE / RBig::from(10).pow(exponent);
    for exponent in [20, 17, 16] {
        for (h, nearest) in [(&middle + small(exponent), "L-.1"), (&middle - small(exponent), "L+.1")] {
            let h = Number::from_rational(h);
            for margin in margins(&on_axis, &h, &l, Accuracy::Exact) {
                assert_eq!(margin.nearest.unwrap().to_string(), nearest, "1e-{exponent}: {margin:?}");
                assert!((margin.h - 1.0).abs() <= margin.error_bound + 2.0 * f64::EPSILON, "{margin:?}");
            }
        }
    }
}

/// At every event of a body, at relative distances of 10⁻¹⁰ to 10⁻²⁰ from its l: near the event, and away from it.
fn margins_hold_beside_events(body: &Body) -> Verdict {
    let Ok(atlas) = bifdiag_diagram::fast::atlas(body) else { return Ok(()) };
    let levels = [Accuracy::Exact, Accuracy::Fast].map(|accuracy| Solver::new(body.clone(), accuracy));
    let small = |exponent: isize| RBig::ONE / RBig::from(10).pow(exponent);
    for (event, exponent) in atlas.arrangement().events.iter().take(6).zip([14, 20, 15, 16, 10, 18]) {
        let exact = |x: f64| RBig::try_from(x).unwrap();
        let [at, height] = [exact(atlas.momentum(event.x)), exact(atlas.energy(event.h))];
        let scale = exact(atlas.energy(event.x.abs() / atlas.arrangement().set.frame.a[2]));
        for (side, away) in [(1, small(9)), (-1, small(9)), (1, small(4)), (-1, RBig::from(-1) * small(6))] {
            let l = Number::from_rational(&at * (RBig::ONE + RBig::from(side) * small(exponent)));
            let h = Number::from_rational(&height + &scale * away);
            let truth = classify_exactly(body, &h, &l).unwrap().margin;
            for prepared in &levels {
                let margin = prepared.classify(&h, &l).unwrap().margin;
                let allowed = margin.error_bound + truth.error_bound + f64::EPSILON * truth.h;
                let (level, at) = (prepared.accuracy(), (&h, &l));
                prop_assert!((margin.h - truth.h).abs() <= allowed, "{level:?} {at:?}: {margin:?}, not {truth:?}");
                let named = level == Accuracy::Fast || margin.nearest == truth.nearest;
                prop_assert!(named, "{at:?}: {margin:?}, not {truth:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn margins_beside_events_hold_and_name_the_nearest_curve() {
    let strata = [
        Stratum::Generic,
        Stratum::Plane,
        Stratum::OnAxis,
        Stratum::Symmetric,
        Stratum::Lagrange,
        Stratum::NearAxis,
        Stratum::Plate,
    ];
    for stratum in strata {
        holds_for_bodies(stratum, 8, margins_hold_beside_events);
    }
}

/// The samples of a proved atlas, where they are written, but for those beside whose l, within rounding, a curve begins or ends.
fn margins_of_samples_hold(body: &Body) -> Verdict {
    let Ok(proved) = CertifiedAtlas::new(body) else { return Ok(()) };
    let Ok(drawn) = proved.to_atlas() else { return Ok(()) };
    for region in proved.region_ids() {
        let sample = drawn.sample(region);
        let is_near = |x: f64| (drawn.momentum(x) - sample.l).abs() <= 4.0 * f64::EPSILON * sample.l;
        let events = &drawn.arrangement().events;
        if events.iter().any(|event| !matches!(event.change, Change::Swap(_)) && is_near(event.x)) {
            continue;
        }
        let exact = |x: f64| Number::from_rational(RBig::try_from(x).unwrap());
        let decimal = |x: f64| x.to_string().parse::<Number>().unwrap();
        for [h, l] in [[exact(sample.h), exact(sample.l)], [decimal(sample.h), decimal(sample.l)]] {
            let Ok(truth) = classify_exactly(body, &h, &l) else { continue };
            let (truth, margin) = (truth.margin, &sample.margin);
            let off = (margin.h - truth.h).abs();
            prop_assert!(off <= margin.error_bound + truth.error_bound, "{region}: {margin:?}, not {truth:?}");
            let named = margin.nearest == truth.nearest || margin.h < 1e-9 * (truth.h + sample.h.abs());
            prop_assert!(named, "{region}: {margin:?}, not {truth:?}");
        }
    }
    Ok(())
}

#[test]
fn margins_of_samples_hold_where_they_are_written() {
    for stratum in [Stratum::Generic, Stratum::Plane, Stratum::Lagrange, Stratum::Symmetric, Stratum::NearAxis] {
        holds_for_bodies(stratum, 12, margins_of_samples_hold);
    }
}

/// atlas --A 1,1.000000000000001,1.7 --r 0.3,0.2,1e-8: five regions are thinner than doubles are apart.
#[test]
fn margins_of_samples_in_thin_regions_hold_where_they_are_written() {
    margins_of_samples_hold(&body(["1", "1.000000000000001", "1.7"], ["0.3", "0.2", "1e-8"])).unwrap();
}
