//! Verdicts along curves: the points at which the hypotheses of Arnold's theorem fail, against the equilibria beside them;
//! and how many relative equilibria of random bodies are left open.

use std::collections::BTreeMap;

use bifdiag_body::{Body, Preset};
use bifdiag_equilibria::critical::{Equilibrium, RelativeEquilibria};
use bifdiag_equilibria::curves::{CriticalSet, CurveName};
use bifdiag_equilibria::nonlinear::{Failing, NonlinearVerdict, Reason, VerdictChange, Verdicts};
use bifdiag_equilibria::stability::LinearType;
use bifdiag_numbers::Number;
use bifdiag_numbers::vector::{cross, dot};
use support::bodies::{Stratum, random_body};
use support::random::SplitMix64;

/// The point of a curve at l.
fn beside(equilibria: &RelativeEquilibria<'_>, curve: CurveName, l: f64) -> Option<Equilibrium> {
    let found = equilibria.at(&Number::from_f64(l).ok()?).ok()?.list;
    found.into_iter().find(|point| point.curve == Some(curve))
}

/// What passes through zero, or infinity, at such a point.
fn passing(point: &Equilibrium, kind: Failing) -> Option<f64> {
    let near = |n: usize| point.nonlinear.near.map(|near| near[n]);
    match kind {
        Failing::Resonance11 => near(0),
        Failing::Resonance12 => near(1),
        Failing::Resonance13 => near(2),
        Failing::Determinant => point.nonlinear.arnold.map(|found| found.value),
    }
}

/// On both sides of a change what fails there has different signs, or the spectrum leaves the axis.
fn is_confirmed(equilibria: &RelativeEquilibria<'_>, set: &CriticalSet, change: &VerdictChange) -> bool {
    let curve = CurveName::of(set, change.curve);
    let step = 1e-7 * change.l;
    let sides = [change.l - step, change.l + step].map(|l| beside(equilibria, curve, l));
    let [Some(before), Some(after)] = sides else { return false };
    if change.kind == Failing::Resonance11 {
        let verdicts = [before, after].map(|point| point.nonlinear.verdict);
        return verdicts.contains(&NonlinearVerdict::Stable)
            && verdicts.contains(&NonlinearVerdict::Unstable) == change.changes;
    }
    let signs = [passing(&before, change.kind), passing(&after, change.kind)];
    matches!(signs, [Some(p), Some(q)] if (p > 0.0) != (q > 0.0)) && !change.changes
}

#[test]
fn the_papers_body_has_these_changes() {
    let body = Preset::find("paper").unwrap().body();
    let set = CriticalSet::new(body.frame()).unwrap();
    let verdicts = Verdicts::new(&body, &set);
    assert!(verdicts.is_complete());
    let expected = [
        (
            1.947_890_543_818_278_5,
            2.619_765_065_855_363,
            Failing::Resonance11,
            NonlinearVerdict::Stable,
            Reason::Resonance11,
        ),
        (
            2.236_708_030_753_01,
            3.199_864_242_090_404,
            Failing::Resonance12,
            NonlinearVerdict::Unstable,
            Reason::Resonance12,
        ),
        (2.327_799_984_629_819, 3.401_836_073_571_975, Failing::Determinant, NonlinearVerdict::Stable, Reason::Arnold),
        (
            3.030_861_364_678_378_4,
            5.255_603_779_766_969,
            Failing::Resonance13,
            NonlinearVerdict::Stable,
            Reason::Resonance13,
        ),
    ];
    assert_eq!(verdicts.changes().len(), expected.len(), "{:?}", verdicts.changes());
    for (change, (l, h, kind, verdict, why)) in verdicts.changes().iter().zip(expected) {
        assert!((change.l - l).abs() < 1e-12 && (change.h - h).abs() < 1e-12, "{change:?}");
        assert_eq!((change.kind, change.verdict, change.why, change.proved), (kind, verdict, why, true));
        assert!(change.error_bound < 1e-12);
        assert_eq!(CurveName::of(&set, change.curve).to_string(), "G0.1");
    }
}

/// On an axis the cubic terms vanish: the determinant has no pole at ω₁ = 2ω₂, and its polynomial no zero there.
#[test]
fn an_axis_has_no_zero_of_the_determinant_at_its_resonance() {
    let body = Body::parse(&["1.7", "2.9", "3.1"], &["0.3", "0", "0"]).unwrap();
    let set = CriticalSet::new(body.frame()).unwrap();
    let verdicts = Verdicts::new(&body, &set);
    assert!(verdicts.is_complete());
    let kinds: Vec<Failing> = verdicts.changes().iter().map(|change| change.kind).collect();
    assert_eq!(kinds, [Failing::Resonance11, Failing::Resonance13, Failing::Resonance12]);
    let last = verdicts.changes()[2];
    assert_eq!((last.verdict, last.why, last.proved), (NonlinearVerdict::Stable, Reason::Arnold, true));
}

/// Beside special bodies, where the polynomial of the determinant has values of many sizes, no zero is left open.
#[test]
fn beside_special_bodies_every_zero_is_known() {
    let near = [
        (["1", "1.000001", "1.3"], ["0.3", "0.5", "0.7"]),
        (["1", "1.000000000001", "1.3"], ["0.3", "0.5", "0.7"]),
        (["2", "1.1", "1"], ["0.94868", "1e-9", "0.61623"]),
        (["1", "1.000000001", "0.7"], ["1e-9", "0", "1"]),
        // A zero, sharp in l and h, nearer to ω₁ = ω₂ than its range is wide, or so near that D₆ needs more of it.
        (["1", "1.000000000001", "0.7"], ["1e-12", "0", "1"]),
        (["1", "1.000000000000001", "0.7"], ["1e-15", "0", "1"]),
        (["1.3", "1", "0.7"], ["2e-12", "1", "1e-12"]),
        (["1e-12", "1", "1.0000000000005"], ["1", "0.3", "0.2"]),
        // ω₁ = 2ω₂ for l → ∞.
        (["2", "2", "1"], ["1", "0", "0"]),
        (["2", "2", "1"], ["0.3", "0", "0.4"]),
        // The pair over a passive moment has its cusp at its pitchfork, on an axis where 4a_i = 3a_k.
        (["1", "0.75", "1.75"], ["1", "0", "0"]),
        (["1", "0.75", "0.8"], ["1", "0", "0"]),
        (["1", "1", "0.75"], ["1", "0", "0"]),
        (["5", "3.75", "3"], ["4", "3", "0"]),
        (["12", "15", "22"], ["3", "0", "14"]),
    ];
    for (moments, center) in near {
        let body = Body::parse(&moments, &center).unwrap();
        let set = CriticalSet::new(body.frame()).unwrap();
        let verdicts = Verdicts::new(&body, &set);
        let is_known = |change: &VerdictChange| change.proved && change.verdict != NonlinearVerdict::Open;
        assert!(verdicts.is_complete() && verdicts.changes().iter().all(is_known), "{moments:?}");
    }
}

/// Every change lies between equilibria that differ in what fails; between the listed points nothing is left open.
#[test]
fn changes_lie_between_equilibria_that_differ() {
    let mut counts: BTreeMap<String, u32> = BTreeMap::new();
    for (stratum, number) in [Stratum::Generic, Stratum::Plane, Stratum::Axis, Stratum::Symmetric].into_iter().zip(39..)
    {
        let mut random = SplitMix64::new(number);
        for _ in 0..8 {
            let body = random_body(&mut random, stratum);
            let set = CriticalSet::new(body.frame()).unwrap();
            let verdicts = Verdicts::new(&body, &set);
            let equilibria = RelativeEquilibria::new(&body).unwrap();
            assert!(verdicts.is_complete(), "{body:?}");
            for change in verdicts.changes() {
                assert!(is_confirmed(&equilibria, &set, change), "{body:?} {change:?}");
                assert!(change.proved && change.error_bound < 1e-11 * (1.0 + change.l + change.h.abs()), "{change:?}");
                *counts.entry(format!("{}: {}", change.kind.word(), change.verdict.word())).or_insert(0) += 1;
            }
        }
    }
    println!("{counts:?}");
    assert!(counts.len() >= 4, "{counts:?}");
}

/// Nothing is left open at generic l. `OPEN_BODIES` sets how many bodies; 1,000 of them: see the printed counts.
#[test]
fn no_equilibrium_of_a_random_body_is_left_open() {
    let bodies: u32 = std::env::var("OPEN_BODIES").ok().and_then(|n| n.parse().ok()).unwrap_or(100);
    let mut random = SplitMix64::new(2039);
    let mut counts: BTreeMap<String, u32> = BTreeMap::new();
    for _ in 0..bodies {
        let body: Body = random_body(&mut random, Stratum::Generic);
        let equilibria = RelativeEquilibria::new(&body).unwrap();
        let unit = body.frame().momentum_unit;
        for k in 1..12 {
            let l = Number::from_f64(0.37 * f64::from(k) * unit).unwrap();
            for point in equilibria.at(&l).unwrap().list {
                let found = point.nonlinear;
                assert!(found.verdict != NonlinearVerdict::Open && found.proved, "{body:?} {l:?} {point:?}");
                *counts.entry(format!("{} ({})", found.verdict.word(), found.why.word())).or_insert(0) += 1;
            }
        }
    }
    println!("{counts:?}");
    assert!(counts.len() >= 3, "{counts:?}");
}

/// The Euler–Poisson equations for (γ, 𝐥).
fn velocity(a: [f64; 3], r: [f64; 3], y: [f64; 6]) -> [f64; 6] {
    let [gamma, l] = [[y[0], y[1], y[2]], [y[3], y[4], y[5]]];
    let omega: [f64; 3] = std::array::from_fn(|k| l[k] / a[k]);
    let (turn, drag, weight) = (cross(gamma, omega), cross(l, omega), cross(gamma, r));
    std::array::from_fn(|k| if k < 3 { turn[k] } else { drag[k - 3] - weight[k - 3] })
}

/// A step of the classical Runge–Kutta method.
fn step(a: [f64; 3], r: [f64; 3], y: [f64; 6], time: f64) -> [f64; 6] {
    let moved = |slope: [f64; 6], time: f64| std::array::from_fn(|k| y[k] + time * slope[k]);
    let first = velocity(a, r, y);
    let second = velocity(a, r, moved(first, 0.5 * time));
    let third = velocity(a, r, moved(second, 0.5 * time));
    let fourth = velocity(a, r, moved(third, time));
    std::array::from_fn(|k| y[k] + time / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]))
}

/// How far γ departs at most from a relative equilibrium in so many steps, after disturbances of this size at fixed l; the
/// search ends where it is as far as `enough`.
fn departure(body: &Body, point: &Equilibrium, size: f64, steps: u32, enough: f64) -> f64 {
    const TIME: f64 = 0.02;
    let (a, r) = (body.moments_f64(), body.center_f64());
    let mut farthest = 0.0_f64;
    for direction in 0..6 {
        let t = 0.7 * f64::from(direction);
        let tilt = [libm::cos(t), libm::sin(t), libm::cos(1.3 * t)];
        let gamma: [f64; 3] = std::array::from_fn(|k| point.gamma[k] + size * tilt[k]);
        let length = dot(gamma, gamma).sqrt();
        let gamma = gamma.map(|x| x / length);
        let mut l: [f64; 3] = std::array::from_fn(|k| {
            a[k] * point.omega * point.gamma[k] + size * libm::sin(1.7 * t + [0.0, 1.0, 2.0][k])
        });
        let excess = point.l - dot(gamma, l);
        l = std::array::from_fn(|k| l[k] + excess * gamma[k]);
        let mut y = [gamma[0], gamma[1], gamma[2], l[0], l[1], l[2]];
        for _ in 0..steps {
            y = step(a, r, y, TIME);
            let apart: [f64; 3] = std::array::from_fn(|k| y[k] - point.gamma[k]);
            farthest = farthest.max(dot(apart, apart).sqrt());
            if farthest >= enough {
                return farthest;
            }
        }
    }
    farthest
}

/// The change of a kind and verdict on a body, and the equilibrium there.
fn at_change(body: &Body, kind: Failing, verdict: NonlinearVerdict) -> Equilibrium {
    let set = CriticalSet::new(body.frame()).unwrap();
    let verdicts = Verdicts::new(body, &set);
    let change = verdicts.changes().iter().find(|change| (change.kind, change.verdict) == (kind, verdict)).unwrap();
    let equilibria = RelativeEquilibria::new(body).unwrap();
    beside(&equilibria, CurveName::of(&set, change.curve), change.l).unwrap()
}

/// At ω₁ = ω₂ motions from a disturbance ε reach the order √ε where that is stable, and the order 1 where it is not.
#[test]
fn motions_at_the_resonance_1_1_do_as_said() {
    let paper = Preset::find("paper").unwrap().body();
    let other = Body::parse(&["0.80", "2.17", "2.47"], &["0.22", "0.74", "0.30"]).unwrap();
    let stable = [(&paper, NonlinearVerdict::Stable), (&other, NonlinearVerdict::Stable)];
    for (body, verdict) in stable.into_iter().chain([(&other, NonlinearVerdict::Unstable)]) {
        let point = at_change(body, Failing::Resonance11, verdict);
        let [far, near] = [1e-4, 1e-5].map(|size| departure(body, &point, size, 150_000, 1.0));
        if verdict == NonlinearVerdict::Stable {
            assert!(far < 0.2 && (far / near - 10.0_f64.sqrt()).abs() < 0.3, "{far} {near}");
        } else {
            assert!(far >= 1.0 && near >= 1.0, "{far} {near}");
        }
    }
}

/// At ω₁ = 2ω₂ and at ω₁ = 3ω₂ with |K₁₁ + 3K₁₂ + 9K₂₂| < 3√3|B| they leave; where Arnold's determinant is 0 they stay.
#[test]
fn motions_at_the_resonances_1_2_and_1_3_do_as_said() {
    let body = Body::parse(&["1.15", "2.29", "1.24"], &["0", "0.65", "0.12"]).unwrap();
    for kind in [Failing::Resonance12, Failing::Resonance13] {
        let point = at_change(&body, kind, NonlinearVerdict::Unstable);
        let far = departure(&body, &point, 0.02, 2_500_000, 1.0);
        assert!(far >= 1.0, "{kind:?}: {far}");
    }
    let paper = Preset::find("paper").unwrap().body();
    for (kind, verdict) in
        [(Failing::Resonance13, NonlinearVerdict::Stable), (Failing::Determinant, NonlinearVerdict::Stable)]
    {
        let point = at_change(&paper, kind, verdict);
        let [soon, late] = [5_000, 500_000].map(|steps| departure(&paper, &point, 0.005, steps, 1.0));
        assert!(late < 1.5 * soon, "{kind:?}: {soon} {late}");
    }
}

/// At μ = A₂ this body has a cusp of the curve that its pair leaves: the Hessian vanishes there, and beside it on one side in l
/// are a minimum, a maximum and two saddles, on the other nothing. So it is no minimum, and f64 cuts the branch otherwise than the
/// exact roots: pieces have other numbers.
#[test]
fn a_pitchfork_exactly_at_a_cusp_is_judged_by_both() {
    let body = Body::parse(&["2178/175", "2353/175", "2528/175"], &["16/5", "0", "12/5"]).unwrap();
    let prepared = RelativeEquilibria::new(&body).unwrap();
    let at = prepared.at(&"4608/175".parse().unwrap()).unwrap();
    let flat: Vec<_> = at.list.iter().filter(|found| found.stability == LinearType::Zero).collect();
    let [flat] = flat[..] else { panic!("{:?}", at.list) };
    assert!((flat.omega - 2.0).abs() < 1e-12);
    assert_eq!((flat.index, flat.friction.survives), (0, Some(false)));
    assert_eq!((flat.nonlinear.verdict, flat.nonlinear.why), (NonlinearVerdict::Open, Reason::Degenerate));
    for omega in ["1.9", "2", "2.01", "2.1", "3"] {
        let omega: Number = omega.parse().unwrap();
        for found in prepared.at_spin(omega.value()).unwrap().list {
            let is_even = matches!(found.stability, LinearType::Elliptic | LinearType::Saddle | LinearType::Complex);
            let is_odd = found.stability == LinearType::SaddleCentre;
            assert!(found.stability == LinearType::Zero || is_even != is_odd);
            assert!(!is_even || found.index != 1, "{found:?}");
            assert!(!is_odd || found.index == 1, "{found:?}");
        }
    }
}
