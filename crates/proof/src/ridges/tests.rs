//! Ridges against the sweep over latitudes, which shares nothing with them.

use support::bodies::{STRATA, random_body};
use support::random::SplitMix64;
use top::body::{Body, Preset};
use top::topology::latitude;

use super::*;

/// Compares both methods on a grid of one body; how many points were compared.
fn compare(body: &Body) -> usize {
    let frame = body.frame();
    let model = Model::new(body, &frame);
    let exact = |x: f64| RBig::try_from(x).unwrap();
    let mut compared = 0;
    for l in [0.37, 1.1, 2.03, 2.86, 4.1, 9.3] {
        let [low, high] = [0.5 * l * l / frame.a[2] - frame.r_norm, 0.5 * l * l / frame.a[0] + frame.r_norm];
        for k in 1..12 {
            let h = low + (high - low) * f64::from(k) / 12.0;
            let Ok(expected) = latitude::components(&frame, h, l) else { continue };
            let x = exact(l) * exact(l) / RBig::from(2);
            let found = components(&model, &x, &exact(h));
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
