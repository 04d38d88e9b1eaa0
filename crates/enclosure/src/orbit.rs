//! The motion at given times, in as many digits as its bounds need.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use bifdiag_body::Body;
use bifdiag_numbers::directed::Big;
use bifdiag_numbers::enclosure::{Arithmetic, Enclosure};
use bifdiag_numbers::wide::{FixedFloat, Wide};
use dashu_ratio::RBig;
use thiserror::Error;

use crate::bound::{frobenius, norm};
use crate::field::{ATTITUDE, Equations, QuadraticField};
use crate::integrals::Integrals;
use crate::scalar::{DoubleDouble, Float, Scalar};
use crate::set::{FlowSet, identity, product};
use crate::start::ExactStart;
use crate::step::{Enclosed, Step};

/// The most digits that can be asked for: bounds are doubles, and beyond this their products would vanish.
pub const MOST_DIGITS: u32 = 250;
/// Bits of as many digits.
pub const MOST_BITS: usize = 832;
/// The longest step, in the time of the motion's fastest frequency.
const LONGEST: f64 = 4.0;
/// The integrals tighten the set every this many steps: more often, roundings dominate; less often, chaos does.
const TIGHTENED: u64 = 8;

/// What to prove.
#[derive(Clone, Copy, Debug)]
pub struct ProofOptions<'a> {
    /// Digits of the computation; by default as many as are needed.
    pub digits: Option<u32>,
    /// The widest enclosure wanted.
    pub bound: f64,
    /// Cancellation: once it is set, the motion ends.
    pub stop: &'a AtomicBool,
    /// Counts steps, for whoever watches: those of every precision that is tried.
    pub steps: &'a AtomicU64,
}

/// An interval with rational ends.
pub type Ends = [RBig; 2];

/// Enclosures at one time, all in the order of their names; the exact values lie within.
#[derive(Clone, Debug, PartialEq)]
pub struct ProvedSample {
    /// The time.
    pub time: RBig,
    /// γ.
    pub gamma: [Ends; 3],
    /// ω, in the body's axes.
    pub omega: [Ends; 3],
    /// The rotation matrix that takes vectors of the body to space, by rows; the last row is γ.
    pub rotation: [Ends; 9],
    /// The same as a quaternion w, x, y, z, continuous in time.
    pub quaternion: [Ends; 4],
}

impl ProvedSample {
    /// All enclosures.
    pub fn enclosures(&self) -> impl Iterator<Item = &Ends> {
        self.gamma.iter().chain(&self.omega).chain(&self.rotation).chain(&self.quaternion)
    }

    /// The width of the widest, rounded up.
    #[must_use]
    pub fn width(&self) -> f64 {
        let width = |[lo, hi]: &Ends| (hi - lo).to_f64().value() * (1.0 + f64::EPSILON);
        self.enclosures().map(width).fold(0.0, f64::max)
    }
}

/// Why the motion was not followed to the last time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ProofEnd {
    /// Enclosures became wider than the bound, or nothing could be proved of the next step.
    #[error("enclosures grow beyond the bound")]
    Wide,
    /// It was stopped from outside.
    #[error("interrupted")]
    Interrupted,
}

/// The proved part of the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct ProvedMotion {
    /// In the order of time; those that could not be proved are missing.
    pub samples: Vec<ProvedSample>,
    /// Enclosures are within the bound from the first to the second of these times.
    pub proved: [f64; 2],
    /// Bits of the arithmetic.
    pub bits: usize,
    /// Steps.
    pub steps: u64,
    /// The logarithm of the norm of the set's frame, which the flow's derivative maps and the integrals cut, up to where the motion is
    /// proved: about λt of a chaotic one. This estimate proves nothing.
    pub growth: f64,
    /// Why samples are missing.
    pub end: Option<ProofEnd>,
}

impl ProvedMotion {
    /// The width of the widest enclosure.
    #[must_use]
    pub fn widest(&self) -> f64 {
        self.samples.iter().map(ProvedSample::width).fold(0.0, f64::max)
    }
}

/// Encloses the motion from `start` at time 0 at times that do not fall; negative ones are in the past.
#[must_use]
pub fn prove(body: &Body, start: &ExactStart, times: &[RBig], options: &ProofOptions<'_>) -> ProvedMotion {
    let (past, future) = times.split_at(times.partition_point(|time| *time < RBig::ZERO));
    let back: Vec<RBig> = past.iter().rev().map(|time| -time.clone()).collect();
    let mut backward = in_one_direction(body, &start.reversed(), &back, options);
    for sample in &mut backward.samples {
        sample.time = -sample.time.clone();
        sample.omega = sample.omega.clone().map(|[lo, hi]| [-hi, -lo]);
    }
    backward.samples.reverse();
    let forward = in_one_direction(body, start, future, options);
    let mut samples = backward.samples;
    samples.extend(forward.samples);
    ProvedMotion {
        samples,
        proved: [0.0 - backward.proved[1], forward.proved[1]],
        bits: backward.bits.max(forward.bits),
        steps: backward.steps + forward.steps,
        growth: backward.growth.max(forward.growth),
        end: backward.end.or(forward.end),
    }
}

/// Times that rise from 0 on.
fn in_one_direction(body: &Body, start: &ExactStart, times: &[RBig], options: &ProofOptions<'_>) -> ProvedMotion {
    let problem = Problem { body, start, times, options, speed: start.speed(body) };
    if let Some(digits) = options.digits {
        return problem.run_with(bits_of(digits).min(MOST_BITS));
    }
    // Bits of the bound, and of what a regular motion loses: the square of the time, and some for roundings.
    let asked = usize::try_from(-libm::ilogb(options.bound.max(f64::MIN_POSITIVE))).unwrap_or(0);
    let last = times.last().map_or(0.0, |time| time.to_f64().value());
    let turns = libm::ilogb((last * problem.speed.to_f64().value()).clamp(1.0, 1e9));
    let mut bits = asked + 4 + 2 * usize::try_from(turns).unwrap_or(0);
    let mut grown = false;
    loop {
        let motion = problem.run_with(bits.min(MOST_BITS));
        if motion.end != Some(ProofEnd::Wide) || motion.bits >= MOST_BITS {
            return motion;
        }
        let (used, reached) = (motion.bits, motion.proved[1]);
        // Once by the growth of a computed motion; where that was not enough, by what was spent up to here.
        bits = if !grown {
            asked + problem.growth(last)
        } else if reached > 0.0 {
            let share = ((last - reached) / reached).clamp(0.0, 50.0);
            used + 8 + times_hundredths(used.saturating_sub(asked), 110.0 * share)
        } else {
            2 * used
        };
        grown = true;
        bits = bits.clamp(used + 1, MOST_BITS.max(used + 1));
    }
}

/// n x/100, rounded down.
fn times_hundredths(n: usize, x: f64) -> usize {
    n * (0_u16..5500).take_while(|part| f64::from(*part) < x).count() / 100
}

/// Bits for a number of digits: log₂ 10 < 3.322.
fn bits_of(digits: u32) -> usize {
    (digits as usize * 3322).div_ceil(1000)
}

struct Problem<'a> {
    body: &'a Body,
    start: &'a ExactStart,
    times: &'a [RBig],
    options: &'a ProofOptions<'a>,
    speed: RBig,
}

impl Problem<'_> {
    /// In the lowest precision with at least this many bits.
    fn run_with(&self, bits: usize) -> ProvedMotion {
        match bits {
            ..=53 => self.run::<f64>((), 53),
            // Pairs of doubles, whose full length is seldom needed.
            54..=64 => self.run::<DoubleDouble>((), 64),
            65..=80 => self.run::<DoubleDouble>((), 80),
            81..=102 => self.run::<DoubleDouble>((), 102),
            103..=255 => self.run::<Float<FixedFloat<4>>>((), 255),
            256..=383 => self.run::<Float<FixedFloat<6>>>((), 383),
            384..=511 => self.run::<Float<FixedFloat<8>>>((), 511),
            _ => self.run::<Float<Big>>(bits, bits),
        }
    }

    /// The bits that the motion up to a time loses, estimated in doubles: its flow's derivative, once for each step,
    /// and some for roundings. This estimate proves nothing.
    fn growth(&self, last: f64) -> usize {
        let field =
            QuadraticField::<f64, ATTITUDE>::new(&Equations::attitude(self.body, &self.speed), (), accuracy(53));
        let mut point = self.start.attitude::<f64>(&self.speed, (), 53).middle;
        let (mut left, mut steps, mut bits) = (last * self.speed.to_f64().value(), 0.0, 0);
        let mut flow = identity();
        while left > 0.0 && !self.options.stop.load(Ordering::Relaxed) {
            let Some(step) = Step::new(&field, FlowSet::new(point, [0.0; ATTITUDE]), LONGEST) else { break };
            let (map, next) = step.plain_end();
            let image = product(&map, &flow);
            // Powers of two, so that nothing overflows.
            let exponent = libm::ilogb(frobenius(&image));
            flow = image.map(|row| row.map(|x| libm::ldexp(x, -exponent)));
            bits += i64::from(exponent);
            left -= step.length();
            steps += 1.0;
            self.options.steps.fetch_add(1, Ordering::Relaxed);
            point = next;
        }
        usize::try_from(bits.max(0)).unwrap_or(0) + usize::try_from(libm::ilogb(1.0 + steps)).unwrap_or(0) + 8
    }

    fn run<S: Scalar>(&self, precision: S::Precision, bits: usize) -> ProvedMotion {
        let mut motion = ProvedMotion { samples: Vec::new(), proved: [0.0; 2], bits, steps: 0, growth: 0.0, end: None };
        let field =
            QuadraticField::<S, ATTITUDE>::new(&Equations::attitude(self.body, &self.speed), precision, accuracy(bits));
        let mut set = self.start.attitude::<S>(&self.speed, precision, bits);
        let integrals = Integrals::new(self.body, self.start, &self.speed, bits);
        // In units of 1/speed.
        let mut now = RBig::ZERO;
        let mut left = self.times.iter().peekable();
        while left.peek().is_some() {
            if self.options.stop.load(Ordering::Relaxed) {
                motion.end = Some(ProofEnd::Interrupted);
                break;
            }
            let Some(step) = Step::new(&field, set, LONGEST) else {
                motion.end = Some(ProofEnd::Wide);
                break;
            };
            let length = RBig::try_from(step.length()).unwrap_or(RBig::ZERO);
            motion.steps += 1;
            self.options.steps.fetch_add(1, Ordering::Relaxed);
            while let Some(time) = left.peek() {
                let from_start = *time * &self.speed - &now;
                if from_start > length {
                    break;
                }
                let sample = self.sample(time, &step.at(&from_start), bits);
                if sample.width() > self.options.bound {
                    motion.end = Some(ProofEnd::Wide);
                    return motion;
                }
                motion.proved[1] = time.to_f64().value();
                motion.samples.push(sample);
                left.next();
            }
            if left.peek().is_none() {
                break;
            }
            now += length;
            match step.end() {
                Some(end) if self.width(&end.component_radii()) <= self.options.bound => {
                    motion.growth = libm::log(frobenius(&end.shape.frame));
                    let is_time = motion.steps.is_multiple_of(TIGHTENED);
                    let tight = if is_time { integrals.tightened(&end, precision) } else { None };
                    set = tight.unwrap_or(end);
                }
                _ => {
                    motion.end = Some(ProofEnd::Wide);
                    break;
                }
            }
            motion.proved[1] = (&now / &self.speed).to_f64().value();
        }
        motion
    }

    /// A bound of the widths of all enclosures that follow from a set: the entries of the rotation are quadratic forms of q
    /// whose gradients are 2 long.
    fn width(&self, radii: &[f64; ATTITUDE]) -> f64 {
        let [w, x, y, z, a, b, c] = *radii;
        let speed = self.speed.to_f64().value();
        (4.0 * norm(&[w, x, y, z])).max(2.0 * speed * a.max(b).max(c))
    }

    fn sample<S: Scalar>(&self, time: &RBig, state: &Enclosed<S, ATTITUDE>, bits: usize) -> ProvedSample {
        let bits = bits + 32;
        let ends = |i: usize| {
            let (middle, radius) = (state.middle[i].to_rational(), RBig::try_from(state.radii[i]).ok());
            middle.zip(radius).map(|(middle, radius)| [&middle - &radius, middle + radius])
        };
        let component: [Wide; ATTITUDE] = std::array::from_fn(|i| match ends(i) {
            Some([lo, hi]) => Wide::rational(&lo, bits).hull(&Wide::rational(&hi, bits)),
            None => Wide::line(bits),
        });
        let [w, x, y, z, a, b, c] = component;
        let product = |factor: i32, u: &Wide, v: &Wide| Wide::small(factor, bits) * u.clone() * v.clone();
        let twice = |u: &Wide, v: &Wide, sign: i32, s: &Wide, t: &Wide| product(2, u, v) + product(2 * sign, s, t);
        let squares = |signs: [i32; 3]| {
            let [i, j, k] = signs.map(|sign| Wide::small(sign, bits));
            w.square() + i * x.square() + j * y.square() + k * z.square()
        };
        let rotation = [
            squares([1, -1, -1]),
            twice(&x, &y, -1, &w, &z),
            twice(&x, &z, 1, &w, &y),
            twice(&x, &y, 1, &w, &z),
            squares([-1, 1, -1]),
            twice(&y, &z, -1, &w, &x),
            twice(&x, &z, -1, &w, &y),
            twice(&y, &z, 1, &w, &x),
            squares([-1, -1, 1]),
        ]
        .map(|x| exact(&x));
        let [.., g1, g2, g3] = rotation.clone();
        let speed = Wide::rational(&self.speed, bits);
        ProvedSample {
            time: time.clone(),
            gamma: [g1, g2, g3],
            omega: [a, b, c].map(|x| exact(&(x * speed.clone()))),
            rotation,
            quaternion: [w, x, y, z].map(|x| exact(&x)),
        }
    }
}

/// 2^−bits.
fn accuracy(bits: usize) -> f64 {
    (0..bits).fold(1.0, |unit, _| 0.5 * unit)
}

/// The ends; what is not bounded has been refused before.
fn exact(x: &Wide) -> Ends {
    x.exact_bounds().unwrap_or_else(|| [-RBig::from(u64::MAX), RBig::from(u64::MAX)])
}
