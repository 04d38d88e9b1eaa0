//! The curves against those of the closed form, and the roots against an oracle.

use super::*;
use crate::model::Model;
use bifdiag_body::{Body, Preset};
use bifdiag_equilibria::curves::{CriticalSet, End};
use dashu_ratio::RBig;

fn compare(body: &Body) {
    let frame = body.frame();
    let model = Model::new(body, &frame);
    let curves = Curves::new(&model, 80).unwrap();
    let set = CriticalSet::new(frame).unwrap();
    let mut names: Vec<_> = curves.list.iter().map(|c| format!("{:?} {} {:?}", c.branch, c.piece, c.orbit)).collect();
    let mut expected: Vec<_> = set.curves.iter().map(|c| format!("{:?} {} {:?}", c.branch, c.piece, c.orbit)).collect();
    names.sort();
    expected.sort();
    assert_eq!(names, expected);
    assert_eq!(curves.cusps.len(), set.cusps.len());
    assert_eq!(curves.pitchforks.len(), set.pitchforks.len());
    for curve in &curves.list {
        let other = set.curves.iter().find(|c| c.branch == curve.branch && c.piece == curve.piece).unwrap();
        let end = |end: End| match end {
            End::Origin => "o",
            End::Infinity => "i",
            End::Cusp(_) => "c",
            End::Pitchfork(_) => "p",
        };
        assert_eq!(curve.ends.map(end), other.ends.map(end), "{curve:?}");
    }
}

#[test]
fn the_curves_are_those_of_the_closed_form() {
    for preset in Preset::all() {
        compare(&preset.body());
    }
    for (a, r) in [
        (["2", "1.1", "1"], ["0.3", "0.5", "0.7"]),
        (["1", "2", "3"], ["0.5", "0", "0.5"]),
        (["1", "1", "3"], ["0.5", "0", "0.5"]),
        (["1", "1", "3"], ["0", "0", "0.5"]),
    ] {
        compare(&Body::parse(&a, &r).unwrap());
    }
}

#[derive(serde::Deserialize)]
struct Oracle {
    #[serde(rename = "A")]
    a: [String; 3],
    r: [String; 3],
    cusps: Vec<String>,
    poles: Vec<String>,
}

/// The roots that FLINT isolates (data/oracles/roots.py): as many, in the same places.
#[test]
fn roots_are_those_of_flint() {
    let value = |text: &str| text.parse::<bifdiag_body::Number>().unwrap().value().clone();
    let mut compared = 0;
    for line in support::data("oracles/roots.jsonl").lines() {
        let oracle: Oracle = serde_json::from_str(line).unwrap();
        let body = Body::parse(&oracle.a, &oracle.r).unwrap();
        let frame = body.frame();
        let model = Model::new(&body, &frame);
        let unit = RBig::try_from(frame.momentum_unit * frame.momentum_unit / frame.energy_unit).unwrap();
        let [_, pole] = model.pole_polynomials();
        for (polynomial, expected) in [(model.cusp_polynomial(), &oracle.cusps), (pole, &oracle.poles)] {
            let mut found: Vec<[RBig; 2]> = Vec::new();
            for number in 0..=model.active.len() {
                let roots = roots_in_interval(&model, &polynomial, number, 110).unwrap();
                found.extend(roots.into_iter().filter(|(_, odd)| *odd).map(|(place, _)| place.mu(&model)));
            }
            assert_eq!(found.len(), expected.len(), "{line}");
            for ([lo, hi], text) in found.into_iter().zip(expected) {
                let (at, slack) = (value(text), RBig::from_parts(1.into(), 10u8.into()).pow(25));
                let (lo, hi) = (lo * &unit, hi * &unit);
                assert!(&lo - &slack <= at && at <= &hi + &slack, "{text} {line}");
                compared += 1;
            }
        }
    }
    assert!(compared > 250, "{compared}");
}
