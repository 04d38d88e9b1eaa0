//! Regions of exact points, however thin: the samples that a proof gives lie in the regions for which it gives them.

use std::cell::Cell;

use bifdiag_body::Body;
use bifdiag_diagram::arrangement::RegionId;
use bifdiag_exact::{Accuracy, CertifiedAtlas, Solver};
use bifdiag_numbers::Number;
use dashu_int::IBig;
use dashu_ratio::RBig;
use proptest::prelude::*;
use support::property::{Verdict, body_text, holds_for_bodies};
use support::strata::Stratum;

fn exact(text: &str) -> RBig {
    text.parse::<Number>().unwrap().value().clone()
}

/// √x to some 200 digits.
fn root(x: &RBig) -> RBig {
    let scale = RBig::from(IBig::from(10).pow(200));
    let mut root = RBig::try_from(x.to_f64().value().sqrt()).unwrap();
    for _ in 0..6 {
        root = (&root + x / &root) / RBig::from(2);
        root = RBig::from((&root * &scale).round()) / &scale;
    }
    root
}

/// The units of energy and of l² of a certificate.
fn units(proved: &CertifiedAtlas) -> [RBig; 2] {
    let units = proved.certificate().units;
    let (moment, energy) = (exact(&units.moment), exact(&units.energy));
    [energy.clone(), moment * energy]
}

/// (h, l) of a sample of each region.
fn samples(proved: &CertifiedAtlas) -> Vec<(RegionId, Number, Number)> {
    let certificate = proved.certificate();
    let [energy, square] = units(proved);
    let of_region = |sample: &bifdiag_schema::CertifiedSample| {
        let x = exact(&certificate.slabs[sample.slab].x);
        let l = root(&(x * RBig::from(2) * &square));
        (sample.region.parse().unwrap(), exact(&sample.h) * &energy, l)
    };
    let number = Number::from_rational;
    certificate.samples.iter().map(of_region).map(|(region, h, l)| (region, number(h), number(l))).collect()
}

/// The regions that meet at a point.
fn places(prepared: &Solver, h: &Number, l: &Number) -> Vec<Option<RegionId>> {
    let found = prepared.classify(h, l).unwrap();
    prepared
        .places(h, l, &found.answer)
        .unwrap_or_else(|why| panic!("{} {h:?} {l:?}: {why}", body_text(prepared.body())))
}

/// `beyond` counts those that `f64` does not tell.
fn samples_lie_in_their_regions(body: &Body, beyond: &Cell<u32>) -> Verdict {
    let Ok(proved) = CertifiedAtlas::new(body) else { return Ok(()) };
    let prepared = Solver::new(body.clone(), Accuracy::Exact);
    let Some(atlas) = prepared.atlas() else { return Ok(()) };
    for (region, h, l) in samples(&proved) {
        let found = prepared.classify(&h, &l).unwrap();
        beyond.set(beyond.get() + u32::from(atlas.places(&h, &l, &found.answer).is_none()));
        prop_assert_eq!(places(&prepared, &h, &l), [Some(region)], "at {:?}, {:?}", h, l);
    }
    Ok(())
}

#[test]
fn proved_samples_lie_in_their_regions() {
    let strata = [
        Stratum::NearAxis,
        Stratum::TinyR,
        Stratum::NearlyEqual,
        Stratum::NearLagrange,
        Stratum::Rod,
        Stratum::Generic,
    ];
    let beyond = Cell::new(0);
    for stratum in strata {
        holds_for_bodies(stratum, 10, |body| samples_lie_in_their_regions(body, &beyond));
    }
    assert!(beyond.get() > 0, "no region was thin");
}

/// classify --A 2,1.1,1 --r 1,1e-12,1e-13 --h 1.9814239699980405 --l 1.9813368920989085
#[test]
fn of_two_regions_of_one_class_within_rounding_the_right_one_is_named() {
    let body = Body::parse(&["2", "1.1", "1"], &["1", "1e-12", "1e-13"]).unwrap();
    let prepared = Solver::new(body, Accuracy::Exact);
    let [h, l]: [Number; 2] = ["1.9814239699980405", "1.9813368920989085"].map(|text| text.parse().unwrap());
    let found = prepared.classify(&h, &l).unwrap();
    assert_eq!(prepared.atlas().unwrap().places(&h, &l, &found.answer), None);
    assert_eq!(places(&prepared, &h, &l), ["R11".parse().ok()]);
}

/// r = (1 − ε², 2ε, 0) has |r| = 1 + ε²: the pole lines run through rational points.
#[test]
fn on_a_line_between_thin_regions_those_on_both_sides_meet_and_no_others() {
    for exponent in [3, 8, 12, 17] {
        let small = RBig::ONE / RBig::from(10).pow(exponent);
        let one = RBig::ONE;
        let r = [&one - &small * &small, &small * RBig::from(2), RBig::ZERO];
        let a = ["2", "1.1", "1"].map(exact);
        let weighted = &a[0] * &r[0] * &r[0] + &a[1] * &r[1] * &r[1];
        let norm = &one + &small * &small;
        let body = Body::new(a.map(Number::from_rational), r.map(Number::from_rational)).unwrap();
        let proved = CertifiedAtlas::new(&body).unwrap();
        let prepared = Solver::new(body, Accuracy::Exact);
        let [_, square] = units(&proved);
        for slab in &proved.certificate().slabs {
            let l = root(&(exact(&slab.x) * RBig::from(2) * &square));
            let kinetic = &l * &l * &norm * &norm / (RBig::from(2) * &weighted);
            for line in [&kinetic - &norm, &kinetic + &norm] {
                let at = |h: RBig| places(&prepared, &Number::from_rational(h), &Number::from_rational(l.clone()));
                let near = &small.pow(40);
                let beside = [at(&line - near), at(&line + near)].concat();
                assert_eq!(at(line), beside, "1e-{exponent} over x = {}", slab.x);
            }
        }
    }
}
