//! Ridges against the sweep over latitudes, which shares nothing with them.

use bifdiag_body::{Body, Preset};
use bifdiag_diagram::topology::latitude as sweep;
use bifdiag_numbers::enclosure::Enclosure;
use bifdiag_numbers::wide::Interval128;
use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;

use super::*;
use crate::critical_values::CriticalValues;

/// Compares both methods on a grid of one body; how many points were compared.
fn compare(body: &Body) -> usize {
    let frame = body.frame();
    let model = Model::new(body, &frame);
    let ridges = Ridges::of(&model);
    let exact = |x: f64| RBig::try_from(x).unwrap();
    let mut compared = 0;
    for l in [0.37, 1.1, 2.03, 2.86, 4.1, 9.3] {
        let [low, high] = [0.5 * l * l / frame.a[2] - frame.r_norm, 0.5 * l * l / frame.a[0] + frame.r_norm];
        for k in 1..12 {
            let h = low + (high - low) * f64::from(k) / 12.0;
            let Ok(expected) = sweep::components(&frame, h, l) else { continue };
            let x = exact(l) * exact(l) / RBig::from(2);
            let found = ridges.components(&x, &exact(h));
            assert_eq!(found.as_ref(), Some(&expected), "{body:?} h = {h}, l = {l}");
            compared += 1;
        }
    }
    compared
}

#[test]
fn random_bodies_of_every_stratum() {
    let mut compared = 0;
    for stratum in STRATA {
        let mut rng = SplitMix64::new(7);
        for _ in 0..4 {
            compared += compare(&random_body(&mut rng, stratum));
        }
    }
    assert!(compared > 1500, "{compared}");
}

#[test]
fn presets_and_symmetric_bodies() {
    let mut compared = 0;
    for preset in Preset::all() {
        compared += compare(&preset.body());
    }
    for (a, r) in [
        (["1", "1", "3"], ["0.5", "0", "0.5"]),
        (["1", "3", "3"], ["0.5", "0.5", "0.5"]),
        (["1", "2", "3"], ["0", "1", "0"]),
        (["1", "2", "3"], ["0", "0", "1"]),
        (["1", "2", "3"], ["1", "0", "1"]),
        (["1", "2", "3"], ["1", "1", "0"]),
        (["1", "2", "3"], ["0", "1", "1"]),
        (["2", "2", "2"], ["0", "1", "1"]),
        (["1", "2", "3"], ["0", "0", "0"]),
        (["1", "1", "3"], ["0", "1", "0"]),
        // The folds on the equator: r1²(a2 − a3) = −r3²(a2 − a1) …
        (["1", "2", "3"], ["1/2", "0", "1/2"]),
    ] {
        compared += compare(&Body::parse(&a, &r).unwrap());
    }
    assert!(compared > 800, "{compared}");
}

/// The components from a cut in intervals, which is the exact one.
fn agreed<E: Enclosure>(
    enclosed: Option<strand::Cut<E>>,
    exact: &strand::Cut<latitude::RootLatitude>,
) -> Option<Vec<Component>> {
    let enclosed = enclosed?;
    assert_eq!(enclosed.roots.len(), exact.roots.len());
    assert_eq!(enclosed.valley_roots, exact.valley_roots);
    assert_eq!(enclosed.inside, exact.inside);
    let components = curve::folded(&enclosed)?;
    assert_eq!(Some(&components), curve::folded(exact).as_ref());
    Some(components)
}

/// The cut at a point according to f64 and 128 bits, which must be the exact one; nothing where Staude's curve passes
/// through the point.
fn cuts_told(model: &Model, whole: &whole::Whole, x: &RBig, h: &RBig) -> Option<[bool; 2]> {
    let exact = exact_cut::cut(model, x, h)?;
    let double = agreed(enclosed::cut(&enclosed::ranges(model, x, h).unwrap()), &exact);
    let finer = agreed(enclosed::cut(&whole.ranges::<Interval128>(x, h)), &exact);
    Some([double.is_some(), finer.is_some()])
}

#[test]
fn the_cut_in_intervals_is_the_exact_one() {
    let (mut decided, mut close) = (0, 0);
    for stratum in STRATA {
        let mut rng = SplitMix64::new(11);
        for _ in 0..12 {
            let body = random_body(&mut rng, stratum);
            let model = Model::new(&body, &body.frame());
            if model.active.len() < 3 {
                continue;
            }
            let whole = whole::Whole::new(&model).unwrap();
            for _ in 0..12 {
                let x = RBig::try_from(0.02 + 5.0 * rng.unit() * rng.unit()).unwrap();
                let h = RBig::try_from(-1.5 + 6.0 * rng.unit()).unwrap();
                let Some(found) = cuts_told(&model, &whole, &x, &h) else { continue };
                assert_eq!(found, [true; 2], "{body:?} h = {h}, x = {x}");
                decided += 1;
                // So close to the lowest critical value above h that no double separates it.
                let heights = CriticalValues::new(&model, x.clone()).enclosed(1).unwrap();
                let above = heights.iter().filter_map(|(_, height)| height.exact_bounds()).map(|[low, _]| low);
                let Some(above) = above.filter(|above| *above > h).min() else { continue };
                let beside = above - RBig::ONE / RBig::from(10).pow(20);
                let Some([double, found]) = cuts_told(&model, &whole, &x, &beside) else { continue };
                assert!(found, "{body:?} h = {beside}, x = {x}");
                close += usize::from(!double);
            }
        }
    }
    assert!(decided > 500 && close > 400, "f64 tells {decided} and leaves {close} open");
}
