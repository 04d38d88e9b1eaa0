//! Families from equilibria: where they begin and end, how well their members close, what happens on the way.

use bifdiag_body::Body;
use bifdiag_dynamics::field::HeavyTop;
use bifdiag_dynamics::section::Monitor;
use bifdiag_equilibria::critical::{Equilibrium, critical};
use bifdiag_periodic::catalogue::Catalogue;
use bifdiag_periodic::family::{Family, FamilyOptions, Held, Stretch, families};
use bifdiag_periodic::orbit::{Fixed, PeriodicOrbit, correct};
use bifdiag_schema::{FamilyEnd, OrbitEventKind};

fn body(moments: [&str; 3], center: [&str; 3]) -> Body {
    Body::parse(&moments, &center).unwrap()
}

fn paper() -> Body {
    body(["2", "11/10", "1"], ["0.94868", "0", "0.61623"])
}

fn followed(body: &Body, equilibrium: &Equilibrium, members: usize, held: Held) -> Vec<Family> {
    let monitor = Monitor::default();
    let options = FamilyOptions { held, members, branches: false, monitor: &monitor };
    families(body, equilibrium, &options).unwrap()
}

/// The arithmetic–geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..14 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

#[test]
fn the_pendulum_of_a_plate_is_found_unasked_from_rest_to_its_separatrix() {
    let body = paper();
    let rest = &critical(&body, &"0".parse().unwrap()).unwrap().list[0];
    let found = followed(&body, rest, 400, Held::Momentum);
    assert_eq!(found.len(), 2);
    let (weight, inertia) = (-rest.h, body.moments_f64()[1]);
    let frequency = (weight / inertia).sqrt();
    let family = found.iter().find(|family| (family.frequency - frequency).abs() < 1e-12).unwrap();
    for orbit in &family.stretch.members {
        // h = −|r| cos φ at the turning point.
        let exact = std::f64::consts::TAU / frequency / agm(1.0, ((1.0 - orbit.h / weight) / 2.0).sqrt());
        let near = (1.0 - orbit.h / weight).max(1e-16);
        assert!((orbit.period / exact - 1.0).abs() < 1e-12 / near, "{orbit:?} {exact}");
        assert!(orbit.symmetric && orbit.residual <= 1e-13 && (orbit.product() - 1.0).abs() < 1e-10, "{orbit:?}");
        assert!(orbit.start.gamma[1].abs() < 1e-9 && orbit.start.l[0].abs() < 1e-9, "{orbit:?}");
    }
    assert_eq!(family.stretch.end.kind, FamilyEnd::Separatrix);
    let last = family.stretch.members.last().unwrap();
    assert!((last.h / weight - 1.0).abs() < 1e-5, "{last:?}");
}

/// Period to 2π/ω, residual, product of the multipliers: at every member, from every imaginary pair.
#[test]
fn families_begin_with_the_periods_of_small_oscillations_and_close() {
    let skew = body(["3", "2.2", "1.7"], ["0.3", "-0.5", "0.8"]);
    let mut count = 0;
    for body in [paper(), skew] {
        for l in ["0.7", "2.5"] {
            for equilibrium in &critical(&body, &l.parse().unwrap()).unwrap().list {
                for family in followed(&body, equilibrium, 60, Held::Momentum) {
                    let members = &family.stretch.members;
                    assert!(members.len() > 10, "{:?} {}", family.stretch.end, family.frequency);
                    let limit = std::f64::consts::TAU / family.frequency;
                    // T = T₀ + c(h − h₀) + …
                    let [p, q] = [&members[0], &members[1]];
                    let slope = (q.period - p.period) / (q.h - p.h);
                    let extrapolated = p.period - slope * (p.h - equilibrium.h);
                    assert!((extrapolated / limit - 1.0).abs() < 1e-7, "{extrapolated} {limit} {p:?}");
                    for orbit in members {
                        count += 1;
                        assert!(orbit.residual <= 1e-13, "{orbit:?}");
                        assert!((orbit.product() - 1.0).abs() < 1e-10, "{orbit:?}");
                        assert!((orbit.l - equilibrium.l).abs() < 1e-12, "{orbit:?}");
                    }
                }
            }
        }
    }
    assert!(count > 500, "{count}");
}

#[test]
fn families_at_one_energy_keep_it() {
    let body = paper();
    let equilibrium = &critical(&body, &"2.5".parse().unwrap()).unwrap().list[0];
    for family in followed(&body, equilibrium, 60, Held::Energy) {
        let members = &family.stretch.members;
        assert!(members.len() > 10, "{:?}", family.stretch.end);
        assert!(members.iter().all(|orbit| (orbit.h - equilibrium.h).abs() < 1e-12 && orbit.residual <= 1e-13));
    }
}

/// Without the symmetry of a mirror no orbit is symmetric where l ≠ 0.
#[test]
fn orbits_of_a_body_without_mirror_have_no_reversor() {
    let skew = body(["3", "2.2", "1.7"], ["0.3", "-0.5", "0.8"]);
    let equilibrium = &critical(&skew, &"0.7".parse().unwrap()).unwrap().list[0];
    for family in followed(&skew, equilibrium, 10, Held::Momentum) {
        assert!(family.stretch.members.iter().all(|orbit| !orbit.symmetric));
    }
    let equilibrium = &critical(&paper(), &"0.7".parse().unwrap()).unwrap().list[0];
    for family in followed(&paper(), equilibrium, 10, Held::Momentum) {
        assert!(family.stretch.members.iter().all(|orbit| orbit.symmetric));
    }
}

/// Around the axis of Lagrange's top that stands or hangs, periodic orbits of γ and l are regular precessions: with c = γ₃ and
/// n = l₃ constant and l across the axis κ times γ across it, κ²c/A₁ − κn/A₁ + … vanishes and γ turns at the rate n/A₃ − κc/A₁.
#[test]
fn lagrange_precesses_regularly_in_the_families_of_its_axis() {
    let body = body(["2", "2", "1"], ["0", "0", "1"]);
    let mut count = 0;
    for equilibrium in &critical(&body, &"3.5".parse().unwrap()).unwrap().list {
        if equilibrium.gamma[2].abs() < 0.999 {
            continue;
        }
        for family in followed(&body, equilibrium, 40, Held::Momentum) {
            for orbit in &family.stretch.members {
                let (g, l) = (orbit.start.gamma, orbit.start.l);
                let across = g[0] * g[0] + g[1] * g[1];
                let kappa = (g[0] * l[0] + g[1] * l[1]) / across;
                let (c, n) = (g[2], l[2]);
                assert!((g[0] * l[1] - g[1] * l[0]).abs() < 1e-10, "{orbit:?}");
                // A₁Ω²c − nΩ − r₃ = 0 with Ω = κ/A₁, γ pointing down.
                let omega = kappa / 2.0;
                let rest = 2.0 * omega * omega * c - n * omega - 1.0;
                assert!(rest.abs() < 1e-8 / across.sqrt(), "{rest:e} {orbit:?}");
                let rate = (n - kappa * c / 2.0).abs();
                assert!((orbit.period * rate / std::f64::consts::TAU - 1.0).abs() < 1e-9 / across.sqrt(), "{orbit:?}");
                assert_eq!(orbit.crossings, 0);
                count += 1;
            }
        }
    }
    assert!(count > 50, "{count}");
}

/// A family that comes to orbits of half its period ends there, and does not run through its own orbits a second time.
#[test]
fn a_family_ends_where_its_orbits_are_run_through_twice() {
    let body = paper();
    let list = critical(&body, &"2.5".parse().unwrap()).unwrap().list;
    let found = followed(&body, list.last().unwrap(), 300, Held::Momentum);
    let slow = found.iter().find(|family| family.frequency < 1.0).unwrap();
    assert_eq!(slow.stretch.end.kind, FamilyEnd::Joined, "{:?}", slow.stretch.end);
    // There its trace is 2: that of a doubling, squared, less 2. And an orbit of half the period is there.
    let last = slow.stretch.members.last().unwrap();
    assert!((last.trace - 2.0).abs() < 1e-3, "{last:?}");
    let top = HeavyTop::new(&body);
    let (start, period) = correct(&top, &last.start, 0.5 * last.period, Fixed::Both).unwrap();
    let half = PeriodicOrbit::new(&top, &start, period).unwrap();
    assert!((half.trace + 2.0).abs() < 1e-2 && half.residual <= 1e-13, "{half:?}");
}

/// Folds, doublings and crossings are where they are said to be: the trace there is 2 or −2, and l is kept.
#[test]
fn special_orbits_have_the_traces_of_their_kind() {
    let body = paper();
    let mut kinds = Vec::new();
    for l in ["0", "0.7", "1.5", "2.5"] {
        for equilibrium in &critical(&body, &l.parse().unwrap()).unwrap().list {
            for family in followed(&body, equilibrium, 150, Held::Momentum) {
                for event in &family.stretch.events {
                    let trace = match event.kind {
                        OrbitEventKind::Fold | OrbitEventKind::Branch => 2.0,
                        OrbitEventKind::Doubling => -2.0,
                        OrbitEventKind::Tripling => -1.0,
                    };
                    assert!((event.orbit.trace - trace).abs() < 1e-5, "{event:?}");
                    // Where families cross an orbit is known to the square root of its defect.
                    let bound = if event.kind == OrbitEventKind::Branch { 4e-7 } else { 1e-8 };
                    assert!(event.error <= bound && event.orbit.residual <= 1e-13, "{event:?}");
                    kinds.push(event.kind);
                }
            }
        }
    }
    for kind in [OrbitEventKind::Branch, OrbitEventKind::Doubling, OrbitEventKind::Tripling] {
        assert!(kinds.contains(&kind), "{kind:?} {kinds:?}");
    }
}

/// A family does not lose a symmetry but where another one crosses it.
#[test]
fn fast_orbits_stay_symmetric() {
    let body = body(["2", "1", "1"], ["0.3", "0.4", "0.3"]);
    for equilibrium in &critical(&body, &"1.9".parse().unwrap()).unwrap().list {
        for family in followed(&body, equilibrium, 200, Held::Momentum) {
            let members = &family.stretch.members;
            let Some(first) = members.first() else { continue };
            let other = members.iter().find(|orbit| orbit.symmetric != first.symmetric);
            assert!(other.is_none(), "{other:?}");
        }
    }
}

/// Beside an equilibrium with a fast unstable pair the period hardly grows while the orbit comes ever nearer.
#[test]
fn a_family_that_creeps_to_a_separatrix_ends_there() {
    let body = body(["3", "2", "1"], ["1", "0", "0"]);
    let rest = &critical(&body, &"0".parse().unwrap()).unwrap().list[0];
    for family in followed(&body, rest, 200, Held::Momentum) {
        assert_eq!(family.stretch.end.kind, FamilyEnd::Separatrix, "{:?}", family.stretch.members.last());
        assert_eq!(family.stretch.end.curves, ["L-.1"]);
        let last = family.stretch.members.last().unwrap();
        assert!((last.h - 1.0).abs() < 1e-4, "{last:?}");
    }
}

/// Where a family runs into a separatrix its trace may swing to and fro between −2 and 2 (or beyond) for ever: between two
/// members it never does so unseen.
#[test]
fn members_are_so_near_that_no_special_orbit_between_them_is_missed() {
    let body = paper();
    let mut most = 0.0_f64;
    for equilibrium in &critical(&body, &"4".parse().unwrap()).unwrap().list {
        for family in followed(&body, equilibrium, 120, Held::Momentum) {
            for pair in family.stretch.members.windows(2) {
                let [p, q] = [&pair[0], &pair[1]].map(|orbit| orbit.trace.clamp(-3.0, 3.0));
                most = most.max((p - q).abs());
            }
        }
    }
    assert!(most < 1.0, "{most}");
}

/// Where the trace falls from 1,000 to 2 within a hundredth, a fold, two triplings and a crossing lie close together. The fold's h
/// is that of a continuation by another program (DOP853 and the monodromy, closed to 10⁻¹³).
#[test]
fn a_fold_between_steep_traces_is_no_crossing() {
    let body = body(["1", "2", "3"], ["1", "0", "0"]);
    let hanging = &critical(&body, &"0.5".parse().unwrap()).unwrap().list[0];
    let family = followed(&body, hanging, 400, Held::Momentum).remove(1);
    let events = family.stretch.events.iter().filter(|event| (26.1..26.3).contains(&event.orbit.period));
    let told: Vec<_> = events.map(|event| (event.kind, event.orbit.h)).collect();
    let kinds: Vec<OrbitEventKind> = told.iter().map(|(kind, _)| *kind).collect();
    let (fold, tripling, branch) = (OrbitEventKind::Fold, OrbitEventKind::Tripling, OrbitEventKind::Branch);
    assert_eq!(kinds, [fold, tripling, tripling, branch], "{told:?}");
    assert!((told[0].1 - 0.737_621_089).abs() < 1e-8, "{told:?}");
}

/// The two equilibria of S1.1 are mirror images of each other, and so are their families, which come near to others on their way:
/// none changes over to one of these, or runs back through its own orbits.
#[test]
fn families_of_mirror_images_are_mirror_images() {
    // The second body only as far as T = 34, where three families come nearer to each other than the steps resolve.
    for (moments, center, [h, l], longest) in [
        (["5", "4", "3"], ["0", "0", "1"], [1.0, 3.7031], f64::INFINITY),
        (["3", "2", "2.5"], ["0", "1", "0.2"], [1.5, 3.3493], 34.0),
    ] {
        let body = body(moments, center);
        let catalogue = Catalogue::new(&body).unwrap();
        let starts = catalogue.starts(Held::Energy, &format!("{h:?}").parse().unwrap(), None).unwrap();
        let pair: Vec<_> = starts.iter().filter(|start| (start.l - l).abs() < 1e-3).collect();
        let [one, other] = [pair[0], pair[1]].map(|start| followed(&body, start, 200, Held::Energy).remove(1).stretch);
        let kinds = |stretch: &Stretch| -> Vec<(OrbitEventKind, f64)> {
            let before = stretch.events.iter().take_while(|event| event.orbit.period < longest);
            before.map(|event| (event.kind, event.orbit.l)).collect()
        };
        let [one, other] = [&one, &other].map(kinds);
        assert!(!one.is_empty() && one.len() == other.len(), "{one:?}\n{other:?}");
        for ((kind, l), (other_kind, other_l)) in one.iter().zip(&other) {
            assert!(kind == other_kind && (l - other_l).abs() < 1e-6, "{one:?}\n{other:?}");
        }
    }
}

/// Of Lagrange's top that hangs the slow family comes to the circle of minima, whose precession does not turn in the body: no
/// separatrix. h over 1/T goes to that of the circle.
#[test]
fn precessions_end_along_the_circle_that_does_not_turn() {
    let body = body(["2", "2", "1"], ["0", "0", "1"]);
    let list = critical(&body, &"1.5".parse().unwrap()).unwrap().list;
    let (circle, axis) = (&list[0], &list[1]);
    let found = followed(&body, axis, 1500, Held::Momentum);
    let family = found.iter().find(|family| family.frequency < 1.0).unwrap();
    assert_eq!(family.stretch.end.kind, FamilyEnd::Circle);
    assert_eq!(family.stretch.end.curves, ["S12.1"]);
    let members = &family.stretch.members;
    let [p, q] = [&members[members.len() - 200], &members[members.len() - 1]];
    // h is h₀ + c/T² there: the circle has the least of all precessions.
    let [a, b] = [p, q].map(|orbit| 1.0 / (orbit.period * orbit.period));
    let limit = q.h - b * (p.h - q.h) / (a - b);
    assert!(q.h - circle.h > 1e-3 && (limit - circle.h).abs() < 1e-4, "{limit} {}", circle.h);
}

/// At a tripling a family of three times the period passes: both ways are followed. Its orbits close after three turns, and
/// their trace tends to 2 there.
#[test]
fn the_family_that_passes_a_tripling_is_followed_both_ways() {
    let body = paper();
    let monitor = Monitor::default();
    let options = FamilyOptions { held: Held::Momentum, members: 40, branches: true, monitor: &monitor };
    let l = "1.5".parse().unwrap();
    let mut seen = 0;
    for equilibrium in &critical(&body, &l).unwrap().list {
        for family in families(&body, equilibrium, &options).unwrap() {
            for event in family.stretch.events.iter().filter(|event| event.kind == OrbitEventKind::Tripling) {
                assert_eq!(event.branches.len(), 2, "{event:?}");
                let firsts = [0, 1].map(|k| &event.branches[k].members[0]);
                let [below, above] = firsts;
                // At the same distance from the special orbit they differ.
                let apart = (below.h - above.h).abs() + (below.trace - above.trace).abs();
                assert!(apart > 1e-7, "{below:?} {above:?}");
                for first in firsts {
                    assert!((first.period / event.orbit.period - 3.0).abs() < 0.05, "{first:?}");
                    assert!(first.trace > 1.9 && first.residual <= 1e-13, "{first:?}");
                    assert_eq!(first.crossings, 3 * event.orbit.crossings);
                }
                seen += 1;
            }
        }
    }
    assert!(seen > 0);
}
