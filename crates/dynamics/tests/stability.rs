//! Relative equilibria that are called stable keep what starts beside them, those called unstable do not.

use std::sync::atomic::AtomicBool;

use bifdiag_body::Body;
use bifdiag_dynamics::field::{HeavyTop, State};
use bifdiag_dynamics::integrator::DEFAULT_TOLERANCE;
use bifdiag_dynamics::motion::{MotionOptions, follow};
use bifdiag_equilibria::critical::{Equilibrium, Multiplicity, critical};
use bifdiag_equilibria::nonlinear::NonlinearVerdict;
use bifdiag_numbers::Number;

/// Steele, Lea and Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * (((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn body(&mut self) -> Body {
        let a: [f64; 3] = std::array::from_fn(|_| (1e4 * self.between(0.3, 2.0)).round() / 1e4);
        let r: [f64; 3] = std::array::from_fn(|_| (1e4 * self.between(-1.0, 1.0)).round() / 1e4);
        // Every third body is Lagrange's.
        let (a, r) = if self.between(0.0, 3.0) < 1.0 { ([a[0], a[0], a[2]], [0.0, 0.0, r[2]]) } else { (a, r) };
        Body::from_f64(a, r).unwrap()
    }
}

/// Size of the disturbance.
const DISTURBANCE: f64 = 1e-6;

/// The largest distance from an equilibrium, relative to the sizes of γ and l, of a motion that starts beside it.
fn departure(body: &Body, point: &Equilibrium, random: &mut Random, duration: f64) -> f64 {
    let a = body.moments_f64();
    let l: [f64; 3] = std::array::from_fn(|k| a[k] * point.omega * point.gamma[k]);
    let size = l.iter().fold(1e-3_f64, |m, x| m.max(x.abs()));
    let mut gamma = point.gamma.map(|g| g + DISTURBANCE * random.between(-1.0, 1.0));
    let norm = gamma.iter().map(|g| g * g).sum::<f64>().sqrt();
    gamma = gamma.map(|g| g / norm);
    let start = State { gamma, l: l.map(|x| x + DISTURBANCE * size * random.between(-1.0, 1.0)) };
    let stop = AtomicBool::new(false);
    let options = MotionOptions { tolerance: DEFAULT_TOLERANCE, phi: 0.0, stop: &stop };
    let times: Vec<f64> = (0..=400).map(|k| duration * f64::from(k) / 400.0).collect();
    let motion = follow(&HeavyTop::new(body), &start, &times, &options).unwrap();
    let far = |sample: &bifdiag_dynamics::motion::MotionSample| {
        (0..3)
            .map(|k| (sample.gamma[k] - point.gamma[k]).abs().max((sample.l[k] - l[k]).abs() / size))
            .fold(0.0, f64::max)
    };
    motion.samples.iter().map(far).fold(0.0, f64::max)
}

/// Bodies of the test; more with STABILITY_BODIES in the environment.
fn bodies() -> usize {
    std::env::var("STABILITY_BODIES").ok().and_then(|n| n.parse().ok()).unwrap_or(25)
}

#[test]
fn motions_beside_stable_equilibria_stay_and_beside_unstable_ones_leave() {
    let mut random = Random(2026);
    let mut counts = std::collections::BTreeMap::new();
    let mut farthest = 0.0_f64;
    for _ in 0..bodies() {
        let body = random.body();
        let l = Number::from_f64((1e4 * random.between(0.2, 4.0)).round() / 1e4).unwrap();
        for point in critical(&body, &l).unwrap().list {
            let parts = point.eigenvalues.pairs;
            let speeds = parts.map(|[re, im]| (re * re + im * im).sqrt());
            let growth = parts.iter().map(|pair| pair[0]).fold(0.0, f64::max);
            // Circles drift along themselves; next to degenerate points the disturbance is large.
            if point.multiplicity != Multiplicity::Points(1)
                || speeds[0].min(speeds[1]) < 0.1 * speeds[0].max(speeds[1])
            {
                continue;
            }
            // Beside the resonance 1:1 linear motions swell by much.
            let is_apart = point.nonlinear.near.is_none_or(|near| near[0] > 0.1);
            match point.nonlinear.verdict {
                NonlinearVerdict::Stable if is_apart => {
                    let slowest = speeds[0].min(speeds[1]);
                    let far = departure(&body, &point, &mut random, 200.0 * std::f64::consts::TAU / slowest);
                    farthest = farthest.max(far);
                    assert!(far < 1e3 * DISTURBANCE, "{body:?} l = {l}: {far:e} {point:?}");
                    *counts.entry("stays").or_insert(0) += 1;
                }
                NonlinearVerdict::Unstable if growth > 0.1 * speeds[0].max(speeds[1]) => {
                    let far = departure(&body, &point, &mut random, 60.0 / growth);
                    assert!(far > 1e4 * DISTURBANCE, "{body:?} l = {l}: {far:e} {point:?}");
                    *counts.entry("leaves").or_insert(0) += 1;
                }
                _ => {}
            }
        }
    }
    println!("{counts:?}, farthest {farthest:e} after a disturbance of {DISTURBANCE:e}");
    assert!(counts.len() == 2 && counts.values().all(|&count| count >= bodies() / 2), "{counts:?}");
}
