//! Verdicts along curves: the points at which the hypotheses of Arnold's theorem fail, against the equilibria beside them;
//! and how many relative equilibria of random bodies are left open.

use std::collections::BTreeMap;

use bifdiag_body::{Body, Preset};
use bifdiag_equilibria::critical::{Equilibrium, RelativeEquilibria};
use bifdiag_equilibria::curves::{CriticalSet, CurveName};
use bifdiag_equilibria::nonlinear::{Failing, Verdict, VerdictChange, Verdicts, Why};
use bifdiag_numbers::Number;
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
        return verdicts.contains(&Verdict::Stable) && verdicts.contains(&Verdict::Unstable) == change.changes;
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
        (1.947_890_543_818_278_5, 2.619_765_065_855_363, Failing::Resonance11, Verdict::Stable, Why::Resonance11),
        (2.236_708_030_753_01, 3.199_864_242_090_404, Failing::Resonance12, Verdict::Unstable, Why::Resonance12),
        (2.327_799_984_629_819, 3.401_836_073_571_975, Failing::Determinant, Verdict::Open, Why::Degenerate),
        (3.030_861_364_678_378_4, 5.255_603_779_766_969, Failing::Resonance13, Verdict::Stable, Why::Resonance13),
    ];
    assert_eq!(verdicts.changes().len(), expected.len(), "{:?}", verdicts.changes());
    for (change, (l, h, kind, verdict, why)) in verdicts.changes().iter().zip(expected) {
        assert!((change.l - l).abs() < 1e-12 && (change.h - h).abs() < 1e-12, "{change:?}");
        assert_eq!((change.kind, change.verdict, change.why, change.proved), (kind, verdict, why, true));
        assert!(change.error_bound < 1e-12);
        assert_eq!(CurveName::of(&set, change.curve).to_string(), "G0.1");
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
                *counts.entry(format!("{}: {}", change.kind, change.verdict)).or_insert(0) += 1;
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
                assert!(found.verdict != Verdict::Open && found.proved, "{body:?} {l:?} {point:?}");
                *counts.entry(format!("{} ({})", found.verdict, found.why)).or_insert(0) += 1;
            }
        }
    }
    println!("{counts:?}");
    assert!(counts.len() >= 3, "{counts:?}");
}
