//! One orbit's way through the steps: which of them cross the section, where, and when to stop.
//!
//! On the way only times and states are kept; what is read off them, and whether they need to be polished, comes at the
//! end, for a register of crossings at a time.

use pulp::Simd;

use super::condition::{SectionCondition, polished};
use super::orbit::{OrbitEnd, OrbitReport, OrbitSection, SectionPoint, SweepOptions};
use super::readings::{Gauge, Reading};
use super::roots::all_roots;
use super::scan::Scan;
use super::torus::PpTorus;
use super::workers::{LANE, OrbitCheckpoint};
use crate::field::{Integrals, State};
use crate::integrator::taylor::{LaneVector, Lanes, ROWS, lane_values, lane_values_mut, state_of};
use crate::integrator::{Instant, StepError};

/// |S| below this part of its scale over a whole step is rounding.
const FLAT: f64 = 1.0 / (1u64 << 42) as f64;
/// |S| below this part of its scale is rounding.
const ROUNDING: f64 = 1.0 / (1u64 << 50) as f64;
/// Flat steps in a row that mean S ≡ 0.
const FLAT_STEPS: u32 = 64;

/// What the current step holds for the lanes that may cross the section in it.
pub(super) struct News<'a, S: Simd> {
    lanes: &'a Lanes<S>,
    scan: &'a Scan<S>,
    /// Roots of the lanes that have exactly one, as times after the step's start, and the states there.
    offsets: [S::f64s; 1],
    states: [LaneVector<S>; 2],
}

impl<'a, S: Simd> News<'a, S> {
    #[inline(always)]
    pub fn read(simd: S, lanes: &'a Lanes<S>, scan: &'a Scan<S>) -> Self {
        let offset = scan.single_roots(simd, lanes);
        Self { lanes, scan, offsets: [offset], states: lanes.states_at(simd, offset) }
    }
}

/// An orbit in a lane.
pub(super) struct OrbitFollower {
    pub start: State,
    /// Unit of |l| for the tolerance.
    pub momentum_scale: f64,
    pub end: Option<OrbitEnd>,
    orbit: u32,
    /// S at the start; NaN if the start lies on the section.
    pub start_value: f64,
    /// Σ|c_k| of S below this is rounding.
    pub flat: f64,
    /// |S| of a state that is on the section.
    rounding: f64,
    /// Flat steps in a row, and the last of them.
    flat_steps: u32,
    last_flat: u64,
    integrals: Integrals,
    points: Vec<SectionPoint>,
    crossings: u32,
    /// Crossings that the monitor knows of.
    reported: u32,
    /// Steps of the lanes before the orbit's first.
    origin: u64,
    steps: u64,
    time: f64,
    tangencies: u32,
    drift: Integrals,
    residual: f64,
    roots: Vec<f64>,
}

impl OrbitFollower {
    pub fn new(torus: &PpTorus, options: &SweepOptions, most: usize, orbit: u32, start: &State) -> Self {
        let top = torus.top();
        let integrals = Integrals::of(top, start);
        let value = options.condition.value(top, start);
        let scale = options.condition.scale(top, integrals.energy);
        let on_section = value.abs() <= FLAT * scale;
        let mut follower = Self {
            start: *start,
            momentum_scale: top.momentum_scale(integrals.energy),
            end: (options.crossings == 0).then_some(OrbitEnd::Crossings),
            orbit,
            start_value: if on_section { f64::NAN } else { value },
            flat: FLAT * scale,
            rounding: ROUNDING * scale,
            flat_steps: 0,
            last_flat: 0,
            integrals,
            // Room for what was asked for, unless that is a way of saying "many".
            points: Vec::with_capacity(options.crossings.min(most).min(1 << 16) + 1),
            crossings: 0,
            reported: 0,
            origin: 0,
            steps: 0,
            time: 0.0,
            tangencies: 0,
            drift: Integrals::default(),
            residual: 0.0,
            roots: Vec::new(),
        };
        if on_section {
            follower.record(Instant::default(), start);
        }
        follower
    }

    /// Goes on where it was halted.
    pub fn resume(&mut self, halt: &OrbitCheckpoint) {
        let [.., energy, vertical_momentum, gamma_squared, residual, time] = halt.numbers;
        let [crossings, steps, tangencies, flat_steps, last_flat] = halt.counts;
        // Counts of `u32` were kept as more.
        let narrow = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
        self.points.clear();
        self.start_value = halt.value();
        self.drift = Integrals { energy, vertical_momentum, gamma_squared };
        (self.residual, self.time) = (residual, time);
        (self.crossings, self.reported) = (narrow(crossings), narrow(crossings));
        (self.steps, self.tangencies) = (steps, narrow(tangencies));
        (self.flat_steps, self.last_flat) = (narrow(flat_steps), last_flat);
    }

    /// The state needed to continue, besides that of its lane and of the scan: S there.
    pub fn halt(&self, lane: [f64; LANE], value: f64) -> OrbitCheckpoint {
        let Integrals { energy, vertical_momentum, gamma_squared } = self.drift;
        let more = [value, energy, vertical_momentum, gamma_squared, self.residual, self.time];
        let counts = [self.crossings, self.tangencies, self.flat_steps].map(u64::from);
        OrbitCheckpoint {
            numbers: std::array::from_fn(|k| if k < LANE { lane[k] } else { more[k - LANE] }),
            counts: [counts[0], self.steps, counts[1], counts[2], self.last_flat],
        }
    }

    /// True once `most` points are stored.
    #[inline(always)]
    pub fn has(&self, most: usize) -> bool {
        self.points.len() >= most
    }

    /// Enters the lanes after `step` of their steps.
    #[inline(always)]
    pub fn enter(&mut self, step: u64) {
        self.origin = step.wrapping_sub(self.steps);
    }

    /// The lanes have made `step` steps.
    #[inline(always)]
    pub fn count(&mut self, step: u64) {
        self.steps = step.wrapping_sub(self.origin);
    }

    /// It is now at `time`.
    #[inline(always)]
    pub fn arrive(&mut self, time: f64) {
        self.time = time;
    }

    /// Crossings since the last call.
    pub fn unreported(&mut self) -> u64 {
        let new = self.crossings - self.reported;
        self.reported = self.crossings;
        u64::from(new)
    }

    /// True when there is nothing more to do.
    #[inline(always)]
    pub fn is_over(&mut self, options: &SweepOptions) -> bool {
        if self.end.is_none() && self.time >= options.max_time {
            self.end = Some(OrbitEnd::Time);
        }
        self.end.is_some()
    }

    /// Looks for crossings in the lane's step, which was counted and may have some.
    #[inline(always)]
    pub fn look<S: Simd>(&mut self, simd: S, options: &SweepOptions, news: &News<S>, lane: usize) {
        let (lanes, scan) = (news.lanes, news.scan);
        let verdict = scan.verdict(lane);
        let start = lanes.time(lane);
        if verdict.flat {
            self.count_flat_step();
        } else if verdict.single {
            let offset = lane_values::<S>(&news.offsets)[lane];
            let state = state_of::<S>(&news.states, lane);
            self.cross(options, start.after(offset), &state);
        } else {
            let mut room = [0.0; ROWS];
            let c = scan.coefficients(lane, &mut room);
            if !c.iter().all(|x| x.is_finite()) {
                self.end = Some(OrbitEnd::Failed(StepError { time: start.seconds() }));
                return;
            }
            let mut roots = std::mem::take(&mut self.roots);
            self.tangencies += self.general_roots(simd, c, verdict.start, verdict.end >= 0.0, &mut roots);
            for &x in &roots {
                let offset = lanes.step_of(lane) * x;
                if self.end.is_none() {
                    let states = lanes.states_at(simd, simd.splat_f64s(offset));
                    self.cross(options, start.after(offset), &state_of::<S>(&states, lane));
                }
            }
            roots.clear();
            self.roots = roots;
        }
        if !verdict.end.is_finite() {
            self.end = Some(OrbitEnd::Failed(StepError { time: start.seconds() }));
        }
    }

    #[inline(never)]
    fn count_flat_step(&mut self) {
        self.flat_steps = if self.last_flat + 1 == self.steps { self.flat_steps + 1 } else { 1 };
        self.last_flat = self.steps;
        if self.flat_steps >= FLAT_STEPS {
            self.end = Some(OrbitEnd::StaysOnSection);
        }
    }

    /// All roots of S = Σ c_k xᵏ, x ∈ (0, 1), where `start` is S at 0 as the step before saw it (NaN: exactly 0).
    #[inline(never)]
    fn general_roots<S: Simd>(&self, simd: S, c: &[f64], start: f64, end_positive: bool, roots: &mut Vec<f64>) -> u32 {
        if !start.is_nan() {
            return all_roots(simd, c, start >= 0.0, end_positive, roots);
        }
        // S(0) = 0: the start itself, with the multiplicity that its leading coefficients show, is not a crossing.
        let multiplicity = 1 + c[1..].iter().take_while(|x| x.abs() <= self.flat).count();
        match c.get(multiplicity..) {
            Some(rest) if rest.len() > 1 => all_roots(simd, rest, rest[0] >= 0.0, end_positive, roots),
            _ => 0,
        }
    }

    /// A crossing close to this time and state.
    #[inline(always)]
    fn cross(&mut self, options: &SweepOptions, time: Instant, state: &State) {
        if time.seconds() > options.max_time {
            self.end = Some(OrbitEnd::Time);
            return;
        }
        self.crossings += 1;
        self.record(time, state);
        if self.crossings as usize >= options.crossings {
            self.end = Some(OrbitEnd::Crossings);
        }
    }

    /// Keeps a point of which nothing has been read yet.
    #[inline(always)]
    fn record(&mut self, time: Instant, state: &State) {
        self.points.push(SectionPoint {
            orbit: self.orbit,
            index: self.crossings,
            time: time.seconds(),
            time_low: time.remainder(),
            gamma: state.gamma,
            l: state.l,
            sheet: 1,
            s_dot: 0.0,
            theta: 0.0,
            psi: 0.0,
        });
    }

    /// Reads all points.
    #[inline(always)]
    pub fn settle<S: Simd>(&mut self, simd: S, gauge: &Gauge<S>, torus: &PpTorus, condition: SectionCondition) {
        let mut all = std::mem::take(&mut self.points);
        for points in all.chunks_mut(S::F64_LANES) {
            let mut states = [[simd.splat_f64s(0.0); 3]; 2];
            let values = lane_values_mut::<S>(states.as_flattened_mut());
            for (lane, point) in points.iter().enumerate() {
                for (k, &number) in point.gamma.iter().chain(&point.l).enumerate() {
                    values[k * S::F64_LANES + lane] = number;
                }
            }
            let readings = gauge.read(simd, states);
            for (lane, point) in points.iter_mut().enumerate() {
                let reading = readings.of(lane);
                if reading.value.abs() <= self.rounding || point.index == 0 {
                    self.place(torus, point, &reading);
                } else {
                    self.polish(torus, condition, point, reading.value);
                }
            }
        }
        self.points = all;
    }

    /// Moves a point where S = `value` onto the section.
    #[inline(never)]
    fn polish(&mut self, torus: &PpTorus, condition: SectionCondition, point: &mut SectionPoint, value: f64) {
        let state = State { gamma: point.gamma, l: point.l };
        let (offset, state) = polished(torus.top(), condition, &state, value);
        let time = Instant::new(point.time, point.time_low).after(offset);
        (point.time, point.time_low) = (time.seconds(), time.remainder());
        (point.gamma, point.l) = (state.gamma, state.l);
        self.place(torus, point, &Reading::new(torus, condition, &state));
    }

    /// Gives a point what was read of it.
    #[inline(always)]
    fn place(&mut self, torus: &PpTorus, point: &mut SectionPoint, reading: &Reading) {
        let place = reading.place(torus, &State { gamma: point.gamma, l: point.l });
        self.drift = self.drift.max(&reading.integrals.distance(&self.integrals));
        self.residual = self.residual.max(reading.value.abs());
        (point.sheet, point.s_dot) = (place.sheet, reading.rate);
        (point.theta, point.psi) = (place.theta, place.psi);
    }

    /// The orbit's crossings, which were read, and its report.
    pub fn finish(self) -> OrbitSection {
        OrbitSection {
            points: self.points,
            report: OrbitReport {
                end: self.end.unwrap_or(OrbitEnd::Interrupted),
                crossings: self.crossings,
                steps: self.steps,
                time: self.time,
                tangencies: self.tangencies,
                drift: self.drift,
                residual: self.residual,
            },
            orbit: self.orbit,
        }
    }
}
