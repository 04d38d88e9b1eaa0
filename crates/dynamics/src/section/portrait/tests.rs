use std::f64::consts::PI;

use super::*;
use crate::field::{dot, norm};
use crate::section::SectionError;
use bifdiag_body::Body;

/// Nodes of a grid that the areas of a portrait take for something else than they are; those within a thousandth of
/// a line are left out.
fn misplaced(portrait: &Portrait, chart: SectionChart, rows: usize) -> Vec<([f64; 2], &'static str)> {
    let accessible = portrait.accessible(chart);
    let incoming = [portrait.incoming(chart, -1), portrait.incoming(chart, 1)];
    let kind = |point| portrait.rates(chart, point).map(|rates| rates.map(|rate| rate < 0.0));
    let mut wrong = Vec::new();
    for row in 0..rows {
        for column in 0..2 * rows {
            let [x, y] = [(column as f64 + 0.37) * PI / rows as f64, (row as f64 + 0.41) * PI / rows as f64];
            let here = kind([x, y]);
            let near = [[x - 1e-3, y], [x + 1e-3, y], [x, y - 1e-3], [x, y + 1e-3]];
            if near.into_iter().any(|place| kind(place) != here) {
                continue;
            }
            if accessible.contains([x, y]) != here.is_some() {
                wrong.push(([x, y], "accessible"));
            }
            for sheet in 0..2 {
                if incoming[sheet].contains([x, y]) != here.is_some_and(|rates| rates[sheet]) {
                    wrong.push(([x, y], ["incoming on T-", "incoming on T+"][sheet]));
                }
            }
        }
    }
    wrong
}

fn paper() -> Body {
    Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap()
}

/// Fig. BifGen: (h, l) and the number of circles of ∂U.
const NINE: [(f64, f64, usize); 9] = [
    (1.8, 3.25, 1),
    (2.6, 3.25, 1),
    (3.8, 3.25, 2),
    (4.45, 3.25, 2),
    (4.675, 3.25, 2),
    (5.3, 3.25, 1),
    (6.5, 3.25, 0),
    (3.1486, 2.72, 2),
    (14.0, 7.2, 2),
];

#[test]
fn the_papers_nine_regions_are_mapped_completely() {
    for (h, l, circles) in NINE {
        let portrait = Portrait::new(&paper(), h, l, &PortraitOptions::default()).unwrap();
        let report = portrait.report();
        assert_eq!(report.certified_circles, Some(circles), "({h}, {l})");
        assert_eq!((report.boundary_circles, report.open_lines), (circles, 0), "({h}, {l})");
        for chart in [SectionChart::Torus, SectionChart::Sphere] {
            let wrong = misplaced(&portrait, chart, 40);
            assert!(wrong.is_empty(), "({h}, {l}) {chart:?}: {} nodes, first {:?}", wrong.len(), wrong[0]);
        }
    }
}

#[test]
fn vertices_lie_on_their_curves() {
    let portrait = Portrait::new(&paper(), 4.675, 3.25, &PortraitOptions::default()).unwrap();
    let top = *portrait.torus().top();
    for line in portrait.boundary() {
        for &gamma in &line.points {
            assert!((norm(gamma) - 1.0).abs() < 1e-13);
            assert!((top.effective_potential(gamma, 3.25) - 4.675).abs() < 1e-12);
        }
    }
    for sheet in [-1, 1] {
        assert!(!portrait.tangency(sheet).is_empty());
        for line in portrait.tangency(sheet) {
            for &gamma in &line.points {
                // At ∂U, where lines end, rounding decides whether there is a state.
                let Some(rates) = portrait.rates(SectionChart::Torus, portrait.position(SectionChart::Torus, gamma))
                else {
                    assert!((top.effective_potential(gamma, 3.25) - 4.675).abs() < 1e-12);
                    continue;
                };
                // Ṡ varies like the root of the distance there.
                assert!(rates[usize::from(sheet > 0)].abs() < 1e-5, "{rates:?}");
            }
            for pair in line.points.windows(2) {
                assert!(dot(pair[0], pair[1]) > libm::cos(0.025));
            }
        }
    }
}

#[test]
fn symmetric_bodies_are_no_exception() {
    for (a, r, h, l) in [
        (["2", "2", "1"], ["1", "0", "0"], 3.4, 2.87),
        (["2", "1.5", "1"], ["1", "0", "0"], 80.5, 12.80),
        // Lagrange: the lines of tangency are circles of latitude.
        (["1", "1", "0.5"], ["0", "0", "1"], 1.2, 0.7),
        (["2", "1.1", "1"], ["0", "0", "-1"], 1.5, 1.7),
        (["2", "1.1", "1"], ["0", "1", "0"], 0.3, 0.0),
    ] {
        let body = Body::parse(&a, &r).unwrap();
        let portrait = Portrait::new(&body, h, l, &PortraitOptions::default()).unwrap();
        assert!(portrait.report().is_complete(), "{a:?} {r:?}: {:?}", portrait.report());
        for chart in [SectionChart::Torus, SectionChart::Sphere] {
            let wrong = misplaced(&portrait, chart, 30);
            assert!(wrong.is_empty(), "{a:?} {r:?} {chart:?}: {} nodes, first {:?}", wrong.len(), wrong[0]);
        }
    }
}

#[test]
fn the_other_condition_has_its_map_too() {
    let options = PortraitOptions { condition: SectionCondition::AngularMomentum, ..PortraitOptions::default() };
    for (h, l) in [(2.6, 3.25), (4.45, 3.25), (6.5, 3.25)] {
        let portrait = Portrait::new(&paper(), h, l, &options).unwrap();
        let wrong = misplaced(&portrait, SectionChart::Sphere, 40);
        assert!(wrong.is_empty(), "({h}, {l}): {} nodes, first {:?}; {:?}", wrong.len(), wrong[0], portrait.report());
    }
}

#[test]
fn forbidden_and_senseless_parameters_are_reported() {
    let error = Portrait::new(&paper(), 1.0, 3.25, &PortraitOptions::default()).unwrap_err();
    assert!(matches!(error, SectionError::Inaccessible { lowest, .. } if (1.639..1.66).contains(&lowest)), "{error}");
    let euler = Body::parse(&["2", "1.1", "1"], &["0", "0", "0"]).unwrap();
    let error = Portrait::new(&euler, 1.0, 1.0, &PortraitOptions::default()).unwrap_err();
    assert_eq!(error, SectionError::WeightlessBody);
    let error = Portrait::new(&paper(), f64::NAN, 1.0, &PortraitOptions::default()).unwrap_err();
    assert!(matches!(error, SectionError::Parameter { name: "h", .. }));
}

#[test]
fn random_bodies_are_mapped_completely() {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut drawn = 0;
    for case in 0..60 {
        let moments = [(); 3].map(|()| 0.4 + 1.6 * next());
        let center = [(); 3].map(|()| 2.0 * next() - 1.0);
        let (h, l) = (-0.5 + 4.0 * next(), 3.0 * next());
        let body = Body::from_f64(moments, center).unwrap();
        let portrait = match Portrait::new(&body, h, l, &PortraitOptions::default()) {
            Ok(portrait) => portrait,
            Err(SectionError::Inaccessible { .. }) => continue,
            Err(error) => panic!("{error}"),
        };
        drawn += 1;
        assert!(
            portrait.report().is_complete(),
            "case {case}: {moments:?} {center:?} ({h}, {l}): {:?}",
            portrait.report()
        );
        let wrong = misplaced(&portrait, SectionChart::Torus, 24);
        assert!(wrong.is_empty(), "case {case}: {moments:?} {center:?} ({h}, {l}): {wrong:?}");
    }
    assert!(drawn > 30, "{drawn}");
}
