//! The fixed bodies and points on which time is measured.
#![allow(dead_code)]

use bifdiag_body::{Body, Number, Preset};

use support::bodies::{Stratum, random_body, random_point};
use support::random::SplitMix64;

const SEED: u64 = 20_080_303;

/// Bodies of a workload.
const BODIES: usize = 64;

/// A body with a point to classify.
#[derive(Clone, Debug)]
pub struct Case {
    pub body: Body,
    pub h: f64,
    pub l: f64,
}

impl Case {
    /// h and l as they come from a command line.
    pub fn exact(&self) -> (Number, Number) {
        let exact = |x: f64| Number::from_f64(x).expect("a workload is finite");
        (exact(self.h), exact(self.l))
    }
}

/// Generic bodies of order one that satisfy the triangle inequality, each with a random point.
pub fn generic() -> Vec<Case> {
    let mut rng = SplitMix64::new(SEED);
    (0..BODIES).map(|_| generic_case(&mut rng)).collect()
}

fn generic_case(rng: &mut SplitMix64) -> Case {
    let body = loop {
        let a = [rng.between(0.3, 2.0), rng.between(0.3, 2.0), rng.between(0.3, 2.0)];
        let body = Body::from_f64(a, rng.direction()).expect("the moments are positive");
        if !body.flags().unphysical {
            break body;
        }
    };
    with_point(rng, body)
}

/// r within about a thousandth of a principal axis.
pub fn near_axis() -> Vec<Case> {
    stratum(Stratum::NearAxis)
}

/// Rods: one moment a hundredth to a millionth of the others.
pub fn rods() -> Vec<Case> {
    let mut rng = SplitMix64::new(SEED);
    let rod = |rng: &mut SplitMix64| {
        let thin = rng.power_of_ten(-6.0, -2.0);
        let body = Body::from_f64([thin, 1.0, 1.0 + 0.9 * thin], rng.direction()).expect("the moments are positive");
        with_point(rng, body)
    };
    (0..BODIES).map(|_| rod(&mut rng)).collect()
}

/// Some r_i = 0: pairs and pitchforks.
pub fn plane() -> Vec<Case> {
    stratum(Stratum::Plane)
}

/// One of the named bodies.
pub fn preset(name: &str) -> Vec<Case> {
    let mut rng = SplitMix64::new(SEED);
    let body = Preset::find(name).expect("a preset").body();
    vec![with_point(&mut rng, body)]
}

fn stratum(stratum: Stratum) -> Vec<Case> {
    let mut rng = SplitMix64::new(SEED);
    (0..BODIES)
        .map(|_| {
            let body = random_body(&mut rng, stratum);
            with_point(&mut rng, body)
        })
        .collect()
}

fn with_point(rng: &mut SplitMix64, body: Body) -> Case {
    let (h, l) = random_point(rng, &body);
    Case { body, h, l }
}

/// Further points of one body.
pub fn points(body: &Body, count: usize) -> Vec<(f64, f64)> {
    let mut rng = SplitMix64::new(SEED + 1);
    (0..count).map(|_| random_point(&mut rng, body)).collect()
}
