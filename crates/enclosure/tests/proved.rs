//! Enclosures of motions against Taylor series of 84 digits in integers, and against elliptic functions.
//!
//! A campaign of more cases: `python3 data/oracles/motion.py --cases 10000 --seed 7 --out FILE`, then
//! `MOTIONS=FILE cargo test --release --test proved oracle`.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64};

use bifdiag_body::{Body, Number};
use bifdiag_enclosure::orbit::{Ends, ProofOptions, ProvedMotion, prove};
use bifdiag_enclosure::start::ExactStart;
use dashu_ratio::RBig;
use serde::Deserialize;
use support::random::SplitMix64;

#[derive(Deserialize)]
struct Case {
    kind: String,
    #[serde(rename = "A")]
    a: [String; 3],
    r: [String; 3],
    gamma0: [String; 3],
    omega0: [String; 3],
    #[serde(default)]
    phi: Option<String>,
    time: String,
    #[serde(default)]
    gamma: Vec<String>,
    #[serde(default)]
    gamma3: Option<String>,
    #[serde(default)]
    omega: Vec<String>,
    #[serde(default)]
    quaternion: Vec<String>,
}

fn exact(text: &str) -> RBig {
    text.parse::<Number>().unwrap_or_else(|error| panic!("{text}: {error}")).value().clone()
}

fn cases(name: &str) -> Vec<Case> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/oracles").join(name);
    let file = std::env::var_os("MOTIONS").filter(|_| name == "motion.jsonl").map_or(here, PathBuf::from);
    let text = std::fs::read_to_string(&file).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

impl Case {
    fn prove(&self, digits: Option<u32>, bound: f64) -> ProvedMotion {
        let body = Body::parse(&self.a, &self.r).unwrap();
        let start = ExactStart {
            gamma: self.gamma0.each_ref().map(|x| exact(x)),
            omega: self.omega0.each_ref().map(|x| exact(x)),
            phi: self.phi.as_deref().map_or(RBig::ZERO, exact),
        };
        let stop = AtomicBool::new(false);
        prove(
            &body,
            &start,
            &[exact(&self.time)],
            &ProofOptions { digits, bound, stop: &stop, steps: &AtomicU64::new(0) },
        )
    }
}

/// The oracle's value, cut after some digits, lies in the enclosure.
fn holds(ends: &Ends, value: &str, digits: i32) -> bool {
    let (value, cut) = (exact(value), RBig::try_from(libm::pow(10.0, f64::from(-digits))).unwrap());
    let cut = cut * (RBig::ONE + value.clone().max(-value.clone()));
    ends[0] <= ends[1] && &ends[0] - &cut <= value && value <= &ends[1] + cut
}

#[test]
fn every_enclosure_holds_the_oracle_and_none_is_wider_than_asked() {
    let mut refused = 0;
    for (number, case) in cases("motion.jsonl").iter().enumerate() {
        let speed = case.omega0.iter().map(|x| exact(x).to_f64().value().abs()).fold(1.0, f64::max);
        let bounds = [1e-3, 1e-6, 1e-9, 1e-12, 1e-20, 1e-40];
        let bound = bounds[number % 6] * speed;
        let motion = case.prove(if number % 6 < 3 && number % 4 == 0 { Some(15) } else { None }, bound);
        let Some(sample) = motion.samples.first() else {
            // Only fixed digits may not be enough.
            assert!(number % 6 < 3 && number % 4 == 0, "case {number}, {}: {motion:?}", case.kind);
            refused += 1;
            continue;
        };
        assert!(sample.width() <= bound);
        let found = sample.gamma.iter().chain(&sample.omega).chain(&sample.quaternion);
        let known = case.gamma.iter().chain(&case.omega).chain(&case.quaternion);
        for (k, (ends, value)) in found.zip(known).enumerate() {
            assert!(holds(ends, value, 60), "case {number}, {}, entry {k}: {ends:?} {value}", case.kind);
        }
        for (row, gamma) in sample.rotation[6..].iter().zip(&sample.gamma) {
            assert_eq!(row, gamma);
        }
    }
    println!("{refused} were not enclosed as well as requested in 15 digits");
}

/// What doubles enclose, up to where they end, holds what 102 bits know to twenty digits: random bodies and starts, long times.
#[test]
fn enclosures_in_doubles_hold_those_of_more_digits() {
    let mut random = SplitMix64::new(1889);
    let times = ["1", "3", "10", "30", "100"].map(exact);
    let (mut compared, mut widest) = (0, 0.0_f64);
    for round in 0..120 {
        let mut three = |lo: f64, hi: f64| -> [String; 3] {
            std::array::from_fn(|_| format!("{:.4}", lo + (hi - lo) * 0.5 * (1.0 + random.between(-1.0, 1.0))))
        };
        let (a, r) = (three(0.7, 1.3), three(-1.0, 1.0));
        let Ok(body) = Body::parse(&a, &r) else { continue };
        let [gamma, omega] = [three(-1.0, 1.0), three(-2.0, 2.0)].map(|v| v.map(|x| exact(&x)));
        let start = ExactStart { gamma, omega, phi: RBig::ZERO };
        let stop = AtomicBool::new(false);
        let proved = |digits: u32, bound: f64| {
            let options = ProofOptions { digits: Some(digits), bound, stop: &stop, steps: &AtomicU64::new(0) };
            prove(&body, &start, &times, &options)
        };
        let (doubles, more) = (proved(15, 1e-2), proved(30, 1e-12));
        for (sample, narrow) in doubles.samples.iter().zip(&more.samples) {
            assert_eq!(sample.time, narrow.time);
            for (outer, inner) in sample.enclosures().zip(narrow.enclosures()) {
                assert!(outer[0] <= inner[0] && inner[1] <= outer[1], "{round}, {}: {outer:?} {inner:?}", sample.time);
            }
            compared += 1;
            widest = widest.max(sample.width());
        }
    }
    assert!(compared > 400 && widest > 1e-6, "{compared} {widest}");
}

#[test]
fn elliptic_functions_agree() {
    for (number, case) in cases("elliptic_motion.jsonl").iter().enumerate() {
        for bound in [1e-9, 1e-30] {
            let motion = case.prove(None, bound);
            let sample = motion.samples.first().unwrap_or_else(|| panic!("case {number}: {motion:?}"));
            for (ends, value) in sample.omega.iter().zip(&case.omega) {
                assert!(holds(ends, value, 48), "case {number}: {ends:?} {value}");
            }
            if let Some(value) = &case.gamma3 {
                assert!(holds(&sample.gamma[2], value, 48), "case {number}: {:?} {value}", sample.gamma[2]);
            }
        }
    }
}

fn paper() -> Body {
    Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap()
}

/// The motion runs backwards into where it came from, and the times between lie on it.
#[test]
fn the_past_is_enclosed_too() {
    let text = ["0.6", "0", "0.8"];
    let start = ExactStart { gamma: text.map(exact), omega: ["1", "0.3", "1"].map(exact), phi: exact("0.5") };
    let stop = AtomicBool::new(false);
    let options = ProofOptions { digits: None, bound: 1e-12, stop: &stop, steps: &AtomicU64::new(0) };
    let times = ["-3", "-1.5", "0", "2"].map(exact);
    let there = prove(&paper(), &start, &times, &options);
    assert_eq!(there.samples.len(), 4);
    let middle = |[lo, hi]: &Ends| (lo + hi) / RBig::from(2);
    let past = &there.samples[0];
    let again = ExactStart {
        gamma: past.gamma.each_ref().map(middle),
        omega: past.omega.each_ref().map(middle),
        phi: RBig::ZERO,
    };
    let back = prove(&paper(), &again, &["3", "5"].map(exact), &options);
    for (sample, known) in back.samples.iter().zip([&there.samples[2], &there.samples[3]]) {
        for (ends, other) in sample.gamma.iter().chain(&sample.omega).zip(known.gamma.iter().chain(&known.omega)) {
            let gap = (middle(ends) - middle(other)).to_f64().value();
            assert!(gap.abs() < 1e-10, "{gap}");
        }
    }
    // φ, and the continuous quaternion, as the plain motion has them.
    let [w, ..] = there.samples[2].quaternion.each_ref().map(middle);
    assert!(w > RBig::ZERO);
}

fn followed(body: &Body, [gamma, omega]: [[&str; 3]; 2], time: &str, bound: f64, digits: Option<u32>) -> ProvedMotion {
    let start = ExactStart { gamma: gamma.map(exact), omega: omega.map(exact), phi: RBig::ZERO };
    let stop = AtomicBool::new(false);
    prove(body, &start, &[exact(time)], &ProofOptions { digits, bound, stop: &stop, steps: &AtomicU64::new(0) })
}

/// A chaotic motion of the body `ten`: the derivative of its flow is e^24 large at t = 141, e^34 at t = 167 and e^50 at t = 270.
/// With sets in frames of one parallelepiped doubles ended at t = 71, pairs of doubles with 64 bits at 134; without what the
/// integrals cut off at 132 and 165.
#[test]
fn chaos_is_followed_as_far_as_digits_reach() {
    let ten = Body::parse(&["0.57847392", "0.53739099", "1"], &["0.00595273", "0.00176367", "-0.99998073"]).unwrap();
    let start = [["0", "0.1", "1"], ["0.3", "0.2", "0.5"]];
    let doubles = followed(&ten, start, "200", 1e-2, Some(15));
    assert!(doubles.samples.is_empty() && doubles.bits == 53, "{doubles:?}");
    assert!(doubles.proved[1] > 138.0 && doubles.proved[1] < 150.0, "{:?}", doubles.proved);
    assert!(doubles.growth > 23.0 && doubles.growth < 25.0, "{}", doubles.growth);
    let pairs = followed(&ten, start, "200", 1e-2, Some(19));
    assert!(pairs.bits == 64 && pairs.proved[1] > 166.0 && pairs.growth > 30.0, "{:?}", pairs.proved);
    let rising = followed(&ten, start, "270", 1e-2, None);
    assert!(rising.samples.len() == 1 && rising.bits == 102 && rising.widest() <= 1e-2, "{} bits", rising.bits);
}

/// The integrals take the drift out of the phases of a regular motion: without them this one is 3.4e-6 wide in doubles.
#[test]
fn the_integrals_keep_a_regular_motion_narrow() {
    let regular = followed(&paper(), [["0.6", "0", "0.8"], ["3", "0.2", "2"]], "1500", 1e-2, Some(15));
    assert!(regular.samples.len() == 1 && regular.bits == 53 && regular.widest() <= 4e-7, "{:e}", regular.widest());
}

/// A regular motion loses digits slowly: this one outran 102 bits when sets were parallelepipeds.
#[test]
fn a_regular_motion_stays_in_pairs_of_doubles() {
    let regular = followed(&paper(), [["0.6", "0", "0.8"], ["3", "0.2", "2"]], "1500", 1e-10, None);
    assert!(regular.samples.len() == 1 && regular.bits <= 80 && regular.widest() <= 1e-10, "{} bits", regular.bits);
}

/// Where digits are not enough the proof ends, and without a number of digits there are as many as are needed.
#[test]
fn the_proof_ends_where_digits_do() {
    let start = [["0.6", "0", "0.8"], ["0.1", "0.3", "0.1"]];
    let doubles = followed(&paper(), start, "1000", 1e-10, Some(15));
    assert!(doubles.samples.is_empty() && doubles.proved[1] > 500.0 && doubles.proved[1] < 700.0, "{doubles:?}");
    let rising = followed(&paper(), start, "1000", 1e-10, None);
    assert!(rising.samples.len() == 1 && rising.bits > 53 && rising.widest() <= 1e-10);
}

/// Whoever watches sees the steps of every precision that is tried.
#[test]
fn steps_are_counted_while_a_motion_is_proved() {
    let body = Body::parse(&["2", "1.1", "1"], &["0.94868", "0", "0.61623"]).unwrap();
    let number = |text: &str| exact(text);
    let start =
        ExactStart { gamma: ["0.6", "0", "0.8"].map(number), omega: ["1", "0.3", "1"].map(number), phi: RBig::ZERO };
    let (stop, steps) = (AtomicBool::new(false), AtomicU64::new(0));
    let options = ProofOptions { digits: None, bound: 1e-12, stop: &stop, steps: &steps };
    let motion = prove(&body, &start, &[exact("30")], &options);
    let counted = steps.load(std::sync::atomic::Ordering::Relaxed);
    assert!(motion.end.is_none() && motion.steps > 10 && counted >= motion.steps, "{counted} {}", motion.steps);
    stop.store(true, std::sync::atomic::Ordering::Relaxed);
    assert!(prove(&body, &start, &[exact("30")], &options).end.is_some());
    assert_eq!(steps.load(std::sync::atomic::Ordering::Relaxed), counted);
}
