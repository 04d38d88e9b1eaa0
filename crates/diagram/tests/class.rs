//! Classes of diagrams: what they tell apart and what they do not see.

use std::collections::BTreeMap;

use bifdiag_body::{Body, Number, Preset};
use bifdiag_diagram::class::{Class, PlanarMap, Unclassified};
use dashu_ratio::RBig;
use support::bodies::{Stratum, random_body};
use support::random::SplitMix64;

fn class(body: &Body) -> Result<Class, Unclassified> {
    Class::of(&bifdiag_diagram::fast::atlas(body).unwrap())
}

/// A with other units and axes in another order, r likewise and with other signs.
fn disguised(body: &Body, order: [usize; 3], signs: [i32; 3], units: &[RBig; 2]) -> Body {
    let moments = order.map(|i| Number::from_rational(body.moments()[i].value() * &units[0]));
    let center =
        [0, 1, 2].map(|k| Number::from_rational(body.center()[order[k]].value() * RBig::from(signs[k]) * &units[1]));
    Body::new(moments, center).unwrap()
}

#[test]
fn axes_signs_and_units_do_not_matter() {
    let mut rng = SplitMix64::new(5);
    let (mut compared, mut open) = (0, 0);
    for round in 0..60 {
        for stratum in [
            Stratum::Generic,
            Stratum::Plane,
            Stratum::Axis,
            Stratum::NearAxis,
            Stratum::Symmetric,
            Stratum::Flat,
            Stratum::Lagrange,
            Stratum::Euler,
            Stratum::Isotropic,
        ] {
            let body = random_body(&mut rng, stratum);
            let Ok(expected) = class(&body) else {
                open += 1;
                continue;
            };
            let order = [[1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]][round % 5];
            let signs = [[1, -1, 1], [-1, -1, -1], [1, 1, -1]][round % 3];
            let units = [RBig::from_parts(3.into(), 7_u8.into()), RBig::from_parts(1000.into(), 11_u8.into())];
            match class(&disguised(&body, order, signs, &units)) {
                Ok(found) => assert_eq!(found, expected, "{body:?}"),
                Err(_) => open += 1,
            }
            compared += 1;
        }
    }
    assert!(compared > 500 && open < 10, "{compared} compared, {open} open");
}

#[test]
fn maps_are_planar_in_every_stratum() {
    let mut rng = SplitMix64::new(17);
    for stratum in [Stratum::Generic, Stratum::TinyR, Stratum::NearEqual, Stratum::NearAxis, Stratum::Plane] {
        for _ in 0..60 {
            let body = random_body(&mut rng, stratum);
            let Ok(atlas) = bifdiag_diagram::fast::atlas(&body) else { continue };
            match PlanarMap::of(&atlas) {
                Ok(map) => map.check().unwrap(),
                Err(Unclassified::Map(error)) => panic!("{body:?}: {error}"),
                Err(_open) => {}
            }
        }
    }
}

/// Katok's class by Example 15.2 of docs/algorithms.md, exactly but for a square root; `None` near a border.
fn katok_class([a2, a3]: [f64; 2]) -> Option<usize> {
    let near = |x: f64, y: f64| (x - y).abs() < 1e-3;
    if [a2, a3].iter().any(|a| near(*a, 1.0) || near(*a, 0.75)) || near(a2, a3) {
        return None;
    }
    let (a2, a3) = (a2.max(a3), a2.min(a3));
    let (k2, k3) = (1.0 - a2, 1.0 - a3);
    Some(match (a2, a3) {
        _ if a3 > 1.0 => 1,
        _ if a2 > 1.0 && a3 > 0.75 => 2,
        _ if a2 > 1.0 => 3,
        _ if a3 > 0.75 => 4,
        _ if a2 > 0.75 => 5,
        _ => {
            let excess = 4.0 * (1.0 / f64::sqrt(k2) - 1.0) - 1.0 / k3;
            if excess.abs() < 1e-2 {
                return None;
            }
            if excess > 0.0 { 6 } else { 7 }
        }
    })
}

#[test]
fn katoks_seven_classes_are_seven() {
    let mut rng = SplitMix64::new(3);
    let mut found: BTreeMap<usize, Class> = BTreeMap::new();
    let mut compared = 0;
    for _ in 0..1500 {
        let moments = [rng.between(0.2, 1.8), rng.between(0.2, 1.8)];
        let Some(number) = katok_class(moments) else { continue };
        let body = Body::from_f64([1.0, moments[0], moments[1]], [1.0, 0.0, 0.0]).unwrap();
        let class = class(&body).unwrap();
        let known = found.entry(number).or_insert_with(|| class.clone());
        assert_eq!(*known, class, "katok:{number} {moments:?}\n{}\n{}", known.text(), class.text());
        compared += 1;
    }
    assert_eq!(found.len(), 7);
    assert!(compared > 1400);
    let mut names: Vec<String> = found.values().map(|class| class.name().to_string()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), 7);
    for (number, expected) in &found {
        let preset = Preset::find(&format!("katok:{number}")).unwrap().body();
        assert_eq!(class(&preset).unwrap(), *expected, "katok:{number}");
    }
}

#[test]
fn an_undecided_diagram_has_no_class() {
    // A region between a cusp, a crossing and a pitchfork that are all but one: its type is not decided in f64.
    let body = Body::parse(&["1", "1.4", "0.74998"], &["1", "0", "0"]).unwrap();
    assert!(matches!(class(&body), Err(Unclassified::Region { .. } | Unclassified::Undecided { .. })));
}
