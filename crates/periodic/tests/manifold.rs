//! Manifolds of unstable orbits and the orbits that connect them, held against other ways to them.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::poincare::SectionSetting;
use bifdiag_dynamics::section::{Monitor, SectionCondition};
use bifdiag_periodic::chart::Surface;
use bifdiag_periodic::flow::Phase;
use bifdiag_periodic::list::{ListOptions, OrbitList, list};
use bifdiag_periodic::manifold::{Curve, ManifoldOptions, Manifolds, manifolds};
use bifdiag_periodic::reversor::reversors;
use bifdiag_periodic::section_map::SectionMap;
use bifdiag_schema::{ManifoldEnd, ManifoldKind};
use support::peers::Method;

struct Found {
    setting: SectionSetting,
    list: OrbitList,
    manifolds: Manifolds,
}

fn found(moments: [&str; 3], center: [&str; 3], [h, l]: [&str; 2], length: f64) -> Found {
    let body = Body::parse(&moments, &center).unwrap();
    let setting = SectionSetting::new(&body, &h.parse().unwrap(), &l.parse().unwrap()).unwrap();
    let monitor = Monitor::default();
    let list = list(&setting, &ListOptions::default(), &monitor).unwrap();
    let manifolds = manifolds(&setting, &list, &ManifoldOptions { length }, &monitor).unwrap();
    Found { setting, list, manifolds }
}

/// A symmetric pair of unstable orbits.
fn paper(length: f64) -> Found {
    found(["2", "1.1", "1"], ["0.94868", "0", "0.61623"], ["6.5", "3.25"], length)
}

impl Found {
    fn top(&self) -> &HeavyTop {
        self.setting.torus().top()
    }

    fn surface(&self) -> Surface {
        Surface::new(self.top(), self.setting.h(), self.setting.l())
    }

    fn curves(&self, orbit: usize, kind: ManifoldKind) -> &[Curve] {
        let own = self.manifolds.manifolds.iter().find(|manifold| manifold.orbit == orbit && manifold.kind == kind);
        &own.unwrap().curves
    }
}

/// Beside the orbit R multiplies the distance from it along the unstable curve by the multiplier.
#[test]
fn the_return_stretches_a_curve_by_the_multiplier() {
    let all = paper(1.0);
    let (surface, monitor) = (all.surface(), Monitor::default());
    let map = SectionMap::new(&surface, all.setting.torus(), all.list.longest, &monitor);
    let mut tried = 0;
    for manifold in all.manifolds.manifolds.iter().filter(|manifold| manifold.kind == ManifoldKind::Unstable) {
        let start = surface.point(&all.list.orbits[manifold.orbit].orbit.start);
        for curve in &manifold.curves {
            let away = |y: &Phase| (y - start).norm();
            let near = curve.pieces[0].iter().map(|vertex| vertex.point);
            for y in near.filter(|y| (2e-4..1e-3).contains(&away(y))).take(3) {
                let image = map.images(&[y], 1).unwrap()[0][0].point;
                assert!((away(&image) / away(&y) / manifold.multiplier.unwrap() - 1.0).abs() < 0.02, "{y} {image}");
                tried += 1;
            }
        }
    }
    assert!(tried >= 8, "{tried}");
}

/// A connection is followed both ways by the method of Dormand and Prince, which shares nothing with what found it: from crossing to
/// crossing it comes nearer to the orbits at its ends, at last by the multiplier, until what was rounded leads it away.
#[test]
fn connections_come_to_their_orbits_at_both_ends() {
    let all = paper(6.0);
    let (top, surface) = (*all.top(), all.surface());
    assert!(all.manifolds.connections.len() > 20, "{}", all.manifolds.connections.len());
    let is = |from: usize, to: usize| all.manifolds.connections.iter().find(move |c| (c.from, c.to) == (from, to));
    // To itself, and to the mirror image.
    for connection in [is(1, 1), is(1, 2), is(2, 1), is(2, 2)] {
        let connection = connection.unwrap();
        assert!(connection.residual <= 1e-10, "{connection:?}");
        for (end, backward) in [(connection.to, false), (connection.from, true)] {
            let orbit = &all.list.orbits[end].orbit;
            let turned = |state: &State| State { l: state.l.map(|l| if backward { -l } else { l }), ..*state };
            let method = Method::Dop853 { tolerance: 1e-14 };
            let crossings = method.crossings(&top, &turned(&connection.state), SectionCondition::Height, 60).found;
            let place = surface.point(&orbit.start);
            let away: Vec<f64> = crossings
                .iter()
                .filter(|crossing| SectionCondition::Height.rate(&top, &crossing.state) < 0.0)
                .map(|crossing| (surface.point(&turned(&crossing.state)) - place).norm())
                .collect();
            let least = away.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(least < 1e-4, "{away:?}");
            let is_linear = |pair: &&[f64]| (5e-4..2e-2).contains(&pair[0]) && pair[1] < pair[0];
            let rates: Vec<f64> = away.windows(2).filter(is_linear).map(|pair| pair[0] / pair[1]).collect();
            assert!(rates.len() >= 2, "{away:?}");
            let multiplier = orbit.multipliers[0][0];
            assert!(rates.iter().all(|rate| (rate / multiplier - 1.0).abs() < 0.1), "{rates:?} {multiplier}");
        }
    }
}

/// The reflection in the body's plane of symmetry takes each orbit to the other one and motions to motions run backwards: the
/// unstable curves of one are the images of the stable ones of the other, point by point.
#[test]
fn mirror_images_have_each_others_curves() {
    let all = paper(4.0);
    let mirror = reversors(all.top(), all.setting.l())[0];
    let surface = all.surface();
    for (one, other) in [(1, 2), (2, 1)] {
        for curve in all.curves(one, ManifoldKind::Stable) {
            let image: Vec<Phase> =
                curve.pieces[0].iter().map(|v| surface.point(&mirror.apply(&surface.state(&v.point)))).collect();
            let is_image = |other: &&Curve| {
                let own = &other.pieces[0];
                own.len() == image.len() && own.iter().zip(&image).all(|(v, y)| (v.point - y).norm() < 1e-6)
            };
            assert!(all.curves(other, ManifoldKind::Unstable).iter().find(is_image).is_some());
        }
    }
}

/// Kovalevskaya's top is integrable: stable and unstable curves are the same, and no crossing of them is claimed. Where a motion
/// touches P a curve is broken, and nowhere else.
#[test]
fn curves_of_an_integrable_body_coincide_and_do_not_cross() {
    let all = found(["2", "2", "1"], ["1", "0", "0"], ["1.5", "0.5"], 10.0);
    assert!(all.manifolds.connections.is_empty(), "{:?}", all.manifolds.connections);
    assert!(!all.manifolds.contacts.is_empty() && all.manifolds.left_out.is_empty());
    let mut touched = 0;
    for manifold in &all.manifolds.manifolds {
        for curve in &manifold.curves {
            // It ends at an orbit, long before the length that was asked for.
            assert_eq!(curve.end, Some(ManifoldEnd::Orbit), "{}", curve.length);
            assert_eq!((curve.gaps, curve.tangencies), (0, curve.pieces.len() - 1));
            touched += curve.tangencies;
            for pair in curve.pieces.iter().flat_map(|piece| piece.windows(2)) {
                assert!((pair[1].point - pair[0].point).norm() <= 0.02);
            }
        }
    }
    assert!(touched > 0);
}
