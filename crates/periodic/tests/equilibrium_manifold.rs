//! Manifolds of unstable equilibria, held against other ways to them.

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::section::{Monitor, PpTorus, SectionCondition};
use bifdiag_equilibria::critical::{Equilibrium, critical};
use bifdiag_periodic::chart::Surface;
use bifdiag_periodic::flow::Phase;
use bifdiag_periodic::manifold::{Curve, ManifoldError, ManifoldOptions, Manifolds, manifolds_of_equilibria, rest};
use bifdiag_periodic::reversor::reversors;
use bifdiag_periodic::section_map::SectionMap;
use bifdiag_schema::{ManifoldEnd, ManifoldKind};
use support::peers::Method;

struct Found {
    top: HeavyTop,
    surface: Surface,
    rest: State,
    manifolds: Manifolds,
}

/// The unstable equilibrium of the lowest energy, or, if none is unstable, the one of the highest.
fn chosen(body: &Body, l: &str) -> Equilibrium {
    let list = critical(body, &l.parse().unwrap()).unwrap().list;
    list.iter().find(|found| found.stability.is_unstable()).or(list.last()).unwrap().clone()
}

/// Of the unstable equilibrium of the lowest energy.
fn found(moments: [&str; 3], center: [&str; 3], l: &str, length: f64) -> Found {
    let body = Body::parse(&moments, &center).unwrap();
    let equilibrium = chosen(&body, l);
    let top = HeavyTop::new(&body);
    let surface = Surface::new(&top, equilibrium.h, equilibrium.l);
    let options = ManifoldOptions { length };
    let rest = rest(&equilibrium, &top);
    let manifolds = manifolds_of_equilibria(&body, &[equilibrium], &options, &Monitor::default()).unwrap();
    Found { top, surface, rest, manifolds }
}

const GENERIC: [[&str; 3]; 2] = [["2", "1.5", "1.2"], ["0.3", "0.5", "0.8"]];

impl Found {
    fn curves(&self, kind: ManifoldKind) -> &[Curve] {
        &self.manifolds.manifolds.iter().find(|manifold| manifold.kind == kind).unwrap().curves
    }

    /// How near the motion through a state comes to the equilibrium, by the method of Dormand and Prince.
    fn nearest(&self, state: &State, backward: bool, time: f64) -> f64 {
        let turned = |state: &State| State { l: state.l.map(|l| if backward { -l } else { l }), ..*state };
        let rest = self.surface.point(&self.rest);
        let method = Method::Dop853 { tolerance: 1e-14 };
        let mut state = turned(state);
        let mut nearest = f64::INFINITY;
        for _ in 0..400 {
            state = method.state_after(&self.top, &state, time / 400.0);
            nearest = nearest.min((self.surface.point(&turned(&state)) - rest).norm());
        }
        nearest
    }
}

/// Points of the unstable curves come from the equilibrium, and those of the stable ones go to it, as another integrator finds; all
/// lie in P, where ⟨γ,r⟩ is largest, at the energy of the equilibrium. For rates of both kinds.
#[test]
fn points_of_the_curves_come_from_the_equilibrium() {
    let [moments, center] = GENERIC;
    for l in ["0", "0.5", "1.5"] {
        let all = found(moments, center, l, 6.0);
        let mut tried = 0;
        for kind in [ManifoldKind::Unstable, ManifoldKind::Stable] {
            for piece in all.curves(kind).iter().flat_map(|curve| &curve.pieces) {
                for vertex in piece.iter().skip(1).step_by(25) {
                    let state = all.manifolds.state(vertex);
                    let height = SectionCondition::Height.value(&all.top, &state);
                    assert!(
                        height.abs() < 1e-13 && SectionCondition::Height.rate(&all.top, &state) <= 1e-9,
                        "{height:e}"
                    );
                    assert!((all.top.energy(&state) - all.top.energy(&all.rest)).abs() < 1e-13);
                    let nearest = all.nearest(&state, kind == ManifoldKind::Unstable, 40.0);
                    assert!(nearest < 1e-4, "{l} {kind:?} {nearest:e} {:?}", vertex.point);
                    tried += 1;
                }
            }
        }
        assert!(tried > 20, "{tried}");
    }
}

/// Beside an equilibrium of complex eigenvalues R multiplies the distance from it along the curve by e^(2π Re λ/Im λ), with λ as
/// `critical` prints it.
#[test]
fn the_return_stretches_the_curve_by_the_eigenvalue() {
    let [moments, center] = GENERIC;
    let body = Body::parse(&moments, &center).unwrap();
    let [re, im] = chosen(&body, "2").eigenvalues.pairs[0];
    let factor = libm::exp(std::f64::consts::TAU * re / im);
    let all = found(moments, center, "2", 2.0);
    let (torus, monitor) = (PpTorus::new(&all.top).unwrap(), Monitor::default());
    let map = SectionMap::new(&all.surface, &torus, 1e3, &monitor);
    let rest = all.surface.point(&all.rest);
    let away = |y: &Phase| (y - rest).norm();
    let mut tried = 0;
    for piece in all.curves(ManifoldKind::Unstable).iter().flat_map(|curve| &curve.pieces) {
        for y in piece.iter().map(|vertex| vertex.point).filter(|y| (5e-4..2e-3).contains(&away(y))) {
            let image = map.images(&[y], 1).unwrap()[0][0].point;
            assert!((away(&image) / away(&y) / factor - 1.0).abs() < 0.05, "{} {factor}", away(&image) / away(&y));
            tried += 1;
        }
    }
    assert!(tried >= 1, "{tried}");
}

/// Homoclinic orbits are followed both ways by the method of Dormand and Prince and come to the equilibrium.
#[test]
fn homoclinic_orbits_come_to_the_equilibrium_at_both_ends() {
    let mut told = 0;
    for ([moments, center], l) in [(GENERIC, "0"), (GENERIC, "0.5"), ([["2", "2", "1"], ["1", "0", "0"]], "0.5")] {
        let all = found(moments, center, l, 12.0);
        assert!(!all.manifolds.connections.is_empty(), "{l}");
        for connection in all.manifolds.connections.iter().take(6) {
            assert!(connection.residual <= 1e-10 && connection.angle >= 1e-4, "{connection:?}");
            for backward in [false, true] {
                let nearest = all.nearest(&connection.state, backward, 60.0);
                assert!(nearest < 1e-4, "{l} {backward} {nearest:e} {connection:?}");
            }
            told += 1;
        }
    }
    assert!(told > 4, "{told}");
}

/// The reflection in the body's plane of symmetry takes the unstable curves to the stable ones, point by point.
#[test]
fn a_mirror_takes_unstable_curves_to_stable_ones() {
    let all = found(["2", "1.1", "1"], ["0.94868", "0", "0.61623"], "1.5", 4.0);
    // It lies in P itself, on the line of tangency.
    let height = SectionCondition::Height;
    assert!(height.value(&all.top, &all.rest).abs().max(height.rate(&all.top, &all.rest).abs()) < 1e-15);
    let mirror = reversors(&all.top, 1.5)[0];
    let stable: Vec<Phase> =
        all.curves(ManifoldKind::Stable).iter().flat_map(|c| &c.pieces).flatten().map(|v| v.point).collect();
    let mut tried = 0;
    for vertex in all.curves(ManifoldKind::Unstable).iter().flat_map(|curve| &curve.pieces).flatten() {
        let image = all.surface.point(&mirror.apply(&all.manifolds.state(vertex)));
        let nearest = stable.iter().map(|y| (y - image).norm()).fold(f64::INFINITY, f64::min);
        // Neighbours are 0.02 apart at most; the curves were not cut alike.
        assert!(nearest < 0.021, "{nearest} {:?}", vertex.point);
        tried += 1;
    }
    assert!(tried > 100, "{tried}");
}

/// Lagrange's top: every motion that leaves the upright position comes back to it. The curves coincide, which is reported, and no
/// crossing is claimed.
#[test]
fn all_motions_of_lagranges_top_come_back() {
    for l in ["1", "0.3"] {
        let all = found(["3/2", "1", "1"], ["1", "0", "0"], l, 20.0);
        assert!(all.manifolds.connections.is_empty(), "{:?}", all.manifolds.connections);
        assert_eq!((all.manifolds.contacts.len(), all.manifolds.unresolved), (1, 0));
        assert!(all.manifolds.contacts[0].places > 20);
        for curve in [ManifoldKind::Unstable, ManifoldKind::Stable].into_iter().flat_map(|kind| all.curves(kind)) {
            assert_eq!((curve.end, curve.gaps, curve.pieces.len()), (Some(ManifoldEnd::Orbit), 0, 1));
            let heights = curve.pieces[0].iter().map(|vertex| vertex.point[0]);
            let [low, high] = heights.fold([1.0, -1.0], |[a, b]: [f64; 2], x| [a.min(x), b.max(x)]);
            assert!(high - low < 1e-11, "{low} {high}");
        }
    }
}

/// Kovalevskaya's top with one real and one imaginary pair: both motions that leave come back, as the other kind says, too.
#[test]
fn motions_of_kovalevskayas_top_come_back() {
    let all = found(["2", "2", "1"], ["1", "0", "0"], "2.5", 1.0);
    let [contact] = all.manifolds.contacts[..] else { panic!("{:?}", all.manifolds.contacts) };
    assert_eq!((contact.from, contact.to, contact.places), (0, 0, 2));
    for curve in all.manifolds.manifolds.iter().flat_map(|manifold| &manifold.curves) {
        assert_eq!(curve.end, Some(ManifoldEnd::Orbit));
        assert!(curve.nearest.is_some_and(|nearest| nearest < 1e-10), "{curve:?}");
        let state = all.manifolds.state(&curve.pieces[curve.pieces.len() / 2][0]);
        for backward in [false, true] {
            assert!(all.nearest(&state, backward, 40.0) < 1e-4);
        }
    }
}

/// A body without symmetry whose manifolds part by some e^(−πω/λ) = 10⁻²⁰: that they agree to 10⁻¹⁰ is no homoclinic orbit.
#[test]
fn motions_that_part_by_little_are_not_called_homoclinic() {
    let body = Body::parse(&["1.33", "2.01", "1.53"], &["0.1", "0.2", "0.9"]).unwrap();
    let list = critical(&body, &"3.7".parse().unwrap()).unwrap().list;
    let saddle = list.into_iter().find(|found| found.curve.is_some_and(|curve| curve.to_string() == "G1.2")).unwrap();
    let found = manifolds_of_equilibria(&body, &[saddle], &ManifoldOptions::default(), &Monitor::default()).unwrap();
    assert!(found.connections.is_empty(), "{:?}", found.connections);
    assert!(!found.contacts.is_empty());
}

/// Another body with such an equilibrium is not integrable, and its motions do not come back.
#[test]
fn motions_of_another_body_are_not_homoclinic() {
    let body = Body::parse(&["2", "1.5", "1.2"], &["0.3", "0.5", "0.8"]).unwrap();
    let list = critical(&body, &"3".parse().unwrap()).unwrap().list;
    let saddle = list.into_iter().find(|found| found.index == 1).unwrap();
    let found = manifolds_of_equilibria(&body, &[saddle], &ManifoldOptions::default(), &Monitor::default()).unwrap();
    assert!(found.connections.is_empty());
    for curve in found.manifolds.iter().flat_map(|manifold| &manifold.curves) {
        assert!(curve.pieces.len() > 5, "{}", curve.pieces.len());
        assert!(curve.nearest.is_some_and(|nearest| nearest > 1e-6), "{:?}", curve.nearest);
    }
}

#[test]
fn stable_and_degenerate_equilibria_are_refused() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    let refused = |body: &Body, equilibrium: Equilibrium| {
        manifolds_of_equilibria(body, &[equilibrium], &ManifoldOptions::default(), &Monitor::default()).unwrap_err()
    };
    assert!(matches!(refused(&body, chosen(&body, "2")), ManifoldError::Type(_)));
    let lagrange = Body::parse(&["3/2", "1", "1"], &["1", "0", "0"]).unwrap();
    let circle = critical(&lagrange, &"4".parse().unwrap()).unwrap().list;
    for equilibrium in circle {
        assert!(matches!(refused(&lagrange, equilibrium), ManifoldError::Type(_) | ManifoldError::NotIsolated));
    }
}
